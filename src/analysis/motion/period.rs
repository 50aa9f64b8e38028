//! What kind of motion the points of its sections belong to: periodic, of two frequencies, or irregular.

use std::f64::consts::PI;

use serde::Serialize;

use super::closed_curve::{ClosedCurve, closed_curve};
use super::{Moments, SectionKind};
use crate::keys;

/// Longest period that is sought, cycles of a section.
pub const LONGEST_PERIOD: usize = 12;
/// Points that come back within this part of the motion repeat.
const REPEATS: f64 = 1e-3;
/// Points that a closed curve misses by less than this part of their spread lie on it.
const ON_CURVE: f64 = 0.02;
/// Repetitions of a period that are compared at least.
const FEWEST_COMPARED: usize = 3;
/// Fewest points that a closed curve is sought through.
const FEWEST_ON_CURVE: usize = 20;
/// Fewest points that a motion is called irregular by.
const FEWEST_IRREGULAR: usize = 100;
/// The 0–1 test says that a motion is irregular above this.
const IRREGULAR: f64 = 0.5;
/// Cycles after which the other drive may repeat in a motion of two frequencies.
const MOST_REPEATED: u32 = 4;

/// Points of one section.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// What a point is taken once of.
    pub kind: SectionKind,
    /// Cycles of the section a revolution of the shaft.
    pub order: f64,
    /// Displacements and rates of every point, in parts of the RMS of the whole motion.
    pub points: Vec<Vec<f64>>,
}

/// What kind of motion it is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(tag = "name", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Kind {
    /// There is none.
    Rest,
    /// It grows beyond all bounds.
    Diverging,
    /// It repeats after a number of cycles of a section.
    Periodic {
        /// The section.
        section: SectionKind,
        /// The number.
        cycles: usize,
        /// RMS distance of points any multiple of so many cycles apart, in parts of the motion.
        distance: f64,
    },
    /// It has two frequencies: the points of a section lie on a closed curve.
    QuasiPeriodic {
        /// The section.
        section: SectionKind,
        /// The curve.
        #[serde(rename = "closed_curve")]
        curve: ClosedCurve,
    },
    /// Neither, and the 0–1 test says that it is irregular.
    Irregular {
        /// The test: near 1 for chaos.
        #[serde(rename = "zero_one_test")]
        test: f64,
    },
    /// None of these: too few points, or not settled.
    Unknown {
        /// Number of points of the section that has most.
        points: usize,
        /// The 0–1 test, where there are enough points for it.
        #[serde(rename = "zero_one_test")]
        test: Option<f64>,
    },
}

/// The kind of a motion and what speaks for it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Recognition {
    /// The kind.
    pub kind: Kind,
    /// Of every section the RMS distance of points any multiple of 1, 2, … cycles apart, in parts of the
    /// motion, over the last half of the points.
    #[serde(serialize_with = "keys::by_name")]
    pub distances: Vec<(SectionKind, Vec<f64>)>,
    /// Of every section the best closed curve, where no period was found.
    #[serde(rename = "closed_curves", serialize_with = "keys::by_name")]
    pub curves: Vec<(SectionKind, ClosedCurve)>,
}

/// Recognises a motion by the points of its sections.
///
/// In this order: it is periodic where points so many cycles apart (up to [`LONGEST_PERIOD`]), and any
/// multiple of it, are the same within a thousandth of the motion; of two frequencies where the points lie on a closed curve
/// within a fiftieth of their spread ([`closed_curve`]); irregular where at least a hundred points have
/// a 0–1 test above a half ([`zero_one_test`]).
pub fn recognise(series: &[Series]) -> Recognition {
    let distances: Vec<(SectionKind, Vec<f64>)> = series
        .iter()
        .map(|section| (section.kind, distances(&section.points)))
        .collect();
    if let Some(kind) = shortest_period(series, &distances) {
        return Recognition {
            kind,
            distances,
            curves: Vec::new(),
        };
    }
    let curves: Vec<(SectionKind, ClosedCurve)> = series
        .iter()
        .filter_map(|section| Some((section.kind, curve(section, series)?)))
        .collect();
    let best = curves
        .iter()
        .min_by(|a, b| a.1.residual.total_cmp(&b.1.residual));
    let kind = match best {
        Some((section, curve)) if curve.residual < ON_CURVE => Kind::QuasiPeriodic {
            section: *section,
            curve: *curve,
        },
        _ => irregular(series),
    };
    Recognition {
        kind,
        distances,
        curves,
    }
}

/// RMS distance, over the last half of the points, of two points any multiple of 1, 2, … cycles apart: √2
/// times their distance from the mean of those that would be one point.
fn distances(points: &[Vec<f64>]) -> Vec<f64> {
    let most = (points.len() / FEWEST_COMPARED).min(LONGEST_PERIOD);
    let components = points.first().map_or(0, Vec::len);
    let apart = |cycles: usize| {
        let wanted = (points.len() / 2).max(FEWEST_COMPARED * cycles);
        let late = &points[points.len() - wanted..];
        let scatter = |(component, first): (usize, usize)| {
            let values = late.iter().skip(first).step_by(cycles);
            let moments: Moments = values.map(|point| point[component]).collect();
            moments.scatter()
        };
        let all = (0..components).flat_map(|component| (0..cycles).map(move |k| (component, k)));
        (2.0 * all.map(scatter).sum::<f64>() / wanted as f64).sqrt()
    };
    (1..=most).map(apart).collect()
}

/// The period that takes the shortest time.
fn shortest_period(series: &[Series], distances: &[(SectionKind, Vec<f64>)]) -> Option<Kind> {
    let periods = series
        .iter()
        .zip(distances)
        .filter_map(|(section, (kind, apart))| {
            let cycles = 1 + apart.iter().position(|distance| *distance < REPEATS)?;
            let period = Kind::Periodic {
                section: *kind,
                cycles,
                distance: apart[cycles - 1],
            };
            Some((cycles as f64 / section.order, period))
        });
    let shortest = periods.min_by(|a, b| a.0.total_cmp(&b.0));
    shortest.map(|(_, kind)| kind)
}

/// The closed curve of a section, with the rotation numbers that the other sections would make.
fn curve(section: &Series, all: &[Series]) -> Option<ClosedCurve> {
    if section.points.len() < FEWEST_ON_CURVE {
        return None;
    }
    let others = all.iter().filter(|other| other.kind != section.kind);
    let known: Vec<f64> = others
        .flat_map(|other| {
            let turns = other.order / section.order;
            (1..=MOST_REPEATED).map(move |repeated| turns / f64::from(repeated))
        })
        .collect();
    closed_curve(&section.points, &known)
}

/// By the section that has most points, along the component that varies most.
fn irregular(series: &[Series]) -> Kind {
    let longest = series.iter().max_by_key(|section| section.points.len());
    let points = longest.map_or(&[][..], |section| &section.points[..]);
    let known = points.len();
    if known < FEWEST_IRREGULAR {
        return Kind::Unknown {
            points: known,
            test: None,
        };
    }
    let components = (0..points[0].len())
        .map(|index| -> Vec<f64> { points.iter().map(|point| point[index]).collect() });
    let spread = |values: &[f64]| Moments::from_iter(values.iter().copied()).peak_to_peak();
    let widest = components.max_by(|a, b| spread(a).total_cmp(&spread(b)));
    let test = zero_one_test(&widest.unwrap_or_default());
    if test > IRREGULAR {
        Kind::Irregular { test }
    } else {
        Kind::Unknown {
            points: known,
            test: Some(test),
        }
    }
}

/// Frequencies that are tried.
const FREQUENCIES: u32 = 100;
/// Most values that are tested: the last ones.
const MOST_VALUES: usize = 2000;
/// Part of the values over which the growth is followed.
const FOLLOWED: usize = 10;

/// The 0–1 test for chaos: near 0 for a regular sequence, near 1 for a chaotic one.
///
/// ```text
/// p(n) + i q(n) = Σ_{j≤n} φ_j e^{ijc},   M(m) = mean_n |p(n + m) − p(n)|² + |q(n + m) − q(n)|²
/// D(m) = M(m) − mean(φ)² (1 − cos mc)/(1 − cos c),   K_c = correlation of D with m,   m ≤ N/10
/// ```
///
/// The answer is the median of K_c over a hundred c in π/5 … 4π/5.
///
/// Source: G. A. Gottwald & I. Melbourne, *On the implementation of the 0–1 test for chaos*, SIAM
/// J. Appl. Dyn. Syst. 8 (2009) 129–145. The c of this function are evenly spread instead of random.
pub fn zero_one_test(values: &[f64]) -> f64 {
    let values = &values[values.len().saturating_sub(MOST_VALUES)..];
    if values.len() < 2 * FOLLOWED {
        return 0.0;
    }
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    // evenly by the golden ratio, so that none is a simple part of a turn
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let mut found: Vec<f64> = (1..=FREQUENCIES)
        .map(|index| {
            let part = (golden * f64::from(index)).fract();
            growth(values, mean, PI * (0.2 + 0.6 * part))
        })
        .collect();
    found.sort_by(f64::total_cmp);
    found[found.len() / 2]
}

/// K_c.
fn growth(values: &[f64], mean: f64, c: f64) -> f64 {
    let mut sum = [0.0; 2];
    let path: Vec<[f64; 2]> = values
        .iter()
        .zip(1u32..)
        .map(|(value, n)| {
            let (sin, cos) = (f64::from(n) * c).sin_cos();
            sum = [sum[0] + value * cos, sum[1] + value * sin];
            sum
        })
        .collect();
    let most = values.len() / FOLLOWED;
    let kept = values.len() - most;
    let (times, distances): (Vec<f64>, Vec<f64>) = (1..=most)
        .map(|m| {
            let pairs = path[..kept].iter().zip(&path[m..]);
            let squares = pairs.map(|(a, b)| (b[0] - a[0]).powi(2) + (b[1] - a[1]).powi(2));
            let time = m as f64;
            let oscillation = mean * mean * (1.0 - (time * c).cos()) / (1.0 - c.cos());
            (time, squares.sum::<f64>() / kept as f64 - oscillation)
        })
        .unzip();
    correlation(&times, &distances)
}

fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let (mean_a, mean_b) = (mean(a), mean(b));
    let pairs = || a.iter().zip(b).map(|(a, b)| (a - mean_a, b - mean_b));
    let product: f64 = pairs().map(|(a, b)| a * b).sum();
    let squares = pairs().fold([0.0; 2], |sum, (a, b)| [sum[0] + a * a, sum[1] + b * b]);
    let norm = (squares[0] * squares[1]).sqrt();
    if norm > 0.0 { product / norm } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_those_of_points_that_would_be_one() {
        let value = |n: usize| [0.0, 1.0, 3.0][n % 3] + if n < 30 { 7.0 } else { 0.0 };
        let points: Vec<Vec<f64>> = (0..60).map(|n| vec![value(n)]).collect();
        let found = distances(&points);
        // mean square distance of two independent picks of 0, 1 and 3 is twice their variance 14/9
        assert!((found[0] - (28.0f64 / 9.0).sqrt()).abs() < 1e-12);
        assert!((found[1] - found[0]).abs() < 1e-12 && found[2] < 1e-12);
    }

    #[test]
    fn the_logistic_map_is_regular_and_chaotic() {
        let logistic = |r: f64| {
            let step = move |x: &f64| Some(r * x * (1.0 - x));
            std::iter::successors(Some(0.3), step)
                .skip(1000)
                .take(1000)
                .collect::<Vec<_>>()
        };
        assert!(zero_one_test(&logistic(3.55)) < 0.1); // a period of eight
        assert!(zero_one_test(&logistic(3.97)) > 0.9); // chaos
    }
}
