//! The level of vibration that machine standards look at: RMS velocity in a band of frequencies.

use serde::Serialize;

use crate::analysis::Transform;

/// The band of ISO 20816-1, Hz.
pub const VELOCITY_BAND: [f64; 2] = [10.0, 1000.0];
/// Equivalent noise bandwidth of the Hann window in bins: what the lobe of a line adds up to.
const NOISE_BANDWIDTH: f64 = 1.5;

/// RMS of a velocity in a band of frequencies.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct VelocityLevel {
    /// RMS, m/s.
    #[serde(rename = "rms_m_s")]
    pub rms: f64,
    /// Lowest and highest frequency that counts, Hz: of `VELOCITY_BAND` what the sampling resolves.
    #[serde(rename = "band_Hz")]
    pub band: [f64; 2],
}

/// RMS velocity in [`VELOCITY_BAND`] of samples of a velocity in m/s, `rate` of them a second.
///
/// `v_RMS² = Σ_k A_k²/(2 · 1.5)` over the bins in the band, A_k amplitudes under a Hann window, whose
/// lobe counts a line one and a half times: exact for lines on bins three or more apart.
///
/// Source: for the quantity, ISO 20816-1:2016, broad-band RMS velocity 10 Hz to 1000 Hz. Its zones
/// belong to whole machines, measured at the housing; what is simulated here is the shaft.
pub fn velocity_level(velocity: Vec<f64>, rate: f64) -> Option<VelocityLevel> {
    if velocity.len() < 16 {
        return None;
    }
    let resolution = rate / velocity.len() as f64;
    let transform = Transform::new(velocity);
    let first = ((VELOCITY_BAND[0] / resolution).ceil() as usize).max(1);
    let last = ((VELOCITY_BAND[1] / resolution).floor() as usize).min(transform.bins() - 1);
    (first <= last).then(|| VelocityLevel {
        rms: (transform.mean_square(first..=last) / NOISE_BANDWIDTH).sqrt(),
        band: [first as f64 * resolution, last as f64 * resolution],
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn the_level_counts_what_is_in_the_band() {
        // 3 mm/s at 50 Hz counts, 40 mm/s at 5 Hz and 20 mm/s at 1200 Hz do not
        let line = |amplitude: f64, frequency: f64, n: u32| {
            amplitude * (TAU * frequency * f64::from(n) / 4000.0).cos()
        };
        let signal = |n| line(3e-3, 50.0, n) + line(4e-2, 5.0, n) + line(2e-2, 1200.0, n);
        let level = velocity_level((0..4000).map(signal).collect(), 4000.0).unwrap();
        assert!((level.rms - 3e-3 / 2f64.sqrt()).abs() < 1e-15);
    }
}
