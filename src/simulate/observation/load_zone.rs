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
    /// Arc that holds all loaded balls, rad: the full circle less the longest run of azimuths without load, every azimuth
    /// counted for its share of the circle. Of two rows an azimuth has load where the element of either row has.
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
#[derive(Debug)]
pub(super) struct LoadZoneSums {
    /// Balls or rollers of a row: those of all rows are at the same azimuths.
    row: usize,
    loaded: Moments,
    spanned: Moments,
}

impl LoadZoneSums {
    /// Of a bearing with so many balls or rollers in a row.
    pub fn new(row: usize) -> Self {
        Self {
            row,
            loaded: Moments::default(),
            spanned: Moments::default(),
        }
    }

    /// Takes the loads of all balls at the inner race in a sample, N, row after row; one is loaded by more than `least`.
    pub fn take(&mut self, loads: &[f64], least: f64) {
        let count = loads.iter().filter(|load| **load > least).count();
        let at_azimuth = |place: usize| loads.iter().skip(place).step_by(self.row);
        let is_free = |place: usize| at_azimuth(place).all(|load| *load <= least);
        let gap = longest_run((0..self.row).map(is_free));
        self.loaded.take(count as f64);
        self.spanned.take((self.row - gap) as f64);
    }

    /// None without samples.
    pub fn finish(self) -> Option<LoadZone> {
        // of no samples the extremes are infinite
        let [least, _] = self.loaded.extremes();
        least.is_finite().then(|| LoadZone {
            balls: Spread::from_moments(&self.loaded, 1.0),
            extent: Spread::from_moments(&self.spanned, TAU / self.row as f64),
        })
    }
}

/// Length of the longest run of `true` around a circle.
fn longest_run(circle: impl ExactSizeIterator<Item = bool>) -> usize {
    let count = circle.len();
    let (mut longest, mut run, mut leading) = (0, 0, None);
    for member in circle {
        if member {
            run += 1;
        } else {
            leading.get_or_insert(run);
            longest = longest.max(run);
            run = 0;
        }
    }
    // the last run goes on in the first; without an end there is but one
    leading.map_or(count, |leading: usize| longest.max(run + leading))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_close_around_the_circle() {
        let run = |circle: &str| longest_run(circle.bytes().map(|ball| ball == b'.'));
        assert_eq!(run("oooo"), 0);
        assert_eq!(run("...."), 4);
        assert_eq!(run("o..o...o"), 3);
        assert_eq!(run("..o..o.."), 4);
    }

    /// Ten azimuths; the first row bears at the last two and the first, the second row at the first two.
    #[test]
    fn rows_share_their_azimuths() {
        let mut sums = LoadZoneSums::new(10);
        let rows = ["o.......oo", "oo........"].concat();
        let loads: Vec<f64> = rows.bytes().map(|ball| f64::from(ball == b'o')).collect();
        sums.take(&loads, 0.0);
        let zone = sums.finish().expect("a sample");
        assert_eq!(zone.balls.mean, 5.0);
        assert!((zone.extent.mean - 0.4 * TAU).abs() < 1e-12);
    }
}
