//! What acts on a shaft in a state, by what it comes from, and at which power.

use super::coefficients::half_square;
use super::energy::Works;
use super::linear_bearing::AttachedLinear;
use super::motion::dot;
use super::structure::UnbalancedPoint;
use super::{Drive, DriveMoments, Rotation, Rotor};
use crate::bearing::{Angle, Vector5, quarter_turn};

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
    /// Power that linear bearings supply whose stiffness is not symmetric, W.
    crossing: f64,
    pub moments: Option<DriveMoments>,
}

impl Action {
    /// Powers in the order of [`Works`], W.
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
        for (bearing, seen) in self.bearings_at(rotation) {
            let support = bearing.support;
            let ratio = match support.follows_cage() {
                true => self.cage_rate(support, rotation.angle),
                false => 0.0,
            };
            let cage_speed = ratio * rotation.speed;
            let [place, velocity] = bearing.motion(place, velocity);
            let turn = quarter_turn(&place);
            let [force, damping] = support.damped_force(&place, &velocity, &seen);
            // in the frame that turns with the cage
            let rate: Vector5 =
                std::array::from_fn(|axis| velocity[axis] - cage_speed * turn[axis]);
            let surfaces = support.surface_moments([&place, &velocity], &seen, ratio);
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
        }
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

    /// Power in W that damping inside the shaft takes of the velocities in the frame that turns with it, and its moment on
    /// the rotation in N m.
    fn internal_damping(&self, place: &[f64], velocity: &[f64], speed: f64) -> [f64; 2] {
        if !self.damped_inside {
            return [0.0; 2];
        }
        let [mut across, mut resisting] = [(); 2].map(|()| vec![0.0; self.dofs()]);
        self.circulatory.add_product(1.0, place, &mut across);
        self.internal_damping
            .add_product(1.0, place, &mut resisting);
        let (crossing, held) = (dot(&across, velocity), dot(&resisting, place));
        let moment = crossing - speed * held;
        let along = 2.0 * half_square(&self.internal_damping.entries, velocity);
        [along - speed * (crossing + moment), moment]
    }

    /// Power of the part of K that is not symmetric and has no potential, as of films, `−½ (q̇ᵀ K q − qᵀ K q̇)`, W.
    fn crossing_power(&self, place: &[f64], velocity: &[f64]) -> f64 {
        let across = |own: &AttachedLinear| own.stiffness != own.stiffness.transpose();
        if !self.structure.linear.iter().any(across) {
            return 0.0;
        }
        let [mut by_place, mut by_rate] = [(); 2].map(|()| vec![0.0; self.dofs()]);
        self.stiffness.add_product(1.0, place, &mut by_place);
        self.stiffness.add_product(1.0, velocity, &mut by_rate);
        0.5 * (dot(&by_rate, place) - dot(&by_place, velocity))
    }

    /// Everything that acts in a state; leaves the accelerations of the degrees of freedom in `sum`.
    pub(super) fn act(&self, time: f64, state: &[f64], sum: &mut [f64]) -> Action {
        let dofs = self.dofs();
        let (place, velocity) = state[..2 * dofs].split_at(dofs);
        let mut rotation = self.rotation(time, state);
        sum.fill(0.0);
        // first, so that bearings that balance each other leave nothing
        let bearings = self.bearings_act(place, velocity, &rotation, sum);
        for (sum, constant) in sum.iter_mut().zip(&self.constant_force) {
            *sum += constant;
        }
        self.add_loads(time, rotation.angle, sum);
        self.add_unbalances::<false>(&rotation, &self.phases(&rotation), sum);
        self.damping.add_product(-1.0, velocity, sum);
        self.stiffness.add_product(-1.0, place, sum);
        self.circulatory.add_product(rotation.speed, place, sum);
        self.gyroscopic.add_product(-rotation.speed, velocity, sum);
        self.mass.accelerate(sum);
        let [internal, internal_moment] = self.internal_damping(place, velocity, rotation.speed);
        let mut loads = dot(&self.constant_force, velocity);
        loads += self.power_of_loads(time, rotation.angle, velocity);
        let unbalance = self.power_of_unbalances(&rotation, velocity);
        let moments = self.drive.as_ref().map(|drive| {
            let mut along = self.unbalances_along(rotation.angle);
            // masses beside the axis feel the base and the weight
            let base = self.felt_by_unbalances(time, rotation.angle);
            loads += rotation.speed * base;
            let resisting = dot(&along, sum) + base + internal_moment;
            let moments = self.moments(drive, &bearings, &rotation, resisting);
            rotation.acceleration = moments.total() / self.inertia_polar;
            self.mass.accelerate(&mut along);
            for (sum, along) in sum.iter_mut().zip(&along) {
                *sum += rotation.acceleration * along;
            }
            moments
        });
        let [all, turning] = [&self.damping, &self.internal_damping]
            .map(|damping| half_square(&damping.entries, velocity));
        Action {
            rotation,
            bearings,
            internal_moment,
            loads,
            unbalance,
            viscous: 2.0 * (all - turning) + internal,
            crossing: self.crossing_power(place, velocity),
            moments,
        }
    }

    /// Forces of the unbalances on the degrees of freedom per angular acceleration at an angle of the shaft, kg m and kg m².
    pub(super) fn unbalances_along(&self, angle: f64) -> Vec<f64> {
        let mut sum = vec![0.0; self.dofs()];
        for UnbalancedPoint { point, unbalance } in &self.structure.unbalances {
            point.add_force(1.0, &unbalance.along(Angle::new(angle)), &mut sum);
        }
        sum
    }

    /// Moment on the rotation of base motion and weight through the unbalances, N m.
    fn felt_by_unbalances(&self, time: f64, angle: f64) -> f64 {
        let [a_x, a_y, _] = self.base_acceleration(time, angle);
        let moment = |own: &UnbalancedPoint| {
            let [x, y, ..] = own.unbalance.along(Angle::new(angle));
            x * a_x + y * (a_y + self.gravity)
        };
        self.structure.unbalances.iter().map(moment).sum()
    }
}
