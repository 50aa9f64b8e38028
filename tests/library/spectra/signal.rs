//! The signals of `scipy_spectra.py`.

use std::f64::consts::TAU;

/// Samples a second.
pub const RATE: f64 = 1000.0;

/// Uniform on −½ … ½, of the upper 53 bits of the generator of Knuth's MMIX.
pub fn noise(seed: u64, length: usize) -> Vec<f64> {
    let mut state = seed;
    let mut next = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    (0..length).map(|_| next()).collect()
}

/// Both signals.
pub fn signals(length: usize) -> [Vec<f64>; 2] {
    let time = |n: usize| n as f64 / RATE;
    let x = |t: f64, noise: f64| {
        0.7 + 0.4 * t
            + 1.5 * (TAU * 50.0 * t + 0.3).cos()
            + 0.8 * (TAU * 123.4 * t).sin()
            + 0.5 * noise
    };
    let y = |t: f64, noise: f64| {
        let swell = 1.0 + 0.5 * (TAU * 12.0 * t).cos();
        -0.2 + 1.1 * (TAU * 50.0 * t - 0.9).cos()
            + 0.3 * (TAU * 310.7 * t).cos() * swell
            + 0.4 * noise
    };
    let make = |seed, value: &dyn Fn(f64, f64) -> f64| {
        let noise = noise(seed, length).into_iter().enumerate();
        noise.map(|(n, noise)| value(time(n), noise)).collect()
    };
    [make(1, &x), make(2, &y)]
}
