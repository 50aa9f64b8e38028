//! What acts on a shaft in a state, by what it comes from, and at which power.

use super::energy::Works;
use super::{Drive, DriveMoments, FREEDOMS, Rotation, Rotor};
use crate::bearing::{Angle, Vector5, quarter_turn};

/// What acts on the shaft in a state.
pub(super) struct Action {
    pub velocity: Vector5,
    pub rotation: Rotation,
    pub unbalance: Vector5,
    bearings: Bearings,
    /// Loads at the centre of mass.
    pub on_mass: Vector5,
    /// Loads on the shaft's axis.
    on_centre: Vector5,
    viscous: Vector5,
    /// All forces that act on the shaft's axis.
    pub at_centre: Vector5,
    pub moments: Option<DriveMoments>,
}

impl Action {
    /// Powers in the order of [`Works`], W.
    pub fn powers(&self, rotor: &Rotor) -> Works {
        let velocity = &self.velocity;
        let mut loads = dot(&self.on_mass, velocity) + dot(&self.on_centre, velocity);
        let bearings = &self.bearings;
        let speed = self.rotation.speed;
        let mut powers = Works {
            loads,
            viscous: dot(&self.viscous, velocity),
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

/// Forces on the shaft, by what they come from, and the powers of some.
#[derive(Default)]
struct Bearings {
    force: Vector5,
    damping: Vector5,
    /// Work per time on the contacts, W.
    power: f64,
    /// Work per time against the damping of the contacts, W.
    damping_power: f64,
    /// Moment that the balls exert on the shaft by way of the cages, N m.
    cage_moment: f64,
    /// Friction moment, N m.
    friction: f64,
}

impl Rotor {
    fn bearings(&self, place: &Vector5, velocity: &Vector5, rotation: &Rotation) -> Bearings {
        let friction = self.drive.is_some_and(|drive| drive.friction);
        let turn = quarter_turn(place);
        let mut sum = Bearings::default();
        self.for_each_support(rotation, &self.phases(rotation), |support, rotation| {
            let ratio = if support.follows_cage() {
                self.cage_ratio(support)
            } else {
                0.0
            };
            let cage_speed = ratio * rotation.speed;
            let [force, damping] = support.damped_force(place, velocity, rotation);
            // in the frame that turns with the cage
            let rate: Vector5 =
                std::array::from_fn(|axis| velocity[axis] - cage_speed * turn[axis]);
            sum.power += dot(&force, &rate);
            sum.damping_power += dot(&damping, &rate);
            sum.cage_moment += ratio * (dot(&force, &turn) + dot(&damping, &turn));
            if friction {
                sum.friction += support.friction_moment(&force, rotation.speed).total();
            }
            for axis in 0..FREEDOMS {
                sum.force[axis] += force[axis];
                sum.damping[axis] += damping[axis];
            }
        });
        sum
    }

    /// Moments on a driven shaft; `at_centre` are the forces that do not act at the centre of mass.
    fn moments(
        &self,
        drive: &Drive,
        bearings: &Bearings,
        rotation: &Rotation,
        at_centre: &Vector5,
    ) -> DriveMoments {
        let resistance = Drive::resistance(rotation.speed);
        let friction = resistance * bearings.friction;
        DriveMoments {
            drive: drive.torque_at(rotation.speed),
            load: resistance * drive.load_torque,
            friction,
            // e (f_x sin ψ − f_y cos ψ) + Σ (ω_c/ω) F·Sq
            vibration: self
                .unbalance
                .moment_of([at_centre[0], at_centre[1]], rotation)
                + bearings.cage_moment,
            twist: friction * drive.compliance,
        }
    }

    /// Everything that acts in a state.
    pub(super) fn act(&self, time: f64, state: &[f64]) -> Action {
        let [place, velocity] = self.motion(state);
        let mut rotation = self.rotation(time, state);
        let bearings = self.bearings(&place, &velocity, &rotation);
        let [on_mass, on_centre] = self.loads_apart(time, rotation.angle);
        let viscous = self.damping.force(&velocity[..self.kept]);
        let at_centre: Vector5 = std::array::from_fn(|axis| {
            on_centre[axis] - viscous[axis] - bearings.force[axis] - bearings.damping[axis]
        });
        let moments = self.drive.as_ref().map(|drive| {
            let moments = self.moments(drive, &bearings, &rotation, &at_centre);
            rotation.acceleration = moments.total() / self.inertia_polar;
            moments
        });
        let [x, y] = self.unbalance.force(&rotation, Angle::new(rotation.angle));
        Action {
            velocity,
            rotation,
            unbalance: [x, y, 0.0, 0.0, 0.0],
            bearings,
            on_mass,
            on_centre,
            viscous,
            at_centre,
            moments,
        }
    }
}

fn dot(a: &Vector5, b: &Vector5) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
