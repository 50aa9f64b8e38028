//! The cheapest law of the contacts that a scene needs.
//!
//! At the operating points of a scene, the force and the stiffness of every cheaper fidelity level are compared with
//! those of the highest level that the bearings' data allow. The first whose largest difference stays below
//! the error that the scene allows is chosen.
//!
//! The points are the static equilibria at the speeds of the scene (at the start, the highest, and after
//! the settle time), and around each, along every freedom that moves, the motion that is estimated from
//! unbalance, varying loads and passing balls; each with the balls at four positions of the cage where it
//! rolls. Three differences count: of the force at the same displacement, relative to the largest force
//! that a bearing bears there or to what the motion changes it by where that is more; of what the force
//! changes by from the equilibrium, relative to that change, for this is what a vibration is made of;
//! and of the stiffness, relative to the largest one.
//!
//! What that does not promise: a difference in stiffness of one in a thousand moves a resonance by half
//! of that, and shifts the response near a lightly damped one by much more; traces of an irregular
//! motion diverge whatever the law; and a motion that is larger than estimated (a transient through
//! a resonance, a shock) leaves the points that were compared. `jeffcott accuracy` measures what the levels
//! do to the motion itself.

use std::f64::consts::TAU;

use nalgebra::DMatrix;
use serde::Serialize;

use super::Fidelity;
use super::contact_points::{Point, speeds};
use crate::bearing::{
    BearingRotation, ContactLaw, Geometry, Matrix5, MountedBearing, Support, Vector5,
};
use crate::keys;
use crate::rotor::{
    Attachment, FREEDOMS, RotorDefinition, RotorError, build_supports, static_place,
};

/// What a scene lets the program choose.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactQuestion {
    /// Largest difference that is allowed, relative.
    pub model_error: f64,
    /// Of which bearings the law is to be chosen; they have the highest level that their data allow.
    pub open: Vec<bool>,
    /// Whether the balls must be known, so that the frozen stiffness is no choice.
    pub balls: bool,
    /// Settle time of the motion, s; `None` where nothing moves.
    pub settle: Option<f64>,
}

/// The law that was chosen, and why.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ContactChoice {
    /// Largest difference that was allowed.
    pub model_error: f64,
    /// The chosen level.
    #[serde(serialize_with = "keys::name")]
    pub chosen: Fidelity,
    /// The highest level, which the others were compared with.
    #[serde(rename = "compared_with", serialize_with = "keys::name")]
    pub top: Fidelity,
    /// The cheaper levels, the cheapest first.
    pub(crate) cheaper: Vec<FidelityDifference>,
    /// Largest motion that was considered, m.
    #[serde(rename = "motion_looked_at_m")]
    pub motion: f64,
    /// Speeds that were considered, rad/s.
    #[serde(rename = "speeds_looked_at_rad_s")]
    pub speeds: Vec<f64>,
    /// Why nothing could be compared, so that the top fidelity stays.
    pub failure: Option<String>,
}

/// How far a fidelity level is from the highest one.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FidelityDifference {
    /// The level.
    #[serde(rename = "contact", serialize_with = "keys::name")]
    pub fidelity: Fidelity,
    /// Its largest differences, or why it cannot be built.
    #[serde(flatten, serialize_with = "keys::or_note")]
    pub result: Result<Difference, String>,
}

/// Largest differences from the highest level over all points.
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
/// Where nothing can be compared, as without an equilibrium, the highest level stays, and whatever is asked
/// of the scene next meets the reason.
pub fn choose_contact(
    rotor: &RotorDefinition,
    question: &ContactQuestion,
) -> (RotorDefinition, ContactChoice) {
    let top = open_bearings(rotor, question).map(Fidelity::from).max();
    let top = top.unwrap_or(Fidelity::Hertz);
    let mut choice = ContactChoice {
        model_error: question.model_error,
        chosen: top,
        top,
        cheaper: Vec::new(),
        motion: 0.0,
        speeds: Vec::new(),
        failure: None,
    };
    if let Err(error) = compare(rotor, question, &mut choice) {
        choice.failure = Some(error.to_string());
    }
    let fits = |fidelity: &&FidelityDifference| {
        let largest = fidelity.result.as_ref().map(Difference::largest);
        largest.is_ok_and(|largest| largest <= question.model_error)
    };
    let cheapest = choice.cheaper.iter().find(fits).map(|fit| fit.fidelity);
    choice.chosen = cheapest.unwrap_or(top);
    (at_level(rotor, question, choice.chosen), choice)
}

/// The bearings whose law is to be chosen.
fn open_bearings<'a>(
    rotor: &'a RotorDefinition,
    question: &'a ContactQuestion,
) -> impl Iterator<Item = &'a MountedBearing> {
    let all = rotor.bearings.iter().zip(&question.open);
    all.filter(|(_, open)| **open).map(|(bearing, _)| bearing)
}

/// The scene with its open bearings at a level, or at their own highest one where that is lower.
fn at_level(
    rotor: &RotorDefinition,
    question: &ContactQuestion,
    fidelity: Fidelity,
) -> RotorDefinition {
    let lower = |(bearing, open): (&MountedBearing, &bool)| {
        if !*open {
            return bearing.clone();
        }
        let inertia = Fidelity::from(bearing).has_ball_inertia();
        let fidelity = match fidelity {
            // a frozen force knows no surfaces
            Fidelity::Linear if !bearing.imperfections.has_perfect_surfaces() => Fidelity::Hertz,
            Fidelity::Jones if !inertia => Fidelity::Hertz,
            Fidelity::JonesFilm if !inertia => Fidelity::HertzFilm,
            fidelity => fidelity,
        };
        fidelity.applied_to(bearing, bearing.oil)
    };
    let bearings = rotor.bearings.iter().zip(&question.open).map(lower);
    RotorDefinition {
        bearings: bearings.collect(),
        ..rotor.clone()
    }
}

/// The levels below the highest one that are different from each other.
fn cheaper(rotor: &RotorDefinition, question: &ContactQuestion, top: Fidelity) -> Vec<Fidelity> {
    let film = open_bearings(rotor, question).any(|bearing| bearing.oil.is_some());
    let useful = |fidelity: &Fidelity| {
        (film || !fidelity.has_film())
            && (top.has_ball_inertia() || !fidelity.has_ball_inertia())
            && !(question.balls && *fidelity == Fidelity::Linear)
    };
    let below = Fidelity::ALL.into_iter().filter(|fidelity| *fidelity < top);
    below.filter(useful).collect()
}

fn compare(
    rotor: &RotorDefinition,
    question: &ContactQuestion,
    choice: &mut ContactChoice,
) -> Result<(), RotorError> {
    let mut points = Vec::new();
    for speed in speeds(rotor, question.settle)? {
        let point = Point::new(rotor, question, speed)?;
        choice.motion = choice.motion.max(point.reach);
        choice.speeds.push(speed);
        points.push(point);
    }
    let top = Candidate::new(rotor)?;
    for fidelity in cheaper(rotor, question, choice.top) {
        let candidate = Candidate::new(&at_level(rotor, question, fidelity));
        let result = candidate.map_err(|error| error.to_string());
        choice.cheaper.push(FidelityDifference {
            fidelity,
            result: result.map(|candidate| difference(rotor, &candidate, &top, &points)),
        });
    }
    Ok(())
}

pub(super) fn lever(axis: usize, arm: f64) -> f64 {
    if axis < 3 { 1.0 } else { arm }
}

pub(super) fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.map(f64::abs).fold(0.0, f64::max)
}

/// Places of the cage within one ball spacing.
const CAGE_POSITIONS: usize = 4;

/// The bearings under some law.
pub(super) struct Candidate {
    pub supports: Vec<Support>,
    /// Where they sit on the shaft, taken as rigid.
    pub attachments: Vec<Attachment>,
    /// Where linear bearings are frozen, and the speed there.
    pub frozen: (Vector5, f64),
}

impl Candidate {
    pub fn new(rotor: &RotorDefinition) -> Result<Self, RotorError> {
        let mut supports = build_supports(rotor)?;
        let found = static_place(rotor, &supports, false, &[None; FREEDOMS])?;
        let position = found.equilibrium.displacement;
        let attachments = rotor.rigid_attachments();
        for (support, attachment) in supports.iter_mut().zip(&attachments) {
            support.freeze(&attachment.displacement(&position, &[]), rotor.speed);
        }
        Ok(Self {
            supports,
            attachments,
            frozen: (position, rotor.speed),
        })
    }

    /// Length that turns tilts into displacements, m.
    pub fn arm(&self) -> f64 {
        Support::largest(&self.supports, Geometry::lever)
    }

    /// Force and stiffness of all bearings, the cages turned by a part of their ball spacing.
    pub fn tangent(&self, position: &Vector5, part: f64, speed: f64) -> (Vector5, Matrix5) {
        let mut force = [0.0; FREEDOMS];
        let mut stiffness = DMatrix::zeros(FREEDOMS, FREEDOMS);
        for (support, attachment) in self.supports.iter().zip(&self.attachments) {
            let definition = support.definition();
            let balls = definition.bearing.geometry.balls() as f64;
            let rotation = BearingRotation::at_start(speed).with_cage_at(part * TAU / balls);
            let own = support.force(&attachment.displacement(position, &[]), &rotation);
            attachment.add_force(1.0, &own, &mut force);
            let (position, rotation) = if definition.law == ContactLaw::Linear {
                let (position, speed) = &self.frozen;
                (position, BearingRotation::at_start(*speed))
            } else {
                (position, rotation)
            };
            let displacement = attachment.displacement(position, &[]);
            let own = support.tangent(&displacement, &rotation);
            attachment.add_stiffness(&own.stiffness, &mut stiffness);
        }
        (
            force,
            Matrix5::from_fn(|row, column| stiffness[(row, column)]),
        )
    }
}

/// Largest differences of a candidate from the top over all points.
fn difference(
    rotor: &RotorDefinition,
    candidate: &Candidate,
    top: &Candidate,
    points: &[Point],
) -> Difference {
    let active = rotor.shaft.freedoms.axes();
    let arm = top.arm();
    // the largest entry of the active freedoms as that of a force by a displacement, N/m
    let stiffest = |matrix: &Matrix5| {
        let entries = active
            .iter()
            .flat_map(|row| active.iter().map(|column| (*row, *column)));
        let levers = |(row, column)| lever(row, arm) * lever(column, arm);
        largest(entries.map(|entry| matrix[entry] / levers(entry)))
    };
    // differences of the forces as forces, and that of the stiffness relative to the largest
    let apart = |position: &Vector5, part: f64, speed: f64| {
        let (own, own_stiffness) = candidate.tangent(position, part, speed);
        let (truth, true_stiffness) = top.tangent(position, part, speed);
        let forces = active
            .iter()
            .map(|&axis| (own[axis] - truth[axis]) / lever(axis, arm));
        let stiffness = stiffest(&(own_stiffness - true_stiffness));
        let forces: Vec<f64> = forces.collect();
        (forces, relative(stiffness, stiffest(&true_stiffness)))
    };
    let mut found = Difference::default();
    for point in points {
        let rolls = rotor.cage.turns() && point.moves() && point.speed > 0.0;
        let before = found.largest();
        let (rest, _) = apart(&point.positions[0], 0.0, point.speed);
        for cage in 0..if rolls { CAGE_POSITIONS } else { 1 } {
            let part = cage as f64 / CAGE_POSITIONS as f64;
            for position in &point.positions {
                let (forces, stiffness) = apart(position, part, point.speed);
                let whole = relative(largest(forces.iter().copied()), point.force);
                found.force = found.force.max(whole);
                found.stiffness = found.stiffness.max(stiffness);
                if point.moves() {
                    let change = forces.iter().zip(&rest).map(|(here, rest)| here - rest);
                    let change = relative(largest(change), point.change);
                    found.change = found.change.max(change);
                }
            }
        }
        if found.largest() > before {
            found.speed = point.speed;
        }
    }
    found
}

/// Nothing differs by nothing; something from nothing by all.
fn relative(difference: f64, size: f64) -> f64 {
    if difference == 0.0 {
        0.0
    } else if size > 0.0 && difference.is_finite() {
        difference / size
    } else {
        f64::INFINITY
    }
}
