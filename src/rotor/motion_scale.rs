//! How large the motion will be: what a tolerance is relative to.

use std::f64::consts::TAU;

use nalgebra::{Complex, DMatrix, DVector};

use super::motion::AttachedBearing;
use super::static_search::POSITION_ROUND_OFF;
use super::structure::UnbalancedPoint;
use super::unconstrained::NOTHING;
use super::{CageMotion, Rotor};
use crate::bearing::{BearingRotation, Geometry, Support};

/// Smallest error of a position that a tolerance can ask for, relative to the groove centre distance.
const SMALLEST_ERROR: f64 = 4.0 * f64::EPSILON;
/// Positions of the cage within one ball spacing at which the varying force is looked at.
const CAGE_POSITIONS: usize = 8;

/// Length and time that make the states of the integration numbers of order one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionScale {
    /// Length of the motion, m.
    pub length: f64,
    /// Length that turns tilts into displacements, m.
    pub arm: f64,
    /// Angular frequency that turns velocities into displacements, rad/s: the highest of speed and
    /// natural frequencies, with that of the shaft on one contact where nothing holds it.
    pub frequency: f64,
}

impl MotionScale {
    /// Length that turns component `axis` of x, y, z, θx, θy into a displacement.
    pub fn lever(&self, axis: usize) -> f64 {
        if axis < 3 { 1.0 } else { self.arm }
    }
}

impl Rotor {
    /// Estimates the motion before it is known, from the linearised rotor.
    ///
    /// The length is the largest of: the forced response to unbalance, to the varying loads and to
    /// the force that varies with the cage angle, and the distance of the initial state from
    /// equilibrium. Where the speed varies, unbalance counts at the points of its profile: a
    /// resonance that is passed in between leaves the length, and with it the error, smaller. A
    /// shock counts as a steady vibration of its length, which is less than what it excites. The
    /// length is at least so large that `tolerance` times the length stays above the round-off of a position.
    pub fn motion_scale(&self, tolerance: f64) -> MotionScale {
        let arm = Support::largest(&self.supports, Geometry::inner_groove_radius);
        let frequency = self.highest_frequency();
        let smallest = SMALLEST_ERROR / tolerance * self.groove_centre_distance();
        let length = smallest
            .max(self.unbalance_response(arm))
            .max(self.load_response(arm))
            .max(self.varying_compliance(arm))
            .max(self.initial_distance(arm, frequency));
        MotionScale {
            length,
            arm,
            frequency,
        }
    }

    /// Round-off of a displacement in a motion, m: that of the positions between the races, from which the forces
    /// follow. No two passes of a method show it, for they share it.
    pub(crate) fn displacement_round_off(&self) -> f64 {
        POSITION_ROUND_OFF * self.groove_centre_distance()
    }

    /// Highest natural frequency of a freedom by itself, rad/s, or the speed where that is higher;
    /// where nothing resists at the equilibrium, as in the middle of a clearance, that of the shaft on one
    /// contact.
    fn highest_frequency(&self) -> f64 {
        let highest = (0..self.dofs())
            .map(|dof| (self.tangent[(dof, dof)].max(0.0) / self.mass.entry(dof, dof)).sqrt())
            .fold(0.0, f64::max);
        let natural = match highest {
            0.0 => (self.contact_stiffness() / self.shaft_mass).sqrt(),
            highest => highest,
        };
        natural.max(self.highest_speed())
    }

    /// Angular frequency that makes velocities of displacements, rad/s: that of the scale; of a structure with housings,
    /// whose natural frequencies lie far apart, the lowest, so that no slow motion is allowed the velocities of a fast one.
    pub(super) fn velocity_rate(&self, scale: &MotionScale) -> f64 {
        if self.rigid {
            return scale.frequency;
        }
        let modes = self.modes();
        let natural = modes.iter().map(|mode| mode.eigenvalue.norm());
        let lowest = natural
            .filter(|rate| *rate > 0.0)
            .fold(f64::INFINITY, f64::min);
        lowest.max(self.highest_speed()).min(scale.frequency)
    }

    fn groove_centre_distance(&self) -> f64 {
        Support::largest(&self.supports, Geometry::groove_centre_distance)
    }

    /// Estimated amplitudes of the degrees of freedom under unbalance and loads at a speed of the shaft in rad/s, m and
    /// rad. A shaft that starts beside this motion has free vibrations of these amplitudes besides.
    pub(super) fn forced_amplitudes(&self, speed: f64) -> Vec<f64> {
        let mut sum = vec![0.0; self.dofs()];
        let unbalance = self.unbalance_phasor(speed);
        add_sizes(&mut sum, &self.amplitudes(unbalance, speed, speed));
        for (frequency, force) in self.load_vibrations(speed) {
            add_sizes(&mut sum, &self.amplitudes(force, frequency, speed));
        }
        sum
    }

    /// Estimated amplitudes of the degrees of freedom about the static equilibrium at a speed of the shaft in rad/s, m and
    /// rad: the sum of what [`Rotor::motion_scale`] takes the largest of.
    pub(super) fn amplitude_estimate(&self, speed: f64) -> Vec<f64> {
        let mut sum = self.forced_amplitudes(speed);
        let mut passing = vec![0.0_f64; self.dofs()];
        for shift in self.passing_shifts() {
            for (passing, shift) in passing.iter_mut().zip(shift.iter()) {
                *passing = passing.max(shift.abs());
            }
        }
        add_sizes(&mut sum, &passing);
        let [shift, velocity] = self.initial_deviation();
        let frequency = self.highest_frequency();
        add_sizes(&mut sum, &shift);
        let swept: Vec<f64> = velocity
            .iter()
            .map(|velocity| velocity / frequency)
            .collect();
        add_sizes(&mut sum, &swept);
        sum
    }

    /// Displacement from the static equilibrium and velocity of the degrees of freedom at t = 0.
    fn initial_deviation(&self) -> [Vec<f64>; 2] {
        let (start, dofs) = (self.start(), self.dofs());
        let places = start[..dofs].iter().zip(&self.rest);
        [
            places.map(|(place, rest)| place - rest).collect(),
            start[dofs..2 * dofs].to_vec(),
        ]
    }

    /// Forces of the unbalances on the degrees of freedom at a speed as complex amplitudes.
    pub(super) fn unbalance_phasor(&self, speed: f64) -> DVector<Complex<f64>> {
        let mut sum = DVector::zeros(self.dofs());
        for UnbalancedPoint { point, unbalance } in &self.structure.unbalances {
            point.add_phasor(&unbalance.phasor(speed), sum.as_mut_slice());
        }
        sum
    }

    /// Angular frequency of each varying load at a speed of the shaft, and its forces on the degrees of freedom.
    pub(super) fn load_vibrations(&self, speed: f64) -> Vec<(f64, DVector<Complex<f64>>)> {
        let loads = self.loads.iter().zip(&self.structure.load_places);
        loads
            .map(|(load, place)| {
                let vibration = load.main_vibration();
                let mut force = DVector::zeros(self.dofs());
                if load.acts_on_mass() {
                    self.add_base_force(&vibration.amplitude, force.as_mut_slice());
                } else {
                    place.add_force(&vibration.amplitude, force.as_mut_slice());
                }
                let frequency = vibration.frequency + vibration.order * speed;
                (frequency, force.map(Complex::from))
            })
            .collect()
    }

    /// Largest amplitude under the unbalance at the speeds of the profile.
    fn unbalance_response(&self, arm: f64) -> f64 {
        let response = |speed: f64| {
            let force = self.unbalance_phasor(speed);
            self.largest(&self.amplitudes(force, speed, speed), arm)
        };
        let speeds = self.speed.points().map(|point| point.speed);
        speeds
            .chain([self.highest_speed()])
            .map(response)
            .fold(0.0, f64::max)
    }

    /// Largest amplitude under each of the varying loads by itself.
    fn load_response(&self, arm: f64) -> f64 {
        let speed = self.highest_speed();
        let vibrations = self.load_vibrations(speed).into_iter();
        vibrations
            .map(|(frequency, force)| self.largest(&self.amplitudes(force, frequency, speed), arm))
            .fold(0.0, f64::max)
    }

    /// Amplitudes of the degrees of freedom under forces of angular frequency ω while the shaft turns at Ω,
    /// `|(K − ω²M + iω(C + ΩG))⁻¹ F|`; none at an undamped resonance.
    fn amplitudes(&self, force: DVector<Complex<f64>>, omega: f64, speed: f64) -> Vec<f64> {
        let dofs = self.dofs();
        let dynamic = DMatrix::from_fn(dofs, dofs, |row, column| {
            let inertia = omega * omega * self.mass.entry(row, column);
            let rate = self.rate_entry(row, column, speed);
            let turning = speed * self.circulatory.entries()[(row, column)];
            Complex::new(
                self.tangent[(row, column)] - turning - inertia,
                omega * rate,
            )
        });
        let response = dynamic.lu().solve(&force);
        response.map_or_else(Vec::new, |response| {
            response.iter().map(|part| part.norm()).collect()
        })
    }

    /// Static displacement under the change of force as the cage turns by one ball spacing.
    fn varying_compliance(&self, arm: f64) -> f64 {
        self.passing_shifts()
            .iter()
            .map(|shift| self.largest(shift.as_slice(), arm))
            .fold(0.0, f64::max)
    }

    /// These displacements of the degrees of freedom at some positions of the cage; none in a direction that nothing
    /// holds.
    fn passing_shifts(&self) -> Vec<DVector<f64>> {
        let imperfect = self.supports.iter().any(Support::is_imperfect);
        let still = self.cage == CageMotion::Frozen && !imperfect;
        if still || self.highest_speed() == 0.0 {
            return Vec::new();
        }
        let dofs = self.dofs();
        let stiffness = self.tangent.view((0, 0), (dofs, dofs)).into_owned();
        let least = NOTHING * self.contact_stiffness();
        let factors = stiffness.svd(true, true);
        let mut changes = self.imperfect_changes();
        if self.cage == CageMotion::Rolling {
            let parts = 1..CAGE_POSITIONS;
            changes.extend(
                parts.map(|position| self.force_change(position as f64 / CAGE_POSITIONS as f64)),
            );
        }
        let shift = |change| factors.solve(&change, least).ok();
        changes.into_iter().filter_map(shift).collect()
    }

    /// Change of the forces on the degrees of freedom at the equilibrium when every cage has turned by a part of its ball
    /// spacing.
    fn force_change(&self, part: f64) -> DVector<f64> {
        let dofs = self.dofs();
        let mut sum = DVector::zeros(dofs);
        for bearing in self.bearings() {
            let place = bearing.displacement(&self.rest[..dofs]);
            let spacing = TAU / bearing.support.definition().bearing.geometry.balls() as f64;
            let start = BearingRotation::at_start(self.speed());
            let turned = bearing
                .support
                .force(&place, &start.with_cage_at(part * spacing));
            let still = bearing.support.force(&place, &start);
            let change = std::array::from_fn(|axis| turned[axis] - still[axis]);
            bearing
                .attachment
                .add_force(1.0, &change, sum.as_mut_slice());
        }
        sum
    }

    /// Changes of the forces as imperfect surfaces pass under the balls of each bearing by itself.
    fn imperfect_changes(&self) -> Vec<DVector<f64>> {
        let dofs = self.dofs();
        let change = |bearing: AttachedBearing<'_>, seen: &BearingRotation| {
            let place = bearing.displacement(&self.rest[..dofs]);
            let still = BearingRotation::at_start(self.speed());
            let [passing, still] = [seen, &still].map(|seen| bearing.support.force(&place, seen));
            let change = std::array::from_fn(|axis| passing[axis] - still[axis]);
            let mut sum = DVector::zeros(dofs);
            bearing
                .attachment
                .add_force(1.0, &change, sum.as_mut_slice());
            sum
        };
        self.bearings()
            .flat_map(|bearing| {
                let rotations = self.imperfect_rotations(bearing);
                rotations
                    .into_iter()
                    .map(move |seen| change(bearing, &seen))
                    .collect::<Vec<_>>()
            })
            .collect()
    }

    /// Largest of these changes in every degree of freedom.
    pub(super) fn passing_force(&self) -> DVector<f64> {
        let changes = (1..CAGE_POSITIONS).map(|position| {
            self.force_change(position as f64 / CAGE_POSITIONS as f64)
                .abs()
        });
        changes.fold(DVector::zeros(self.dofs()), |largest, change| {
            largest.sup(&change)
        })
    }

    fn initial_distance(&self, arm: f64, frequency: f64) -> f64 {
        let [shift, velocity] = self.initial_deviation();
        let reach: Vec<f64> = velocity
            .iter()
            .map(|velocity| velocity / frequency)
            .collect();
        self.largest(&shift, arm).max(self.largest(&reach, arm))
    }

    /// Largest component as a displacement; what is not a number does not count.
    fn largest(&self, components: &[f64], arm: f64) -> f64 {
        let coordinates = self.structure.coordinates.iter();
        components
            .iter()
            .zip(coordinates)
            .map(|(value, coordinate)| value.abs() * coordinate.length(arm))
            .filter(|value| value.is_finite())
            .fold(0.0, f64::max)
    }
}

/// Adds the magnitudes of amplitudes to others.
fn add_sizes(sum: &mut [f64], amplitudes: &[f64]) {
    for (sum, amplitude) in sum.iter_mut().zip(amplitudes) {
        *sum += amplitude.abs();
    }
}
