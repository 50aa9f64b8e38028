//! Evaluation zones of the vibration of machine housings.

use serde::Serialize;

/// Evaluation zone of ISO 20816-3.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum VibrationZone {
    /// Newly commissioned machines.
    A,
    /// Fit for unrestricted long-term operation.
    B,
    /// Unsatisfactory for long-term operation.
    C,
    /// Severe enough to cause damage.
    D,
}

/// Limits between the zones, RMS velocity in m/s of 10 Hz to 1000 Hz, of machines of group 2 (15 kW to 300 kW): on a
/// rigid support, then on a flexible one.
///
/// Source: ISO 20816-3:2022, table A.2. The standard speaks of velocities measured on the housing at the bearings; those
/// of a shaft in a housing that does not move are larger.
pub const GROUP_2_LIMITS: [[f64; 3]; 2] = [[1.4e-3, 2.8e-3, 4.5e-3], [2.3e-3, 4.5e-3, 7.1e-3]];

impl VibrationZone {
    /// The zone of an RMS velocity in m/s between limits.
    ///
    /// ```
    /// use jeffcott::physics::{GROUP_2_LIMITS, VibrationZone};
    /// let [rigid, flexible] = GROUP_2_LIMITS.map(|limits| VibrationZone::of(3e-3, &limits));
    /// assert_eq!([rigid, flexible], [VibrationZone::C, VibrationZone::B]);
    /// ```
    pub fn of(velocity: f64, limits: &[f64; 3]) -> Self {
        let zones = [Self::A, Self::B, Self::C, Self::D];
        zones[limits.iter().filter(|limit| velocity > **limit).count()]
    }
}
