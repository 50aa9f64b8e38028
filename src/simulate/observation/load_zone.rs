//! How many balls bear the load, and over which arc.

use std::f64::consts::TAU;

use serde::Serialize;

use crate::analysis::Moments;

/// Smallest, mean and largest value of the samples.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Spread {
    /// Smallest value.
    pub smallest: f64,
    /// Mean value.
    pub mean: f64,
    /// Largest value.
    pub largest: f64,
}

/// Balls of a bearing that are loaded at the inner race, by the rule of
/// [`crate::rotor::BallContacts::least_load`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct LoadZone {
    /// Number of loaded balls.
    #[serde(rename = "balls_loaded")]
    pub balls: Spread,
    /// Arc that holds all loaded balls, rad: the full circle less the longest row of unloaded ones,
    /// every ball counted for its share of the circle.
    #[serde(rename = "extent_rad")]
    pub extent: Spread,
}

impl Spread {
    /// Of some values, in parts of a unit.
    fn from_moments(values: &Moments, unit: f64) -> Self {
        let [smallest, largest] = values.extremes();
        Self {
            smallest: unit * smallest,
            mean: unit * values.mean(),
            largest: unit * largest,
        }
    }
}

/// Collects the load zone of one bearing.
#[derive(Debug, Default)]
pub(super) struct LoadZoneSums {
    balls: usize,
    loaded: Moments,
    spanned: Moments,
}

impl LoadZoneSums {
    /// Takes the loads of all balls at the inner race in a sample, N; one is loaded by more than `least`.
    pub fn take(&mut self, loads: &[f64], least: f64) {
        self.balls = loads.len();
        let count = loads.iter().filter(|load| **load > least).count();
        let gap = longest_row(loads.iter().map(|load| *load <= least));
        self.loaded.take(count as f64);
        self.spanned.take((self.balls - gap) as f64);
    }

    pub fn finish(self) -> Option<LoadZone> {
        (self.balls > 0).then(|| LoadZone {
            balls: Spread::from_moments(&self.loaded, 1.0),
            extent: Spread::from_moments(&self.spanned, TAU / self.balls as f64),
        })
    }
}

/// Length of the longest row of `true` around a circle.
fn longest_row(circle: impl ExactSizeIterator<Item = bool>) -> usize {
    let count = circle.len();
    let (mut longest, mut row, mut leading) = (0, 0, None);
    for member in circle {
        if member {
            row += 1;
        } else {
            leading.get_or_insert(row);
            longest = longest.max(row);
            row = 0;
        }
    }
    // the last row goes on in the first; without an end there is but one
    leading.map_or(count, |leading: usize| longest.max(row + leading))
}

#[cfg(test)]
mod tests {
    use super::longest_row;

    #[test]
    fn rows_close_around_the_circle() {
        let row = |circle: &str| longest_row(circle.bytes().map(|ball| ball == b'.'));
        assert_eq!(row("oooo"), 0);
        assert_eq!(row("...."), 4);
        assert_eq!(row("o..o...o"), 3);
        assert_eq!(row("..o..o.."), 4);
    }
}
