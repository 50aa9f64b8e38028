//! Extremes of quantities that repeat, between their samples.

use std::f64::consts::TAU;

use nalgebra::Complex;

use crate::analysis::fourier_coefficients;

/// Part of the largest coefficient below which another one is round-off.
const ROUND_OFF: f64 = 1e-17;
/// A curve rises above its highest sample by about an eighth of the second difference there: beyond this part it does not.
const RISE: f64 = 0.5;
/// Steps of a search between three samples by the golden section: to 1e-9 of their distance, where a peak is flat.
const STEPS: usize = 43;
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Lowest and highest value of the trigonometric polynomial through the samples of a period; not numbers where a sample is
/// none. Of quantities that are not smooth it is as exact as samples so far apart are.
pub(super) fn extremes(samples: &[f64]) -> [f64; 2] {
    if samples.iter().any(|value| !value.is_finite()) {
        return [f64::NAN; 2];
    }
    let complex: Vec<_> = samples.iter().copied().map(Complex::from).collect();
    let coefficients = fourier_coefficients(&complex);
    let half = samples.len() / 2;
    let largest = coefficients
        .iter()
        .map(|own| own.norm())
        .fold(0.0, f64::max);
    // of a real curve, both of a pair at once; the coefficient of half the sampling rate stands for itself
    let lines = coefficients[..=half].iter().enumerate();
    let lines = lines.map(|(k, own)| {
        let pair = if k == 0 || 2 * k == samples.len() {
            1.0
        } else {
            2.0
        };
        (k as f64 * TAU / samples.len() as f64, pair * own)
    });
    let lines: Vec<_> = lines
        .filter(|(_, own)| own.norm() > ROUND_OFF * largest)
        .collect();
    [-1.0, 1.0].map(|sign| {
        let at = |place: f64| -> f64 {
            let parts = lines.iter();
            sign * parts
                .map(|(turn, own)| (own * Complex::cis(turn * place)).re)
                .sum::<f64>()
        };
        sign * highest(samples, sign, at)
    })
}

/// Highest value of a curve through samples of a period, `sign` times as large, at places counted in samples.
fn highest(samples: &[f64], sign: f64, at: impl Fn(f64) -> f64) -> f64 {
    let count = samples.len();
    let value = |index: usize| sign * samples[index % count];
    let top = (0..count).map(value).fold(f64::NEG_INFINITY, f64::max);
    let bound = |index: usize| {
        let [before, own, after] = [count - 1, 0, 1].map(|step| value(index + step));
        let bends = own >= before && own >= after;
        bends.then_some(own + RISE * (2.0 * own - before - after))
    };
    let peaks = (0..count).filter_map(|index| Some((index, bound(index)?)));
    let peaks = peaks.filter(|(_, bound)| *bound > top);
    // what is not smooth may swing farther between its samples than it bends
    let heights = peaks.map(|(index, bound)| searched(&at, index as f64).min(bound));
    heights.fold(top, f64::max)
}

/// Highest value within a sample of a place, by the golden section.
fn searched(at: impl Fn(f64) -> f64, place: f64) -> f64 {
    let (mut low, mut high) = (place - 1.0, place + 1.0);
    let inner = |low: f64, high: f64| [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
    let mut places = inner(low, high);
    let mut heights = places.map(&at);
    for _ in 0..STEPS {
        if heights[0] > heights[1] {
            high = places[1];
            places = [inner(low, high)[0], places[0]];
            heights = [at(places[0]), heights[0]];
        } else {
            low = places[0];
            places = [places[1], inner(low, high)[1]];
            heights = [heights[1], at(places[1])];
        }
    }
    heights[0].max(heights[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of cosines of three periods: their peaks lie between samples, two of them of nearly one height.
    #[test]
    fn extremes_are_those_of_the_curve() {
        let curve = |angle: f64| {
            3.0 + 2.0 * (angle - 0.02).cos() + 0.7 * (2.0 * angle + 1.0).sin() - (3.0 * angle).cos()
        };
        let dense = (0..2_000_000).map(|k| curve(TAU * f64::from(k) / 2e6));
        let [low, high] = dense.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
            [low.min(value), high.max(value)]
        });
        for count in [16, 64, 128] {
            let samples: Vec<_> = (0..count)
                .map(|k| curve(TAU * f64::from(k) / f64::from(count)))
                .collect();
            let found = extremes(&samples);
            assert!(
                (found[0] - low).abs() < 1e-11 && (found[1] - high).abs() < 1e-11,
                "{found:?} {low} {high}"
            );
        }
    }

    #[test]
    fn a_quantity_that_stays_has_one_value() {
        assert_eq!(extremes(&[4.0; 8]), [4.0; 2]);
    }
}
