//! A [`Model`] goes in, a [`Run`] comes out. No files, no clock, no printing.

pub(crate) mod bare_run;
mod energy_audit;
mod model;
mod observation;
mod observers;
mod passes;
mod recorded;
mod recorders;
mod run;
mod run_up;
mod sampling;
mod severity;
mod spalls;
mod spectra;
mod tables;
mod warnings;
mod watch;

pub(crate) use bare_run::BareRun;
pub use energy_audit::EnergyReport;
pub use model::Model;
pub(crate) use model::{Analyses, MotionAnalysis, Sampling};
pub use observation::{BearingHistory, Event, EventCount, EventKind};
pub(crate) use observation::{BeyondContact, PeakWatch, Spread};
#[cfg(test)]
pub(crate) use observation::{ConsumedLife, LifeHistory, LoadZone};
pub(crate) use passes::{Recorded, reference_settings};
pub(crate) use recorded::LAST_BALLS;
pub use recorded::{RecordedRun, UnknownColumn};
pub use recorders::Maps;
pub(crate) use recorders::tracked_orders;
pub use run::{MeasuredError, Reduction, ReductionError, Run, StaticState};
pub use run_up::{Extreme, RunUp};
pub(crate) use sampling::{RunSize, line_causes};
pub(crate) use severity::Machine;
pub(crate) use severity::VibrationSeverity;
pub(crate) use spalls::SpallPassage;
pub(crate) use tables::TableUse;
pub(crate) use warnings::{PROMISE, assembled_warnings, range_warnings, speed_warnings};
pub use watch::{Monitor, SimulateError, TraceSink};

use crate::analysis::Motion;
pub use crate::integrate::{Counters, IntegrateError};
use crate::integrate::{Progress, States, System};
pub use crate::rotor::{BallContacts, NaturalFrequency, RotorError, Sample, Whirl};
use crate::rotor::{Rotor, check_constraints};
use observers::Observers;
use passes::{Passes, Watch};
use tables::TableAudit;

/// Samples that are integrated, checked and written at a time.
const BLOCK: usize = 4096;

/// Runs a model: every sample goes to `sink`, everything else is returned.
///
/// # Errors
/// [`SimulateError`]; the samples before the failure have gone to the sink.
pub fn simulate(
    model: &Model,
    sink: &mut dyn TraceSink,
    monitor: &mut Monitor<'_>,
) -> Result<Run, SimulateError> {
    simulate_watched(model, sink, monitor, [None; 3])
}

/// Modes in each plane of the reduction that measures the error of one with so many: twice as many, and at least four
/// more, as the modes that follow the last one kept may be local ones that hardly move the bearings.
pub(crate) fn finer_modes(modes: usize) -> usize {
    modes + modes.max(4)
}

/// As [`simulate`], with the progress of the passes: of the run, of its error, of that of a shaft that bends.
///
/// # Errors
/// [`SimulateError`] as there.
pub(crate) fn simulate_watched(
    model: &Model,
    sink: &mut dyn TraceSink,
    monitor: &mut Monitor<'_>,
    progress: [Option<&Progress>; 3],
) -> Result<Run, SimulateError> {
    let mut rotor = Rotor::assemble(&model.rotor)?;
    let tables = TableAudit::new(if model.table {
        rotor.tabulate()
    } else {
        Vec::new()
    });
    if model.energy {
        rotor.account_for_energy();
    }
    let unconstrained = check_constraints(&model.rotor, &rotor)?;
    let grid = sampling::grid(model, &rotor)?;
    let finer = finer_rotor(model, &rotor)?;
    let scale = passes::motion_scale(model, &rotor);
    let watch = Watch {
        stop: monitor.stop,
        progress,
    };
    let mut passes = Passes::start(model, (&rotor, finer.as_ref()), grid, watch, scale);
    let mut observers = Observers::new(model, &rotor, grid, sink, tables);
    integrate(&mut passes, &mut observers, monitor)?;
    let mut warnings = unconstrained;
    warnings.extend(observers.observation.peak_warnings(&rotor)?);
    Ok(answer(model, &passes, observers, warnings))
}

/// Of a motion that is verified, the shaft that bends with more modes.
pub(crate) fn finer_rotor(model: &Model, rotor: &Rotor) -> Result<Option<Rotor>, RotorError> {
    let modes = rotor.bending_modes().filter(|_| model.verify);
    let Some(modes) = modes else { return Ok(None) };
    let definition = model.rotor.with_modes(finer_modes(modes));
    let mut finer = Rotor::assemble(&definition)?;
    if model.table {
        finer.tabulate();
    }
    Ok(Some(finer))
}

/// Integrates block by block to the end of the run.
fn integrate(
    passes: &mut Passes<'_>,
    observers: &mut Observers<'_>,
    monitor: &mut Monitor<'_>,
) -> Result<(), SimulateError> {
    let grid = passes.grid;
    let mut states = States::with_capacity(passes.rotor.states(), BLOCK);
    while passes.main.done() < grid.count {
        let first = passes.main.done();
        states.clear();
        let mut result = passes.main.advance(BLOCK, &mut states);
        if first == 0 && result.is_ok() && passes.restart_to_scale(&states) {
            states.clear();
            result = passes.main.advance(BLOCK, &mut states);
        }
        passes.record(first, &states);
        // an interrupted block has no second pass, which would tell of its own start
        if !matches!(result, Err(IntegrateError::Interrupted { .. })) {
            passes.compare(&states)?;
        }
        observers.take(passes.rotor, first, &states)?;
        result?;
        (monitor.progress)(passes.main.done() as f64 / grid.count as f64);
    }
    Ok(())
}

fn answer(
    model: &Model,
    passes: &Passes<'_>,
    observers: Observers<'_>,
    mut warnings: Vec<String>,
) -> Run {
    let rotor = passes.rotor;
    let measured_error = passes.measured_error();
    let causes = sampling::line_causes(model, rotor);
    let recording = observers.recording.as_ref();
    let analysis = sampling::analyse(model, rotor, recording, &causes);
    let estimated = spectra::estimated(model, recording, &causes, rotor.is_random());
    let (motion, maps, run_up) = observers.recorders.finish();
    let motion = motion.map(|motion| Motion {
        random: rotor.is_random(),
        ..motion
    });
    let (spectrum, peaks) = analysis.map_or_else(Default::default, |analysis| {
        (Some(analysis.spectrum), analysis.peaks)
    });
    let error = measured_error.as_ref();
    warnings.extend(warnings::warnings(model, passes, error, motion.as_ref()));
    let energy = observers.audit.finish();
    warnings.extend(energy.as_ref().and_then(EnergyReport::warning));
    let steady = rotor.steady_from(model.settle);
    let speed_changes = steady.is_none();
    let whole = spectrum.as_ref();
    let whole = whole.filter(|_| model.analyses.highest_order.is_none());
    warnings.extend(spectra::warnings(whole, &estimated, speed_changes));
    warnings.extend(maps.iter().flat_map(|maps| maps.tracks.warnings()));
    let severity = |machine| {
        Some(VibrationSeverity::from_motion(
            machine,
            motion.as_ref()?,
            steady?,
        ))
    };
    let vibration_severity = model.analyses.machine.and_then(severity);
    let vibration_severity = vibration_severity.and_then(|found| {
        let refused = |why| warnings.push(why);
        found.map_err(refused).ok()
    });
    Run {
        vibration_severity,
        equilibrium: StaticState::from_rotor(rotor),
        ball_pass: sampling::ball_pass(rotor, sampling::reported_speed(model, rotor)),
        nominal_ball_pass: sampling::nominal_ball_pass(
            rotor,
            sampling::reported_speed(model, rotor),
        ),
        counters: passes.main.counters(),
        method_use: passes.main.method_use(),
        samples: passes.grid.count,
        bearings: observers.observation.finish(),
        largest_ball_load: observers.largest_ball_load,
        tables: observers.tables.finish(),
        warnings: model.rotor.warnings_with(warnings),
        measured_error,
        reduction: passes.reduction(),
        finer_counters: passes.finer_counters(),
        energy,
        corrected_scale: passes.corrected_scale(),
        spectrum,
        peaks,
        motion,
        maps,
        run_up,
        spalls: steady.map_or_else(Vec::new, |speed| spalls::spall_passages(rotor, speed)),
        spectra: estimated
            .into_iter()
            .filter_map(|(_, found)| found.ok())
            .collect(),
    }
}
