//! Evaluation zones of the vibration of machine housings.

use std::f64::consts::TAU;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

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

/// Size of a machine by ISO 20816-3.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MachineGroup {
    /// Rated power above 300 kW, or electrical machines with a shaft height of 315 mm or more.
    Large,
    /// Rated power of 15 kW to 300 kW, or electrical machines with a shaft height of 160 mm to 315 mm.
    Medium,
}

/// Support of a machine in the direction of measurement, by ISO 20816-3.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MachineSupport {
    /// The lowest natural frequency of machine and support lies at least 25 % above the main excitation frequency, most often
    /// the rotation.
    Rigid,
    /// Any other.
    Flexible,
}

/// Frequencies that the RMS velocity of a machine counts at a speed in rad/s, Hz: from 10 Hz, below 600 rpm from 2 Hz, to
/// 1000 Hz.
///
/// Source: ISO 20816-3:2022, clause on measurement equipment.
///
/// ```
/// use jeffcott::physics::velocity_band;
/// assert_eq!(velocity_band(31.4), [2.0, 1000.0]); // 300 rpm
/// assert_eq!(velocity_band(314.0), [10.0, 1000.0]);
/// ```
pub fn velocity_band(speed: f64) -> [f64; 2] {
    // 600 rpm, 10 Hz, belong to the faster machines, round-off aside
    let slow = speed.abs() < TAU * 10.0 * (1.0 - 1e-9);
    [if slow { 2.0 } else { 10.0 }, 1000.0]
}

/// Boundaries between the zones A and B, B and C, C and D: RMS velocity of bearing housings in m/s, from 10 Hz (2 Hz below
/// 600 rpm) to 1000 Hz.
///
/// Source: ISO 20816-3:2022, tables A.1 (group 1, large machines) and A.2 (group 2, medium-sized ones). The standard holds
/// for industrial machines above 15 kW at 120 rpm to 30 000 rpm, for velocities measured on the housings at the bearings;
/// those of a shaft are larger.
///
/// ```
/// use jeffcott::physics::{MachineGroup, MachineSupport, zone_boundaries};
/// let boundaries = zone_boundaries(MachineGroup::Medium, MachineSupport::Rigid);
/// assert_eq!(boundaries, [1.4e-3, 2.8e-3, 4.5e-3]);
/// ```
pub fn zone_boundaries(group: MachineGroup, support: MachineSupport) -> [f64; 3] {
    match (group, support) {
        (MachineGroup::Large, MachineSupport::Flexible) => [3.5e-3, 7.1e-3, 11.0e-3],
        (MachineGroup::Large, MachineSupport::Rigid)
        | (MachineGroup::Medium, MachineSupport::Flexible) => [2.3e-3, 4.5e-3, 7.1e-3],
        (MachineGroup::Medium, MachineSupport::Rigid) => [1.4e-3, 2.8e-3, 4.5e-3],
    }
}

impl VibrationZone {
    /// The zone of an RMS velocity in m/s between boundaries; none of NaN.
    ///
    /// ```
    /// use jeffcott::physics::{MachineGroup, MachineSupport, VibrationZone, zone_boundaries};
    /// let zone = |support| VibrationZone::from_velocity(3e-3, &zone_boundaries(MachineGroup::Medium, support));
    /// assert_eq!(zone(MachineSupport::Rigid), Some(VibrationZone::C));
    /// assert_eq!(zone(MachineSupport::Flexible), Some(VibrationZone::B));
    /// ```
    pub fn from_velocity(velocity: f64, boundaries: &[f64; 3]) -> Option<Self> {
        if velocity.is_nan() {
            return None;
        }
        let zones = [Self::A, Self::B, Self::C, Self::D];
        let below = boundaries.iter().filter(|boundary| velocity > **boundary);
        Some(zones[below.count()])
    }

    /// What the standard says of a machine in this zone.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::A => "as a newly commissioned machine",
            Self::B => "fit for unrestricted long-term operation",
            Self::C => "unsatisfactory for long-term operation",
            Self::D => "severe enough to cause damage",
        }
    }
}
