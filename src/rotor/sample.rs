//! What is observed of the shaft at one instant.

use super::{DriveMoments, EnergyBalance, FREEDOMS};

/// State of the shaft and of its bearings at one instant, SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Time, s.
    pub time: f64,
    /// Shaft angle ψ, rad.
    pub angle: f64,
    /// Angular speed, rad/s.
    pub speed: f64,
    /// x, y, z in m and θx, θy in rad.
    pub displacement: [f64; FREEDOMS],
    /// Time derivatives of `displacement`.
    pub velocity: [f64; FREEDOMS],
    /// Force of all bearings on the shaft: x, y, z in N, moments about X and Y in N m.
    pub force_on_shaft: [f64; FREEDOMS],
    /// Largest load on a ball of any bearing, N; zero where no bearing has balls (linear law).
    pub largest_ball_load: f64,
    /// Number of balls in contact, all bearings together.
    pub balls_loaded: u32,
    /// Energy, where it is accounted for.
    pub energy: Option<EnergyBalance>,
    /// Moments on the shaft, where it is driven.
    pub drive: Option<DriveMoments>,
}
