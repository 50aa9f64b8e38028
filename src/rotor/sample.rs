//! What is observed of the shaft at one instant.

use super::{DriveMoments, EnergyBalance, FREEDOMS};

/// Housings are observed of so many bearings, the first ones.
pub const MOST_HOUSINGS: usize = 4;

/// Motion of a housing at one instant.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct HousingMotion {
    /// x, y, z from where its own weight has put it, m.
    pub displacement: [f64; 3],
    /// m/s.
    pub velocity: [f64; 3],
    /// m/s², where asked for.
    pub acceleration: Option<[f64; 3]>,
}

/// State of the shaft and of its bearings at one instant, SI units. What was not observed is none.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
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
    /// Second time derivatives of `displacement`, where asked for.
    pub acceleration: Option<[f64; FREEDOMS]>,
    /// Housings of the first bearings; none where no bearing has one.
    pub housings: Option<[HousingMotion; MOST_HOUSINGS]>,
    /// Force of all bearings on the shaft: x, y, z in N, moments about X and Y in N m; none where it is not
    /// observed.
    pub force_on_shaft: Option<[f64; FREEDOMS]>,
    /// Largest load on a ball of any bearing, N; none where no ball is observed, as of a linear bearing.
    pub largest_ball_load: Option<f64>,
    /// Number of balls in contact, all bearings together; likewise.
    pub balls_loaded: Option<u32>,
    /// Energy, where it is accounted for.
    pub energy: Option<EnergyBalance>,
    /// Moments on the shaft, where it is driven.
    pub drive: Option<DriveMoments>,
}
