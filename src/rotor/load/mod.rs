//! Loads of the shaft, constant or varying with time or with the angle of the shaft, one kind a file.
//!
//! Each kind is a pure function of time and angle that allocates nothing. A [`Load`] puts it at its
//! position along the shaft; the rotor adds them all up.

mod harmonic;
mod noise;
mod series;
mod shock;
mod sprocket;

pub use harmonic::{Harmonic, HarmonicRate};
pub use noise::{Noise, NoiseBand, SplitMix64};
pub use series::{Interpolation, Series, SeriesComponent, SeriesError};
pub use shock::{RandomShocks, Shock, ShockStatistics};
pub use sprocket::{ChainDrive, Sprocket};

use nalgebra::Complex;

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
    /// Acceleration a(t) of the housing along X, Y, Z in m/s², of one of the other kinds: in its frame the inertial force
    /// −m a(t) acts on every mass. The bearings feel the motion of the shaft against the housing, which is what the
    /// displacements mean. Components about X and Y do not act.
    Base(Box<LoadKind>),
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

impl MainVibration {
    /// One of an angular frequency in rad/s that does not depend on the shaft's speed.
    fn at(frequency: f64, amplitude: Vector5) -> Self {
        Self {
            amplitude,
            frequency,
            order: 0.0,
        }
    }

    /// Its angular frequency at a speed of the shaft, both rad/s.
    pub fn frequency_at(&self, speed: f64) -> f64 {
        self.frequency + self.order * speed
    }
}

impl Load {
    /// A load that stays: forces along X, Y, Z in N and moments about X and Y in N m.
    #[cfg(test)]
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

    /// Whether it acts on all masses, as an acceleration of the base does; everything else acts on the shaft's axis.
    pub fn acts_on_mass(&self) -> bool {
        matches!(self.kind, LoadKind::Base(_))
    }
}

impl LoadKind {
    /// The load at its position at a time (s) and angle of the shaft (rad), N and N m; an acceleration of the base in m/s².
    #[inline]
    pub fn at(&self, time: f64, angle: f64) -> Vector5 {
        match self {
            Self::Constant(constant) => *constant,
            Self::Harmonic(harmonic) => harmonic.at(time, angle),
            Self::Shock(shock) => shock.at(time),
            Self::RandomShocks(shocks) => shocks.at(time),
            Self::Sprocket(sprocket) => sprocket.at(angle),
            Self::Noise(noise) => noise.at(time),
            Self::Series(series) => series.at(time),
            Self::Base(acceleration) => acceleration.at(time, angle),
        }
    }

    /// What the static equilibrium carries of it: the mean pull of a chain, the value of a series at
    /// t = 0; nothing of what merely vibrates or strikes. At its position, as [`LoadKind::at`].
    pub fn static_part(&self) -> Vector5 {
        match self {
            Self::Sprocket(sprocket) => sprocket.mean(),
            Self::Series(series) => series.at(0.0),
            _ => [0.0; 5],
        }
    }

    /// Its main vibration at its position; that of the base is an acceleration in m/s².
    pub fn main_vibration(&self) -> MainVibration {
        match self {
            Self::Constant(_) => MainVibration::at(0.0, [0.0; 5]),
            Self::Harmonic(harmonic) => harmonic.main_vibration(),
            Self::Shock(shock) => shock.main_vibration(),
            Self::RandomShocks(shocks) => shocks.main_vibration(),
            Self::Sprocket(sprocket) => sprocket.main_vibration(),
            Self::Noise(noise) => noise.main_vibration(),
            Self::Series(series) => series.main_vibration(),
            Self::Base(acceleration) => acceleration.main_vibration(),
        }
    }

    /// Angular frequency in rad/s and begin in s of a load that repeats, at a speed of the shaft in rad/s; none where it
    /// does not act.
    ///
    /// # Errors
    /// What it is, where it does not repeat.
    pub(super) fn repetition(&self, speed: f64) -> Result<Option<(f64, f64)>, &'static str> {
        match self {
            Self::Harmonic(harmonic) => Ok(harmonic.repetition(speed)),
            Self::Shock(shock) => shock.repetition(),
            Self::Sprocket(sprocket) => {
                Ok(Some((sprocket.main_vibration().frequency_at(speed), 0.0)))
            }
            Self::Constant(_) => Ok(None),
            Self::RandomShocks(_) => Err("a series of random shocks"),
            Self::Noise(_) => Err("noise"),
            Self::Series(_) => Err("a series of values"),
            Self::Base(acceleration) => acceleration.repetition(speed),
        }
    }

    /// Angular frequencies in rad/s and complex amplitudes of what varies of it, at a constant speed of the shaft in rad/s;
    /// none where it is not made of harmonics.
    pub(super) fn harmonics(&self, speed: f64) -> Option<Vec<(f64, [Complex<f64>; 5])>> {
        match self {
            Self::Constant(_) => Some(Vec::new()),
            Self::Harmonic(harmonic) => Some(vec![harmonic.phasor(speed)]),
            Self::Sprocket(sprocket) => Some(sprocket.phasors(speed)),
            Self::Base(acceleration) => acceleration.harmonics(speed),
            Self::Shock(_) | Self::RandomShocks(_) | Self::Noise(_) | Self::Series(_) => None,
        }
    }

    /// Whether it is random, or a record, which may be.
    pub fn is_random(&self) -> bool {
        match self {
            Self::RandomShocks(_) | Self::Noise(_) | Self::Series(_) => true,
            Self::Constant(_) | Self::Harmonic(_) | Self::Shock(_) | Self::Sprocket(_) => false,
            Self::Base(acceleration) => acceleration.is_random(),
        }
    }

    /// The first time after `after` at which the load or its slope jumps, s.
    pub fn next_break(&self, after: f64) -> f64 {
        match self {
            Self::Shock(shock) => shock.next_break(after),
            Self::RandomShocks(shocks) => shocks.next_break(after),
            Self::Series(series) => series.next_break(after),
            Self::Base(acceleration) => acceleration.next_break(after),
            Self::Constant(_) | Self::Harmonic(_) | Self::Sprocket(_) | Self::Noise(_) => {
                f64::INFINITY
            }
        }
    }
}
