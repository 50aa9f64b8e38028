//! One period of a motion, sampled from every place; and the trace that is shown.

use nalgebra::DVector;

use super::rotor_map::RotorMap;
use super::{Base, SteadyError};
use crate::integrate::{Grid, States};
use crate::rotor::{BallContacts, Sample};
use crate::shooting::ReturnMap;
use crate::simulate::{Model, Sampling};

/// Least number of samples of a period, and the most.
const LEAST_SAMPLES: usize = 128;
const MOST_SAMPLES: usize = 1 << 16;
/// Periods of the slower frequency in the trace of a motion of two.
const TRACED: f64 = 4.0;
/// Least number of samples there, of a period of the first frequency.
const LEAST_SHOWN: usize = 32;

/// Samples of a period from every place: how the shaft moves and, where asked for, the forces of its
/// bearings; nothing of balls.
pub(super) fn sampled(
    map: &mut RotorMap<'_>,
    states: &DVector<f64>,
    model: &Model,
    forces: bool,
) -> Result<Vec<Vec<Sample>>, SteadyError> {
    let flights = flights(map, states, model)?;
    Ok(seen(map, &flights, map.rotor.unwatched_balls(forces)))
}

/// States of a period on a grid, from every place.
pub(super) fn flights(
    map: &mut RotorMap<'_>,
    states: &DVector<f64>,
    model: &Model,
) -> Result<Vec<States>, SteadyError> {
    let count = samples(map, model);
    let grid = Grid {
        interval: map.places.circle.period() / count as f64,
        count: count as u64,
    };
    let strobes = map.places.circle.strobes().to_vec();
    let mut all = Vec::new();
    for (state, strobe) in map.states(states).iter().zip(strobes) {
        all.push(map.flight(map.places.time(strobe), state, grid)?);
    }
    Ok(all)
}

/// What is observed on the flights of a period; of balls, what the trace shows where it is one of them.
pub(super) fn observed(map: &RotorMap<'_>, flights: &[States]) -> Vec<Vec<Sample>> {
    let contacts = match map.places.is_torus() {
        true => map.rotor.unwatched_balls(true),
        false => map.rotor.ball_loads(),
    };
    seen(map, flights, contacts)
}

fn seen(map: &RotorMap<'_>, flights: &[States], mut contacts: BallContacts) -> Vec<Vec<Sample>> {
    let circle = &map.places.circle;
    let mut flight = |(states, strobe): (&States, &u64)| {
        let start = map.places.time(*strobe);
        let interval = circle.period() / states.len() as f64;
        let sample = |(number, state): (usize, &[f64])| {
            map.rotor
                .sample(start + number as f64 * interval, state, &mut contacts)
        };
        states.iter().enumerate().map(sample).collect()
    };
    flights
        .iter()
        .zip(circle.strobes())
        .map(&mut flight)
        .collect()
}

/// Samples of a period: as many as the scene asks for, and a power of two.
fn samples(map: &RotorMap<'_>, model: &Model) -> usize {
    let least = LEAST_SAMPLES * map.places.multiple as usize;
    asked(map, model)
        .max(least)
        .next_power_of_two()
        .min(MOST_SAMPLES)
}

/// Samples of a period that the scene asks for.
fn asked(map: &RotorMap<'_>, model: &Model) -> usize {
    let period = map.places.circle.period();
    let asked = match model.sampling {
        Sampling::Rate(rate) => rate * period,
        Sampling::PerRevolution(samples) => {
            f64::from(samples) * period * map.rotor.speed() / std::f64::consts::TAU
        }
    };
    asked.ceil() as usize
}

/// The trace that is shown: the period itself, or some of the slower of two frequencies, whose states
/// stand between those of the places, as close to each other as the scene asks for.
pub(super) fn trace(
    map: &RotorMap<'_>,
    flights: &[States],
    sampled: &[Vec<Sample>],
    model: &Model,
) -> Vec<Sample> {
    let (circle, mut contacts) = (&map.places.circle, map.rotor.ball_loads());
    if !map.places.is_torus() {
        return sampled.first().cloned().unwrap_or_default();
    }
    let slower = map
        .places
        .bases
        .iter()
        .map(Base::period)
        .fold(0.0, f64::max);
    let periods = (TRACED * slower / circle.period()).ceil() as u64;
    let instants = flights.first().map_or(0, States::len);
    let shown = asked(map, model).max(LEAST_SHOWN).next_power_of_two();
    let mut trace = Vec::new();
    for strobe in 0..periods {
        let weights = circle.values_at(&[circle.phase(strobe)]);
        for instant in (0..instants).step_by((instants / shown).max(1)) {
            let mut state = vec![0.0; map.size()];
            for (flight, weight) in flights.iter().zip(weights.iter()) {
                let parts = flight.get(instant).into_iter().flatten();
                for (sum, part) in state.iter_mut().zip(parts) {
                    *sum += weight * part;
                }
            }
            let since = strobe as f64 + instant as f64 / instants as f64;
            let time = map.places.time(0) + since * circle.period();
            trace.push(map.rotor.sample(time, &state, &mut contacts));
        }
    }
    trace
}
