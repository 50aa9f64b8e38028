//! The envelope of a signal in a band of frequencies.

use realfft::RealFftPlanner;
use realfft::num_complex::Complex;

/// Envelope of what a signal of `rate` samples a second holds between two frequencies in Hz, both
/// included: the magnitude of the analytic signal.
///
/// ```text
/// X = DFT(x), zero outside the band;  e_n = |b_n + i h_n|,  b = DFT⁻¹(X),  h = DFT⁻¹(−i sign(f) X)
/// ```
///
/// The band has sharp edges over the whole record, which is taken as periodic: where its ends do not
/// meet, the envelope errs over about one reciprocal bandwidth at either end.
///
/// Source: S. L. Marple, IEEE Trans. Signal Process. 47 (1999) 2600–2603, for the discrete analytic
/// signal; `abs(scipy.signal.hilbert(x))` of the band-passed x is the same.
pub fn envelope(samples: &[f64], rate: f64, [low, high]: [f64; 2]) -> Vec<f64> {
    let length = samples.len();
    if length == 0 {
        return Vec::new();
    }
    let mut planner = RealFftPlanner::new();
    let forward = planner.plan_fft_forward(length);
    let mut bins = forward.make_output_vec();
    forward
        .process(&mut samples.to_vec(), &mut bins)
        .expect("the output was made by the plan for this very length");
    for (k, bin) in bins.iter_mut().enumerate() {
        let frequency = k as f64 * rate / length as f64;
        if !(low..=high).contains(&frequency) {
            *bin = Complex::ZERO;
        }
    }
    let quarter_turned = bins
        .iter()
        .enumerate()
        .map(|(k, bin)| {
            // what has no image has no sign of its frequency
            let has_image = k > 0 && 2 * k < length;
            if has_image {
                -Complex::<f64>::I * bin
            } else {
                Complex::ZERO
            }
        })
        .collect();
    let backward = planner.plan_fft_inverse(length);
    let [in_phase, quadrature] = [bins, quarter_turned].map(|mut bins: Vec<Complex<f64>>| {
        let mut samples = backward.make_output_vec();
        backward
            .process(&mut bins, &mut samples)
            .expect("a spectrum of a real signal of this very length");
        samples
    });
    let scale = 1.0 / length as f64;
    let parts = in_phase.iter().zip(&quadrature);
    parts.map(|(b, h)| scale * b.hypot(*h)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn a_swelling_tone_has_its_envelope() {
        // a tone at 200 Hz that swells by half at 10 Hz, on a slow swing that the band leaves out
        let swell = |t: f64| 1.0 + 0.5 * (TAU * 10.0 * t).cos();
        let times = (0..1000).map(|n| f64::from(n) / 1000.0);
        let signal: Vec<f64> = times
            .map(|t| swell(t) * (TAU * 200.0 * t).cos() + (TAU * 3.0 * t).sin())
            .collect();
        let found = envelope(&signal, 1000.0, [150.0, 250.0]);
        assert!((found[0] - 1.5).abs() < 1e-12 && (found[50] - 0.5).abs() < 1e-12);
    }
}
