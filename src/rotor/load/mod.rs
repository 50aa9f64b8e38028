//! Loads of the shaft, constant or varying with time or with the angle of the shaft, one kind a file.
//!
//! Each kind is a pure function of time and angle that allocates nothing. A [`Load`] puts it at its
//! position along the shaft; the rotor adds them all up.

mod base;
mod harmonic;
mod noise;
mod series;
mod shock;
mod sprocket;

pub use base::BaseAcceleration;
pub use harmonic::{Harmonic, Pace};
pub use noise::{Noise, NoiseBand, SplitMix64};
pub use series::{Column, Interpolation, Series, SeriesError};
pub use shock::{RandomShocks, Shock, ShockStatistics};
pub use sprocket::{ChainDrive, Sprocket};

use crate::bearing::Vector5;

/// A load at its position along the shaft.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    /// What acts.
    pub kind: LoadKind,
    /// Where it acts along the shaft, m: of a rigid one from the centre of mass towards +Z, where a force (P_x, P_y) adds
    /// the moments `M_x = −a P_y`, `M_y = a P_x`; of one that bends from its left end.
    pub position: f64,
}

/// The kinds of load.
#[derive(Debug, Clone, PartialEq)]
pub enum LoadKind {
    /// Forces along X, Y, Z in N and moments about X and Y in N m that stay.
    Constant(Vector5),
    /// A cosine of time or of the shaft's angle.
    Harmonic(Harmonic),
    /// One half-sine shock, or one after the other at a fixed interval.
    Shock(Shock),
    /// Half-sine shocks at random times.
    RandomShocks(RandomShocks),
    /// The pull of a chain on a sprocket.
    Sprocket(Sprocket),
    /// Band-limited noise.
    Noise(Noise),
    /// A recorded or computed series.
    Series(Series),
    /// Acceleration of the housing.
    Base(BaseAcceleration),
}

/// The main vibration of a load: what the size of the motion is estimated from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MainVibration {
    /// Amplitudes, N and N m.
    pub amplitude: Vector5,
    /// Part of the angular frequency that does not depend on the shaft's speed, rad/s.
    pub frequency: f64,
    /// Part that does, as a multiple of the shaft's speed.
    pub order: f64,
}

impl Load {
    /// A load that stays: forces along X, Y, Z in N and moments about X and Y in N m.
    pub fn constant(parts: Vector5, position: f64) -> Self {
        let kind = LoadKind::Constant(parts);
        Self { kind, position }
    }

    /// Its forces and moments where it stays as it is.
    pub fn as_constant(&self) -> Option<&Vector5> {
        match &self.kind {
            LoadKind::Constant(parts) => Some(parts),
            _ => None,
        }
    }

    /// The load at its position at a time (s) and angle of the shaft (rad), N and N m; zero of an acceleration of the base,
    /// which acts on all masses.
    #[inline]
    pub fn at(&self, time: f64, angle: f64) -> Vector5 {
        match &self.kind {
            LoadKind::Constant(constant) => *constant,
            LoadKind::Harmonic(harmonic) => harmonic.at(time, angle),
            LoadKind::Shock(shock) => shock.at(time),
            LoadKind::RandomShocks(shocks) => shocks.at(time),
            LoadKind::Sprocket(sprocket) => sprocket.at(angle),
            LoadKind::Noise(noise) => noise.at(time),
            LoadKind::Series(series) => series.at(time),
            LoadKind::Base(_) => [0.0; 5],
        }
    }

    /// Whether it acts on all masses, as an acceleration of the base does; everything else acts on the shaft's axis.
    pub fn acts_on_mass(&self) -> bool {
        matches!(self.kind, LoadKind::Base(_))
    }

    /// What the static equilibrium carries of it: the mean pull of a chain, the value of a series at
    /// t = 0; nothing of what merely vibrates or strikes. At its position, as [`Load::at`].
    pub fn static_part(&self) -> Vector5 {
        match &self.kind {
            LoadKind::Sprocket(sprocket) => sprocket.mean(),
            LoadKind::Series(series) => series.at(0.0),
            _ => [0.0; 5],
        }
    }

    /// Its main vibration at its position; that of the base is an acceleration in m/s².
    pub fn main_vibration(&self) -> MainVibration {
        match &self.kind {
            LoadKind::Constant(_) => MainVibration {
                amplitude: [0.0; 5],
                frequency: 0.0,
                order: 0.0,
            },
            LoadKind::Harmonic(harmonic) => harmonic.main_vibration(),
            LoadKind::Shock(shock) => shock.main_vibration(),
            LoadKind::RandomShocks(shocks) => shocks.main_vibration(),
            LoadKind::Sprocket(sprocket) => sprocket.main_vibration(),
            LoadKind::Noise(noise) => noise.main_vibration(),
            LoadKind::Series(series) => series.main_vibration(),
            LoadKind::Base(base) => base.main_vibration(),
        }
    }

    /// Angular frequency in rad/s and begin in s of a load that repeats, at a speed of the shaft in rad/s; none where it
    /// does not act.
    ///
    /// # Errors
    /// What it is, where it does not repeat.
    pub(super) fn repetition(&self, speed: f64) -> Result<Option<(f64, f64)>, &'static str> {
        match &self.kind {
            LoadKind::Harmonic(harmonic) | LoadKind::Base(BaseAcceleration::Harmonic(harmonic)) => {
                Ok(harmonic.repetition(speed))
            }
            LoadKind::Shock(shock) | LoadKind::Base(BaseAcceleration::Shock(shock)) => {
                shock.repetition()
            }
            LoadKind::Sprocket(sprocket) => {
                Ok(Some((sprocket.main_vibration().order * speed, 0.0)))
            }
            LoadKind::Constant(_) => Ok(None),
            LoadKind::RandomShocks(_) => Err("a series of random shocks"),
            LoadKind::Noise(_) => Err("noise"),
            LoadKind::Series(_) => Err("a series of values"),
        }
    }

    /// The first time after `after` at which the load or its slope jumps, s.
    pub fn next_break(&self, after: f64) -> f64 {
        match &self.kind {
            LoadKind::Shock(shock) => shock.next_break(after),
            LoadKind::RandomShocks(shocks) => shocks.next_break(after),
            LoadKind::Series(series) => series.next_break(after),
            LoadKind::Base(base) => base.next_break(after),
            LoadKind::Constant(_)
            | LoadKind::Harmonic(_)
            | LoadKind::Sprocket(_)
            | LoadKind::Noise(_) => f64::INFINITY,
        }
    }
}

/// The earliest of times that lie after `after`; infinite where none does.
fn earliest(times: impl IntoIterator<Item = f64>, after: f64) -> f64 {
    let later = times.into_iter().filter(|time| *time > after);
    later.fold(f64::INFINITY, f64::min)
}
