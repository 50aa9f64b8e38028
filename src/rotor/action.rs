//! What acts on a shaft in a state, by what it comes from, and at which power.

use super::element::{AttachedBearing, ElementMotion};
use super::energy::Works;
use super::{Drive, DriveMoments, Rotation, Rotor, dot};
use crate::bearing::{Vector5, quarter_turn};

/// What acts on the shaft in a state.
pub(super) struct Action {
    pub rotation: Rotation,
    bearings: Bearings,
    /// Moment of damping inside the shaft on the rotation, N m.
    internal_moment: f64,
    /// Power of the loads and the weight, W; on a driven shaft of their share in the masses beside the axis, too.
    loads: f64,
    /// Power of the unbalances at a prescribed speed, W.
    unbalance: f64,
    /// Power that viscous damping takes, W.
    viscous: f64,
    /// Power that the rotation supplies through linear elements whose stiffness is not symmetric or follows its speed, W.
    crossing: f64,
    pub moments: Option<DriveMoments>,
}

impl Action {
    /// The powers of the works, W.
    pub fn powers(&self) -> Works {
        let bearings = &self.bearings;
        let speed = self.rotation.speed;
        let powers = Works {
            loads: self.loads,
            rotation: self.crossing,
            viscous: self.viscous,
            contact: bearings.damping_power,
            bearings: bearings.power,
            ..Works::default()
        };
        match &self.moments {
            None => Works {
                unbalance: self.unbalance,
                rotation: self.crossing - (bearings.cage_moment + self.internal_moment) * speed,
                ..powers
            },
            Some(moments) => Works {
                drive: moments.drive * speed,
                load_torque: moments.load * speed,
                friction: moments.friction * speed,
                ..powers
            },
        }
    }
}

/// What the bearings do besides exerting their forces.
#[derive(Default)]
struct Bearings {
    /// Work per time on the contacts, W.
    power: f64,
    /// Work per time against the damping of the contacts, and what other laws dissipate, W.
    damping_power: f64,
    /// Moment that the balls exert on the shaft by way of the cages, and by surfaces that fall under them, and that of
    /// rubs, N m.
    cage_moment: f64,
    /// Friction moment, N m.
    friction: f64,
    /// Power that the rotation supplies through coefficients that follow its speed, W.
    supplied: f64,
}

impl Bearings {
    /// Adds what a bearing does in its motion, and returns its force; `ratio` is that of its cage to the shaft.
    fn add(
        &mut self,
        bearing: &AttachedBearing<'_>,
        motion: &ElementMotion,
        ratio: f64,
        friction: bool,
    ) -> Vector5 {
        let (support, seen) = (bearing.support, &motion.rotation);
        let (place, velocity) = (&motion.displacement, &motion.rate);
        let turn = quarter_turn(place);
        let [force, damping] = support.damped_force(place, velocity, seen);
        // in the frame that turns with the cage
        let cage_speed = ratio * seen.speed;
        let rate: Vector5 = std::array::from_fn(|axis| velocity[axis] - cage_speed * turn[axis]);
        let surfaces = support.surface_moments([place, velocity], seen, ratio);
        let [elastic, damped] = surfaces.map(|moment| moment * seen.speed);
        self.power += dot(&force, &rate) - elastic;
        self.damping_power += dot(&damping, &rate) - damped;
        let turning = dot(&force, &turn) + dot(&damping, &turn);
        self.cage_moment += ratio * turning + surfaces.iter().sum::<f64>();
        if friction {
            self.friction += support.friction_moment(&force, seen.speed).total();
        }
        std::array::from_fn(|axis| force[axis] + damping[axis])
    }
}

impl Rotor {
    /// Adds the forces of the bearings and of other laws.
    fn bearings_act(&self, state: &[f64], rotation: &Rotation, sum: &mut [f64]) -> Bearings {
        let friction = self.excitation.drive.is_some_and(|drive| drive.friction);
        let mut total = Bearings::default();
        for (bearing, motion) in self.elements.bearings_at(&self.instant(state, rotation)) {
            let ratio = match bearing.support.follows_cage() {
                true => bearing.cage_rate(rotation.angle),
                false => 0.0,
            };
            let force = total.add(&bearing, &motion, ratio, friction);
            bearing.attachment.add_force(-1.0, &force, sum);
        }
        let laws = self.laws_act(&self.instant(state, rotation), sum);
        total.damping_power += laws.dissipated;
        total.cage_moment -= laws.resisting;
        total.supplied = laws.supplied;
        total
    }

    /// Moments on a driven shaft; `unbalances` is the moment by which its unbalances resist as they are moved.
    fn moments(
        &self,
        drive: &Drive,
        bearings: &Bearings,
        rotation: &Rotation,
        unbalances: f64,
    ) -> DriveMoments {
        let resistance = Drive::resistance(rotation.speed);
        let friction = resistance * bearings.friction;
        DriveMoments {
            drive: drive.torque_at(rotation.speed),
            load: resistance * drive.load_torque,
            friction,
            vibration: unbalances + bearings.cage_moment,
            twist: friction * drive.compliance,
        }
    }

    /// Everything that acts in a state; leaves the accelerations of the degrees of freedom in `sum`.
    pub(super) fn act(&self, time: f64, state: &[f64], sum: &mut [f64]) -> Action {
        let dofs = self.dofs();
        let (excitation, linear) = (&self.excitation, &self.linear);
        let (place, velocity) = state[..2 * dofs].split_at(dofs);
        let mut rotation = self.rotation(time, state);
        let phases = self.elements.phases(&rotation);
        // M q̈ = f − (C + ω G) q̇ − (K − ω H) q − Σ Bᵀ F: first the last, so that bearings that balance each other leave
        // nothing
        sum.fill(0.0);
        let bearings = self.bearings_act(state, &rotation, sum);
        for (sum, constant) in sum.iter_mut().zip(&excitation.constant_force) {
            *sum += constant;
        }
        excitation.add_varying_forces::<false>(time, &rotation, &phases, sum);
        linear.add_forces_by_rate(rotation.speed, velocity, sum);
        linear.add_forces_by_place(rotation.speed, place, sum);
        linear.mass.accelerate(sum);
        let mut loads = dot(&excitation.constant_force, velocity);
        loads += excitation.power_of_loads(time, rotation.angle, velocity);
        let unbalance = excitation.power_of_unbalances(&rotation, phases.shaft, velocity);
        let powers = linear.powers(place, velocity, rotation.speed);
        let supplied = bearings.supplied;
        let moments = excitation.drive.as_ref().map(|drive| {
            let mut along = excitation.unbalances_along(rotation.angle, dofs);
            // masses beside the axis feel the base and the weight
            let base = excitation.moment_of_base(time, rotation.angle);
            loads += rotation.speed * base;
            let resisting = dot(&along, sum) + base + powers.internal_moment;
            let moments = self.moments(drive, &bearings, &rotation, resisting);
            rotation.acceleration = moments.total() / excitation.inertia_polar;
            linear.mass.accelerate(&mut along);
            for (sum, along) in sum.iter_mut().zip(&along) {
                *sum += rotation.acceleration * along;
            }
            moments
        });
        Action {
            rotation,
            bearings,
            internal_moment: powers.internal_moment,
            loads,
            unbalance,
            viscous: powers.viscous,
            crossing: powers.crossing + supplied,
            moments,
        }
    }
}
