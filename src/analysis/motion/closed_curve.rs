//! Whether points of a section lie on a closed curve, one after the other by a fixed part of a turn.

use std::convert::Infallible;
use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};
use serde::Serialize;

use crate::analysis::{Transform, Window};
use crate::numerics::minimum::minimum;

/// Most harmonics of a curve.
const MOST_HARMONICS: usize = 8;
/// Fewest points for every number that is fitted.
const POINTS_A_NUMBER: usize = 2;
/// Most points that are fitted: the last ones.
const MOST_POINTS: usize = 400;
/// Part of the range of a search within which a rotation number is found.
const ROTATION_KNOWN: f64 = 1e-6;
/// Best ones of the points' own candidates that are searched.
const REFINED: usize = 2;

/// A closed curve through points.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ClosedCurve {
    /// Part of a turn from a point to the next.
    pub rotation: f64,
    /// Harmonics of the curve.
    pub harmonics: usize,
    /// RMS distance of a point from the curve through all others, relative to the spread of the points.
    pub residual: f64,
}

/// The closed curve that explains a sequence of points best.
///
/// ```text
/// P_n = c_0 + Σ_h (a_h cos 2πhρn + b_h sin 2πhρn),   h = 1 … H
/// ```
///
/// by least squares for every candidate ρ: those in `known`, and those that make the strongest line of
/// the points' own spectrum their first to third harmonic. How well a curve explains the points is
/// measured by leaving every point out once, so that more harmonics are no better by themselves.
///
/// `points` holds components by point; `None` where there are too few of them.
pub fn closed_curve(points: &[Vec<f64>], known: &[f64]) -> Option<ClosedCurve> {
    let points = &points[points.len().saturating_sub(MOST_POINTS)..];
    let centred = Centred::new(points)?;
    let given = known.iter().map(|rotation| centred.best(*rotation));
    let own = strongest(&centred).into_iter().flat_map(fractions);
    let mut own: Vec<ClosedCurve> = own.filter_map(|rotation| centred.best(rotation)).collect();
    own.sort_by(|a, b| a.residual.total_cmp(&b.residual));
    own.truncate(REFINED);
    let own = own.into_iter().map(|curve| centred.refined(curve));
    let all = given.chain(own).flatten();
    all.min_by(|a, b| a.residual.total_cmp(&b.residual))
}

/// Points less their mean.
struct Centred {
    /// One row a point.
    rows: DMatrix<f64>,
    /// Mean square over all.
    spread: f64,
}

impl Centred {
    fn new(points: &[Vec<f64>]) -> Option<Self> {
        let dimensions = points.first()?.len();
        let mut rows =
            DMatrix::from_fn(points.len(), dimensions, |row, column| points[row][column]);
        for mut column in rows.column_iter_mut() {
            let mean = column.mean();
            column.add_scalar_mut(-mean);
        }
        let spread = rows.norm_squared();
        (spread > 0.0).then_some(Self { rows, spread })
    }

    /// The number of harmonics that explains the points best at a rotation number.
    fn best(&self, rotation: f64) -> Option<ClosedCurve> {
        let most = self.rows.nrows() / (2 * POINTS_A_NUMBER);
        let fits = (1..=MOST_HARMONICS.min(most.saturating_sub(1)))
            .filter_map(|harmonics| self.fit(rotation, harmonics));
        fits.min_by(|a, b| a.residual.total_cmp(&b.residual))
    }

    /// A curve with the rotation number moved to where it explains the points best, by golden section.
    fn refined(&self, curve: ClosedCurve) -> Option<ClosedCurve> {
        let residual = |rotation: f64| {
            let fit = self.fit(rotation, curve.harmonics);
            fit.map_or(f64::INFINITY, |curve| curve.residual)
        };
        let reach = 0.5 / (self.rows.nrows() * curve.harmonics) as f64;
        let ends = [curve.rotation - reach, curve.rotation + reach];
        let Ok((rotation, _)) = minimum(
            |rotation| Ok::<_, Infallible>(residual(rotation)),
            ends,
            ROTATION_KNOWN * reach,
        );
        self.best(rotation)
    }

    /// Least squares with every point left out once: its residual over 1 − its own weight in the fit.
    fn fit(&self, rotation: f64, harmonics: usize) -> Option<ClosedCurve> {
        let count = self.rows.nrows();
        let basis = DMatrix::from_fn(count, 1 + 2 * harmonics, |row, column| {
            let harmonic = column.div_ceil(2) as f64;
            let angle = TAU * (harmonic * rotation * row as f64).fract();
            match column {
                0 => 1.0,
                column if column % 2 == 1 => angle.cos(),
                _ => angle.sin(),
            }
        });
        let factors = (basis.transpose() * &basis).cholesky()?;
        let missed = &self.rows - &basis * factors.solve(&(basis.transpose() * &self.rows));
        let mut sum = 0.0;
        for (row, own) in missed.row_iter().zip(basis.row_iter()) {
            let own: DVector<f64> = own.transpose();
            let weight = own.dot(&factors.solve(&own));
            if weight > 1.0 - 1e-6 {
                return None;
            }
            sum += row.norm_squared() / (1.0 - weight).powi(2);
        }
        Some(ClosedCurve {
            rotation: rotation.rem_euclid(1.0),
            harmonics,
            residual: (sum / self.spread).sqrt(),
        })
    }
}

/// Frequency of the strongest line of the points, in turns a point.
fn strongest(points: &Centred) -> Option<f64> {
    let count = points.rows.nrows();
    let columns = points.rows.column_iter();
    let transforms: Vec<Transform> = columns
        .map(|column| Transform::new(column.iter().copied().collect()))
        .collect();
    let power = |k: usize| -> f64 {
        let amplitudes = transforms
            .iter()
            .map(|each| each.amplitude(k, Window::Hann));
        amplitudes.map(|amplitude| amplitude * amplitude).sum()
    };
    let last = count / 2;
    let top = (1..=last).max_by(|a, b| power(*a).total_cmp(&power(*b)))?;
    // the line lies towards the stronger neighbour
    let beside = |k: usize| {
        if (1..=last).contains(&k) {
            power(k).sqrt()
        } else {
            0.0
        }
    };
    let (below, above) = (beside(top - 1), beside(top + 1));
    let ratio = below.max(above) / power(top).sqrt();
    let offset = Window::Hann.line_offset(ratio, count as f64);
    let offset = offset.clamp(-0.5, 0.5);
    let signed = if above >= below { offset } else { -offset };
    Some((top as f64 + signed) / count as f64)
}

/// Rotation numbers of which a frequency is the first, second or third harmonic.
fn fractions(frequency: f64) -> Vec<f64> {
    let pairs = (1..=3).flat_map(|of| (0..of).map(move |turns| (of, turns)));
    pairs
        .map(|(of, turns)| (frequency + f64::from(turns)) / f64::from(of))
        .collect()
}
