//! A motor that turns the shaft, and what resists it.

/// Speed about which a resisting moment changes its sign, rad/s: a tenth of a revolution a minute.
const CREEP: f64 = 0.01;

/// A drive: the speed of the shaft follows from the moments on it.
///
/// ```text
/// I_p ω̇ = T(ω) − s(ω) (T_L + M_f) + Σ_unbalances d·(q̈ + a) + Σ_bearings (ω_c/ω) F·Sq
/// d = U (sin ψ, −cos ψ), and of a couple U_c (cos ψ, sin ψ) about X and Y
/// T(ω) = T_0 (1 − ω/ω_0), or T_0 alone     s(ω) = ω/√(ω² + (0.01 rad/s)²)
/// ```
///
/// | symbol | meaning | unit |
/// |---|---|---|
/// | T, T_L, M_f | moment of the motor, of the load, of the bearings' friction | N m |
/// | U, U_c | an unbalance, and a couple of unbalances | kg m, kg m² |
/// | q̈, a | acceleration of its point of the shaft were ω̇ zero; that of the base with gravity | m/s² |
/// | F·Sq | moment that the balls ask of the cage as they roll past the displaced shaft | N m |
///
/// So the unbalance takes from the rotation what it gives to the vibration: a weak motor may hang at
/// a critical speed. Resisting moments only resist: a shaft that they bring to rest stays, but for a
/// creep, at rest.
///
/// Source: the equations of an unbalanced rotor of its own drive, e.g. Gasch, Nordmann & Pfützner,
/// *Rotordynamik* (2006), ch. 6 (run-up through resonance); A. Sommerfeld (1902).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drive {
    /// Moment T_0 of the motor at rest, N m.
    pub torque: f64,
    /// Speed ω_0 at which the motor gives no moment, rad/s; `None`: its moment is constant.
    pub no_load_speed: Option<f64>,
    /// Moment T_L of the driven machine, N m, against the rotation.
    pub load_torque: f64,
    /// Whether the friction of the bearings resists.
    pub friction: bool,
    /// Twist of the shaft under the friction moment of its bearings, rad/(N m): `L/(G I_p)` of the
    /// segment that it twists.
    pub compliance: f64,
}

impl Drive {
    /// Moment of the motor at a speed in rad/s, N m.
    pub fn torque_at(&self, speed: f64) -> f64 {
        // T_0 (1 − ω/ω_0)
        self.no_load_speed
            .map_or(self.torque, |idle| self.torque * (1.0 - speed / idle))
    }

    /// s(ω): the part of a resisting moment that acts at a speed in rad/s, −1 … 1.
    pub fn resistance(speed: f64) -> f64 {
        speed / speed.hypot(CREEP)
    }
}

/// Moments on a driven shaft at one instant, N m.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct DriveMoments {
    /// Of the motor.
    pub drive: f64,
    /// Of the driven machine, against the rotation.
    pub load: f64,
    /// Of the bearings' friction, against the rotation.
    pub friction: f64,
    /// What unbalance and cages ask of the rotation: the rest of `I_p ω̇`.
    pub vibration: f64,
    /// Twist of the shaft under the friction moment θz, rad.
    pub twist: f64,
}

impl DriveMoments {
    /// Sum about the shaft's axis, N m.
    pub fn total(&self) -> f64 {
        self.drive - self.load - self.friction + self.vibration
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_moment_of_the_motor_falls_with_the_speed() {
        let drive = Drive {
            torque: 10.0,
            no_load_speed: Some(300.0),
            load_torque: 0.0,
            friction: false,
            compliance: 0.0,
        };
        assert_eq!(drive.torque_at(150.0), 5.0);
    }
}
