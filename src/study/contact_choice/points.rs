//! Where the laws are compared: the speeds of a scene, and the places of the shaft at each.

use super::{ContactQuestion, largest, lever};
use crate::bearing::{BearingRotation, Geometry, Matrix5, Support, Vector5};
use crate::rotor::{FREEDOMS, Rotor, RotorDefinition, RotorError, build_supports, static_place};

/// Largest motion that is looked at, in groove centre distances: beyond it the estimate is a resonance
/// without damping rather than a motion.
const LARGEST_MOTION: f64 = 0.1;

/// A speed, and the places of the shaft at it.
pub(super) struct Point {
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
pub(super) fn speeds(rotor: &RotorDefinition, settle: Option<f64>) -> Result<Vec<f64>, RotorError> {
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
pub(super) fn equilibrium(
    rotor: &RotorDefinition,
    supports: &[Support],
) -> Result<Vector5, RotorError> {
    let load = rotor.static_load();
    let place = static_place(rotor, supports, load, &[None; FREEDOMS])?;
    Ok(place.equilibrium.displacement)
}
