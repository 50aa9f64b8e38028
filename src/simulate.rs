//! The stair: a [`Model`] goes in, a [`Run`] comes out. No files, no clock, no printing.

mod model;
mod observation;
mod reference;
mod run;
mod sampling;
mod warnings;
mod watch;

use nalgebra::Const;

pub use model::{Model, Sampling};
pub use observation::{
    BearingHistory, ConsumedLife, Event, EventCount, EventKind, LifeHistory, LoadZone, Spread,
};
pub use run::{MeasuredError, Run, StaticState};
pub use watch::{Monitor, SimulateError, TraceSink};

use crate::integrate::{Integration, Scaling, Square};
use crate::rotor::{MotionScale, Rotor};
use observation::Observation;
use reference::{Reference, reference_settings};

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
    let rotor = Rotor::assemble(&model.rotor)?;
    // N states of the kept freedoms, and M = N + 1 with the time
    match rotor.kept() {
        2 => run::<4, 5>(model, &rotor, sink, monitor),
        3 => run::<6, 7>(model, &rotor, sink, monitor),
        _ => run::<10, 11>(model, &rotor, sink, monitor),
    }
}

fn run<const N: usize, const M: usize>(
    model: &Model,
    rotor: &Rotor,
    sink: &mut dyn TraceSink,
    monitor: &mut Monitor<'_>,
) -> Result<Run, SimulateError>
where
    Const<N>: Square,
{
    let scale = rotor.motion_scale(reference_settings(model).tolerance);
    let grid = sampling::grid(model, rotor)?;
    let mut recorder = model.spectrum.map(|_| sampling::recorder(model, rotor));
    let start = |settings| {
        let (scaling, state) = (scaling(rotor, &scale), initial_state(rotor));
        Integration::<_, N, M>::new(rotor, scaling, grid, settings, monitor.stop, &state)
    };
    let mut main = start(model.integrator);
    let mut reference = model
        .verify
        .then(|| Reference::new(start(reference_settings(model))));
    let mut observation = Observation::new(model, rotor);
    let mut states = Vec::with_capacity(BLOCK);
    while main.done() < grid.count {
        let first = main.done();
        states.clear();
        let result = main.advance(BLOCK, &mut states);
        if let Some(reference) = &mut reference {
            reference.compare(&states, rotor, &scale);
        }
        for (index, state) in states.iter().enumerate() {
            let time = grid.time(first + index as u64);
            let sample = rotor.sample(time, state, observation.contacts());
            sink.sample(&sample)?;
            observation.take(&sample, sink)?;
            if let Some(recorder) = &mut recorder {
                recorder.record(&sample);
            }
        }
        result?;
        (monitor.progress)(main.done() as f64 / grid.count as f64);
    }
    let measured_error = reference.and_then(|reference| reference.measured(model, &scale));
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
        warnings: warnings::warnings(model, rotor, measured_error.as_ref()),
        measured_error,
        spectrum,
        peaks,
    })
}

/// States become deviations from the static equilibrium in units of the motion.
fn scaling<const N: usize>(rotor: &Rotor, scale: &MotionScale) -> Scaling<N> {
    let place = &rotor.equilibrium().displacement;
    Scaling {
        origin: std::array::from_fn(|index| if index < N / 2 { place[index] } else { 0.0 }),
        scale: rotor.state_scale(scale),
        time: 1.0 / scale.frequency,
    }
}

fn initial_state<const N: usize>(rotor: &Rotor) -> [f64; N] {
    let [displacement, velocity] = rotor.initial_state();
    std::array::from_fn(|index| {
        if index < N / 2 {
            displacement[index]
        } else {
            velocity[index - N / 2]
        }
    })
}
