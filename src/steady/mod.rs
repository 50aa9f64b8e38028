//! A [`Model`] goes in, the motion that it settles to comes out, found directly instead of waiting for the start to
//! die out. No files, no clock, no printing.
//!
//! [`steady`] finds the motion of a scene, `response` follows it along a parameter.

mod error;
mod extremes;
mod lines;
mod measured;
mod orbit;
mod periods;
pub(crate) mod response;
mod rotor_map;
mod samples;
mod search;
mod solve;

use std::sync::atomic::{AtomicBool, AtomicU64};

use nalgebra::DVector;
use serde::Serialize;

pub use error::SteadyError;
pub use lines::{MotionRange, SteadyLine, SteadyLines};
pub use measured::Measured;
pub(crate) use orbit::{Orbit, orbit_alone, orbit_near};
pub(crate) use periods::Base;
pub(crate) use response::{Response, ResponsePoint, ResponseQuestion, response, response_warnings};
pub use solve::steady;

use rotor_map::RotorMap;

use crate::integrate::Counters;
use crate::keys;
use crate::rotor::Sample;
use crate::shooting::Circle;
pub use crate::shooting::{Multipliers, SpecialKind, Stability};
use crate::simulate::{Model, Reduction, StaticState};

/// What to find.
#[derive(Debug, Clone, Copy)]
pub struct SteadyQuestion<'a> {
    /// The scene; its duration, its settle time and its initial state play no part.
    pub model: &'a Model,
    /// How many periods of the forcing the motion may take to repeat; where `None`, one, or as many as a
    /// stable motion takes that is found beside one that is not stable.
    pub multiple: Option<u32>,
    /// Set to end the search at its next step.
    pub stop: &'a AtomicBool,
    /// Counts the periods that were integrated, for whoever watches the search.
    pub integrated: &'a AtomicU64,
}

/// A steady motion.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Steady {
    /// The static equilibrium that it moves about.
    #[serde(skip)]
    pub equilibrium: StaticState,
    /// Frequencies of the forcing, one or two.
    #[serde(rename = "frequencies")]
    pub(crate) bases: Vec<Base>,
    /// Period of the map, s: the whole motion repeats with it, or its phase against the second frequency
    /// turns.
    #[serde(rename = "period_s")]
    pub period: f64,
    /// How many periods of the first frequency that is.
    pub multiple: u32,
    /// Floquet multipliers over the period.
    pub multipliers: Multipliers,
    /// Whether a long run settles to it.
    #[serde(skip)]
    pub stability: Stability,
    /// Largest multiplier of the motion of a single period, where the motion found takes several.
    #[serde(rename = "single_period_multipliers")]
    pub single_period: Option<Multipliers>,
    /// Distance of the state after a period from that before it, relative to the size of the motion.
    pub residual: f64,
    /// The residual before every correction.
    #[serde(rename = "residual_history")]
    pub history: Vec<f64>,
    /// Periods integrated before the search, where it did not succeed from rest.
    #[serde(rename = "periods_waited")]
    pub waited: u64,
    /// Harmonics of the second frequency.
    #[serde(rename = "harmonics_of_second")]
    pub harmonics: usize,
    /// Ranges of displacements and forces.
    pub ranges: Vec<MotionRange>,
    /// The spectrum.
    #[serde(skip)]
    pub lines: SteadyLines,
    /// One period of the motion; of two frequencies, four periods of the slower one.
    #[serde(rename = "samples", serialize_with = "keys::count")]
    pub trace: Vec<Sample>,
    /// Measured error, where the scene asks for it.
    #[serde(skip)]
    pub measured: Option<Measured>,
    /// What is kept of a shaft that bends.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reduction: Option<Reduction>,
    /// Work of the search, measurement included.
    pub counters: Counters,
    /// What the reader should know.
    pub warnings: Vec<String>,
    /// Times and states of the first period, for whoever goes on.
    #[serde(skip)]
    section: Section,
}

/// States of a motion where its periods begin.
#[derive(Debug, Clone, PartialEq)]
struct Section {
    circle: Circle,
    /// Time of strobe 0, s.
    start: f64,
    states: Vec<Vec<f64>>,
    /// Length that the tolerance is relative to, m.
    length: f64,
}

impl Section {
    fn new(map: &RotorMap<'_>, states: &DVector<f64>) -> Self {
        Self {
            start: map.periods.time(0),
            states: map.states(states),
            circle: map.periods.circle.clone(),
            length: map.scale.length,
        }
    }
}

impl Steady {
    /// Time and state (displacements, then velocities) at the begin of a period, counted from the first
    /// one.
    pub fn strobe(&self, number: u64) -> (f64, Vec<f64>) {
        let Section {
            circle,
            start,
            states,
            ..
        } = &self.section;
        let weights = circle.values_at(&[circle.phase(number)]);
        let size = states.first().map_or(0, Vec::len);
        let state = (0..size).map(|part| {
            let values = states.iter().zip(weights.iter());
            values.map(|(state, weight)| weight * state[part]).sum()
        });
        (start + number as f64 * circle.period, state.collect())
    }

    /// Whether neighbouring motions come closer: the motion is what a long run settles to.
    pub fn is_stable(&self) -> bool {
        self.stability == Stability::Stable
    }

    /// Whether it has two frequencies without a common period.
    pub fn is_torus(&self) -> bool {
        self.bases.len() == 2
    }
}
