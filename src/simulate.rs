//! The stair: a [`Model`] goes in, a [`Run`] comes out. No files, no clock, no printing.

mod analyses;
pub(crate) mod bare;
mod energy_audit;
mod model;
mod observation;
mod observers;
mod part;
mod recorded;
mod reference;
mod run;
mod sampling;
mod size;
mod spectra;
mod tables;
mod warnings;
mod watch;

use std::sync::atomic::{AtomicBool, Ordering};

pub use analyses::Maps;
pub(crate) use analyses::{Analyses, BallParts, SpectrumLines, Watched};
pub(crate) use bare::BareRun;
pub use energy_audit::EnergyReport;
pub use model::Model;
pub(crate) use model::Sampling;
pub use observation::{
    BearingHistory, ConsumedLife, Event, EventCount, EventKind, LifeHistory, LoadZone, Spread,
};
pub(crate) use part::{Earlier, Part, Standing, StateKeeper, StateSource};
pub use recorded::{RecordedRun, UnknownColumn};
pub use run::{MeasuredError, Run, StaticState};
pub(crate) use size::RunSize;
pub(crate) use tables::TableUse;
pub use watch::{Monitor, SimulateError, TraceSink};

pub use crate::integrate::{Counters, IntegrateError};
use crate::integrate::{Grid, Integration, MethodUse, Pace, SEGMENT, States, Stiffness, System};
pub use crate::rotor::{
    BallContacts, DriveMoments, EnergyBalance, NaturalFrequency, RotorDefinition, RotorError,
    Sample, UnconstrainedError, Whirl, Works,
};
use crate::rotor::{MotionScale, Rotor, check_constraints};
use observers::Observers;
use reference::{Reference, reference_settings};
use tables::TableAudit;

/// Samples that are integrated, checked and written at a time.
const BLOCK: usize = SEGMENT as usize;

/// Runs a model: every sample goes to `sink`, everything else is returned.
///
/// # Errors
/// [`SimulateError`]; the samples before the failure have gone to the sink.
pub fn simulate(
    model: &Model,
    sink: &mut dyn TraceSink,
    monitor: &mut Monitor<'_>,
) -> Result<Run, SimulateError> {
    simulate_part(model, sink, monitor, &mut Part::default())
}

/// As [`simulate`], but from where an earlier part of the run stopped, and up to where this one is
/// to stop; the sink takes all samples from the first on.
///
/// # Errors
/// [`SimulateError`], and among them [`SimulateError::Stopped`] at the end of the part;
/// `part.standing` then says what it takes to go on.
pub(crate) fn simulate_part(
    model: &Model,
    sink: &mut dyn TraceSink,
    monitor: &mut Monitor<'_>,
    part: &mut Part<'_>,
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
    let mut passes = Passes::start(model, &rotor, grid, monitor.stop, part.paces);
    let mut observers = Observers::new(model, &rotor, grid, sink, tables);
    part.go_on(&mut passes.main, passes.reference.as_mut())?;
    replay(&passes, &mut observers, monitor, part)?;
    integrate(&mut passes, &mut observers, monitor, part)?;
    let Passes {
        main,
        grid,
        reference,
        scale,
        ..
    } = &passes;
    let reference = reference.as_ref();
    let work = Work {
        counters: main.counters(),
        method_use: main.method_use(),
        stiffness: main.stiffness(),
        samples: grid.count,
        measured_error: reference.and_then(|reference| reference.measured(model, &rotor, scale)),
        error_unknown: reference.and_then(Reference::failure),
    };
    let mut warnings = unconstrained;
    warnings.extend(observers.observation.peak_warnings(&rotor)?);
    Ok(answer(model, &rotor, work, observers, warnings))
}

/// Shows the observers what an earlier part of the run has integrated.
fn replay(
    passes: &Passes<'_>,
    observers: &mut Observers<'_>,
    monitor: &mut Monitor<'_>,
    part: &mut Part<'_>,
) -> Result<(), SimulateError> {
    let mut states = States::new(passes.rotor.states());
    let mut replayed = 0;
    while replayed < passes.main.done() {
        if monitor.stop.load(Ordering::Relaxed) {
            let time = passes.grid.time(replayed);
            return Err(IntegrateError::Interrupted { time }.into());
        }
        part.replay(replayed, BLOCK, &mut states)?;
        observers.take(passes.rotor, replayed, &states)?;
        replayed += states.len() as u64;
        (monitor.progress)(replayed as f64 / passes.grid.count as f64);
    }
    Ok(())
}

/// Integrates block by block to the end of the run or of its part.
fn integrate(
    passes: &mut Passes<'_>,
    observers: &mut Observers<'_>,
    monitor: &mut Monitor<'_>,
    part: &mut Part<'_>,
) -> Result<(), SimulateError> {
    let grid = passes.grid;
    let mut states = States::with_capacity(passes.rotor.states(), BLOCK);
    while passes.main.done() < grid.count {
        let first = passes.main.done();
        part.stand(grid.time(first), &passes.main, passes.reference.as_ref())?;
        states.clear();
        let result = passes.main.advance(BLOCK, &mut states);
        part.counters = passes.main.counters();
        if let Some(reference) = &mut passes.reference {
            reference.compare(&states, passes.rotor, &passes.scale)?;
        }
        observers.take(passes.rotor, first, &states)?;
        result?;
        part.keep(&states)?;
        (monitor.progress)(passes.main.done() as f64 / grid.count as f64);
    }
    Ok(())
}

/// What an integration has done.
struct Work<'a> {
    counters: Counters,
    method_use: Option<MethodUse>,
    stiffness: Option<Stiffness>,
    samples: u64,
    measured_error: Option<MeasuredError>,
    /// Why the error is not known, where it was to be.
    error_unknown: Option<&'a str>,
}

fn answer(
    model: &Model,
    rotor: &Rotor,
    work: Work<'_>,
    observers: Observers<'_>,
    mut warnings: Vec<String>,
) -> Run {
    let analysis = sampling::analyse(model, rotor, observers.recording.as_ref());
    let (motion, maps) = observers.recorders.finish();
    let (spectrum, peaks) = analysis.map_or_else(Default::default, |analysis| {
        (Some(analysis.spectrum), analysis.peaks)
    });
    let estimated = spectra::estimated(model, observers.recording.as_ref());
    warnings.extend(warnings::warnings(model, rotor, &work, motion.as_ref()));
    let speed_changes = rotor.steady_from(model.settle).is_none();
    let whole = spectrum.as_ref();
    let whole = whole.filter(|_| model.analyses.lines == SpectrumLines::All);
    warnings.extend(spectra::warnings(whole, &estimated, speed_changes));
    Run {
        equilibrium: StaticState::of(rotor),
        ball_pass: sampling::ball_pass(rotor, sampling::reported_speed(model, rotor)),
        operating_ball_pass: sampling::operating_ball_pass(model, rotor),
        counters: work.counters,
        method_use: work.method_use,
        samples: work.samples,
        bearings: observers.observation.finish(),
        largest_ball_load: observers.largest_ball_load,
        tables: observers.tables.finish(),
        warnings,
        measured_error: work.measured_error,
        energy: observers.audit.finish(),
        spectrum,
        peaks,
        motion,
        maps,
        spectra: estimated
            .into_iter()
            .filter_map(|(_, found)| found.ok())
            .collect(),
    }
}

/// The run and the second pass that measures its error.
struct Passes<'a> {
    rotor: &'a Rotor,
    scale: MotionScale,
    grid: Grid,
    main: Integration<'a>,
    reference: Option<Reference<'a>>,
}

impl<'a> Passes<'a> {
    fn start(
        model: &Model,
        rotor: &'a Rotor,
        grid: Grid,
        stop: &'a AtomicBool,
        [pace, reference_pace]: [Option<&'a Pace>; 2],
    ) -> Self {
        let scale = rotor.motion_scale(reference_settings(model).tolerance);
        let pass = |settings| {
            let (scaling, state) = (rotor.scaling(&scale), rotor.start());
            Integration::new(rotor, scaling, grid, settings, stop, &state)
        };
        Self {
            rotor,
            grid,
            main: pass(model.integrator).watched(pace),
            reference: model.verify.then(|| {
                let second = pass(reference_settings(model)).watched(reference_pace);
                Reference::new(second, rotor.states())
            }),
            scale,
        }
    }
}
