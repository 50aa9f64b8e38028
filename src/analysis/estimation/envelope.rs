//! Envelopes of what a signal holds in bands of frequencies.

use realfft::RealFftPlanner;
use realfft::num_complex::Complex;

use super::welch::sides;

/// The transform of a signal, of which the envelope in any band is taken: the magnitude of the analytic signal.
///
/// ```text
/// X = DFT(x − mean of x), zero outside the band;  e_n = |Σ_k s_k X_k exp(2πikn/N)|/N,  s_k = 2 where k has an image at −k, else 1
/// ```
///
/// The band has sharp edges over the whole record, which is taken as periodic: where its ends do not
/// meet, the envelope errs over about one reciprocal bandwidth at either end.
///
/// Source: S. L. Marple, IEEE Trans. Signal Process. 47 (1999) 2600–2603, for the discrete analytic
/// signal; `abs(scipy.signal.hilbert(x))` of the band-passed x without its mean is the same.
pub struct Envelopes {
    planner: RealFftPlanner<f64>,
    bins: Vec<Complex<f64>>,
    length: usize,
    rate: f64,
}

impl Envelopes {
    /// Of a signal of `rate` samples a second.
    pub fn new(samples: &[f64], rate: f64) -> Self {
        Self::planned(samples, rate, RealFftPlanner::new())
    }

    /// Of a signal, by a planner that remembers the lengths it has met.
    pub(super) fn planned(samples: &[f64], rate: f64, mut planner: RealFftPlanner<f64>) -> Self {
        let length = samples.len();
        let mut bins = Vec::new();
        if length > 0 {
            let forward = planner.plan_fft_forward(length);
            bins = forward.make_output_vec();
            forward
                .process(&mut samples.to_vec(), &mut bins)
                .expect("the output was made by the plan for this very length");
            // an offset is no vibration: it would beat with what a band from 0 Hz on holds
            bins[0] = Complex::ZERO;
        }
        Self {
            planner,
            bins,
            length,
            rate,
        }
    }

    /// The envelope of what lies between two frequencies in Hz, both included, at every sample.
    pub fn envelope(&mut self, band: [f64; 2]) -> Vec<f64> {
        let bins = self.analytic(band);
        let squares = self.squares(bins, self.length);
        squares.into_iter().map(f64::sqrt).collect()
    }

    /// Means of the square and of the fourth power of the envelope between two frequencies in Hz, both included.
    ///
    /// In a band of less than half the range: the square of an envelope of M bins is a trigonometric polynomial of degree
    /// M − 1, its fourth power one of twice that: their means over any 2M points are those over all samples.
    pub fn mean_powers(&mut self, band: [f64; 2]) -> [f64; 2] {
        let bins = self.analytic(band);
        let points = (2 * bins.len()).next_power_of_two();
        let squares = self.squares(bins, points);
        let powers = squares.iter().fold([0.0; 2], |[second, fourth], square| {
            [second + square, fourth + square * square]
        });
        powers.map(|sum| sum / points as f64)
    }

    /// The planner, for the next signal.
    pub(super) fn into_planner(self) -> RealFftPlanner<f64> {
        self.planner
    }

    /// Bins of the analytic signal in a band.
    fn analytic(&self, [low, high]: [f64; 2]) -> Vec<Complex<f64>> {
        let frequency = |k: usize| k as f64 * self.rate / self.length as f64;
        let scale = 1.0 / self.length as f64;
        // a bin more on either side, for the rounding of the quotients
        let nearest = |at: f64| (at * self.length as f64 / self.rate).round() as usize;
        let around = nearest(low).saturating_sub(1)..nearest(high) + 2;
        let bins = self.bins.iter().enumerate();
        bins.take(around.end)
            .skip(around.start)
            .filter(|(k, _)| (low..=high).contains(&frequency(*k)))
            .map(|(k, bin)| *bin * (scale * sides(k, self.length)))
            .collect()
    }

    /// Square of the envelope of a band at so many equal steps over the record, about twice its bins or more.
    ///
    /// Its lowest bin is taken as the mean, which turns the analytic signal and leaves its magnitude; the real and the imaginary
    /// part of what is left are two real signals.
    fn squares(&mut self, bins: Vec<Complex<f64>>, points: usize) -> Vec<f64> {
        if points == 0 {
            return Vec::new();
        }
        let backward = self.planner.plan_fft_inverse(points);
        let [real, imaginary] = [Complex::<f64>::ONE, -Complex::<f64>::I].map(|turned| {
            let mut half = backward.make_input_vec();
            for (k, (half, bin)) in half.iter_mut().zip(&bins).enumerate() {
                let part = *bin * turned / sides(k, points);
                *half = if sides(k, points) == 2.0 {
                    part
                } else {
                    part.re.into()
                };
            }
            let mut signal = backward.make_output_vec();
            backward
                .process(&mut half, &mut signal)
                .expect("a spectrum of a real signal of this very length");
            signal
        });
        let parts = real.iter().zip(&imaginary);
        parts.map(|(re, im)| re * re + im * im).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn a_swelling_tone_has_its_envelope() {
        // a tone at 200 Hz that swells by half at 10 Hz, on a slow vibration that the band leaves out
        let swell = |t: f64| 1.0 + 0.5 * (TAU * 10.0 * t).cos();
        let times = (0..1000).map(|n| f64::from(n) / 1000.0);
        let signal: Vec<f64> = times
            .map(|t| swell(t) * (TAU * 200.0 * t).cos() + (TAU * 3.0 * t).sin())
            .collect();
        let found = Envelopes::new(&signal, 1000.0).envelope([150.0, 250.0]);
        assert!((found[0] - 1.5).abs() < 1e-12 && (found[50] - 0.5).abs() < 1e-12);
        assert!(Envelopes::new(&[], 1.0).envelope([0.0, 1.0]).is_empty());
    }

    /// In bands with and without the ends of the range, of even and odd lengths.
    #[test]
    fn means_over_few_points_are_those_over_all_samples() {
        for length in [1000_usize, 999] {
            let noise = |n: usize| (0.1 * (n * n) as f64).sin() + (0.01 * n as f64).cos();
            let signal: Vec<f64> = (0..length).map(noise).collect();
            let mut envelopes = Envelopes::new(&signal, 2.0);
            for band in [[0.0, 0.5], [0.0, 0.1], [0.3, 0.37], [0.9, 1.0], [0.5, 0.5]] {
                let all = envelopes.envelope(band);
                let mean = |power| all.iter().map(|e| e.powi(power)).sum::<f64>() / length as f64;
                let found = envelopes.mean_powers(band);
                for (found, expected) in found.into_iter().zip([mean(2), mean(4)]) {
                    assert!((found - expected).abs() <= 1e-12 * expected, "{band:?}");
                }
            }
        }
    }
}
