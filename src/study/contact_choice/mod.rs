//! The cheapest law of the contacts that a scene needs.
//!
//! At the operating points of a scene, the force and the stiffness of every cheaper rung are compared with
//! those of the top rung that the bearings' data allow. The first whose largest difference stays below
//! the error that the scene allows is chosen.
//!
//! The points are the static equilibria at the speeds of the scene (at the start, the highest, and after
//! the settle time), and around each, along every freedom that moves, the motion that is estimated from
//! unbalance, varying loads and passing balls; each with the balls at four places of the cage where it
//! rolls. Three differences count: of the force at the same displacement, relative to the largest force
//! that a bearing bears there or to what the motion changes it by where that is more; of what the force
//! changes by from the equilibrium, relative to that change, for this is what a vibration is made of;
//! and of the stiffness, relative to the largest one.
//!
//! What that does not promise: a difference in stiffness of one in a thousand moves a resonance by half
//! of that, and shifts the response near a lightly damped one by much more; traces of an irregular
//! motion part company whatever the law; and a motion that is larger than estimated (a transient through
//! a resonance, a shock) leaves the points that were looked at. `jeffcott accuracy` measures what the rungs
//! do to the motion itself.

mod candidate;
mod points;

use serde::Serialize;

use super::Rung;
use crate::bearing::MountedBearing;
use crate::keys;
use crate::rotor::{RotorDefinition, RotorError};
use candidate::{Candidate, difference};
use points::Point;

/// What a scene lets the program choose.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactQuestion {
    /// Largest difference that is allowed, relative.
    pub model_error: f64,
    /// Of which bearings the law is to be chosen; they stand on the highest rung that their data allow.
    pub open: Vec<bool>,
    /// Whether the balls must be known, so that the frozen stiffness is no choice.
    pub balls: bool,
    /// Settle time of the motion, s; `None` where nothing moves.
    pub settle: Option<f64>,
}

/// The law that was chosen, and why.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ContactChoice {
    /// Largest difference that was allowed.
    pub model_error: f64,
    /// The chosen rung.
    #[serde(serialize_with = "keys::name")]
    pub chosen: Rung,
    /// The top rung, which the others were compared with.
    #[serde(rename = "compared_with", serialize_with = "keys::name")]
    pub top: Rung,
    /// The cheaper rungs, the cheapest first.
    #[serde(rename = "cheaper")]
    pub(crate) rungs: Vec<RungDifference>,
    /// Largest motion that was looked at, m.
    #[serde(rename = "motion_looked_at_m")]
    pub motion: f64,
    /// Speeds that were looked at, rad/s.
    #[serde(rename = "speeds_looked_at_rad_s")]
    pub speeds: Vec<f64>,
    /// Why nothing could be compared, so that the top rung stays.
    pub failure: Option<String>,
}

/// How far a rung is from the top one.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RungDifference {
    /// The rung.
    #[serde(rename = "contact", serialize_with = "keys::name")]
    pub rung: Rung,
    /// Its largest differences, or why it cannot be built.
    #[serde(flatten, serialize_with = "keys::or_note")]
    pub result: Result<Difference, String>,
}

/// Largest differences from the top rung over all points.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Difference {
    /// Of the force, relative to the force on a bearing.
    #[serde(rename = "force_relative")]
    pub force: f64,
    /// Of the change of the force from the equilibrium, relative to the change in motion; zero where
    /// nothing moves.
    #[serde(rename = "force_change_relative")]
    pub change: f64,
    /// Of the stiffness, relative to the largest.
    #[serde(rename = "stiffness_relative")]
    pub stiffness: f64,
    /// Speed at which the largest of these is found, rad/s.
    #[serde(rename = "worst_at_rad_s")]
    pub speed: f64,
}

impl Difference {
    /// The largest of the three.
    pub fn largest(&self) -> f64 {
        self.force.max(self.change).max(self.stiffness)
    }
}

/// The scene with the cheapest law that stays within the allowed difference, and how it was found.
///
/// Where nothing can be compared, as without an equilibrium, the top rung stays, and whatever is asked
/// of the scene next meets the reason.
pub fn choose_contact(
    rotor: &RotorDefinition,
    question: &ContactQuestion,
) -> (RotorDefinition, ContactChoice) {
    let tops = rotor.bearings.iter().zip(&question.open);
    let tops = tops.filter(|(_, open)| **open);
    let top = tops.map(|(bearing, _)| Rung::from(bearing)).max();
    let top = top.unwrap_or(Rung::Hertz);
    let mut choice = ContactChoice {
        model_error: question.model_error,
        chosen: top,
        top,
        rungs: Vec::new(),
        motion: 0.0,
        speeds: Vec::new(),
        failure: None,
    };
    if let Err(error) = compare(rotor, question, &mut choice) {
        choice.failure = Some(error.to_string());
    }
    let fits = |rung: &&RungDifference| {
        let largest = rung.result.as_ref().map(Difference::largest);
        largest.is_ok_and(|largest| largest <= question.model_error)
    };
    let cheapest = choice.rungs.iter().find(fits).map(|fit| fit.rung);
    choice.chosen = cheapest.unwrap_or(top);
    (on_rung(rotor, question, choice.chosen), choice)
}

/// The scene with its open bearings on a rung, or on their own top one where that is lower.
fn on_rung(rotor: &RotorDefinition, question: &ContactQuestion, rung: Rung) -> RotorDefinition {
    let lower = |(bearing, open): (&MountedBearing, &bool)| {
        if !*open {
            return *bearing;
        }
        let inertia = Rung::from(bearing).has_ball_inertia();
        let rung = match rung {
            Rung::Jones if !inertia => Rung::Hertz,
            Rung::JonesFilm if !inertia => Rung::HertzFilm,
            rung => rung,
        };
        rung.of(bearing, bearing.oil)
    };
    let bearings = rotor.bearings.iter().zip(&question.open).map(lower);
    RotorDefinition {
        bearings: bearings.collect(),
        ..rotor.clone()
    }
}

/// The rungs below the top one that are different from each other.
fn cheaper(rotor: &RotorDefinition, question: &ContactQuestion, top: Rung) -> Vec<Rung> {
    let open = rotor.bearings.iter().zip(&question.open);
    let film = open
        .filter(|(_, open)| **open)
        .any(|(bearing, _)| bearing.oil.is_some());
    let useful = |rung: &Rung| {
        (film || !rung.has_film())
            && (top.has_ball_inertia() || !rung.has_ball_inertia())
            && !(question.balls && *rung == Rung::Linear)
    };
    let below = Rung::ALL.into_iter().filter(|rung| *rung < top);
    below.filter(useful).collect()
}

fn compare(
    rotor: &RotorDefinition,
    question: &ContactQuestion,
    choice: &mut ContactChoice,
) -> Result<(), RotorError> {
    let mut points = Vec::new();
    for speed in points::speeds(rotor, question.settle)? {
        let point = Point::new(rotor, question, speed)?;
        choice.motion = choice.motion.max(point.reach);
        choice.speeds.push(speed);
        points.push(point);
    }
    let top = Candidate::new(rotor)?;
    for rung in cheaper(rotor, question, choice.top) {
        let candidate = Candidate::new(&on_rung(rotor, question, rung));
        let result = candidate.map_err(|error| error.to_string());
        choice.rungs.push(RungDifference {
            rung,
            result: result.map(|candidate| difference(rotor, &candidate, &top, &points)),
        });
    }
    Ok(())
}

fn lever(axis: usize, arm: f64) -> f64 {
    if axis < 3 { 1.0 } else { arm }
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.map(f64::abs).fold(0.0, f64::max)
}
