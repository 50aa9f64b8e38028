//! A load given as a series of values.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::MainVibration;
use crate::bearing::Vector5;

/// How a series is read between its rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Interpolation {
    /// Straight lines.
    #[default]
    Linear,
    /// Cubic pieces of continuous slope that do not overshoot (Fritsch and Butland).
    MonotoneCubic,
}

/// A component of a series.
#[derive(Debug, Clone, PartialEq)]
pub struct SeriesComponent {
    /// Number of the freedom it acts on: x, y, z, θx, θy.
    pub axis: usize,
    /// One value a row, N or N m.
    pub values: Vec<f64>,
}

/// Why rows do not make a series.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SeriesError {
    /// Nothing to interpolate between.
    #[error("a series needs at least two rows; this one has {rows}")]
    TooFew {
        /// Number of rows.
        rows: usize,
    },
    /// A column is shorter or longer than that of the times.
    #[error("a column has {values} values for {rows} times")]
    Length {
        /// Values in the column.
        values: usize,
        /// Number of times.
        rows: usize,
    },
    /// A number is not finite.
    #[error("row {row} has {value}, which is not finite")]
    NotFinite {
        /// Row, from 1.
        row: usize,
        /// The value.
        value: f64,
    },
    /// A time does not come after the one before it.
    #[error("row {row} has the time {time} s, not after {before} s")]
    Time {
        /// Row, from 1.
        row: usize,
        /// Its time, s.
        time: f64,
        /// Time of the row before, s.
        before: f64,
    },
}

/// A load that follows a table of times and values.
///
/// Before the first row its values are held, after the last row those of the last.
///
/// ```text
/// linear:          P(s) = P_k + (P_(k+1) − P_k) s,   s = (t − t_k)/h,   h = t_(k+1) − t_k
/// monotone cubic:  P(s) = (1 + 2s)(1 − s)² P_k + s(1 − s)² h d_k + s²(3 − 2s) P_(k+1) − s²(1 − s) h d_(k+1)
/// ```
///
/// with d_k = 0 where the differences change their sign, and else their weighted harmonic mean, so
/// that the curve stays between neighbouring values.
///
/// Source: Fritsch & Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300, with Brodlie's weights.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    times: Vec<f64>,
    columns: Vec<SeriesComponent>,
    /// Slopes d_k of each column; none for straight lines.
    slopes: Vec<Vec<f64>>,
}

impl Series {
    /// A series of rising times in s and the columns beside them.
    ///
    /// # Errors
    /// [`SeriesError`] with the row that is wrong.
    pub fn new(
        times: Vec<f64>,
        columns: Vec<SeriesComponent>,
        interpolation: Interpolation,
    ) -> Result<Self, SeriesError> {
        check(&times, &columns)?;
        let slopes = match interpolation {
            Interpolation::Linear => Vec::new(),
            Interpolation::MonotoneCubic => columns
                .iter()
                .map(|column| monotone_slopes(&times, &column.values))
                .collect(),
        };
        Ok(Self {
            times,
            columns,
            slopes,
        })
    }

    /// Time of the last row, s.
    pub fn end(&self) -> f64 {
        self.times[self.times.len() - 1]
    }

    /// The load at a time in s.
    #[inline]
    pub fn at(&self, time: f64) -> Vector5 {
        let next = self.times.partition_point(|row| *row <= time);
        let right = next.clamp(1, self.times.len() - 1);
        let (from, to) = (self.times[right - 1], self.times[right]);
        let part = ((time - from) / (to - from)).clamp(0.0, 1.0);
        let mut sum = [0.0; 5];
        for (number, column) in self.columns.iter().enumerate() {
            let values = [column.values[right - 1], column.values[right]];
            sum[column.axis] += match self.slopes.get(number) {
                None => values[0] + (values[1] - values[0]) * part,
                Some(slopes) => {
                    let rises = [slopes[right - 1], slopes[right]].map(|slope| slope * (to - from));
                    hermite(values, rises, part)
                }
            };
        }
        sum
    }

    /// Its largest distance from the first row, as an amplitude at frequency zero.
    pub fn main_vibration(&self) -> MainVibration {
        let mut amplitude = [0.0; 5];
        for column in &self.columns {
            let start = column.values[0];
            let distances = column.values.iter().map(|value| (value - start).abs());
            amplitude[column.axis] = distances.fold(amplitude[column.axis], f64::max);
        }
        MainVibration::at(0.0, amplitude)
    }

    /// The next row after a time, s.
    pub fn next_break(&self, after: f64) -> f64 {
        let passed = self.times.partition_point(|row| *row <= after);
        self.times.get(passed).copied().unwrap_or(f64::INFINITY)
    }
}

fn check(times: &[f64], columns: &[SeriesComponent]) -> Result<(), SeriesError> {
    let rows = times.len();
    if rows < 2 {
        return Err(SeriesError::TooFew { rows });
    }
    let lists = std::iter::once(times).chain(columns.iter().map(|column| &column.values[..]));
    for list in lists {
        if list.len() != rows {
            let values = list.len();
            return Err(SeriesError::Length { values, rows });
        }
        if let Some(row) = list.iter().position(|value| !value.is_finite()) {
            let value = list[row];
            return Err(SeriesError::NotFinite {
                row: row + 1,
                value,
            });
        }
    }
    match times.windows(2).position(|pair| pair[1] <= pair[0]) {
        None => Ok(()),
        Some(row) => Err(SeriesError::Time {
            row: row + 2,
            time: times[row + 1],
            before: times[row],
        }),
    }
}

/// Cubic through two values with given rises (slopes times the distance).
fn hermite(values: [f64; 2], rises: [f64; 2], s: f64) -> f64 {
    let rest = 1.0 - s;
    (1.0 + 2.0 * s) * rest * rest * values[0]
        + s * rest * rest * rises[0]
        + s * s * (3.0 - 2.0 * s) * values[1]
        - s * s * rest * rises[1]
}

/// Slopes at the rows; at both ends those of the straight line there.
fn monotone_slopes(times: &[f64], values: &[f64]) -> Vec<f64> {
    let steps = |k: usize| times[k + 1] - times[k];
    let slope = |k: usize| (values[k + 1] - values[k]) / steps(k);
    let last = times.len() - 1;
    let inner = |k: usize| {
        let (before, after) = (slope(k - 1), slope(k));
        if before * after <= 0.0 {
            return 0.0;
        }
        // weights (h_(k−1) + 2 h_k)/3(h_(k−1) + h_k) and their complement
        let weight = (steps(k - 1) + 2.0 * steps(k)) / (3.0 * (steps(k - 1) + steps(k)));
        before * after / (weight * after + (1.0 - weight) * before)
    };
    (0..=last)
        .map(|k| match k {
            0 => slope(0),
            _ if k == last => slope(last - 1),
            _ => inner(k),
        })
        .collect()
}
