//! The shaft in motion: the right-hand side of its equations.

use std::borrow::Cow;

use fearless_simd::{Level, Simd};
use nalgebra::{DMatrix, DVector};

use super::coefficients::{Coefficients, Mass};
use super::equilibrium::Equilibrium;
use super::phases::Phases;
use super::point::{Attachment, Place, Point, about_origin};
use super::structure::{Structure, UnbalancedPoint};
use super::unconstrained::FreeDirections;
use super::{CageMotion, Drive, FREEDOMS, Freedoms, InitialPosition, Load, Rotation, SpeedProfile};
use crate::bearing::{Angle, BearingRotation, BearingState, CageJitter, Support, Vector5};
use crate::registers::in_wide_registers;

/// A shaft on its bearings, assembled and ready to move.
///
/// ```text
/// M q̈ + (C + ω G) q̇ + K q + Σ_b B_bᵀ F_b(B_b q, B_b q̇, ψ_b, ω) = f(t, ψ)
/// ```
///
/// q are its degrees of freedom, B_b takes from them the displacement between the points that the rings of bearing b
/// sit at, F_b is the force that moves its inner ring there against the damping of the contacts, and f are the
/// unbalances, the weight and the loads. Damping inside a shaft that bends adds to f the force ω times a matrix times q,
/// which drives a forward whirl. Of a rigid shaft on bearings that stand on the
/// ground, K = 0 and
///
/// ```text
/// m ẍ  + (C q̇)_x = −F_x + m e (ω² cos ψ + ω̇ sin ψ) + P_x
/// m ÿ  + (C q̇)_y = −F_y + m e (ω² sin ψ − ω̇ cos ψ) − m g + P_y
/// m z̈  + (C q̇)_z = −F_z + P_z
/// I_t θ̈x + (C q̇)_θx + I_p ω θ̇y = −M_x + P_θx
/// I_t θ̈y + (C q̇)_θy − I_p ω θ̇x = −M_y + P_θy
/// ```
///
/// with ψ, ω and ω̇ those of the speed profile. The
/// cage of a bearing turns by its constant ratio of ψ, at any profile. Coordinates that the scene holds stay where the
/// static equilibrium has them.
///
/// Source: the equations of a Jeffcott rotor with gyroscopic tilt, e.g. Krämer, *Dynamics of Rotors
/// and Foundations* (1993), ch. 1 and 5.
#[derive(Debug, Clone)]
pub struct Rotor {
    /// Vector instructions of the processor.
    pub(super) level: Level,
    /// Coordinates, K, and the points where forces act.
    pub(super) structure: Structure,
    /// Freedoms of the shaft that move.
    pub(super) freedoms: Freedoms,
    /// Whether the structure is a rigid shaft on the ground.
    pub(super) rigid: bool,
    /// M.
    pub(super) mass: Mass,
    /// K without the ball bearings.
    pub(super) stiffness: Coefficients,
    /// C.
    pub(super) damping: Coefficients,
    /// Whether C follows from the stiffness with the cages turned by half a ball spacing, as nothing holds the shaft before.
    pub(super) damped_by_later_balls: bool,
    /// G.
    pub(super) gyroscopic: Coefficients,
    /// Forces per speed and displacement, of damping that turns with the shaft.
    pub(super) circulatory: Coefficients,
    /// Whether damping inside the shaft turns with it.
    pub(super) damped_inside: bool,
    /// The part of C that turns with the shaft.
    pub(super) internal_damping: Coefficients,
    /// Mass of the shaft, kg.
    pub(super) shaft_mass: f64,
    pub(super) inertia_polar: f64,
    pub(super) speed: SpeedProfile,
    /// Decides the speed in place of the profile, which then holds that of the start.
    pub(super) drive: Option<Drive>,
    pub(super) cage: CageMotion,
    /// Whether energy is accounted for.
    pub(super) energy: bool,
    /// Constant loads and the weight on the degrees of freedom.
    pub(super) constant_force: Vec<f64>,
    /// Acceleration of gravity along −Y, m/s²; zero where no weight acts.
    pub(super) gravity: f64,
    /// M t of a unit translation t of all masses along x, y and z, kg: times an acceleration of the base, its inertial force
    /// against it.
    pub(super) base_inertia: [Vec<f64>; 3],
    /// Varying loads.
    pub(super) loads: Vec<Load>,
    /// Whether the contacts of any bearing are damped.
    pub(super) contacts_damped: bool,
    pub(super) supports: Vec<Support>,
    /// Place of each of them among all bearings of the shaft, those of constant stiffness counted.
    pub(super) ball_places: Vec<usize>,
    /// Number of balls whose force is not smooth where they lift off.
    pub(super) balls_that_lift_off: usize,
    /// Speed of the first bearing's cage over that of the shaft.
    pub(super) leading_ratio: f64,
    pub(super) equilibrium: Equilibrium,
    /// Place of all coordinates at the static equilibrium.
    pub(super) rest: Vec<f64>,
    /// K and the stiffness of the bearings there, of all coordinates.
    pub(super) tangent: DMatrix<f64>,
    /// What nothing holds there.
    pub(super) free: FreeDirections,
    /// Where the motion starts from.
    pub(super) starts_from: InitialPosition,
    /// Displacement and velocity of the shaft at t = 0.
    pub(super) initial: [Vector5; 2],
}

/// A bearing between the points of its rings.
#[derive(Clone, Copy)]
pub(super) struct AttachedBearing<'a> {
    pub support: &'a Support,
    pub attachment: &'a Attachment,
    rest: &'a [f64],
}

impl AttachedBearing<'_> {
    /// Displacement of the inner ring's point from the outer one's.
    #[inline(always)]
    pub fn displacement(&self, dofs: &[f64]) -> Vector5 {
        self.attachment.displacement(dofs, self.rest)
    }

    /// The same and its rate.
    pub fn motion(&self, dofs: &[f64], velocity: &[f64]) -> [Vector5; 2] {
        [self.displacement(dofs), self.attachment.rate(velocity)]
    }
}

impl Rotor {
    /// Freedoms of the shaft that move.
    pub fn freedoms(&self) -> Freedoms {
        self.freedoms
    }

    /// Displacement of the observed point of the shaft in a state.
    pub(crate) fn displacement(&self, state: &[f64]) -> Vector5 {
        let place = self.place_of_all(&state[..self.dofs()]);
        self.structure.shaft.displacement(&place, &self.rest)
    }

    /// Place of all coordinates where some have no mass and follow, else that of the degrees of freedom.
    pub(super) fn place_of_all<'a>(&self, dofs: &'a [f64]) -> Cow<'a, [f64]> {
        self.of_all(dofs, Some(&self.rest))
    }

    /// Rates likewise.
    pub(super) fn rate_of_all<'a>(&self, rates: &'a [f64]) -> Cow<'a, [f64]> {
        self.of_all(rates, None)
    }

    /// Values of all coordinates by those of the degrees of freedom, about `rest` or zero.
    fn of_all<'a>(&self, dofs: &'a [f64], rest: Option<&[f64]>) -> Cow<'a, [f64]> {
        let followers = &self.structure.followers;
        if followers.is_empty() {
            return Cow::Borrowed(dofs);
        }
        let rest = rest.map_or_else(|| Cow::Owned(vec![0.0; self.rest.len()]), Cow::Borrowed);
        let moved = dofs.iter().zip(rest.iter()).map(|(own, rest)| own - rest);
        let moved = followers * DVector::from_iterator(dofs.len(), moved);
        let first = rest.len() - followers.nrows();
        let mut all = [dofs, &rest[dofs.len()..]].concat();
        all[first..]
            .iter_mut()
            .zip(&moved)
            .for_each(|(sum, part)| *sum += part);
        Cow::Owned(all)
    }

    /// Modes of bending that are kept in each plane of a shaft that bends.
    pub(crate) fn bending_modes(&self) -> Option<usize> {
        self.structure.bending.as_ref().map(|bending| bending.modes)
    }

    /// Number of degrees of freedom.
    #[inline(always)]
    pub(crate) fn dofs(&self) -> usize {
        self.structure.dofs
    }

    /// Angular speed of the shaft at t = 0, rad/s.
    pub(crate) fn speed(&self) -> f64 {
        self.speed.at(0.0).speed
    }

    /// Speed and angle of the shaft from t = 0 on.
    pub(crate) fn speed_profile(&self) -> &SpeedProfile {
        &self.speed
    }

    /// Highest speed that the shaft is meant for, [`super::RotorDefinition::highest_speed`], rad/s.
    pub(crate) fn highest_speed(&self) -> f64 {
        let idle = self.drive.and_then(|drive| drive.no_load_speed);
        self.speed.highest().max(idle.unwrap_or(0.0))
    }

    /// Whether a drive decides the speed.
    pub(crate) fn is_driven(&self) -> bool {
        self.drive.is_some()
    }

    /// The speed that is kept from a time on; `None` where it changes after it.
    pub(crate) fn steady_from(&self, time: f64) -> Option<f64> {
        if self.is_driven() {
            return None;
        }
        self.speed.steady_from(time)
    }

    /// Static equilibrium under the constant loads, without unbalance.
    pub fn equilibrium(&self) -> &Equilibrium {
        &self.equilibrium
    }

    /// Bearings on the shaft.
    pub(crate) fn supports(&self) -> &[Support] {
        &self.supports
    }

    /// What is known of every bearing at the static equilibrium and a speed of the shaft in rad/s.
    pub(crate) fn bearing_states(&self, speed: f64) -> Vec<BearingState> {
        let state = |bearing: AttachedBearing<'_>| {
            let place = bearing.displacement(&self.rest[..self.dofs()]);
            bearing.support.state(&place, speed, self.cage)
        };
        self.bearings().map(state).collect()
    }

    /// Where shaft and cages point.
    #[inline(always)]
    pub(super) fn phases(&self, rotation: &Rotation) -> Phases {
        Phases::new(rotation, self.leading_ratio)
    }

    /// The bearings between their points.
    #[inline(always)]
    pub(super) fn bearings(&self) -> impl Iterator<Item = AttachedBearing<'_>> {
        let pairs = self.supports.iter().zip(&self.structure.attachments);
        pairs.map(|(support, attachment)| AttachedBearing {
            support,
            attachment,
            rest: &self.rest,
        })
    }

    /// The same with the rotation that each of them sees.
    pub(super) fn bearings_at(
        &self,
        rotation: &Rotation,
    ) -> impl Iterator<Item = (AttachedBearing<'_>, BearingRotation)> {
        let phases = self.phases(rotation);
        let seen =
            move |bearing: AttachedBearing<'_>| self.seen_by(bearing.support, rotation, &phases);
        self.bearings().map(move |bearing| (bearing, seen(bearing)))
    }

    /// The rotation that a bearing sees; cages that roll as the first one share its sine.
    #[inline(always)]
    pub(super) fn seen_by(
        &self,
        support: &Support,
        rotation: &Rotation,
        phases: &Phases,
    ) -> BearingRotation {
        let ratio = support.cage_ratio();
        if let Some(jitter) = support.cage_jitter() {
            return jittering(jitter, ratio, rotation, phases);
        }
        BearingRotation {
            cage: if ratio == phases.ratio {
                phases.cage
            } else {
                Angle::new(ratio * rotation.angle)
            },
            shaft: phases.shaft,
            cage_angle: ratio * rotation.angle,
            cage_speed: ratio * rotation.speed,
            speed: rotation.speed,
        }
    }

    /// Adds the forces of the unbalances.
    #[inline(always)]
    pub(super) fn add_unbalances<const RIGID: bool>(
        &self,
        rotation: &Rotation,
        phases: &Phases,
        sum: &mut [f64],
    ) {
        for UnbalancedPoint { point, unbalance } in &self.structure.unbalances {
            let point = if RIGID { &Point::RIGID_SHAFT } else { point };
            point.add_force(1.0, &unbalance.force(rotation, phases.shaft), sum);
        }
    }

    /// Adds the forces of the varying loads; apart from the rest, which stays small where no load varies.
    #[inline(never)]
    pub(super) fn add_loads(&self, time: f64, angle: f64, sum: &mut [f64]) {
        for (load, place) in self.loads.iter().zip(&self.structure.load_places) {
            self.add_load(load, place, &load.kind.at(time, angle), sum);
        }
    }

    /// Adds a value of a load, an amplitude or a rate of it.
    pub(super) fn add_load(&self, load: &Load, place: &Place, value: &Vector5, sum: &mut [f64]) {
        if load.acts_on_mass() {
            self.add_base_force(value, sum);
        } else {
            place.add_force(value, sum);
        }
    }

    /// Power of the varying loads at velocities of the degrees of freedom, W.
    pub(super) fn power_of_loads(&self, time: f64, angle: f64, velocity: &[f64]) -> f64 {
        let power = |(load, place): (&Load, &Place)| -> f64 {
            let value = load.kind.at(time, angle);
            if load.acts_on_mass() {
                let axes = self.base_inertia.iter().zip(value);
                return -axes
                    .map(|(inertia, part)| part * dot(inertia, velocity))
                    .sum::<f64>();
            }
            dot(
                &about_origin(&value, place.arm),
                &place.point.rate(velocity),
            )
        };
        let loads = self.loads.iter().zip(&self.structure.load_places);
        loads.map(power).sum()
    }

    /// Power of the unbalances at velocities of the degrees of freedom, W.
    pub(super) fn power_of_unbalances(&self, rotation: &Rotation, velocity: &[f64]) -> f64 {
        let shaft = self.phases(rotation).shaft;
        let unbalances = self.structure.unbalances.iter();
        let power = |own: &UnbalancedPoint| {
            dot(
                &own.unbalance.force(rotation, shaft),
                &own.point.rate(velocity),
            )
        };
        unbalances.map(power).sum()
    }

    /// Adds the inertial forces of the shaft and the housings where the base accelerates, in m/s².
    fn add_base_force(&self, acceleration: &Vector5, sum: &mut [f64]) {
        for (inertia, acceleration) in self.base_inertia.iter().zip(acceleration) {
            for (sum, inertia) in sum.iter_mut().zip(inertia) {
                *sum -= inertia * acceleration;
            }
        }
    }

    /// Acceleration of the base, m/s².
    pub(super) fn base_acceleration(&self, time: f64, angle: f64) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for load in self.loads.iter().filter(|load| load.acts_on_mass()) {
            for (sum, part) in sum.iter_mut().zip(load.kind.at(time, angle)) {
                *sum += part;
            }
        }
        sum
    }

    /// Whether the shaft turns at one speed, and no load jumps from a time on.
    pub(crate) fn goes_on_alike(&self, time: f64) -> bool {
        let mut loads = self.loads.iter();
        self.steady_from(0.0).is_some()
            && loads.all(|load| load.kind.next_break(time) == f64::INFINITY)
    }

    /// The first time after `after` at which a load or the acceleration jumps, or a ball passes a kink of a defect, s.
    pub(super) fn next_break_after(&self, after: f64) -> f64 {
        let breaks = self.loads.iter().map(|load| load.kind.next_break(after));
        let known = breaks.fold(self.speed.next_break(after), f64::min);
        known.min(self.next_passing(after))
    }
}

/// The rotation of a bearing whose cage wanders.
#[inline(never)]
fn jittering(
    jitter: &CageJitter,
    ratio: f64,
    rotation: &Rotation,
    phases: &Phases,
) -> BearingRotation {
    let nominal = ratio * rotation.angle;
    let [ahead, slope] = jitter.at(nominal);
    BearingRotation {
        cage: Angle::new(nominal + ahead),
        shaft: phases.shaft,
        cage_angle: nominal + ahead,
        cage_speed: ratio * rotation.speed * (1.0 + slope),
        speed: rotation.speed,
    }
}

impl Rotor {
    /// Derivative of (q, q̇).
    #[inline(always)]
    pub(super) fn motion_derivative(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        // points and sizes of a rigid shaft on the ground are known to the compiler: with two freedoms that saves a
        // quarter of the time
        in_wide_registers!(self.level, simd => match self.dofs() {
            2 if self.rigid => self.derivative_of::<_, true>(simd, 2, time, state, rate),
            3 if self.rigid => self.derivative_of::<_, true>(simd, 3, time, state, rate),
            5 if self.rigid => self.derivative_of::<_, true>(simd, 5, time, state, rate),
            dofs => self.derivative_of::<_, false>(simd, dofs, time, state, rate),
        });
    }

    /// The same for the processor's level `S`.
    #[inline(always)]
    fn derivative_of<S: Simd, const RIGID: bool>(
        &self,
        simd: S,
        dofs: usize,
        time: f64,
        state: &[f64],
        rate: &mut [f64],
    ) {
        let (place, velocity) = state[..2 * dofs].split_at(dofs);
        let (displacement_rate, force) = rate[..2 * dofs].split_at_mut(dofs);
        displacement_rate.copy_from_slice(velocity);
        force.copy_from_slice(&self.constant_force[..dofs]);
        let rotation = self.speed.at(time);
        let phases = self.phases(&rotation);
        let shaft = if RIGID {
            Point::RIGID_SHAFT
        } else {
            self.structure.shaft
        };
        self.add_unbalances::<RIGID>(&rotation, &phases, force);
        if !self.loads.is_empty() {
            self.add_loads(time, rotation.angle, force);
        }
        self.gyroscopic
            .add_product(-rotation.speed, velocity, force);
        self.damping.add_product(-1.0, velocity, force);
        if !RIGID {
            self.stiffness.add_product(-1.0, place, force);
            self.circulatory.add_product(rotation.speed, place, force);
        }
        if self.contacts_damped {
            self.add_damped_bearings(place, velocity, &rotation, &phases, force);
        } else if RIGID {
            let displacement = shaft.displacement(place, &self.rest);
            let held = self.force_on_grounded(simd, &displacement, &rotation, &phases);
            shaft.add_force(-1.0, &held, force);
        } else {
            for bearing in self.bearings() {
                let displacement = bearing.displacement(place);
                let seen = self.seen_by(bearing.support, &rotation, &phases);
                let held = bearing.support.force_by(simd, &displacement, &seen);
                bearing.attachment.add_force(-1.0, &held, force);
            }
        }
        self.mass.accelerate(force);
    }

    /// Force of a rigid shaft onto all its bearings, N and N m.
    #[inline(always)]
    fn force_on_grounded<S: Simd>(
        &self,
        simd: S,
        displacement: &Vector5,
        rotation: &Rotation,
        phases: &Phases,
    ) -> Vector5 {
        // one by itself, so that no sum has to be kept in memory from bearing to bearing
        if let [support] = &self.supports[..] {
            let seen = self.seen_by(support, rotation, phases);
            return support.force_by(simd, displacement, &seen);
        }
        let mut sum = [0.0; FREEDOMS];
        for support in &self.supports {
            let seen = self.seen_by(support, rotation, phases);
            let force = support.force_by(simd, displacement, &seen);
            for axis in 0..FREEDOMS {
                sum[axis] += force[axis];
            }
        }
        sum
    }

    /// Adds the forces of the bearings with the damping of their contacts; apart from the rest, which
    /// stays small where no contact is damped.
    #[inline(never)]
    fn add_damped_bearings(
        &self,
        place: &[f64],
        velocity: &[f64],
        rotation: &Rotation,
        phases: &Phases,
        sum: &mut [f64],
    ) {
        for bearing in self.bearings() {
            let seen = self.seen_by(bearing.support, rotation, phases);
            let [place, rate] = bearing.motion(place, velocity);
            let [elastic, damping] = bearing.support.damped_force(&place, &rate, &seen);
            let force = std::array::from_fn(|axis| elastic[axis] + damping[axis]);
            bearing.attachment.add_force(-1.0, &force, sum);
        }
    }
}

/// Σ a_i b_i.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
