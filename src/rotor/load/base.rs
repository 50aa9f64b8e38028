//! Acceleration of the housing.

use super::{Harmonic, MainVibration, Shock};
use crate::bearing::Vector5;

/// The base is shaken: in its frame an inertial force acts on every mass.
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
    /// Acceleration at a time in s and an angle of the shaft in rad, m/s².
    #[inline]
    pub fn acceleration(&self, time: f64, angle: f64) -> Vector5 {
        match self {
            Self::Harmonic(harmonic) => harmonic.at(time, angle),
            Self::Shock(shock) => shock.at(time),
        }
    }

    /// The acceleration as a vibration.
    pub fn main_vibration(&self) -> MainVibration {
        match self {
            Self::Harmonic(harmonic) => harmonic.main_vibration(),
            Self::Shock(shock) => shock.main_vibration(),
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
