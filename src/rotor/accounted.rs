//! The shaft in motion with its energy accounted for, and, where it is driven, with its rotation.

use nalgebra::SMatrix;

use super::energy::{EnergyBalance, Works};
use super::{
    BallContacts, Drive, DriveMoments, FREEDOMS, MotionScale, Moving, Rotation, Rotor, Sample,
};
use crate::bearing::{Support, Vector5};
use crate::integrate::{Linearised, Scaling, System};

/// Relative step of the differences that stand for slopes: the cube root of round-off.
const STEP: f64 = 6e-6;
/// Time over which the change of the right-hand side is looked at, s.
const TIME_STEP: f64 = 1e-8;

/// States of an accounted rotor that keeps all freedoms and is driven.
pub const ACCOUNTED_STATES: usize = 2 * FREEDOMS + 2 + Works::COUNT;

type State = [f64; ACCOUNTED_STATES];

/// A rotor whose state goes on with the angle and the speed of its shaft, where it is driven, and with
/// the works of [`Works`]:
///
/// ```text
/// (q, q̇, [ψ, ω], W_1 … W_9, 0 … )
/// ```
///
/// What is left of [`ACCOUNTED_STATES`] where fewer freedoms are kept stays zero.
/// The works are integrals that the integrator keeps as exactly as the motion itself. A scene that
/// asks neither for energy nor for a drive does not pay for it: a [`Rotor`] moves by itself, too.
#[derive(Debug, Clone, Copy)]
pub struct AccountedRotor<'a> {
    rotor: &'a Rotor,
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

impl<'a> AccountedRotor<'a> {
    /// The rotor with its accounts.
    pub fn new(rotor: &'a Rotor) -> Self {
        Self { rotor }
    }

    /// Number of states of the rotation.
    fn turning(rotor: &Rotor) -> usize {
        if rotor.drive.is_some() { 2 } else { 0 }
    }

    /// Angle and speed; the acceleration of a driven shaft is not known before its moments are.
    fn rotation(&self, time: f64, state: &[f64]) -> Rotation {
        match self.rotor.drive {
            None => self.rotor.speed.at(time),
            Some(_) => {
                let first = 2 * self.rotor.kept;
                Rotation {
                    angle: state[first],
                    speed: state[first + 1],
                    acceleration: 0.0,
                }
            }
        }
    }

    fn motion(&self, state: &[f64]) -> [Vector5; 2] {
        let (rotor, kept) = (self.rotor, self.rotor.kept);
        [
            rotor.full(&rotor.equilibrium.displacement, &state[..kept]),
            rotor.full(&[0.0; FREEDOMS], &state[kept..2 * kept]),
        ]
    }

    fn bearings(&self, place: &Vector5, velocity: &Vector5, rotation: &Rotation) -> Bearings {
        let rotor = self.rotor;
        let friction = rotor.drive.is_some_and(|drive| drive.friction);
        let turn = quarter_turn(place);
        let mut sum = Bearings::default();
        rotor.for_each_support(rotation.angle, &rotor.phases(rotation), |support, cage| {
            let ratio = if support.follows_cage() {
                rotor.cage_ratio(support)
            } else {
                0.0
            };
            let cage_speed = ratio * rotation.speed;
            let force = support.force(place, cage, rotation.speed);
            let speeds = [cage_speed, rotation.speed];
            let damping = support.damping_force(place, velocity, cage, speeds);
            // seen by one who turns with the cage
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
        let eccentricity = self.rotor.imbalance * self.rotor.inverse_mass[0];
        let (sin, cos) = rotation.angle.sin_cos();
        let resistance = Drive::resistance(rotation.speed);
        let friction = resistance * bearings.friction;
        DriveMoments {
            drive: drive.torque_at(rotation.speed),
            load: resistance * drive.load_torque,
            friction,
            // e (f_x sin ψ − f_y cos ψ) + Σ (ω_c/ω) F·Sq
            vibration: eccentricity * (at_centre[0] * sin - at_centre[1] * cos)
                + bearings.cage_moment,
            twist: friction * drive.compliance,
        }
    }

    /// Everything that acts in a state.
    fn act(&self, time: f64, state: &[f64]) -> Action {
        let rotor = self.rotor;
        let [place, velocity] = self.motion(state);
        let mut rotation = self.rotation(time, state);
        let bearings = self.bearings(&place, &velocity, &rotation);
        let [on_mass, on_centre] = rotor.loads_apart(time, rotation.angle);
        let mut viscous = [0.0; FREEDOMS];
        rotor.damping.brake(&velocity[..rotor.kept], &mut viscous);
        let at_centre: Vector5 = std::array::from_fn(|axis| {
            on_centre[axis] + viscous[axis] - bearings.force[axis] - bearings.damping[axis]
        });
        let moments = rotor.drive.as_ref().map(|drive| {
            let moments = self.moments(drive, &bearings, &rotation, &at_centre);
            rotation.acceleration = moments.total() / rotor.inertia_polar;
            moments
        });
        Action {
            velocity,
            rotation,
            unbalance: rotor.unbalance(&rotation, &rotor.phases(&rotation)),
            bearings,
            on_mass,
            on_centre,
            viscous,
            at_centre,
            moments,
        }
    }

    /// Kinetic energy, J.
    fn kinetic(&self, velocity: &Vector5, rotation: &Rotation) -> f64 {
        let rotor = self.rotor;
        let squares =
            (0..rotor.kept).map(|axis| rotor.mass[axis] * velocity[axis] * velocity[axis]);
        let motion = 0.5 * squares.sum::<f64>();
        if rotor.drive.is_none() {
            return motion;
        }
        // of the centre of mass, (ẋ − e ω sin ψ, ẏ + e ω cos ψ), and of the rotation
        let (sin, cos) = rotation.angle.sin_cos();
        let eccentricity = rotor.imbalance * rotor.inverse_mass[0];
        let speed = rotation.speed;
        motion
            + rotor.imbalance * speed * (velocity[1] * cos - velocity[0] * sin)
            + 0.5 * speed * speed * (rotor.inertia_polar + rotor.imbalance * eccentricity)
    }

    fn stored(&self, place: &Vector5, rotation: &Rotation) -> f64 {
        let mut stored = 0.0;
        let phases = self.rotor.phases(rotation);
        self.rotor
            .for_each_support(rotation.angle, &phases, |support, cage| {
                stored += support.stored_energy(place, cage, rotation.speed);
            });
        stored
    }

    fn balance(&self, time: f64, state: &[f64]) -> EnergyBalance {
        let [place, velocity] = self.motion(state);
        let rotation = self.rotation(time, state);
        let first = 2 * self.rotor.kept + Self::turning(self.rotor);
        let steady = self.rotor.drive.is_none() && self.rotor.speed.is_constant();
        EnergyBalance {
            kinetic: self.kinetic(&velocity, &rotation),
            stored: self.stored(&place, &rotation),
            conservative: self
                .rotor
                .supports
                .iter()
                .all(|support| support.has_potential(steady)),
            works: Works::from_values(&state[first..]),
        }
    }
}

/// What acts on the shaft in a state.
struct Action {
    velocity: Vector5,
    rotation: Rotation,
    unbalance: Vector5,
    bearings: Bearings,
    /// Loads at the centre of mass.
    on_mass: Vector5,
    /// Loads on the shaft's axis.
    on_centre: Vector5,
    viscous: Vector5,
    /// All forces that act on the shaft's axis.
    at_centre: Vector5,
    moments: Option<DriveMoments>,
}

impl Action {
    /// Powers in the order of [`Works`], W.
    fn powers(&self, rotor: &Rotor) -> Works {
        let velocity = &self.velocity;
        let mut loads = dot(&self.on_mass, velocity) + dot(&self.on_centre, velocity);
        let bearings = &self.bearings;
        let speed = self.rotation.speed;
        let mut powers = Works {
            loads,
            viscous: -dot(&self.viscous, velocity),
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
                // the centre of mass moves by e ω (−sin ψ, cos ψ) besides
                let (sin, cos) = self.rotation.angle.sin_cos();
                let around = rotor.imbalance * rotor.inverse_mass[0] * speed;
                loads += around * (self.on_mass[1] * cos - self.on_mass[0] * sin);
                powers.loads = loads;
                powers.drive = moments.drive * speed;
                powers.load_torque = moments.load * speed;
                powers.friction = moments.friction * speed;
            }
        }
        powers
    }
}

impl System<ACCOUNTED_STATES> for AccountedRotor<'_> {
    fn derivative(&self, time: f64, state: &State, rate: &mut State) {
        let rotor = self.rotor;
        let kept = rotor.kept;
        let action = self.act(time, state);
        let gyroscopic = rotor.gyroscopic(&action.velocity, action.rotation.speed);
        for axis in 0..kept {
            let push = action.at_centre[axis]
                + action.on_mass[axis]
                + action.unbalance[axis]
                + gyroscopic[axis];
            rate[axis] = action.velocity[axis];
            rate[kept + axis] = push * rotor.inverse_mass[axis];
        }
        let mut next = 2 * kept;
        if action.moments.is_some() {
            rate[next] = action.rotation.speed;
            rate[next + 1] = action.rotation.acceleration;
            next += 2;
        }
        let powers = action.powers(rotor).values();
        rate[next..].fill(0.0);
        rate[next..next + Works::COUNT].copy_from_slice(&powers);
    }

    fn next_break(&self, after: f64) -> f64 {
        self.rotor.next_break_after(after)
    }
}

impl Linearised<ACCOUNTED_STATES> for AccountedRotor<'_> {
    /// By central differences: exact slopes of powers are not worth their code.
    fn linearisation(
        &self,
        time: f64,
        state: &State,
    ) -> (SMatrix<f64, ACCOUNTED_STATES, ACCOUNTED_STATES>, State) {
        let steps = self.difference_steps();
        let rate_at = |time: f64, state: &State| {
            let mut rate = [0.0; ACCOUNTED_STATES];
            self.derivative(time, state, &mut rate);
            rate
        };
        let mut jacobian = SMatrix::zeros();
        // no rate depends on the works
        let moving = 2 * self.rotor.kept + Self::turning(self.rotor);
        for column in 0..moving {
            let step = steps[column];
            let moved = |step: f64| {
                let mut moved = *state;
                moved[column] += step;
                rate_at(time, &moved)
            };
            let (up, down) = (moved(step), moved(-step));
            for row in 0..ACCOUNTED_STATES {
                jacobian[(row, column)] = (up[row] - down[row]) / (2.0 * step);
            }
        }
        let later = |part: f64| rate_at(time + part * TIME_STEP, state);
        let (now, half, full) = (later(0.0), later(0.5), later(1.0));
        let by_time =
            std::array::from_fn(|row| (4.0 * half[row] - 3.0 * now[row] - full[row]) / TIME_STEP);
        (jacobian, by_time)
    }
}

impl AccountedRotor<'_> {
    /// Steps of the differences by each state that moves: short against what the contacts yield.
    fn difference_steps(&self) -> [f64; 2 * FREEDOMS + 2] {
        let rotor = self.rotor;
        let kept = rotor.kept;
        let arm = Support::largest(
            &rotor.supports,
            crate::bearing::Geometry::inner_groove_radius,
        );
        let length = STEP * APPROACH;
        std::array::from_fn(|index| match index {
            index if index < 2 * kept => {
                let lever = if index % kept < 3 { 1.0 } else { arm };
                let unit = if index < kept { 1.0 } else { RATE };
                length * unit / lever
            }
            _ => STEP,
        })
    }
}

/// A usual approach of a contact, m.
const APPROACH: f64 = 1e-5;
/// A usual angular frequency, rad/s.
const RATE: f64 = 1e3;

impl Moving<ACCOUNTED_STATES> for AccountedRotor<'_> {
    fn rotor(&self) -> &Rotor {
        self.rotor
    }

    fn start(&self) -> State {
        let mut state = [0.0; ACCOUNTED_STATES];
        let kept = self.rotor.kept;
        let [displacement, velocity] = &self.rotor.initial;
        state[..kept].copy_from_slice(&displacement[..kept]);
        state[kept..2 * kept].copy_from_slice(&velocity[..kept]);
        if self.rotor.drive.is_some() {
            state[2 * kept + 1] = self.rotor.speed();
        }
        state
    }

    fn scaling(&self, scale: &MotionScale) -> Scaling<ACCOUNTED_STATES> {
        let rotor = self.rotor;
        let (kept, turning) = (rotor.kept, Self::turning(rotor));
        // kinetic energy of the motion
        let energy = rotor.mass[0] * (scale.length * scale.frequency).powi(2);
        let mut scaling = Scaling {
            origin: [0.0; ACCOUNTED_STATES],
            scale: [energy; ACCOUNTED_STATES],
            time: 1.0 / scale.frequency,
        };
        scaling.origin[..kept].copy_from_slice(&rotor.equilibrium.displacement[..kept]);
        for axis in 0..kept {
            let length = scale.length / scale.lever(axis);
            scaling.scale[axis] = length;
            scaling.scale[kept + axis] = length * scale.frequency;
        }
        if turning > 0 {
            scaling.scale[2 * kept] = 1.0;
            scaling.scale[2 * kept + 1] = scale.frequency;
        }
        scaling
    }

    fn sample(&self, time: f64, state: &State, contacts: &mut BallContacts) -> Sample {
        let [place, velocity] = self.motion(state);
        let action = self.rotor.drive.map(|_| self.act(time, state));
        let rotation = match &action {
            Some(action) => action.rotation,
            None => self.rotation(time, state),
        };
        Sample {
            energy: Some(self.balance(time, state)),
            drive: action.and_then(|action| action.moments),
            ..self
                .rotor
                .observe(time, &rotation, [place, velocity], contacts)
        }
    }
}

/// A displacement turned by a right angle about Z.
fn quarter_turn(vector: &Vector5) -> Vector5 {
    let [x, y, _, tilt_x, tilt_y] = *vector;
    [-y, x, 0.0, -tilt_y, tilt_x]
}

fn dot(a: &Vector5, b: &Vector5) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
