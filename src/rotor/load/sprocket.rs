//! The pull of a chain on its sprocket: the polygon effect.

use std::f64::consts::PI;

use nalgebra::Complex;

use super::MainVibration;
use crate::bearing::Vector5;

/// A chain strand that pulls at a driving sprocket.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChainDrive {
    /// Number z of teeth that carry a joint of the chain in turn, at least 3.
    pub teeth: u32,
    /// Distance p of two joints, m, positive.
    pub pitch: f64,
    /// Length L of the free strand, from the sprocket to its next guide, m, positive.
    pub span: f64,
    /// Mean pull of the strand, N.
    pub force: f64,
    /// Direction of the pull, from +X towards +Y, rad.
    pub direction: f64,
    /// Number of harmonics of the meshing frequency that are kept.
    pub harmonics: u32,
}

/// Pull of a chain on a sprocket: the mean and the harmonics of the meshing frequency z ω/2π.
///
/// The chain lies on the sprocket as a polygon. While the sprocket turns by one pitch angle, the
/// lever of the strand falls and rises:
///
/// ```text
/// R = p/(2 sin(π/z)),   r(θ) = R cos θ,   −π/z ≤ θ = ψ (modulo 2π/z) ≤ π/z
/// F(θ) = F_mean (1/cos θ)/mean(1/cos θ)          along the strand
/// S(θ) = F(θ) (mean(r) − r(θ))/L                 across it, 90° on from the pull
/// ```
///
/// What is assumed: the torque is constant, so the pull is inverse to the lever; the joints have no
/// mass and the chain no vibration of its own; the far end of the strand stays at the mean height
/// of the near one, so that the strand swings by the rise over its length. Both are kept as Fourier
/// series in z ψ up to a given harmonic, which rounds the corner at the change of teeth.
///
/// Source: for the lever and the rise, the kinematics of chordal action: Binder, *Mechanics of the
/// Roller Chain Drive* (1956); Niemann & Winter, *Maschinenelemente* III (1983), Polygoneffekt. The
/// forces follow from them by the assumptions above.
#[derive(Debug, Clone, PartialEq)]
pub struct Sprocket {
    teeth: f64,
    /// Cosine and sine of the direction of the pull.
    direction: [f64; 2],
    /// Mean force along the strand and across it, N.
    mean: [f64; 2],
    /// Amplitudes of cos(k z ψ) along the strand and across it, k = 1, 2, …, N.
    harmonics: Vec<[f64; 2]>,
}

/// Points of a pitch angle at which the force is taken for its Fourier series.
const POINTS: u32 = 4096;

impl Sprocket {
    /// The Fourier series of the pull.
    pub fn new(drive: &ChainDrive) -> Self {
        let half = PI / f64::from(drive.teeth);
        let radius = drive.pitch / (2.0 * half.sin());
        // mean of 1/cos θ = ln((1 + sin(π/z))/(1 − sin(π/z)))/(2π/z), of cos θ = sin(π/z)/(π/z)
        let mean_inverse = ((1.0 + half.sin()) / (1.0 - half.sin())).ln() / (2.0 * half);
        let mean_lever = radius * half.sin() / half;
        let pull = |part: f64| {
            let cos = (half * part).cos();
            let along = drive.force / (cos * mean_inverse);
            [along, along * (mean_lever - radius * cos) / drive.span]
        };
        let [_, mean_across] = fourier(pull, 0);
        Self {
            teeth: f64::from(drive.teeth),
            direction: [drive.direction.cos(), drive.direction.sin()],
            mean: [drive.force, mean_across],
            harmonics: (1..=drive.harmonics).map(|k| fourier(pull, k)).collect(),
        }
    }

    /// The load at an angle of the shaft in rad.
    #[inline]
    pub fn at(&self, angle: f64) -> Vector5 {
        let first = (self.teeth * angle).cos();
        // cos((k+1)α) = 2 cos α cos(kα) − cos((k−1)α)
        let (mut before, mut cos) = (1.0, first);
        let [mut along, mut across] = self.mean;
        for harmonic in &self.harmonics {
            along += harmonic[0] * cos;
            across += harmonic[1] * cos;
            (before, cos) = (cos, 2.0 * first * cos - before);
        }
        self.directed([along, across])
    }

    /// Its mean over a revolution.
    pub fn mean(&self) -> Vector5 {
        self.directed(self.mean)
    }

    /// Its first harmonic, at the meshing frequency.
    pub fn main_vibration(&self) -> MainVibration {
        let first = self.harmonics.first().copied().unwrap_or_default();
        MainVibration {
            amplitude: self.directed(first),
            frequency: 0.0,
            order: self.teeth,
        }
    }

    /// Angular frequencies in rad/s at a speed of the shaft, and amplitudes, of its harmonics.
    pub(super) fn phasors(&self, speed: f64) -> Vec<(f64, [Complex<f64>; 5])> {
        let harmonics = self.harmonics.iter().zip(1_u32..);
        let phasor = |(amplitudes, k): (&[f64; 2], u32)| {
            let frequency = f64::from(k) * self.teeth * speed;
            (frequency, self.directed(*amplitudes).map(Complex::from))
        };
        harmonics.map(phasor).collect()
    }

    fn directed(&self, [along, across]: [f64; 2]) -> Vector5 {
        let [cos, sin] = self.direction;
        let (x, y) = (along * cos - across * sin, along * sin + across * cos);
        [x, y, 0.0, 0.0, 0.0]
    }
}

/// Coefficient of cos(kα) of an even function of α/π ∈ −1 … 1; the mean for k = 0.
fn fourier(function: impl Fn(f64) -> [f64; 2], k: u32) -> [f64; 2] {
    let weight = if k == 0 { 1.0 } else { 2.0 } / f64::from(POINTS);
    let mut sum = [0.0; 2];
    for point in 0..POINTS {
        // midpoints of −1 … 1
        let part = 2.0 * (f64::from(point) + 0.5) / f64::from(POINTS) - 1.0;
        let cos = (PI * f64::from(k) * part).cos();
        for (sum, value) in sum.iter_mut().zip(function(part)) {
            *sum += weight * cos * value;
        }
    }
    sum
}
