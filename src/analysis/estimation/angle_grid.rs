//! Equal steps of shaft angle in a record of equal steps of time.

use std::f64::consts::TAU;

use super::EstimateError;

/// Finest grid of angle, in samples per sample of time at the highest speed.
const MOST_OVERSAMPLING: f64 = 8.0;
/// Newton steps and bisections that place an angle in its interval to the last digits.
const MOST_STEPS: usize = 64;

/// Shaft angle and speed at every sample.
#[derive(Debug, Clone, Copy)]
pub(super) struct Turning<'a> {
    pub angle: &'a [f64],
    pub speed: &'a [f64],
}

/// A place between two samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    /// Sample before.
    pub index: usize,
    /// Part of the interval after it, 0 … 1.
    pub fraction: f64,
}

/// Equal steps of angle over the last whole revolutions of a record.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct AngleGrid {
    /// Samples per revolution that the sampling of time resolves at the highest speed: half as many
    /// orders can be told.
    pub per_revolution: usize,
    /// The grid is this much finer, so that lower speeds lose nothing that would fold.
    pub oversampling: usize,
    /// Share of the time in which even that is coarser than the sampling of time.
    pub coarse_share: f64,
    /// Where its angles stand in the record.
    pub places: Vec<Place>,
}

impl AngleGrid {
    /// The finest grid that a record of `rate` samples a second needs.
    ///
    /// # Errors
    /// [`EstimateError`] where the shaft turns back, stands, or makes less than one revolution.
    pub fn new(turning: Turning<'_>, rate: f64, start: f64) -> Result<Self, EstimateError> {
        let Turning { angle, speed } = turning;
        let falls = |pair: &[f64]| pair[1] < pair[0];
        if let Some(sample) = angle.windows(2).position(falls) {
            let time = start + sample as f64 / rate;
            return Err(EstimateError::TurnsBack { time });
        }
        let turns = match (angle.first(), angle.last()) {
            (Some(first), Some(last)) => (last - first) / TAU,
            _ => 0.0,
        };
        let highest = speed.iter().copied().fold(0.0, f64::max);
        // a record of whole revolutions keeps its last one in spite of round-off
        let revolutions = (turns * (1.0 + 1e-12)).floor();
        if revolutions < 1.0 || highest <= 0.0 {
            return Err(EstimateError::NoRevolution { turns });
        }
        let per_revolution = (rate * TAU / highest * (1.0 - 1e-12)).ceil().max(1.0);
        let lowest = speed.iter().copied().fold(f64::INFINITY, f64::min);
        let needed = (highest / lowest.max(highest / MOST_OVERSAMPLING) * (1.0 - 1e-12)).ceil();
        let oversampling = needed.clamp(1.0, MOST_OVERSAMPLING);
        let slow = speed
            .iter()
            .filter(|speed| **speed * oversampling < highest * (1.0 - 1e-9));
        let count = revolutions * per_revolution * oversampling;
        let step = TAU / (per_revolution * oversampling);
        let end = angle.last().copied().unwrap_or(0.0);
        let angles = (0..count as usize).map(|n| end - (count - 1.0 - n as f64) * step);
        Ok(Self {
            per_revolution: per_revolution as usize,
            oversampling: oversampling as usize,
            coarse_share: slow.count() as f64 / speed.len() as f64,
            places: turning.places(rate, angles),
        })
    }
}

impl Turning<'_> {
    /// Where rising angles stand.
    fn places(&self, rate: f64, angles: impl Iterator<Item = f64>) -> Vec<Place> {
        let last = self.angle.len().saturating_sub(2);
        let mut index = 0;
        let place = |angle: f64| {
            while index < last && self.angle[index + 1] <= angle {
                index += 1;
            }
            let fraction = self.fraction(index, 1.0 / rate, angle);
            Place { index, fraction }
        };
        angles.map(place).collect()
    }

    /// Where an angle stands in an interval, on the cubic through angles and speeds at both ends: exact
    /// at constant acceleration. Newton's method, bisected where it would leave the bracket.
    fn fraction(&self, index: usize, interval: f64, angle: f64) -> f64 {
        let [from, to] = [self.angle[index], self.angle[index + 1]];
        let [v, v1] = [index, index + 1].map(|index| interval * self.speed[index]);
        let rise = to - from;
        let [c2, c3] = [3.0 * rise - 2.0 * v - v1, v + v1 - 2.0 * rise];
        let beyond = |u: f64| u * (v + u * (c2 + u * c3)) - (angle - from);
        let slope = |u: f64| v + u * (2.0 * c2 + 3.0 * c3 * u);
        let (mut low, mut high) = (0.0, 1.0);
        let mut u = if rise > 0.0 {
            ((angle - from) / rise).clamp(0.0, 1.0)
        } else {
            0.0
        };
        for _ in 0..MOST_STEPS {
            let excess = beyond(u);
            if excess > 0.0 {
                high = u;
            } else {
                low = u;
            }
            let newton = u - excess / slope(u);
            let next = if newton > low && newton < high {
                newton
            } else {
                0.5 * (low + high)
            };
            if excess == 0.0 || (next - u).abs() < 1e-15 {
                break;
            }
            u = next;
        }
        u
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_of_a_run_up_stand_where_the_square_root_says() {
        // ψ = ½ α t² from rest
        let (rate, alpha) = (1000.0, 40.0);
        let times = (0..=2000).map(|n| f64::from(n) / rate);
        let (angle, speed): (Vec<f64>, Vec<f64>) =
            times.map(|t| (0.5 * alpha * t * t, alpha * t)).unzip();
        let turning = Turning {
            angle: &angle,
            speed: &speed,
        };
        let grid = AngleGrid::new(turning, rate, 0.0).expect("it turns");
        assert_eq!(grid.per_revolution, 79); // 1000 · 2π/80
        assert_eq!(grid.oversampling, 8);
        assert!(
            (grid.coarse_share - 0.125).abs() < 2e-3,
            "{}",
            grid.coarse_share
        );
        let count = grid.places.len();
        assert_eq!(count, 12 * 79 * 8); // 80/2π = 12.7 revolutions
        for (n, place) in grid.places.iter().enumerate() {
            let angle = 80.0 - (count - 1 - n) as f64 * TAU / (79.0 * 8.0);
            let time = (place.index as f64 + place.fraction) / rate;
            assert!((time - (2.0 * angle / alpha).sqrt()).abs() < 1e-12, "{n}");
        }
    }

    #[test]
    fn what_turns_back_or_hardly_turns_has_no_grid() {
        let grid = |angle: &[f64], start| {
            let speed = &vec![1.0; angle.len()][..];
            AngleGrid::new(Turning { angle, speed }, 10.0, start)
        };
        let back = grid(&[0.0, 4.0, 3.0, 9.0], 2.0);
        assert!(
            matches!(back, Err(EstimateError::TurnsBack { time }) if (time - 2.1).abs() < 1e-12)
        );
        let little = grid(&[0.0, 4.0], 2.0);
        assert!(matches!(little, Err(EstimateError::NoRevolution { .. })));
    }
}
