//! How the numbers of a study follow its axes: peaks along the only one, rank correlations with what was drawn.

use std::collections::BTreeMap;

use serde::Serialize;

use super::column_digest::ColumnDigest;
use super::digest::{Digest, is_down, number};
use crate::report::variable::variable_column;
use crate::table::{Column, ColumnKind};

/// What of lengths is reported of its peaks.
const TOLD: [ColumnKind; 2] = [ColumnKind::Measure("rms"), ColumnKind::Measure("order_1")];

/// An order that is less than this part of the motion of its channel is round-off or noise.
const LEAST_PART: f64 = 0.01;

/// A peak of a response curve.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct ResponsePeak {
    /// The number.
    pub number: Column,
    /// `up` or `down`: how the runs came to their values.
    pub direction: &'static str,
    /// Value of the axis at the top of the parabola through three runs.
    pub at: f64,
    /// The number there.
    pub height: f64,
    /// Values of the axis on either side at which half the power is left, where the curve falls so far.
    pub half_power_from: Option<f64>,
    pub half_power_to: Option<f64>,
    /// What lies between them.
    bandwidth: Option<f64>,
}

/// The peaks of a study of one axis on a grid.
pub(super) fn peaks(digest: &Digest) -> Vec<ResponsePeak> {
    if digest.head.axes.len() != 1 || !digest.is_complete() {
        return Vec::new();
    }
    let columns = digest.columns.iter().enumerate();
    let reported = columns.filter(|(_, column)| {
        let Column { unit, kind, .. } = &column.column;
        unit == "m" && TOLD.contains(kind) && tells(digest, column)
    });
    reported
        .flat_map(|(index, column)| {
            [false, true].into_iter().flat_map(move |down| {
                let rows = digest.rows.iter().filter(|row| is_down(row) == down);
                let mut curve: Vec<_> = rows
                    .map(|row| (row.values[0], number(row, index)))
                    .collect();
                curve.retain(|(_, value)| value.is_finite());
                curve.sort_by(|a, b| a.0.total_cmp(&b.0));
                tops(&curve)
                    .into_iter()
                    .map(move |place| peak(&column.column, down, &curve, place))
            })
        })
        .collect()
}

/// Whether a number is a fair part of the motion of its channel, as far as that is known.
fn tells(digest: &Digest, column: &ColumnDigest) -> bool {
    let own = &column.column;
    let whole = digest.columns.iter().find(|known| {
        let known = &known.column;
        known.quantity == own.quantity && known.kind == TOLD[0] && known.unit == own.unit
    });
    whole.is_none_or(|whole| column.highest >= LEAST_PART * whole.highest)
}

/// Places in a curve that are higher than both neighbours, by half the power than the valleys that part
/// them from anything higher.
fn tops(curve: &[(f64, f64)]) -> Vec<usize> {
    let higher = |k: usize| curve[k].1 > curve[k - 1].1 && curve[k].1 > curve[k + 1].1;
    let inner = 1..curve.len().saturating_sub(1);
    inner
        .filter(|k| higher(*k))
        .filter(|k| {
            half_power(curve, *k, curve[*k].1)
                .iter()
                .any(Option::is_some)
        })
        .collect()
}

fn peak(number: &Column, down: bool, curve: &[(f64, f64)], place: usize) -> ResponsePeak {
    let [(a, fa), (b, fb), (c, fc)] = [curve[place - 1], curve[place], curve[place + 1]];
    // the parabola by divided differences
    let first = (fb - fa) / (b - a);
    let second = ((fc - fb) / (c - b) - first) / (c - a);
    let at = 0.5 * (a + b) - 0.5 * first / second;
    let height = fa + first * (at - a) + second * (at - a) * (at - b);
    let [from, to] = half_power(curve, place, height);
    ResponsePeak {
        number: number.clone(),
        direction: if down { "down" } else { "up" },
        at,
        height,
        half_power_from: from,
        half_power_to: to,
        bandwidth: to.zip(from).map(|(to, from)| to - from),
    }
}

/// Where the curve falls to 1/√2 of the height, on either side, between runs linearly; none where it rises
/// above the height before, or ends.
fn half_power(curve: &[(f64, f64)], place: usize, height: f64) -> [Option<f64>; 2] {
    let level = height * std::f64::consts::FRAC_1_SQRT_2;
    let below = curve[..=place].iter().rev().copied().collect::<Vec<_>>();
    [&below[..], &curve[place..]].map(|side| {
        let pair = side
            .windows(2)
            .take_while(|pair| pair[0].1 <= height)
            .find(|pair| pair[1].1 <= level)?;
        let part = (pair[0].1 - level) / (pair[0].1 - pair[1].1);
        Some(pair[0].0 + part * (pair[1].0 - pair[0].0))
    })
}

/// Fewest runs that a rank correlation is reported for.
const FEWEST_RUNS: usize = 10;

/// How a number follows the axes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Sensitivity {
    /// The number.
    pub number: Column,
    /// Rank correlation with every axis by its name.
    pub rank_correlation: BTreeMap<String, f64>,
}

/// Of a number that varies Spearman's rank correlation with every axis, by their values in every run.
///
/// Source: C. Spearman, *The proof and measurement of association between two things*, Am. J. Psychol. 15
/// (1904) 72–101; equal values get the mean of their ranks.
pub(super) fn sensitivity(
    digest: &Digest,
    column: usize,
    axes: &[Vec<f64>],
    numbers: &[f64],
) -> Option<Sensitivity> {
    let of = &digest.columns[column];
    let known = |values: &[f64]| {
        let pairs = values.iter().zip(numbers);
        ranks(pairs.filter_map(|(value, number)| (!number.is_nan()).then_some(*value)))
    };
    if (of.known as usize) < FEWEST_RUNS || !varies(digest, of) {
        return None;
    }
    let ranked = known(numbers);
    let axes = digest.head.axes.iter().zip(axes);
    let axes = axes.map(|(variable, values)| {
        let name = variable_column(variable).name();
        (name, correlation(&known(values), &ranked))
    });
    Some(Sensitivity {
        number: of.column.clone(),
        rank_correlation: axes.collect(),
    })
}

/// Whether a number is not the same in all runs that have it. What changes by a billionth of the largest number that is measured
/// alike, as a displacement across a shaft that is pushed along its axis, is round-off; pure numbers are not alike.
pub(super) fn varies(digest: &Digest, own: &ColumnDigest) -> bool {
    let Column { unit, kind, .. } = &own.column;
    let alike = digest.columns.iter().filter(|of| {
        of.known > 0 && !unit.is_empty() && of.column.unit == *unit && of.column.kind == *kind
    });
    own.varies_beside(alike.map(ColumnDigest::size).fold(own.size(), f64::max))
}

/// Place of every value in their order, from 0 on; equal ones share the mean of their places.
fn ranks(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let values: Vec<f64> = values.collect();
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let mut ranks = vec![0.0; values.len()];
    let mut start = 0;
    for equal in order.chunk_by(|a, b| values[*a] == values[*b]) {
        let rank = start as f64 + 0.5 * (equal.len() - 1) as f64;
        equal.iter().for_each(|place| ranks[*place] = rank);
        start += equal.len();
    }
    ranks
}

/// Pearson's correlation; zero where one does not vary.
fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let (mean_a, mean_b) = (mean(a), mean(b));
    let product = |(a, b): (&f64, &f64)| (a - mean_a) * (b - mean_b);
    let covariance: f64 = a.iter().zip(b).map(product).sum();
    let square = |values: &[f64], mean: f64| -> f64 {
        values.iter().map(|value| (value - mean).powi(2)).sum()
    };
    let spread = (square(a, mean_a) * square(b, mean_b)).sqrt();
    if spread > 0.0 {
        covariance / spread
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Amplitude of an oscillator of damping ratio ζ at frequency ratio r; its half-power bandwidth is 2ζ for
    /// small ζ.
    #[test]
    fn the_bandwidth_of_an_oscillator_is_twice_its_damping_ratio() {
        let damping = 0.02;
        let amplitude = |r: f64| 1.0 / ((1.0 - r * r).powi(2) + (2.0 * damping * r).powi(2)).sqrt();
        let curve: Vec<_> = (0..=4000)
            .map(|k| 0.8 + 1e-4 * f64::from(k))
            .map(|r| (r, amplitude(r)))
            .collect();
        let found = tops(&curve);
        assert_eq!(found.len(), 1);
        let found = peak(&Column::measure("x", "rms", "m"), false, &curve, found[0]);
        assert!((found.at - (1.0 - 2.0 * damping * damping).sqrt()).abs() < 1e-6);
        let bandwidth = found.bandwidth.expect("a bandwidth");
        assert!((bandwidth - 2.0 * damping).abs() < 1e-3 * 2.0 * damping + 1e-4);
    }

    #[test]
    fn the_rank_correlation_is_that_of_scipy() {
        // scipy.stats.spearmanr([1, 2, 3, 4, 5], [5, 6, 7, 8, 7]) = 0.8207826816681233
        let a = ranks([1.0, 2.0, 3.0, 4.0, 5.0].into_iter());
        let b = ranks([5.0, 6.0, 7.0, 8.0, 7.0].into_iter());
        assert!((correlation(&a, &b) - 0.820_782_681_668_123_3).abs() < 1e-14);
    }
}
