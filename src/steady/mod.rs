//! A [`Model`] goes in, the motion that it settles to comes out, found directly instead of waiting for the start to
//! die out. No files, no clock, no printing.
//!
//! [`steady`] finds the motion of a scene, `response` follows it along a parameter.

mod error;
mod lines;
mod measured;
mod periods;
pub(crate) mod response;
mod rotor_map;
mod samples;
mod search;

use std::sync::atomic::{AtomicBool, AtomicU64};

use nalgebra::DVector;
use serde::Serialize;

pub use error::SteadyError;
use lines::ranges;
pub use lines::{MotionRange, SteadyLine, SteadyLines};
pub use measured::Measured;
use measured::{measured, reduction};
pub(crate) use periods::Base;
use periods::Periods;
pub(crate) use response::{Response, ResponsePoint, ResponseQuestion, response, response_warnings};
use rotor_map::{RotorMap, Solver};
use samples::{observed, peak_warnings, trace, trajectories};
use search::{Found, find, found_from, subharmonic};

use crate::analysis::Channel;
use crate::integrate::Counters;
use crate::keys;
use crate::rotor::{CageMotion, Rotor, Sample, check_constraints};
use crate::shooting::{Circle, ReturnMap};
pub use crate::shooting::{Multipliers, SpecialKind, Stability};
use crate::simulate::{Model, Reduction, StaticState, assembled_warnings};

/// A measured error above this many tolerances is worth a warning.
const PROMISE: f64 = 10.0;
/// Lines below this part of the largest, in tolerances, are left out; so are those below the measured error.
const NOISE: f64 = 0.1;

/// Warning where cages do not roll as asked for, as `refusal` of the forcing.
fn rolling_cages(refusal: &SteadyError) -> String {
    let reason = match refusal {
        SteadyError::RatioChanges => {
            "the parameter changes the ratio of the two frequencies of the forcing"
        }
        _ => "the forcing has more than two independent frequencies",
    };
    format!(
        "the cages of the bearings roll at the angles of their loaded balls, and with them {reason}: here they roll at the \
         free contact angle, as with cage = \"rolling\" in [model]"
    )
}

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
    #[serde(rename = "swings")]
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
}

impl Steady {
    /// Time and state (displacements, then velocities) at the begin of a period, counted from the first
    /// one.
    pub fn strobe(&self, number: u64) -> (f64, Vec<f64>) {
        let Section {
            circle,
            start,
            states,
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

/// Finds the motion that a scene settles to.
///
/// # Errors
/// [`SteadyError`] where there is none, or none is found.
pub fn steady(question: &SteadyQuestion<'_>) -> Result<Steady, SteadyError> {
    let model = question.model;
    let mut rotor = Rotor::assemble(&model.rotor)?;
    let unconstrained = check_constraints(&model.rotor, &rotor)?;
    let periods = match Periods::new(&rotor, question.multiple.unwrap_or(1)) {
        Err(error @ SteadyError::Frequencies { .. })
            if model.rotor.cage == CageMotion::Operating =>
        {
            return with_rolling_cages(question, error);
        }
        periods => periods?,
    };
    if periods.is_torus() && periods.multiple > 1 {
        return Err(SteadyError::NoPeriod {
            frequencies: periods.frequencies(),
            multiple: periods.multiple,
        });
    }
    if model.table {
        rotor.tabulate();
    }
    let mut answer = answer(question, rotor, periods)?;
    let further = unconstrained.into_iter().chain(answer.warnings);
    answer.warnings = model.rotor.warnings_with(further);
    Ok(answer)
}

/// The motion with cages that roll at the free contact angle, at which bearings of one kind have one ball-pass frequency;
/// `refusal` where that does not help.
fn with_rolling_cages(
    question: &SteadyQuestion<'_>,
    refusal: SteadyError,
) -> Result<Steady, SteadyError> {
    let mut model = question.model.clone();
    model.rotor.cage = CageMotion::Rolling;
    let rolling = SteadyQuestion {
        model: &model,
        ..*question
    };
    let mut steady = match steady(&rolling) {
        Err(SteadyError::Frequencies { .. }) => return Err(refusal),
        found => found?,
    };
    steady.warnings.push(rolling_cages(&refusal));
    Ok(steady)
}

fn answer(
    question: &SteadyQuestion<'_>,
    rotor: Rotor,
    periods: Periods,
) -> Result<Steady, SteadyError> {
    let solver = Solver::new(
        question.model.integrator,
        question.stop,
        question.integrated,
    );
    let mut map = RotorMap::new(rotor, periods.clone(), solver);
    let find = |map: &mut RotorMap<'_>| -> Result<_, SteadyError> {
        let (found, single_period) = search(map, question.multiple)?;
        let trajectories = trajectories(map, &found.states, question.model)?;
        let sampled = observed(map, &trajectories);
        Ok((found, single_period, trajectories, sampled))
    };
    let mut answer = find(&mut map)?;
    // the tolerance is relative to the motion found, not to the one assumed
    if let Some(scale) = map.scale.corrected(measured::size(&map, &answer.3)) {
        map.periods = periods;
        map.rescale(scale);
        answer = find(&mut map)?;
    }
    let (found, single_period, trajectories, sampled) = answer;
    let measured = match question.model.verify {
        true => Some(measured(&mut map, &found, &sampled, question.model)?),
        false => None,
    };
    let reduction = reduction(&mut map, &found, &sampled, question.model)?;
    let trace = trace(&map, &trajectories, &sampled, question.model);
    let channels = Channel::of_motion(&question.model.rotor);
    let error = measured.as_ref().map_or(0.0, |error| error.relative);
    let noise = error.max(NOISE * solver.settings.tolerance);
    let stability = match &measured {
        Some(error) => found.multipliers.stability(&error.multipliers),
        None => map.stability(&found),
    };
    let mut warnings = peak_warnings(&map, &trajectories)?;
    warnings.extend(assembled_warnings(&question.model.rotor, &map.rotor));
    warnings.extend(reduction.as_ref().and_then(Reduction::warning));
    let error = measured.as_ref();
    warnings.extend(self::warnings(
        &found,
        stability,
        error,
        solver.settings.tolerance,
    ));
    Ok(Steady {
        equilibrium: StaticState::from_rotor(&map.rotor),
        period: map.periods.circle.period,
        multiple: map.periods.multiple,
        stability,
        single_period,
        residual: found.residual,
        history: found.history,
        waited: found.waited,
        harmonics: map.periods.circle.harmonics(),
        ranges: ranges(&channels, &map.periods.circle, &sampled),
        lines: SteadyLines::from_samples(&map.periods, &channels, &sampled, noise),
        trace,
        measured,
        reduction,
        counters: map.counters,
        warnings,
        section: Section {
            start: map.periods.time(0),
            states: map.states(&found.states),
            circle: map.periods.circle.clone(),
        },
        bases: map.periods.bases,
        multipliers: found.multipliers,
    })
}

/// The motion asked for; where none is, a stable one if there is one. Beside it the multipliers of the
/// motion of a single period, where that is another one.
fn search(
    map: &mut RotorMap<'_>,
    multiple: Option<u32>,
) -> Result<(Found, Option<Multipliers>), SteadyError> {
    let asked = map.periods.clone();
    if !asked.is_torus() {
        map.periods = asked.times(1);
    }
    let single = find(map)?;
    let stable = !matches!(map.stability(&single), Stability::Unstable(_));
    if asked.is_torus() || multiple == Some(1) || (stable && multiple.is_none()) {
        return Ok((single, None));
    }
    // what leaves a motion that is not stable begins near it; where a stable one has another beside it, at rest
    let start = match stable {
        true => DVector::zeros(map.size()),
        false => single.states.clone(),
    };
    let fits = |found: u32| found > 1 && multiple.is_none_or(|asked| asked.is_multiple_of(found));
    if let Some(found) = subharmonic(map, &start)?
        && fits(map.periods.multiple)
    {
        return Ok((found, Some(single.multipliers)));
    }
    map.periods = asked;
    if map.periods.multiple == 1 {
        return Ok((single, None));
    }
    let again = found_from(map, single.states)?;
    Ok((again, Some(single.multipliers)))
}

fn warnings(
    found: &Found,
    stability: Stability,
    measured: Option<&Measured>,
    tolerance: f64,
) -> Vec<String> {
    let largest = found.multipliers.largest();
    let left = match stability {
        Stability::Stable => None,
        Stability::Neutral => Some(
            "the motion is neutral: a multiplier of magnitude 1, as without damping; a long run stays on it only where it \
             starts there, as every free vibration beside it lasts"
                .to_owned(),
        ),
        Stability::Unstable(kind) => Some(format!(
            "the motion is not stable: a multiplier of magnitude {largest:.6} ({kind}); a long run leaves it"
        )),
    };
    let missed = measured.filter(|error| error.relative > PROMISE * tolerance);
    let missed = missed.map(|error| {
        format!(
            "the measured error is {:.1e} of the motion, more than {PROMISE} × the tolerance \
             {tolerance:.0e}: the motion rests on contact changes; tighten the tolerance",
            error.relative
        )
    });
    left.into_iter().chain(missed).collect()
}
