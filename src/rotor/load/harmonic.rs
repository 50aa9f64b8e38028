//! A cosine of time or of the shaft's angle.

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::MainVibration;
use crate::bearing::Vector5;

/// What the phase of a harmonic load runs with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum HarmonicRate {
    /// Frequency f, Hz.
    Frequency(f64),
    /// Number n of periods per revolution of the shaft.
    Order(f64),
}

/// A harmonic load.
///
/// ```text
/// P(t) = P̂ cos(2π f t + φ)   or   P̂ cos(n ψ + φ)
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Harmonic {
    /// Amplitudes P̂, N and N m.
    pub amplitude: Vector5,
    /// Frequency or order.
    pub rate: HarmonicRate,
    /// Phase φ, rad.
    pub phase: f64,
}

impl Harmonic {
    /// The load at a time in s and an angle of the shaft in rad.
    #[inline]
    pub fn at(&self, time: f64, angle: f64) -> Vector5 {
        let turned = match self.rate {
            HarmonicRate::Frequency(frequency) => TAU * frequency * time,
            HarmonicRate::Order(order) => order * angle,
        };
        let cos = (turned + self.phase).cos();
        self.amplitude.map(|amplitude| amplitude * cos)
    }

    /// Angular frequency in rad/s and begin in s at a speed of the shaft in rad/s; none where it does not act.
    pub(super) fn repetition(&self, speed: f64) -> Option<(f64, f64)> {
        let acts = self.amplitude.iter().any(|part| *part != 0.0);
        acts.then(|| (self.main_vibration().frequency_at(speed), 0.0))
    }

    /// Its angular frequency in rad/s at a speed of the shaft, and its complex amplitudes P̂ e^(iφ).
    pub(super) fn phasor(&self, speed: f64) -> (f64, [Complex<f64>; 5]) {
        let frequency = self.main_vibration().frequency_at(speed);
        let phasor = |amplitude| Complex::from_polar(amplitude, self.phase);
        (frequency, self.amplitude.map(phasor))
    }

    /// Its amplitude and frequency.
    pub fn main_vibration(&self) -> MainVibration {
        match self.rate {
            HarmonicRate::Frequency(frequency) => {
                MainVibration::at(TAU * frequency, self.amplitude)
            }
            HarmonicRate::Order(order) => MainVibration {
                amplitude: self.amplitude,
                frequency: 0.0,
                order,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_a_period_turns_the_load() {
        let load = Harmonic {
            amplitude: [10.0, 0.0, 0.0, 0.0, 0.0],
            rate: HarmonicRate::Frequency(50.0),
            phase: 0.0,
        };
        assert!((load.at(0.01, 0.0)[0] + 10.0).abs() < 1e-12); // half a period later
    }
}
