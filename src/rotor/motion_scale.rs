//! How large the motion will be: what a tolerance is relative to.

use std::f64::consts::TAU;

use nalgebra::{Complex, DVector};

use super::Rotor;
use super::element::AttachedBearing;
use super::modes::Mode;
use super::static_search::POSITION_ROUND_OFF;
use super::unconstrained::{FREE_STIFFNESS, contact_stiffness};
use crate::bearing::{BearingRotation, Geometry, Support};

/// Smallest error of a position that a tolerance can ask for, relative to the groove centre distance.
const SMALLEST_ERROR: f64 = 4.0 * f64::EPSILON;
/// Positions of the cage within one ball spacing at which the varying force is looked at.
const CAGE_POSITIONS: usize = 8;

/// An assumed length of more than this many times the recorded motion is wrong.
const FAR: f64 = 10.0;

/// Round-off of an eigenvalue of a matrix that is not symmetric, in parts of it: 27 ε was measured on a shaft with cross-coupled
/// springs.
const EIGENVALUE_ROUND_OFF: f64 = 32.0 * f64::EPSILON;

/// Length and time that make the states of the integration numbers of order one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionScale {
    /// Length of the motion, m.
    pub length: f64,
    /// Least value of `length`, m: the tolerance of a smaller motion would lie below the round-off of a position.
    pub least: f64,
    /// Length that turns tilts into displacements, m.
    pub arm: f64,
    /// Angular frequency that turns velocities into displacements, rad/s: the highest of speed and natural frequencies, see
    /// [`Rotor::motion_scale`].
    pub frequency: f64,
}

impl MotionScale {
    /// Length that turns component `axis` of x, y, z, θx, θy into a displacement.
    pub fn lever(&self, axis: usize) -> f64 {
        if axis < 3 { 1.0 } else { self.arm }
    }

    /// The scale for a motion whose recorded size in m is far smaller than the length; none where the length is about right.
    pub(crate) fn corrected(&self, recorded: f64) -> Option<Self> {
        let length = recorded.max(self.least);
        (self.length > FAR * length).then_some(Self { length, ..*self })
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
        let arm = Support::largest(self.elements.supports(), Geometry::lever);
        let frequency = self.highest_frequency();
        let amplitudes = self
            .speeds()
            .map(|speed| self.unbalance_amplitudes(speed))
            .chain(self.load_amplitudes(self.highest_speed()))
            .chain(self.passing_amplitudes())
            .chain(self.initial_amplitudes(frequency));
        let least = SMALLEST_ERROR / tolerance * self.length_scale();
        let length = amplitudes
            .map(|amplitudes| self.largest(&amplitudes, arm))
            .fold(least, f64::max);
        MotionScale {
            length,
            least,
            arm,
            frequency,
        }
    }

    /// Round-off of a displacement in a motion, m: that of the positions between the races, from which the forces
    /// follow. All passes of a run share it, so that their difference does not show it.
    pub(crate) fn displacement_round_off(&self) -> f64 {
        POSITION_ROUND_OFF * self.length_scale()
    }

    /// Round-off in a run of so many seconds, in parts of the largest displacement, where all forces are linear; zero where they
    /// are not.
    ///
    /// All passes of a linear run take exact steps with the same rounded eigenvalues λ, so that their difference does not show
    /// what that leaves: a free vibration errs in proportion to the phase |λ| t it has gone through, until it has died out.
    pub(crate) fn linear_round_off(&self, duration: f64) -> f64 {
        if !self.has_linear_forces() {
            return 0.0;
        }
        let phase = |mode: &Mode| {
            let dies_out = match mode.damping_ratio() {
                ratio if ratio > 0.0 => 1.0 / (ratio * mode.eigenvalue.norm()),
                _ => duration,
            };
            mode.eigenvalue.norm() * duration.min(dies_out)
        };
        EIGENVALUE_ROUND_OFF * self.modes().iter().map(phase).fold(1.0, f64::max)
    }

    /// Highest natural frequency √(K_ii/M_ii) of a freedom with all others held, rad/s, or the speed where that is higher.
    /// Where nothing resists at the equilibrium, as in the middle of a clearance, it is that of the shaft on one contact.
    fn highest_frequency(&self) -> f64 {
        let highest = (0..self.dofs())
            .map(|dof| {
                (self.start.tangent[(dof, dof)].max(0.0) / self.linear.mass.entries[(dof, dof)])
                    .sqrt()
            })
            .fold(0.0, f64::max);
        let natural = match highest {
            0.0 => (contact_stiffness(self.elements.supports()) / self.structure.shaft_mass).sqrt(),
            highest => highest,
        };
        natural.max(self.highest_speed())
    }

    /// Angular frequency by which the tolerance of displacements becomes that of velocities, rad/s: that of the scale of a
    /// rigid shaft on the ground; of other structures, whose natural frequencies lie far apart, the lowest, or else the
    /// velocity of a slow motion would be allowed the error of a fast one.
    pub(super) fn velocity_rate(&self, scale: &MotionScale) -> f64 {
        if self.elements.on_rigid_shaft {
            return scale.frequency;
        }
        let modes = self.modes();
        let natural = modes.iter().map(|mode| mode.eigenvalue.norm());
        let lowest = natural
            .filter(|rate| *rate > 0.0)
            .fold(f64::INFINITY, f64::min);
        lowest.max(self.highest_speed()).min(scale.frequency)
    }

    fn length_scale(&self) -> f64 {
        Support::largest(self.elements.supports(), Geometry::length_scale)
    }

    /// Estimated amplitudes of the degrees of freedom about the static equilibrium at a speed of the shaft in rad/s, m and
    /// rad: the sum of what [`Rotor::motion_scale`] takes the largest of.
    pub(super) fn amplitude_estimate(&self, speed: f64) -> Vec<f64> {
        let mut sum = vec![0.0; self.dofs()];
        add_sizes(&mut sum, &self.unbalance_amplitudes(speed));
        for amplitudes in self.load_amplitudes(speed) {
            add_sizes(&mut sum, &amplitudes);
        }
        let mut passing = vec![0.0_f64; self.dofs()];
        for shift in self.passing_amplitudes() {
            for (passing, shift) in passing.iter_mut().zip(shift) {
                *passing = passing.max(shift.abs());
            }
        }
        add_sizes(&mut sum, &passing);
        for amplitudes in self.initial_amplitudes(self.highest_frequency()) {
            add_sizes(&mut sum, &amplitudes);
        }
        sum
    }

    /// Speeds at the points of the profile and the highest one, rad/s.
    pub(super) fn speeds(&self) -> impl Iterator<Item = f64> {
        let points = self.excitation.speed.points().map(|point| point.speed);
        points.chain([self.highest_speed()])
    }

    /// Displacement of the degrees of freedom from the static equilibrium at t = 0, and the amplitude q̇/ω of a free
    /// vibration at their velocities and an angular frequency ω in rad/s.
    fn initial_amplitudes(&self, frequency: f64) -> [Vec<f64>; 2] {
        let (start, dofs) = (self.start_state(), self.dofs());
        // the state begins with (q, q̇)
        let (places, velocities) = start[..2 * dofs].split_at(dofs);
        let shifts = places.iter().zip(&self.start.rest);
        [
            shifts.map(|(place, rest)| place - rest).collect(),
            velocities.iter().map(|rate| rate / frequency).collect(),
        ]
    }

    /// Amplitudes under the unbalance at a speed of the shaft in rad/s.
    fn unbalance_amplitudes(&self, speed: f64) -> Vec<f64> {
        self.amplitudes(
            self.excitation.unbalance_phasor(speed, self.dofs()),
            speed,
            speed,
        )
    }

    /// Amplitudes under each of the varying loads by itself.
    fn load_amplitudes(&self, speed: f64) -> impl Iterator<Item = Vec<f64>> {
        let vibrations = self
            .excitation
            .load_vibrations(speed, self.dofs())
            .into_iter();
        vibrations.map(move |(frequency, force)| self.amplitudes(force, frequency, speed))
    }

    /// Amplitudes of the degrees of freedom under forces of angular frequency ω while the shaft turns at Ω,
    /// `|(K − ω²M + iω(C + ΩG))⁻¹ F|`; none at an undamped resonance.
    fn amplitudes(&self, force: DVector<Complex<f64>>, omega: f64, speed: f64) -> Vec<f64> {
        let dynamic = self
            .linear
            .dynamic_stiffness(&self.linearised(speed), omega);
        let response = dynamic.lu().solve(&force);
        response.map_or_else(Vec::new, |response| {
            response.iter().map(|part| part.norm()).collect()
        })
    }

    /// Static displacements of the degrees of freedom under the changes of the forces as the cages turn by one ball spacing
    /// and imperfect surfaces pass; none in a direction that nothing holds.
    fn passing_amplitudes(&self) -> Vec<Vec<f64>> {
        let imperfect = self.elements.supports().any(Support::is_imperfect);
        let nothing_passes = !self.elements.cage.turns() && !imperfect;
        if nothing_passes || self.highest_speed() == 0.0 {
            return Vec::new();
        }
        let dofs = self.dofs();
        let stiffness = self.start.tangent.view((0, 0), (dofs, dofs)).into_owned();
        let least = FREE_STIFFNESS * contact_stiffness(self.elements.supports());
        // K⁻¹ by singular values; those below `least` are directions that nothing holds
        let factors = stiffness.svd(true, true);
        let mut changes = self.imperfect_changes();
        if self.elements.cage.turns() {
            changes.extend(self.passing_changes());
        }
        let shift = |change| Some(factors.solve(&change, least).ok()?.as_slice().to_vec());
        changes.into_iter().filter_map(shift).collect()
    }

    /// Changes of the forces on the degrees of freedom at the equilibrium when every cage has turned by parts of its ball
    /// spacing.
    fn passing_changes(&self) -> impl Iterator<Item = DVector<f64>> {
        (1..CAGE_POSITIONS).map(|position| {
            let part = position as f64 / CAGE_POSITIONS as f64;
            let mut sum = DVector::zeros(self.dofs());
            for bearing in self.elements.bearings() {
                let spacing = TAU / bearing.support.definition().bearing.geometry.balls() as f64;
                let turned = BearingRotation::at_start(self.speed()).with_cage_at(part * spacing);
                self.add_change(&bearing, &turned, &mut sum);
            }
            sum
        })
    }

    /// Changes of the forces as imperfect surfaces pass under the balls of each bearing by itself.
    fn imperfect_changes(&self) -> Vec<DVector<f64>> {
        let mut changes = Vec::new();
        for bearing in self.elements.bearings() {
            for seen in self.imperfect_rotations(&bearing) {
                let mut change = DVector::zeros(self.dofs());
                self.add_change(&bearing, &seen, &mut change);
                changes.push(change);
            }
        }
        changes
    }

    /// Adds the change of a bearing's force at the equilibrium, from where shaft and cage start to another rotation.
    fn add_change(
        &self,
        bearing: &AttachedBearing<'_>,
        rotation: &BearingRotation,
        sum: &mut DVector<f64>,
    ) {
        let place = self.static_displacement(bearing);
        let start = BearingRotation::at_start(self.speed());
        let [there, at_start] =
            [rotation, &start].map(|rotation| bearing.support.force(&place, rotation));
        let change = std::array::from_fn(|axis| there[axis] - at_start[axis]);
        let attachment = bearing.attachment;
        attachment.add_force(1.0, &change, sum.as_mut_slice());
    }

    /// Largest change of the force on each degree of freedom as the cages turn by a ball spacing.
    pub(super) fn passing_force(&self) -> DVector<f64> {
        let start = DVector::zeros(self.dofs());
        self.passing_changes()
            .fold(start, |largest, change| largest.sup(&change.abs()))
    }

    /// Largest component in m, tilts by the arm; what is not finite, as at a resonance, does not count.
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
