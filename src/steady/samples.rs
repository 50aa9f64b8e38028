//! One period of a motion, sampled from every node; and the trace that is shown.

use nalgebra::DVector;

use super::rotor_map::RotorMap;
use super::{Base, SteadyError};
use crate::integrate::{Grid, States};
use crate::rotor::{BallContacts, Sample};
use crate::shooting::ReturnMap;
use crate::simulate::{BeyondContact, Model, PeakWatch};

/// Least number of samples of a period, and the most.
const LEAST_SAMPLES: usize = 128;
const MOST_SAMPLES: usize = 1 << 16;
/// Periods of the slower frequency in the trace of a motion of two.
const TRACED: f64 = 4.0;
/// Least number of samples there, of a period of the first frequency.
const LEAST_SHOWN: usize = 32;

/// Samples of a period from every node: how the shaft moves and, where asked for, the forces of its
/// bearings; nothing of balls.
pub(super) fn sampled(
    map: &mut RotorMap<'_>,
    states: &DVector<f64>,
    model: &Model,
    forces: bool,
) -> Result<Vec<Vec<Sample>>, SteadyError> {
    let trajectories = trajectories(map, states, model)?;
    let contacts = map.rotor.unwatched_balls(forces);
    Ok(samples_along(map, &trajectories, contacts))
}

/// States of a period on a grid, from every node.
fn trajectories(
    map: &mut RotorMap<'_>,
    states: &DVector<f64>,
    model: &Model,
) -> Result<Vec<States>, SteadyError> {
    let count = sample_count(map, model);
    let grid = Grid {
        interval: map.periods.circle.period / count as f64,
        count: count as u64,
    };
    let strobes = map.periods.circle.strobes.clone();
    let mut all = Vec::new();
    for (state, strobe) in map.states(states).iter().zip(strobes) {
        all.push(map.trajectory(map.periods.time(strobe), state, grid)?);
    }
    Ok(all)
}

/// A period from every node.
pub(super) struct Observed {
    pub trajectories: Vec<States>,
    /// What is observed along them; of the balls, what the trace shows where it is one of them.
    pub samples: Vec<Vec<Sample>>,
}

impl Observed {
    /// The motion that begins with some states.
    pub fn new(
        map: &mut RotorMap<'_>,
        states: &DVector<f64>,
        model: &Model,
    ) -> Result<Self, SteadyError> {
        let trajectories = trajectories(map, states, model)?;
        let contacts = match map.periods.is_torus() {
            true => map.rotor.unwatched_balls(true),
            false => map.rotor.ball_loads(),
        };
        Ok(Self {
            samples: samples_along(map, &trajectories, contacts),
            trajectories,
        })
    }
}

fn samples_along(
    map: &RotorMap<'_>,
    trajectories: &[States],
    mut contacts: BallContacts,
) -> Vec<Vec<Sample>> {
    let mut rate = Vec::new();
    let samples = instants(map, trajectories).map(|instants| {
        let sample = |(time, state)| {
            let rate = Some(&mut rate);
            map.rotor.whole_sample(time, state, &mut contacts, rate)
        };
        instants.map(sample).collect()
    });
    samples.collect()
}

/// Times and states along each of the trajectories of a period.
fn instants<'a>(
    map: &'a RotorMap<'_>,
    trajectories: &'a [States],
) -> impl Iterator<Item = impl Iterator<Item = (f64, &'a [f64])>> {
    let circle = &map.periods.circle;
    let pairs = trajectories.iter().zip(&circle.strobes);
    pairs.map(|(states, strobe)| {
        let start = map.periods.time(*strobe);
        let interval = circle.period / states.len() as f64;
        let states = states.iter().enumerate();
        states.map(move |(number, state)| (start + number as f64 * interval, state))
    })
}

/// What to know of how hard the balls are pressed along the trajectories of a period.
///
/// # Errors
/// [`BeyondContact`] where that is beyond any contact of a ball.
pub(super) fn peak_warnings(
    map: &RotorMap<'_>,
    trajectories: &[States],
) -> Result<Vec<String>, BeyondContact> {
    let mut contacts = PeakWatch::contacts(&map.rotor);
    let mut peaks = PeakWatch::new(&map.rotor);
    for (time, state) in instants(map, trajectories).flatten() {
        map.rotor.sample(time, state, &mut contacts);
        peaks.take(time, &contacts);
        peaks.take_linear(&map.rotor, time, state);
    }
    peaks.warnings(&map.rotor)
}

/// Samples of a period: as many as the scene asks for, and a power of two.
fn sample_count(map: &RotorMap<'_>, model: &Model) -> usize {
    let least = LEAST_SAMPLES * map.periods.multiple as usize;
    requested(map, model)
        .max(least)
        .next_power_of_two()
        .min(MOST_SAMPLES)
}

/// Samples of a period that the scene asks for.
fn requested(map: &RotorMap<'_>, model: &Model) -> usize {
    let rate = model.sampling.rate(map.rotor.speed());
    (rate * map.periods.circle.period).ceil() as usize
}

/// The trace that is shown: the period itself, or some of the slower of two frequencies, whose states
/// are interpolated between those of the nodes, as close to each other as the scene asks for.
pub(super) fn trace(
    map: &RotorMap<'_>,
    trajectories: &[States],
    sampled: &[Vec<Sample>],
    model: &Model,
) -> Vec<Sample> {
    let (circle, mut contacts) = (&map.periods.circle, map.rotor.ball_loads());
    if !map.periods.is_torus() {
        return sampled.first().cloned().unwrap_or_default();
    }
    let slower = map.periods.bases.iter().map(Base::period);
    let slower = slower.fold(0.0, f64::max);
    let periods = (TRACED * slower / circle.period).ceil() as u64;
    let instants = trajectories.first().map_or(0, States::len);
    let shown = requested(map, model).max(LEAST_SHOWN).next_power_of_two();
    let (mut trace, mut rate) = (Vec::new(), Vec::new());
    for strobe in 0..periods {
        let weights = circle.values_at(&[circle.phase(strobe)]);
        for instant in (0..instants).step_by((instants / shown).max(1)) {
            let mut state = vec![0.0; map.size()];
            for (trajectory, weight) in trajectories.iter().zip(weights.iter()) {
                let parts = trajectory.get(instant).into_iter().flatten();
                for (sum, part) in state.iter_mut().zip(parts) {
                    *sum += weight * part;
                }
            }
            let since = strobe as f64 + instant as f64 / instants as f64;
            let time = map.periods.time(0) + since * circle.period;
            let rate = Some(&mut rate);
            trace.push(map.rotor.whole_sample(time, &state, &mut contacts, rate));
        }
    }
    trace
}
