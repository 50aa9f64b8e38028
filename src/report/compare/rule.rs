//! The rule of one column: what is compared, and how far it may be apart.

use std::f64::consts::{PI, TAU};

use super::{Tolerance, Tolerances};
use crate::analysis::{Channel, NoiseFloor};

/// Where a column stands in the two tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Place {
    /// In the first table.
    pub first: usize,
    /// In the second table.
    pub second: usize,
}

/// Two values of a row and the judgement on them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Judgement {
    /// Their difference; infinite where one is no number.
    pub difference: f64,
    /// Difference allowed.
    pub allowed: f64,
    /// The relative tolerance that alone would allow it; infinite where none would.
    pub needed: f64,
}

/// What the columns of two tables are measured by.
pub(super) struct Scales<F> {
    /// Largest magnitude of a column in both tables.
    pub largest: F,
    /// What of them is round-off.
    floor: NoiseFloor,
}

impl<F> Scales<F> {
    /// Of columns with their names and places, `rate` rows a second.
    pub fn of<'a, P: Copy>(
        columns: impl Iterator<Item = (&'a str, P)>,
        largest: F,
        rate: f64,
    ) -> Self
    where
        F: Fn(P) -> f64,
    {
        let of_column = |(name, place)| Some((Channel::of_column(name)?, largest(place)));
        let floor = NoiseFloor::of(columns.filter_map(of_column), rate);
        Self { largest, floor }
    }

    /// Difference of a column that is round-off; zero where equal values are asked for.
    pub fn floor(&self, name: &str, tolerance: Tolerance) -> f64 {
        match Channel::of_column(name) {
            Some(channel) if !tolerance.is_exact() => self.floor.below(channel),
            _ => 0.0,
        }
    }
}

/// What is compared of a column.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Rule {
    /// The values themselves.
    Value {
        /// What is allowed.
        tolerance: Tolerance,
        /// Largest magnitude of the column.
        scale: f64,
        /// Difference that is round-off.
        floor: f64,
    },
    /// An angle, modulo 2π, where the amplitude is significant.
    Phase {
        /// What is allowed whatever the amplitude.
        tolerance: Tolerance,
        /// Where the amplitude stands.
        amplitude: Place,
        /// Difference allowed of the amplitude.
        amplitude_allowed: f64,
    },
}

impl Rule {
    /// The rule of column `name`, which stands at `place`.
    pub fn new<'a>(
        name: &str,
        columns: impl Iterator<Item = (&'a str, Place)>,
        scales: &Scales<impl Fn(Place) -> f64>,
        place: Place,
        tolerances: &Tolerances,
    ) -> Self {
        let tolerance = tolerances.of(name);
        let amplitude = name.strip_suffix("_phase_rad").and_then(|quantity| {
            let prefix = format!("{quantity}_amplitude_");
            columns
                .into_iter()
                .find(|(other, _)| other.starts_with(&prefix))
        });
        match amplitude {
            None => Self::Value {
                tolerance,
                scale: (scales.largest)(place),
                floor: scales.floor(name, tolerance),
            },
            Some((other, amplitude)) => Self::Phase {
                tolerance,
                amplitude,
                amplitude_allowed: tolerances.of(other).allowed((scales.largest)(amplitude))
                    + scales.floor(other, tolerances.of(other)),
            },
        }
    }

    /// Judges the values at `place` of two rows; `None` where there is nothing to compare.
    pub fn judge(&self, place: Place, first: &[f64], second: &[f64]) -> Option<Judgement> {
        let (a, b) = (first[place.first], second[place.second]);
        match *self {
            Self::Value {
                tolerance,
                scale,
                floor,
            } => Some(judgement(distance(a, b), tolerance, scale, floor)),
            Self::Phase {
                tolerance,
                amplitude,
                amplitude_allowed,
            } => {
                let size = first[amplitude.first].max(second[amplitude.second]);
                let turned = || {
                    judgement(
                        turn(distance(a, b)),
                        tolerance,
                        PI,
                        amplitude_allowed / size,
                    )
                };
                (size > amplitude_allowed).then(turned)
            }
        }
    }
}

/// The judgement on a difference that may be as large as the tolerance of `scale` and something `more`.
pub(super) fn judgement(difference: f64, tolerance: Tolerance, scale: f64, more: f64) -> Judgement {
    let beyond = difference - more;
    Judgement {
        difference,
        allowed: tolerance.allowed(scale) + more,
        needed: if beyond > 0.0 { beyond / scale } else { 0.0 },
    }
}

/// |a − b|; zero for equal infinities and for two NaN, infinite where only one is a number.
pub(super) fn distance(a: f64, b: f64) -> f64 {
    if a == b || (a.is_nan() && b.is_nan()) {
        return 0.0;
    }
    let difference = (a - b).abs();
    if difference.is_nan() {
        f64::INFINITY
    } else {
        difference
    }
}

/// The shorter way round the circle.
fn turn(angle: f64) -> f64 {
    if angle.is_infinite() {
        return angle;
    }
    let angle = angle.rem_euclid(TAU);
    angle.min(TAU - angle)
}
