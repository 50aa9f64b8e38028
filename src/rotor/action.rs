//! What acts on a shaft in a state, by what it comes from, and at which power.

use super::energy::Works;
use super::{Drive, DriveMoments, Rotation, Rotor};
use crate::bearing::{Angle, Vector5, quarter_turn};

/// What acts on the shaft in a state.
pub(super) struct Action {
    pub rotation: Rotation,
    /// Velocity of the centre of mass and tilting rates.
    velocity: Vector5,
    unbalance: Vector5,
    bearings: Bearings,
    /// Loads at the centre of mass.
    on_mass: Vector5,
    /// Loads on the shaft's axis.
    on_axis: Vector5,
    /// Power of the base on housings, W.
    on_housings: f64,
    /// Power that viscous damping takes, W.
    viscous: f64,
    pub moments: Option<DriveMoments>,
}

impl Action {
    /// Powers in the order of [`Works`], W.
    pub fn powers(&self, rotor: &Rotor) -> Works {
        let velocity = &self.velocity;
        let mut loads = dot(&self.on_mass, velocity) + dot(&self.on_axis, velocity);
        loads += self.on_housings;
        let bearings = &self.bearings;
        let speed = self.rotation.speed;
        let mut powers = Works {
            loads,
            viscous: self.viscous,
            contact: bearings.damping_power,
            bearings: bearings.power,
            ..Works::default()
        };
        match &self.moments {
            None => {
                powers.unbalance = dot(&self.unbalance, velocity);
                powers.rotation = -bearings.cage_moment * speed;
            }
            Some(moments) => {
                let [x, y, ..] = self.on_mass;
                loads += rotor.unbalance.power([x, y], &self.rotation);
                powers.loads = loads;
                powers.drive = moments.drive * speed;
                powers.load_torque = moments.load * speed;
                powers.friction = moments.friction * speed;
            }
        }
        powers
    }
}

/// What the bearings do besides exerting their forces.
#[derive(Default)]
struct Bearings {
    /// Work per time on the contacts, W.
    power: f64,
    /// Work per time against the damping of the contacts, W.
    damping_power: f64,
    /// Moment that the balls exert on the shaft by way of the cages, and by surfaces that fall under them, N m.
    cage_moment: f64,
    /// Friction moment, N m.
    friction: f64,
}

impl Rotor {
    /// Adds the forces of the bearings.
    fn bearings_act(
        &self,
        place: &[f64],
        velocity: &[f64],
        rotation: &Rotation,
        sum: &mut [f64],
    ) -> Bearings {
        let friction = self.drive.is_some_and(|drive| drive.friction);
        let mut total = Bearings::default();
        let rotation_of_shaft = rotation;
        self.for_each_bearing(rotation, &self.phases(rotation), |bearing, rotation| {
            let support = bearing.support;
            let ratio = if support.follows_cage() {
                self.cage_rate(support, rotation_of_shaft.angle)
            } else {
                0.0
            };
            let cage_speed = ratio * rotation.speed;
            let [place, velocity] = bearing.motion(place, velocity);
            let turn = quarter_turn(&place);
            let [force, damping] = support.damped_force(&place, &velocity, rotation);
            // in the frame that turns with the cage
            let rate: Vector5 =
                std::array::from_fn(|axis| velocity[axis] - cage_speed * turn[axis]);
            let surfaces = support.surface_moments([&place, &velocity], rotation, ratio);
            let [elastic, damped] = surfaces.map(|moment| moment * rotation.speed);
            total.power += dot(&force, &rate) - elastic;
            total.damping_power += dot(&damping, &rate) - damped;
            let turning = dot(&force, &turn) + dot(&damping, &turn);
            total.cage_moment += ratio * turning + surfaces.iter().sum::<f64>();
            if friction {
                total.friction += support.friction_moment(&force, rotation.speed).total();
            }
            let both = std::array::from_fn(|axis| force[axis] + damping[axis]);
            bearing.attachment.add_force(-1.0, &both, sum);
        });
        total
    }

    /// Moments on a driven shaft; `on_axis` is the force in x and y that does not act at the centre of mass.
    fn moments(
        &self,
        drive: &Drive,
        bearings: &Bearings,
        rotation: &Rotation,
        on_axis: [f64; 2],
    ) -> DriveMoments {
        let resistance = Drive::resistance(rotation.speed);
        let friction = resistance * bearings.friction;
        DriveMoments {
            drive: drive.torque_at(rotation.speed),
            load: resistance * drive.load_torque,
            friction,
            // e (f_x sin ψ − f_y cos ψ) + Σ (ω_c/ω) F·Sq
            vibration: self.unbalance.moment_of(on_axis, rotation) + bearings.cage_moment,
            twist: friction * drive.compliance,
        }
    }

    /// Everything that acts in a state; leaves the accelerations of the degrees of freedom in `sum`.
    pub(super) fn act(&self, time: f64, state: &[f64], sum: &mut [f64]) -> Action {
        let dofs = self.dofs();
        let (place, velocity) = state[..2 * dofs].split_at(dofs);
        let shaft = &self.structure.shaft;
        let mut rotation = self.rotation(time, state);
        let [on_mass, on_axis] = self.loads_apart(time, rotation.angle);
        sum.fill(0.0);
        // first, so that bearings that balance each other leave nothing
        let bearings = self.bearings_act(place, velocity, &rotation, sum);
        shaft.add_force(1.0, &on_axis, sum);
        self.shake_housings(time, rotation.angle, sum);
        self.damping.add_product(-1.0, velocity, sum);
        self.structure.stiffness.add_product(-1.0, place, sum);
        let moments = self.drive.as_ref().map(|drive| {
            let [x, y, ..] = shaft.rate(sum);
            let moments = self.moments(drive, &bearings, &rotation, [x, y]);
            rotation.acceleration = moments.total() / self.inertia_polar;
            moments
        });
        let unbalance = self.unbalance.force(&rotation, Angle::new(rotation.angle));
        shaft.add_force(1.0, &on_mass, sum);
        shaft.add_force(1.0, &unbalance, sum);
        self.gyroscopic.add_product(-rotation.speed, velocity, sum);
        self.mass.accelerate(sum);
        Action {
            rotation,
            velocity: shaft.rate(velocity),
            unbalance,
            bearings,
            on_mass,
            on_axis,
            on_housings: self.base_power(time, rotation.angle, velocity),
            viscous: 2.0 * self.damping.half_square(velocity),
            moments,
        }
    }
}

fn dot(a: &Vector5, b: &Vector5) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
