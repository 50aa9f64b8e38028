//! The stair: a [`Model`] goes in, a [`Run`] comes out. No files, no clock, no printing.

mod energy_audit;
mod model;
mod observation;
mod part;
mod reference;
mod run;
mod sampling;
mod tables;
mod warnings;
mod watch;

use std::sync::atomic::Ordering;

use nalgebra::Const;

pub use energy_audit::EnergyReport;
pub use model::{Model, Sampling};
pub use observation::{
    BearingHistory, ConsumedLife, Event, EventCount, EventKind, LifeHistory, LoadZone, Spread,
};
pub use part::{Earlier, Part, Standing, StateKeeper, StateSource};
pub use reference::ReferenceStanding;
pub use run::{MeasuredError, Run, StaticState};
pub use tables::TableUse;
pub use watch::{Monitor, SimulateError, TraceSink};

use crate::integrate::{IntegrateError, Integration, Square};
use crate::rotor::{ACCOUNTED_STATES, AccountedRotor, Moving, Rotor, check_loose};
use energy_audit::EnergyAudit;
use observation::Observation;
use reference::{Reference, reference_settings};
use tables::TableAudit;
use warnings::Outcome;

/// Samples that are integrated, checked and written at a time.
const BLOCK: usize = 1024;

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
pub fn simulate_part(
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
    if model.energy || rotor.is_driven() {
        let accounted = AccountedRotor::new(&rotor);
        return run::<_, ACCOUNTED_STATES, { ACCOUNTED_STATES + 1 }>(
            model, &accounted, tables, sink, monitor, part,
        );
    }
    // N states of the kept freedoms, and M = N + 1 with the time
    match rotor.kept() {
        2 => run::<_, 4, 5>(model, &rotor, tables, sink, monitor, part),
        3 => run::<_, 6, 7>(model, &rotor, tables, sink, monitor, part),
        _ => run::<_, 10, 11>(model, &rotor, tables, sink, monitor, part),
    }
}

fn run<S, const N: usize, const M: usize>(
    model: &Model,
    system: &S,
    mut tables: TableAudit,
    sink: &mut dyn TraceSink,
    monitor: &mut Monitor<'_>,
    part: &mut Part<'_>,
) -> Result<Run, SimulateError>
where
    S: Moving<N>,
    Const<N>: Square,
{
    let rotor = system.rotor();
    let loose = check_loose(&model.rotor, rotor)?;
    let scale = rotor.motion_scale(reference_settings(model).tolerance);
    let grid = sampling::grid(model, rotor)?;
    let mut recorder = model.spectrum.map(|_| sampling::recorder(model, rotor));
    let start = |settings| {
        let (scaling, state) = (system.scaling(&scale), system.start());
        Integration::<_, N, M>::new(system, scaling, grid, settings, monitor.stop, &state)
    };
    let mut main = start(model.integrator);
    let mut reference = model
        .verify
        .then(|| Reference::new(start(reference_settings(model))));
    let mut observation = Observation::new(model, rotor);
    let mut audit = EnergyAudit::default();
    let mut take = |first: u64, states: &[[f64; N]]| {
        for (index, state) in states.iter().enumerate() {
            let time = grid.time(first + index as u64);
            let sample = system.sample(time, state, observation.contacts());
            sink.sample(&sample)?;
            observation.take(&sample, sink)?;
            audit.sample(&sample);
            tables.sample(rotor, &sample);
            if let Some(recorder) = &mut recorder {
                recorder.record(&sample);
            }
        }
        Ok::<(), SimulateError>(())
    };
    let mut states = Vec::with_capacity(BLOCK);
    part.go_on(&mut main, reference.as_mut())?;
    let mut replayed = 0;
    while replayed < main.done() {
        if monitor.stop.load(Ordering::Relaxed) {
            let time = grid.time(replayed);
            return Err(IntegrateError::Interrupted { time }.into());
        }
        part.replay(replayed, BLOCK, &mut states)?;
        take(replayed, &states)?;
        replayed += states.len() as u64;
        (monitor.progress)(replayed as f64 / grid.count as f64);
    }
    while main.done() < grid.count {
        part.stand(grid.time(main.done()), &main, reference.as_ref())?;
        let first = main.done();
        states.clear();
        let result = main.advance(BLOCK, &mut states);
        part.counters = main.counters();
        if let Some(reference) = &mut reference {
            reference.compare(&states, system, &scale)?;
        }
        take(first, &states)?;
        result?;
        part.keep(&states)?;
        (monitor.progress)(main.done() as f64 / grid.count as f64);
    }
    let measured_error = reference
        .as_ref()
        .and_then(|reference| reference.measured(model, &scale));
    let outcome = Outcome {
        error: measured_error.as_ref(),
        error_unknown: reference.as_ref().and_then(Reference::failure),
        stiffness: main.stiffness(),
        loose,
    };
    let analysis = sampling::analyse(model, rotor, recorder);
    let (spectrum, peaks) = analysis.map_or_else(Default::default, |analysis| {
        (Some(analysis.spectrum), analysis.peaks)
    });
    Ok(Run {
        equilibrium: StaticState::of(rotor),
        ball_pass: sampling::ball_pass(rotor, sampling::reported_speed(model, rotor)),
        counters: main.counters(),
        samples: grid.count,
        bearings: observation.finish(),
        tables: tables.finish(),
        warnings: warnings::warnings(model, rotor, &outcome),
        measured_error,
        energy: audit.finish(),
        spectrum,
        peaks,
    })
}
