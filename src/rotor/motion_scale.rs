//! How large the motion will be: what a tolerance is relative to.

use nalgebra::{Complex, DMatrix, DVector};

use super::loose::NOTHING;
use super::{CageMotion, FREEDOMS, Load, Rotor};
use crate::bearing::{BearingRotation, Geometry, Support};

/// Round-off of a position between the races, relative to the groove centre distance.
const POSITION_ROUND_OFF: f64 = 4.0 * f64::EPSILON;
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
        lever(axis, self.arm)
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
        let smallest = POSITION_ROUND_OFF / tolerance * self.groove_centre_distance();
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

    /// Highest natural frequency of a freedom by itself, rad/s, or the speed where that is higher;
    /// where nothing resists at the equilibrium, as in the middle of a clearance, that of the shaft on one
    /// contact.
    fn highest_frequency(&self) -> f64 {
        let stiffness = &self.equilibrium.stiffness;
        let highest = (0..self.kept)
            .map(|axis| (stiffness[(axis, axis)].max(0.0) * self.inverse_mass[axis]).sqrt())
            .fold(0.0, f64::max);
        let natural = match highest {
            0.0 => (self.contact_stiffness() * self.inverse_mass[0]).sqrt(),
            highest => highest,
        };
        natural.max(self.highest_speed())
    }

    fn groove_centre_distance(&self) -> f64 {
        Support::largest(&self.supports, Geometry::groove_centre_distance)
    }

    /// Estimated amplitudes of the kept freedoms about the static equilibrium at a speed of the shaft in rad/s, m and
    /// rad: the sum of what [`Rotor::motion_scale`] takes the largest of.
    pub(super) fn amplitude_estimate(&self, speed: f64) -> [f64; FREEDOMS] {
        let mut swing = [0.0; FREEDOMS];
        let mut add = |part: &mut dyn Iterator<Item = f64>| {
            for (swing, part) in swing.iter_mut().zip(part) {
                *swing += part.abs();
            }
        };
        add(&mut self
            .amplitudes(&self.unbalance_phasor(speed), speed, speed)
            .into_iter());
        for load in &self.loads {
            let load = load.swing(self.mass[0]);
            let force = load.amplitude.map(|force| Complex::new(force, 0.0));
            let frequency = load.frequency + load.order * speed;
            add(&mut self.amplitudes(&force, frequency, speed).into_iter());
        }
        let mut passing = [0.0_f64; FREEDOMS];
        for shift in self.passing_shifts() {
            for (passing, shift) in passing.iter_mut().zip(shift.iter()) {
                *passing = passing.max(shift.abs());
            }
        }
        add(&mut passing.into_iter());
        let ([place, velocity], frequency) = (&self.initial, self.highest_frequency());
        add(&mut (0..self.kept).map(|axis| place[axis] - self.equilibrium.displacement[axis]));
        add(&mut velocity.iter().map(|velocity| velocity / frequency));
        swing
    }

    /// Force of the unbalance at a speed as complex amplitudes, N.
    fn unbalance_phasor(&self, speed: f64) -> [Complex<f64>; FREEDOMS] {
        let [x, y] = self.unbalance.phasor(speed);
        [x, y, Complex::ZERO, Complex::ZERO, Complex::ZERO]
    }

    /// Largest amplitude under the unbalance at the speeds of the profile.
    fn unbalance_response(&self, arm: f64) -> f64 {
        let response = |speed: f64| {
            let force = self.unbalance_phasor(speed);
            largest(self.amplitudes(&force, speed, speed).into_iter(), arm)
        };
        let speeds = self.speed.points().map(|point| point.speed);
        speeds
            .chain([self.highest_speed()])
            .map(response)
            .fold(0.0, f64::max)
    }

    /// Largest amplitude under each of the varying loads by itself.
    fn load_response(&self, arm: f64) -> f64 {
        let response = |load: &Load| {
            let swing = load.swing(self.mass[0]);
            let force = swing.amplitude.map(|force| Complex::new(force, 0.0));
            let speed = self.highest_speed();
            let frequency = swing.frequency + swing.order * speed;
            largest(self.amplitudes(&force, frequency, speed).into_iter(), arm)
        };
        self.loads.iter().map(response).fold(0.0, f64::max)
    }

    /// Amplitudes of the kept freedoms under a force of angular frequency ω while the shaft turns at Ω,
    /// `|(K − ω²M + iω(C + ΩG))⁻¹ F|`; none at an undamped resonance.
    fn amplitudes(&self, force: &[Complex<f64>; FREEDOMS], omega: f64, speed: f64) -> Vec<f64> {
        let kept = self.kept;
        let stiffness = &self.equilibrium.stiffness;
        let dynamic = DMatrix::from_fn(kept, kept, |row, column| {
            let inertia = if row == column {
                omega * omega * self.mass[row]
            } else {
                0.0
            };
            let rate = self.rate_entry(row, column, speed);
            Complex::new(stiffness[(row, column)] - inertia, omega * rate)
        });
        let force = DVector::from_column_slice(&force[..kept]);
        let response = dynamic.lu().solve(&force);
        response.map_or_else(Vec::new, |response| {
            response.iter().map(|part| part.norm()).collect()
        })
    }

    /// Static displacement under the change of force as the cage turns by one ball spacing.
    fn varying_compliance(&self, arm: f64) -> f64 {
        self.passing_shifts()
            .iter()
            .map(|shift| largest(shift.iter().copied(), arm))
            .fold(0.0, f64::max)
    }

    /// These displacements of the kept freedoms at some positions of the cage; none in a direction that nothing holds.
    fn passing_shifts(&self) -> Vec<DVector<f64>> {
        if self.cage == CageMotion::Frozen || self.highest_speed() == 0.0 {
            return Vec::new();
        }
        let kept = self.kept;
        let stiffness = self
            .equilibrium
            .stiffness
            .view((0, 0), (kept, kept))
            .into_owned();
        let least = NOTHING * self.contact_stiffness();
        let factors = stiffness.svd(true, true);
        (1..CAGE_POSITIONS)
            .filter_map(|position| {
                let part = position as f64 / CAGE_POSITIONS as f64;
                let change = DVector::from_vec(self.force_change(part)[..kept].to_vec());
                factors.solve(&change, least).ok()
            })
            .collect()
    }

    /// Change of force at the equilibrium when every cage has turned by a part of its ball spacing.
    fn force_change(&self, part: f64) -> [f64; FREEDOMS] {
        let place = &self.equilibrium.displacement;
        let mut change = [0.0; FREEDOMS];
        for support in &self.supports {
            let spacing =
                std::f64::consts::TAU / support.definition().bearing.geometry.balls() as f64;
            let start = BearingRotation::at_start(self.speed());
            let turned = support.force(place, &start.with_cage_at(part * spacing));
            let still = support.force(place, &start);
            for axis in 0..FREEDOMS {
                change[axis] += turned[axis] - still[axis];
            }
        }
        change
    }

    /// Largest of these changes in every component.
    pub(super) fn passing_force(&self) -> [f64; FREEDOMS] {
        let mut largest = [0.0_f64; FREEDOMS];
        for position in 1..CAGE_POSITIONS {
            let change = self.force_change(position as f64 / CAGE_POSITIONS as f64);
            for (largest, change) in largest.iter_mut().zip(change) {
                *largest = largest.max(change.abs());
            }
        }
        largest
    }

    fn initial_distance(&self, arm: f64, frequency: f64) -> f64 {
        let [displacement, velocity] = &self.initial;
        let shift =
            (0..self.kept).map(|axis| displacement[axis] - self.equilibrium.displacement[axis]);
        let swing = velocity.iter().map(|velocity| velocity / frequency);
        largest(shift, arm).max(largest(swing, arm))
    }
}

fn lever(axis: usize, arm: f64) -> f64 {
    if axis < 3 { 1.0 } else { arm }
}

/// Largest component as a displacement; what is not a number does not count.
fn largest(components: impl Iterator<Item = f64>, arm: f64) -> f64 {
    components
        .enumerate()
        .map(|(axis, value)| value.abs() * lever(axis, arm))
        .filter(|value| value.is_finite())
        .fold(0.0, f64::max)
}
