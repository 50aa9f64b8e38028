//! The bearings under one of the laws, and how far they are from those under the top one.

use std::f64::consts::TAU;

use super::points::{Point, equilibrium};
use super::{Difference, largest, lever};
use crate::bearing::{BearingRotation, ContactLaw, Geometry, Matrix5, Support, Vector5};
use crate::rotor::{CageMotion, FREEDOMS, RotorDefinition, RotorError, build_supports};

/// Places of the cage within one ball spacing.
const CAGE_PLACES: usize = 4;

/// The bearings under some law.
pub(super) struct Candidate {
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
pub(super) fn difference(
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
