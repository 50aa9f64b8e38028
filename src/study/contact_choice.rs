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

use super::Rung;
use crate::bearing::equilibrium::StaticProblem;
use crate::bearing::{CageAngle, ContactLaw, Geometry, Matrix5, MountedBearing, Support, Vector5};
use crate::rotor::{
    CageMotion, FREEDOMS, Rotor, RotorDefinition, RotorError, build_supports, static_start,
};

/// Places of the cage within one ball spacing.
const CAGE_PLACES: usize = 4;
/// Largest motion that is looked at, in groove centre distances: beyond it the estimate is a resonance
/// without damping rather than a motion.
const LARGEST_MOTION: f64 = 0.1;

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
#[derive(Debug, Clone, PartialEq)]
pub struct ContactChoice {
    /// Largest difference that was allowed.
    pub model_error: f64,
    /// The chosen rung.
    pub chosen: Rung,
    /// The top rung, which the others were compared with.
    pub top: Rung,
    /// The cheaper rungs, the cheapest first.
    pub rungs: Vec<RungDifference>,
    /// Largest motion that was looked at, m.
    pub motion: f64,
    /// Speeds that were looked at, rad/s.
    pub speeds: Vec<f64>,
    /// Why nothing could be compared, so that the top rung stays.
    pub failure: Option<String>,
}

/// How far a rung is from the top one.
#[derive(Debug, Clone, PartialEq)]
pub struct RungDifference {
    /// The rung.
    pub rung: Rung,
    /// Its largest differences, or why it cannot be built.
    pub result: Result<Difference, String>,
}

/// Largest differences from the top rung over all points.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Difference {
    /// Of the force, relative to the force on a bearing.
    pub force: f64,
    /// Of the change of the force from the equilibrium, relative to the change in motion; zero where
    /// nothing moves.
    pub change: f64,
    /// Of the stiffness, relative to the largest.
    pub stiffness: f64,
    /// Speed at which the largest of these is found, rad/s.
    pub speed: f64,
}

impl Difference {
    /// The largest of the three.
    pub fn largest(&self) -> f64 {
        self.force.max(self.change).max(self.stiffness)
    }
}

/// A speed, and the places of the shaft at it.
struct Point {
    speed: f64,
    /// The equilibrium first.
    places: Vec<Vector5>,
    /// Force that differences are relative to, N.
    force: f64,
    /// What the motion changes it by, N.
    change: f64,
}

/// The bearings under some law.
struct Candidate {
    supports: Vec<Support>,
    /// Where linear bearings are frozen, and the speed there.
    frozen: (Vector5, f64),
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
    for speed in speeds(rotor, question.settle)? {
        points.push(point(rotor, question, speed, &mut choice.motion)?);
        choice.speeds.push(speed);
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

/// The equilibrium under the top rung at a speed and the places around it.
fn point(
    rotor: &RotorDefinition,
    question: &ContactQuestion,
    speed: f64,
    motion: &mut f64,
) -> Result<Point, RotorError> {
    let steady = RotorDefinition {
        speed,
        speed_points: Vec::new(),
        drive: None,
        ..rotor.clone()
    };
    let supports = build_supports(&steady)?;
    let middle = equilibrium(&steady, &supports)?;
    let arm = Support::largest(&supports, Geometry::inner_groove_radius);
    let limit = LARGEST_MOTION * Support::largest(&supports, Geometry::groove_centre_distance);
    let reach = match question.settle {
        Some(_) => Rotor::assemble(&steady)?
            .motion_scale(question.model_error)
            .length
            .min(limit),
        None => 0.0,
    };
    *motion = motion.max(reach);
    let mut places = vec![middle];
    if reach > 0.0 {
        for axis in 0..steady.shaft.freedoms.count() {
            for step in [reach, -reach] {
                let mut place = middle;
                place[axis] += step / lever(axis, arm);
                places.push(place);
            }
        }
    }
    let bears = |support: &Support| {
        let force = support.force(&middle, CageAngle::START, speed);
        largest((0..FREEDOMS).map(|axis| force[axis] / lever(axis, arm)))
    };
    let stiffness = supports.iter().fold(Matrix5::zeros(), |sum, support| {
        sum + support
            .force_and_stiffness(&middle, CageAngle::START, speed)
            .1
    });
    let changes = (0..steady.shaft.freedoms.count())
        .map(|axis| reach * stiffness[(axis, axis)] / lever(axis, arm).powi(2));
    let change = largest(changes);
    Ok(Point {
        speed,
        force: largest(supports.iter().map(bears)).max(change),
        change,
        places,
    })
}

fn equilibrium(rotor: &RotorDefinition, supports: &[Support]) -> Result<Vector5, RotorError> {
    let load = rotor.static_load();
    let (free, start) = static_start(rotor, supports, load[2]);
    let speed = rotor.speed;
    let problem = StaticProblem {
        supports,
        load,
        free,
        start,
        speed,
    };
    Ok(problem.solve()?.displacement)
}

impl Candidate {
    fn new(rotor: &RotorDefinition) -> Result<Self, RotorError> {
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
            let cage = CageAngle::new(part * TAU / balls);
            let own = support.force(place, cage, speed);
            for (sum, own) in force.iter_mut().zip(own) {
                *sum += own;
            }
            stiffness += if definition.law == ContactLaw::Linear {
                let (place, speed) = &self.frozen;
                support
                    .force_and_stiffness(place, CageAngle::START, *speed)
                    .1
            } else {
                support.force_and_stiffness(place, cage, speed).1
            };
        }
        (force, stiffness)
    }
}

/// Largest differences of a candidate from the top over all points.
fn difference(
    rotor: &RotorDefinition,
    candidate: &Candidate,
    top: &Candidate,
    points: &[Point],
) -> Difference {
    let kept = rotor.shaft.freedoms.count();
    let arm = Support::largest(&top.supports, Geometry::inner_groove_radius);
    let apart = |place: &Vector5, part: f64, speed: f64| {
        let (own, own_stiffness) = candidate.tangent(place, part, speed);
        let (truth, true_stiffness) = top.tangent(place, part, speed);
        let force: Vec<f64> = (0..kept)
            .map(|axis| (own[axis] - truth[axis]) / lever(axis, arm))
            .collect();
        let stiffness = relative(
            stiffest(&(own_stiffness - true_stiffness), kept, arm),
            stiffest(&true_stiffness, kept, arm),
        );
        (force, stiffness)
    };
    let mut found = Difference::default();
    for point in points {
        let moves = point.places.len() > 1;
        let rolls = moves && rotor.cage == CageMotion::Rolling && point.speed > 0.0;
        let before = found.largest();
        let (rest, _) = apart(&point.places[0], 0.0, point.speed);
        for cage in 0..if rolls { CAGE_PLACES } else { 1 } {
            let part = cage as f64 / CAGE_PLACES as f64;
            for place in &point.places {
                let (force, stiffness) = apart(place, part, point.speed);
                found.force = found
                    .force
                    .max(relative(largest(force.iter().copied()), point.force));
                found.stiffness = found.stiffness.max(stiffness);
                if moves {
                    let change = force.iter().zip(&rest).map(|(here, rest)| here - rest);
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

/// Largest entry of the kept freedoms as that of a force by a displacement, N/m.
fn stiffest(matrix: &Matrix5, kept: usize, arm: f64) -> f64 {
    let all = (0..kept).flat_map(|row| (0..kept).map(move |column| (row, column)));
    largest(all.map(|(row, column)| matrix[(row, column)] / (lever(row, arm) * lever(column, arm))))
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

fn lever(axis: usize, arm: f64) -> f64 {
    if axis < 3 { 1.0 } else { arm }
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.map(f64::abs).fold(0.0, f64::max)
}
