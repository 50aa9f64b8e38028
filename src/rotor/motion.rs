//! The shaft in motion: the right-hand side of its equations.

use fearless_simd::{Level, Simd};

use super::damping::DampingMatrix;
use super::phases::Phases;
use super::unbalance::Unbalance;
use super::{CageMotion, Drive, FREEDOMS, Load, Rotation, SpeedProfile};
use crate::bearing::equilibrium::Equilibrium;
use crate::bearing::{Angle, BearingRotation, Support, Vector5, in_registers};
use crate::registers::in_wide_registers;

/// A concentrated mass on its bearings, assembled and ready to move.
///
/// ```text
/// m ẍ  + (C q̇)_x = −F_x + m e (ω² cos ψ + ω̇ sin ψ) + P_x
/// m ÿ  + (C q̇)_y = −F_y + m e (ω² sin ψ − ω̇ cos ψ) − m g + P_y
/// m z̈  + (C q̇)_z = −F_z + P_z
/// I_t θ̈x + (C q̇)_θx + I_p ω θ̇y = −M_x + P_θx
/// I_t θ̈y + (C q̇)_θy − I_p ω θ̇x = −M_y + P_θy
/// ```
///
/// with F the force that holds the inner rings at q and moves them against the damping of their
/// contacts, and ψ, ω and ω̇ those of the speed profile. The
/// cage of a bearing turns by its constant ratio of ψ, at any profile. Freedoms that the scene does
/// not keep stay where the static equilibrium has them.
///
/// Source: the equations of a Jeffcott rotor with gyroscopic tilt, e.g. Krämer, *Dynamics of Rotors
/// and Foundations* (1993), ch. 1 and 5.
#[derive(Debug, Clone)]
pub struct Rotor {
    /// What the processor has.
    pub(super) level: Level,
    pub(super) kept: usize,
    pub(super) mass: Vector5,
    pub(super) inverse_mass: Vector5,
    pub(super) inertia_polar: f64,
    pub(super) speed: SpeedProfile,
    /// Decides the speed in place of the profile, which then holds that of the start.
    pub(super) drive: Option<Drive>,
    pub(super) cage: CageMotion,
    pub(super) unbalance: Unbalance,
    /// Whether energy is accounted for.
    pub(super) energy: bool,
    /// Constant loads and the weight.
    pub(super) load: Vector5,
    /// The part of it that is weight, N.
    pub(super) weight: f64,
    /// Varying loads.
    pub(super) loads: Vec<Load>,
    pub(super) damping: DampingMatrix,
    /// Whether the contacts of any bearing are damped.
    pub(super) contacts_damped: bool,
    pub(super) supports: Vec<Support>,
    /// Number of balls whose force is not smooth where they lift off.
    pub(super) balls_that_lift_off: usize,
    /// Speed of the first bearing's cage over that of the shaft.
    pub(super) leading_ratio: f64,
    pub(super) equilibrium: Equilibrium,
    /// Displacement and velocity at t = 0.
    pub(super) initial: [Vector5; 2],
}

impl Rotor {
    /// Number of freedoms that move: the first so many of x, y, z, θx, θy.
    pub fn kept(&self) -> usize {
        self.kept
    }

    /// Angular speed of the shaft at t = 0, rad/s.
    pub fn speed(&self) -> f64 {
        self.speed.at(0.0).speed
    }

    /// Speed and angle of the shaft from t = 0 on.
    pub fn speed_profile(&self) -> &SpeedProfile {
        &self.speed
    }

    /// Highest speed that the shaft is meant for, [`super::RotorDefinition::highest_speed`], rad/s.
    pub fn highest_speed(&self) -> f64 {
        let idle = self.drive.and_then(|drive| drive.no_load_speed);
        self.speed.highest().max(idle.unwrap_or(0.0))
    }

    /// Whether a drive decides the speed.
    pub fn is_driven(&self) -> bool {
        self.drive.is_some()
    }

    /// The speed that is kept from a time on; `None` where it changes after it.
    pub fn steady_from(&self, time: f64) -> Option<f64> {
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
    pub fn supports(&self) -> &[Support] {
        &self.supports
    }

    /// Displacement and velocity at t = 0.
    pub fn initial_state(&self) -> [Vector5; 2] {
        self.initial
    }

    /// Force of the shaft onto all bearings at a displacement, N and N m.
    #[inline(always)]
    fn force_on_bearings<S: Simd>(
        &self,
        simd: S,
        displacement: &Vector5,
        rotation: &Rotation,
        phases: &Phases,
    ) -> Vector5 {
        match &self.supports[..] {
            // by itself, so that no sum has to be kept in memory from bearing to bearing
            [support] => {
                support.force_by(simd, displacement, &self.seen_by(support, rotation, phases))
            }
            _ => in_registers(simd.vectorize(
                #[inline(always)]
                || self.force_on_several(simd, in_registers(*displacement), rotation, phases),
            )),
        }
    }

    #[inline(always)]
    fn force_on_several<S: Simd>(
        &self,
        simd: S,
        displacement: Vector5,
        rotation: &Rotation,
        phases: &Phases,
    ) -> Vector5 {
        let mut total = [0.0; FREEDOMS];
        for support in &self.supports {
            let rotation = self.seen_by(support, rotation, phases);
            let force = support.force_by(simd, &displacement, &rotation);
            for axis in 0..FREEDOMS {
                total[axis] += force[axis];
            }
        }
        total
    }

    /// As [`Rotor::force_on_bearings`], and against the damping of the contacts; apart from the rest, which
    /// stays small where no contact is damped.
    #[inline(never)]
    fn damped_force_on_bearings(
        &self,
        displacement: &Vector5,
        velocity: &Vector5,
        rotation: &Rotation,
        phases: &Phases,
    ) -> Vector5 {
        let mut total = [0.0; FREEDOMS];
        self.for_each_support(rotation, phases, |support, rotation| {
            let [elastic, damping] = support.damped_force(displacement, velocity, rotation);
            for axis in 0..FREEDOMS {
                total[axis] += elastic[axis] + damping[axis];
            }
        });
        total
    }

    /// Speed of the cage of a bearing over that of the shaft.
    #[inline]
    pub(super) fn cage_ratio(&self, support: &Support) -> f64 {
        self.cage.ratio(support)
    }

    /// Where shaft and cages point.
    #[inline(always)]
    pub(super) fn phases(&self, rotation: &Rotation) -> Phases {
        Phases::new(rotation, self.leading_ratio)
    }

    /// Visits every bearing with the rotation that it sees.
    #[inline]
    pub(super) fn for_each_support(
        &self,
        rotation: &Rotation,
        phases: &Phases,
        mut visit: impl FnMut(&Support, &BearingRotation),
    ) {
        for support in &self.supports {
            visit(support, &self.seen_by(support, rotation, phases));
        }
    }

    /// The rotation that a bearing sees; cages that roll as the first one share its sine.
    #[inline(always)]
    pub(super) fn seen_by(
        &self,
        support: &Support,
        rotation: &Rotation,
        phases: &Phases,
    ) -> BearingRotation {
        let ratio = self.cage_ratio(support);
        BearingRotation {
            cage: if ratio == phases.ratio {
                phases.cage
            } else {
                Angle::new(ratio * rotation.angle)
            },
            shaft: phases.shaft,
            cage_speed: ratio * rotation.speed,
            speed: rotation.speed,
        }
    }

    /// Loads, weight and unbalance on the shaft, N and N m.
    #[inline(always)]
    fn outer_force(&self, time: f64, rotation: &Rotation, phases: &Phases) -> Vector5 {
        let [x, y] = self.unbalance.force(rotation, phases.shaft);
        let [f_x, f_y, f_z, m_x, m_y] = self.load;
        let push = [f_x + x, f_y + y, f_z, m_x, m_y];
        if self.loads.is_empty() {
            push
        } else {
            in_registers(self.with_loads(time, rotation.angle, push))
        }
    }

    /// Gyroscopic moments, N m.
    #[inline(always)]
    pub(super) fn gyroscopic(&self, velocity: &Vector5, speed: f64) -> Vector5 {
        let inertia = self.inertia_polar * speed;
        [0.0, 0.0, 0.0, -inertia * velocity[4], inertia * velocity[3]]
    }

    /// Loads that act at the centre of mass, and those that act on the shaft's axis, N and N m.
    pub(super) fn loads_apart(&self, time: f64, angle: f64) -> [Vector5; 2] {
        let mut on_mass = [0.0, -self.weight, 0.0, 0.0, 0.0];
        let mut on_axis = self.load;
        on_axis[1] += self.weight;
        for load in &self.loads {
            let sum = if load.acts_on_mass() {
                &mut on_mass
            } else {
                &mut on_axis
            };
            load.add(time, angle, self.mass[0], sum);
        }
        [on_mass, on_axis]
    }

    /// Apart from the rest, which stays small where no load varies.
    #[inline(never)]
    fn with_loads(&self, time: f64, angle: f64, mut push: Vector5) -> Vector5 {
        for load in &self.loads {
            load.add(time, angle, self.mass[0], &mut push);
        }
        push
    }

    /// The first time after `after` at which a load or the acceleration jumps, s.
    pub(super) fn next_break_after(&self, after: f64) -> f64 {
        let breaks = self.loads.iter().map(|load| load.next_break(after));
        breaks.fold(self.speed.next_break(after), f64::min)
    }

    /// Five components, the kept ones from a state, the others from `held`.
    #[inline(always)]
    pub(super) fn full(&self, held: &Vector5, kept: &[f64]) -> Vector5 {
        std::array::from_fn(|axis| kept.get(axis).copied().unwrap_or(held[axis]))
    }
}

impl Rotor {
    /// Derivative of (q, q̇).
    #[inline(always)]
    pub(super) fn motion_derivative(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        in_wide_registers!(self.level, simd => self.derivative_by(simd, time, state, rate));
    }

    /// The same for the processor's level `S`.
    #[inline(always)]
    fn derivative_by<S: Simd>(&self, simd: S, time: f64, state: &[f64], rate: &mut [f64]) {
        // known to the compiler in the loops over them
        match self.kept {
            2 => self.derivative_of::<S, 2>(simd, time, state, rate),
            3 => self.derivative_of::<S, 3>(simd, time, state, rate),
            _ => self.derivative_of::<S, FREEDOMS>(simd, time, state, rate),
        }
    }

    #[inline(always)]
    fn derivative_of<S: Simd, const KEPT: usize>(
        &self,
        simd: S,
        time: f64,
        state: &[f64],
        rate: &mut [f64],
    ) {
        let kept = KEPT;
        let (state, rate) = (&state[..2 * kept], &mut rate[..2 * kept]);
        let velocity = &state[kept..];
        let rotation = self.speed.at(time);
        let phases = self.phases(&rotation);
        let displacement = self.full(&self.equilibrium.displacement, &state[..kept]);
        let force = if self.contacts_damped {
            let velocity = self.full(&[0.0; FREEDOMS], velocity);
            let displacement = in_registers(displacement);
            in_registers(self.damped_force_on_bearings(
                &displacement,
                &velocity,
                &rotation,
                &phases,
            ))
        } else {
            self.force_on_bearings(simd, &displacement, &rotation, &phases)
        };
        let mut push = self.outer_force(time, &rotation, &phases);
        if kept == FREEDOMS {
            let gyroscopic = self.inertia_polar * rotation.speed;
            push[3] -= gyroscopic * velocity[4];
            push[4] += gyroscopic * velocity[3];
        }
        let braking = self.damping.force(velocity);
        for axis in 0..kept {
            push[axis] -= braking[axis];
        }
        for axis in 0..kept {
            rate[axis] = velocity[axis];
            rate[kept + axis] = (push[axis] - force[axis]) * self.inverse_mass[axis];
        }
    }
}
