//! Where the energy of a motion is, where it came from and where it went.

use super::{Rotation, Rotor, dot};

/// Energy of a shaft at one instant, and what has been done on it since t = 0, J.
///
/// ```text
/// T − T_0 + U − U_0 + D_viscous + D_contact + W_friction + W_load torque
///     = W_loads + W_unbalance + W_rotation + W_drive
/// ```
///
/// Where balls have inertia, or films follow a changing speed, the ball bearings have no potential; there
/// `W_bearings`, the work of the shaft on them, takes the place of their part of U − U_0, and the difference of
/// both is what the rotation exchanges with balls and films.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct EnergyBalance {
    /// T: of the mass and the tilts; of a driven shaft with its rotation.
    pub kinetic: f64,
    /// U: of contacts, films, springs, and what is elastic besides.
    pub stored: f64,
    /// The part of U in all but the ball bearings: in shaft, housings and elements.
    pub elastic: f64,
    /// Whether the work on the ball bearings is the change of what they store.
    pub conservative: bool,
    /// What went where since t = 0.
    pub works: Works,
}

/// Works since t = 0, J.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct Works {
    /// Supplied by the loads, the weight among them.
    pub loads: f64,
    /// Supplied by the rotation through the unbalance; part of the whole where the shaft is driven.
    pub unbalance: f64,
    /// Supplied by the rotation of the cages past the displaced shaft, likewise, by rubs, and by linear elements whose stiffness
    /// is not symmetric or follows the speed.
    pub rotation: f64,
    /// Dissipated by viscous damping.
    pub viscous: f64,
    /// Dissipated in the contacts of bearings, and by squeeze films, rubs and the damping of elements whose coefficients follow the speed.
    pub contact: f64,
    /// Done on the bearings' contacts, by shaft and cages.
    pub bearings: f64,
    /// Supplied by the drive.
    pub drive: f64,
    /// Taken by the driven machine.
    pub load_torque: f64,
    /// Dissipated by the friction of the bearings.
    pub friction: f64,
}

impl Works {
    /// Number of works.
    pub(super) const COUNT: usize = Self::PARTS.len();

    /// Each of them, in the order of the states.
    const PARTS: [fn(&mut Self) -> &mut f64; 9] = [
        |works| &mut works.loads,
        |works| &mut works.unbalance,
        |works| &mut works.rotation,
        |works| &mut works.viscous,
        |works| &mut works.contact,
        |works| &mut works.bearings,
        |works| &mut works.drive,
        |works| &mut works.load_torque,
        |works| &mut works.friction,
    ];

    /// From values in the order of [`Works::values`]; what is missing is zero.
    pub(super) fn from_values(values: &[f64]) -> Self {
        let mut works = Self::default();
        for (part, value) in Self::PARTS.iter().zip(values) {
            *part(&mut works) = *value;
        }
        works
    }

    /// All of them, in the order of the states.
    pub(crate) fn values(mut self) -> [f64; Self::COUNT] {
        Self::PARTS.map(|part| *part(&mut self))
    }

    /// Supplied less dissipated.
    fn gained(&self) -> f64 {
        let supplied = self.loads + self.unbalance + self.rotation + self.drive;
        supplied - self.viscous - self.contact - self.load_torque - self.friction
    }
}

impl EnergyBalance {
    /// What all that is elastic has taken up since `start`, J.
    fn taken(&self, start: &Self) -> f64 {
        if self.conservative {
            self.stored - start.stored
        } else {
            self.works.bearings + self.elastic - start.elastic
        }
    }

    /// What does not add up since `start`, J: the error of the integration.
    pub(crate) fn residual(&self, start: &Self) -> f64 {
        self.kinetic - start.kinetic + self.taken(start) - self.works.gained()
    }

    /// The largest term of the balance since `start`, J.
    pub(crate) fn largest(&self, start: &Self) -> f64 {
        let works = self.works.values().into_iter();
        works
            .chain([self.kinetic - start.kinetic, self.taken(start)])
            .map(f64::abs)
            .fold(self.kinetic.max(start.kinetic), f64::max)
    }
}

impl Rotor {
    /// Derivative of all states.
    #[inline(never)]
    pub(super) fn augmented_derivative(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        let dofs = self.dofs();
        rate[..dofs].copy_from_slice(&state[dofs..2 * dofs]);
        let action = self.act(time, state, &mut rate[dofs..2 * dofs]);
        if action.moments.is_some() {
            rate[2 * dofs] = action.rotation.speed;
            rate[2 * dofs + 1] = action.rotation.acceleration;
        }
        rate[self.first_work()..].copy_from_slice(&action.powers().values());
    }

    /// Kinetic energy, J.
    fn kinetic(&self, velocity: &[f64], rotation: &Rotation) -> f64 {
        let motion = self.linear.kinetic(velocity);
        if !self.is_driven() {
            return motion;
        }
        // masses beside the axis: ½ ω² U² a, with a the acceleration by a force at them, and −ω along·q̇
        let excitation = &self.excitation;
        let along = excitation.unbalances_along(rotation.angle, self.dofs());
        let mut accelerated = along.clone();
        self.linear.mass.accelerate(&mut accelerated);
        let inertia = excitation.inertia_polar + dot(&along, &accelerated);
        let speed = rotation.speed;
        motion + 0.5 * inertia * speed * speed - speed * dot(&along, velocity)
    }

    /// Where the energy is in a state at a time, and what has been done since t = 0.
    pub(super) fn energy_balance(&self, time: f64, state: &[f64]) -> EnergyBalance {
        let rotation = self.rotation(time, state);
        let at = self.instant(state, &rotation);
        let stored = self.elements.bearings_at(&at).map(|(bearing, motion)| {
            let support = bearing.support;
            support.stored_energy(&motion.displacement, &motion.rotation)
        });
        let steady = !self.is_driven() && self.excitation.speed.is_constant();
        let elastic = self.linear.elastic(at.place) + self.energy_of_laws(&at);
        EnergyBalance {
            kinetic: self.kinetic(at.velocity, &rotation),
            stored: elastic + stored.sum::<f64>(),
            elastic,
            conservative: self
                .elements
                .supports()
                .all(|support| support.has_potential(steady)),
            works: Works::from_values(&state[self.first_work()..]),
        }
    }
}
