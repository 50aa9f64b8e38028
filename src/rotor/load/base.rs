//! Acceleration of the housing.

use super::{Harmonic, MainVibration, Shock};
use crate::bearing::Vector5;

/// The housing is shaken: in its frame an inertial force acts on the mass.
///
/// ```text
/// P(t) = −m a(t)
/// ```
///
/// The bearings feel the motion of the shaft against the housing, which is what the displacements
/// mean. The components of the two kinds are accelerations along X, Y and Z in m/s²; those about X
/// and Y do not act.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BaseAcceleration {
    /// a(t) is a harmonic.
    Harmonic(Harmonic),
    /// a(t) is a half-sine shock, once or again and again.
    Shock(Shock),
}

impl BaseAcceleration {
    /// Force on a shaft of `mass` in kg at a time in s and an angle of the shaft in rad.
    #[inline]
    pub fn force(&self, mass: f64, time: f64, angle: f64) -> Vector5 {
        let acceleration = match self {
            Self::Harmonic(harmonic) => harmonic.at(time, angle),
            Self::Shock(shock) => shock.at(time),
        };
        inertial(mass, &acceleration)
    }

    /// Its force as a vibration.
    pub fn main_vibration(&self, mass: f64) -> MainVibration {
        let vibration = match self {
            Self::Harmonic(harmonic) => harmonic.main_vibration(),
            Self::Shock(shock) => shock.main_vibration(),
        };
        MainVibration {
            amplitude: inertial(mass, &vibration.amplitude),
            ..vibration
        }
    }

    /// The next begin or end of a shock after a time, s.
    pub fn next_break(&self, after: f64) -> f64 {
        match self {
            Self::Harmonic(_) => f64::INFINITY,
            Self::Shock(shock) => shock.next_break(after),
        }
    }
}

/// −m a; a shaken housing does not tilt.
fn inertial(mass: f64, acceleration: &Vector5) -> Vector5 {
    let [x, y, z, ..] = *acceleration;
    [-mass * x, -mass * y, -mass * z, 0.0, 0.0]
}
