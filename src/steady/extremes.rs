//! Extremes of quantities that repeat, between their samples.

use std::f64::consts::TAU;

use nalgebra::Complex;

use crate::analysis::Transform;
use crate::numerics::root::root;

/// Part of the largest coefficient below which another one is round-off.
const ROUND_OFF: f64 = 1e-17;
/// A curve rises above its highest sample by about an eighth of the second difference there: beyond this part it does not.
const RISE: f64 = 0.5;
/// Part of the distance of samples to which the place of a peak is found: there the curve is flat.
const FOUND: f64 = 1e-8;

/// Lowest and highest value of the trigonometric polynomial through the samples of a period; not numbers where a sample is
/// none. Of quantities that are not smooth it is as exact as samples so far apart are.
pub(super) fn extremes(samples: &[f64]) -> [f64; 2] {
    if samples.iter().any(|value| !value.is_finite()) {
        return [f64::NAN; 2];
    }
    let series = Series::through(samples);
    [-1.0, 1.0].map(|sign| sign * series.highest(samples, sign))
}

/// A trigonometric polynomial over places that are counted in samples.
struct Series {
    /// Angle a sample, and coefficient, of all that count.
    lines: Vec<(f64, Complex<f64>)>,
}

impl Series {
    /// The one through samples of a period.
    fn through(samples: &[f64]) -> Self {
        let count = samples.len();
        let transform = Transform::new(samples.to_vec());
        let lines = (0..=count / 2).map(|k| {
            // both of a pair at once; the coefficient of half the sampling rate stands for itself
            let pair = if k == 0 || 2 * k == count { 1.0 } else { 2.0 };
            (
                k as f64 * TAU / count as f64,
                pair * transform.bin(k as isize),
            )
        });
        let mut lines: Vec<_> = lines.collect();
        let largest = lines.iter().map(|(_, own)| own.norm()).fold(0.0, f64::max);
        lines.retain(|(_, own)| own.norm() > ROUND_OFF * largest);
        Self { lines }
    }

    /// Value and slope at a place.
    fn at(&self, place: f64) -> [f64; 2] {
        self.lines
            .iter()
            .fold([0.0; 2], |[value, slope], (turn, own)| {
                let turned = own * Complex::cis(turn * place);
                [value + turned.re, slope - turn * turned.im]
            })
    }

    /// Highest value of the curve, `sign` times as large, through its samples.
    fn highest(&self, samples: &[f64], sign: f64) -> f64 {
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
        let heights = peaks.filter_map(|(index, bound)| {
            let ends = [index as f64 - 1.0, index as f64 + 1.0];
            let slope = |place: f64| sign * self.at(place)[1];
            let peak = root(slope, ends, ends.map(slope), FOUND)?;
            // what is not smooth may swing farther between its samples than it bends
            Some((sign * self.at(peak)[0]).min(bound))
        });
        heights.fold(top, f64::max)
    }
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
