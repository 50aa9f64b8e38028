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

use std::f64::consts::TAU;

use serde::Serialize;

use super::Rung;
use crate::bearing::{
    BearingRotation, ContactLaw, Geometry, Matrix5, MountedBearing, Support, Vector5,
};
use crate::keys;
use crate::rotor::{
    CageMotion, FREEDOMS, Rotor, RotorDefinition, RotorError, build_supports, static_place,
};

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
            return bearing.clone();
        }
        let inertia = Rung::from(bearing).has_ball_inertia();
        let rung = match rung {
            // a frozen force knows no surfaces
            Rung::Linear if !bearing.imperfections.has_perfect_surfaces() => Rung::Hertz,
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
    for speed in speeds(rotor, question.settle)? {
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

/// Places of the cage within one ball spacing.
const CAGE_PLACES: usize = 4;

/// The bearings under some law.
struct Candidate {
    supports: Vec<Support>,
    /// Where linear bearings are frozen, and the speed there.
    frozen: (Vector5, f64),
}

impl Candidate {
    pub fn new(rotor: &RotorDefinition) -> Result<Self, RotorError> {
        let mut supports = build_supports(rotor)?;
        let place = equilibrium(rotor, &supports)?;
        for support in &mut supports {
            support.freeze(&place, rotor.speed);
        }
        Ok(Self {
            supports,
            frozen: (place, rotor.speed),
        })
    }

    /// Force and stiffness of all bearings, the cages turned by a part of their ball spacing.
    fn tangent(&self, place: &Vector5, part: f64, speed: f64) -> (Vector5, Matrix5) {
        let mut force = [0.0; FREEDOMS];
        let mut stiffness = Matrix5::zeros();
        for support in &self.supports {
            let definition = support.definition();
            let balls = definition.bearing.geometry.balls() as f64;
            let rotation = BearingRotation::at_start(speed).with_cage_at(part * TAU / balls);
            let own = support.force(place, &rotation);
            for (sum, own) in force.iter_mut().zip(own) {
                *sum += own;
            }
            stiffness += if definition.law == ContactLaw::Linear {
                let (place, speed) = &self.frozen;
                let start = BearingRotation::at_start(*speed);
                support.force_and_stiffness(place, &start).1
            } else {
                support.force_and_stiffness(place, &rotation).1
            };
        }
        (force, stiffness)
    }
}
/// Two laws side by side.
struct Pair<'a> {
    own: &'a Candidate,
    top: &'a Candidate,
    active: usize,
    arm: f64,
}

impl Pair<'_> {
    /// Differences of the forces as forces, and that of the stiffness relative to the largest.
    fn apart(&self, place: &Vector5, part: f64, speed: f64) -> (Vec<f64>, f64) {
        let (own, own_stiffness) = self.own.tangent(place, part, speed);
        let (truth, true_stiffness) = self.top.tangent(place, part, speed);
        let force = |axis: usize| (own[axis] - truth[axis]) / lever(axis, self.arm);
        let stiffness = relative(
            self.stiffest(&(own_stiffness - true_stiffness)),
            self.stiffest(&true_stiffness),
        );
        ((0..self.active).map(force).collect(), stiffness)
    }

    /// Largest entry of the active freedoms as that of a force by a displacement, N/m.
    fn stiffest(&self, matrix: &Matrix5) -> f64 {
        let all =
            (0..self.active).flat_map(|row| (0..self.active).map(move |column| (row, column)));
        let levers = |(row, column)| lever(row, self.arm) * lever(column, self.arm);
        largest(all.map(|entry| matrix[entry] / levers(entry)))
    }

    /// Adds the differences at a point to what was found.
    fn look(&self, point: &Point, cage_places: usize, found: &mut Difference) {
        let (rest, _) = self.apart(&point.places[0], 0.0, point.speed);
        for cage in 0..cage_places {
            let part = cage as f64 / CAGE_PLACES as f64;
            for place in &point.places {
                let (force, stiffness) = self.apart(place, part, point.speed);
                let whole = relative(largest(force.iter().copied()), point.force);
                found.force = found.force.max(whole);
                found.stiffness = found.stiffness.max(stiffness);
                if point.moves() {
                    let change = force.iter().zip(&rest).map(|(here, rest)| here - rest);
                    let change = relative(largest(change), point.change);
                    found.change = found.change.max(change);
                }
            }
        }
    }
}

/// Largest differences of a candidate from the top over all points.
fn difference(
    rotor: &RotorDefinition,
    candidate: &Candidate,
    top: &Candidate,
    points: &[Point],
) -> Difference {
    let pair = Pair {
        own: candidate,
        top,
        active: rotor.shaft.freedoms.count(),
        arm: Support::largest(&top.supports, Geometry::inner_groove_radius),
    };
    let mut found = Difference::default();
    for point in points {
        let rolls = rotor.cage == CageMotion::Rolling && point.moves() && point.speed > 0.0;
        let before = found.largest();
        pair.look(point, if rolls { CAGE_PLACES } else { 1 }, &mut found);
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

/// Largest motion that is looked at, in groove centre distances: beyond it the estimate is a resonance
/// without damping rather than a motion.
const LARGEST_MOTION: f64 = 0.1;

/// A speed, and the places of the shaft at it.
struct Point {
    pub speed: f64,
    /// The equilibrium first.
    pub places: Vec<Vector5>,
    /// How far the places are from it, m.
    pub reach: f64,
    /// Force that differences are relative to, N.
    pub force: f64,
    /// What the motion changes it by, N.
    pub change: f64,
}

/// The speeds at the start, the highest, and the one after the settle time.
fn speeds(rotor: &RotorDefinition, settle: Option<f64>) -> Result<Vec<f64>, RotorError> {
    let mut speeds = vec![rotor.speed];
    if let Some(settle) = settle {
        speeds.push(rotor.highest_speed());
        if rotor.drive.is_none() {
            speeds.extend(rotor.speed_profile()?.steady_from(settle));
        }
    }
    speeds.sort_by(f64::total_cmp);
    speeds.dedup();
    Ok(speeds)
}
impl Point {
    /// Whether the shaft moves there.
    pub fn moves(&self) -> bool {
        self.reach > 0.0
    }

    /// The equilibrium under the top rung at a speed, and the places around it.
    pub fn new(
        rotor: &RotorDefinition,
        question: &ContactQuestion,
        speed: f64,
    ) -> Result<Self, RotorError> {
        let steady = RotorDefinition {
            speed,
            speed_points: Vec::new(),
            drive: None,
            ..rotor.clone()
        };
        let supports = build_supports(&steady)?;
        let middle = equilibrium(&steady, &supports)?;
        let reach = reach(&steady, &supports, question)?;
        let arm = Support::largest(&supports, Geometry::inner_groove_radius);
        let active = steady.shaft.freedoms.count();
        let change = reach * stiffest_freedom(&supports, &middle, speed, active, arm);
        let bears = |support: &Support| {
            let force = support.force(&middle, &BearingRotation::at_start(speed));
            largest((0..FREEDOMS).map(|axis| force[axis] / lever(axis, arm)))
        };
        Ok(Self {
            speed,
            force: largest(supports.iter().map(bears)).max(change),
            change,
            places: around(middle, reach, active, arm),
            reach,
        })
    }
}

/// How far the shaft is estimated to move, m; zero where nothing moves.
fn reach(
    steady: &RotorDefinition,
    supports: &[Support],
    question: &ContactQuestion,
) -> Result<f64, RotorError> {
    if question.settle.is_none() {
        return Ok(0.0);
    }
    let scale = Rotor::assemble(steady)?.motion_scale(question.model_error);
    let limit = LARGEST_MOTION * Support::largest(supports, Geometry::groove_centre_distance);
    Ok(scale.length.min(limit))
}

/// A place and those on either side of it along every freedom that moves.
fn around(middle: Vector5, reach: f64, active: usize, arm: f64) -> Vec<Vector5> {
    let mut places = vec![middle];
    if reach > 0.0 {
        for axis in 0..active {
            for step in [reach, -reach] {
                let mut place = middle;
                place[axis] += step / lever(axis, arm);
                places.push(place);
            }
        }
    }
    places
}

/// Largest diagonal term of K of the active freedoms as that of a force by a displacement, N/m.
fn stiffest_freedom(
    supports: &[Support],
    place: &Vector5,
    speed: f64,
    active: usize,
    arm: f64,
) -> f64 {
    let stiffness = supports.iter().fold(Matrix5::zeros(), |sum, support| {
        let (_, own) = support.force_and_stiffness(place, &BearingRotation::at_start(speed));
        sum + own
    });
    largest((0..active).map(|axis| stiffness[(axis, axis)] / lever(axis, arm).powi(2)))
}

/// Where the shaft stands under its static load.
fn equilibrium(rotor: &RotorDefinition, supports: &[Support]) -> Result<Vector5, RotorError> {
    let load = rotor.static_load();
    let place = static_place(rotor, supports, load, &[None; FREEDOMS])?;
    Ok(place.equilibrium.displacement)
}
