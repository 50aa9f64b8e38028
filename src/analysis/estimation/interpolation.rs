//! A signal between its samples, and how far that is off.

use std::array;
use std::f64::consts::TAU;

use super::EstimateError;
use crate::analysis::Hermite;
use crate::numerics::root::root;

/// Nodes of the polynomial through values and rates.
const NODES: usize = 4;
/// Nodes of the polynomial through values alone.
const VALUE_NODES: usize = 8;
/// Binomial weights of the barycentric form on [`VALUE_NODES`] equal distances, (−1)^j C(7, j).
const BARYCENTRIC: [f64; VALUE_NODES] = [1.0, -7.0, 21.0, -35.0, 35.0, -21.0, 7.0, -1.0];
/// Most intervals that the error is measured in.
const MOST_MEASURED: usize = 4096;
/// Intervals over which the error is measured.
const WIDE: usize = 2;

/// Uniform samples of a signal and how it runs between them.
#[derive(Debug, Clone, Copy)]
pub(super) enum Interpolation<'a> {
    /// Of a signal with its derivative per second at samples `interval` seconds apart: Hermite's polynomial of degree
    /// seven through the nearest four.
    Rates {
        values: &'a [f64],
        rates: &'a [f64],
        interval: f64,
    },
    /// Of values alone: the polynomial of degree seven through the nearest eight.
    Values(&'a [f64]),
}

impl Interpolation<'_> {
    /// Value at `fraction` of the way from sample `index` to the next.
    pub fn at(&self, index: usize, fraction: f64) -> f64 {
        self.over(index, 1, fraction)
    }

    /// The value from samples `step` apart, of which `index` is one; at the ends of the record through the last nodes,
    /// and through the nearest sample where there are fewer.
    fn over(&self, index: usize, step: usize, fraction: f64) -> f64 {
        let samples = self.samples();
        let nodes = match self {
            Self::Rates { .. } => NODES,
            Self::Values(_) => VALUE_NODES,
        };
        let before = index / step;
        let after = (samples.len() - 1 - index) / step;
        if before + after + 1 < nodes {
            let next = (index + step).min(samples.len() - 1);
            return samples[if fraction < 0.5 { index } else { next }];
        }
        let left = (nodes / 2 - 1)
            .max(nodes - 1 - after.min(nodes - 1))
            .min(before);
        let node = |number: usize| index - left * step + number * step;
        let position = left as f64 + fraction;
        match self {
            Self::Values(values) => through_values(position, |number| values[node(number)]),
            Self::Rates {
                values,
                rates,
                interval,
            } => Hermite::<NODES>::new(0, position).value(
                array::from_fn(|number| values[node(number)]),
                array::from_fn(|number| step as f64 * interval * rates[node(number)]),
            ),
        }
    }

    fn samples(&self) -> &[f64] {
        match self {
            Self::Rates { values, .. } | Self::Values(values) => values,
        }
    }

    /// Error of the interpolation, its root mean square over that of the signal about its mean.
    ///
    /// Samples are left out and found again over a few intervals and over twice as many; from the fall
    /// between the two, the error over one interval is extrapolated. Where the signal is not smooth it hardly
    /// falls, and the error stays what was measured. `None` of a record too short for that, zero of
    /// rest.
    pub fn error(&self) -> Option<f64> {
        let samples = self.samples();
        let [near, far] = [self.measured(WIDE)?, self.measured(2 * WIDE)?];
        let mean = samples.iter().sum::<f64>() / samples.len() as f64;
        let vibration = root_mean_square(samples.iter().map(|x| x - mean));
        if near == 0.0 || vibration == 0.0 {
            return Some(0.0);
        }
        // the power of the interval with which the error grows, none where it does not
        let order = (far / near).log2().max(0.0);
        Some(near * (WIDE as f64).powf(-order) / vibration)
    }

    /// Root mean square of the error from samples `step` apart.
    fn measured(&self, step: usize) -> Option<f64> {
        let samples = self.samples();
        let intervals = (samples.len().checked_sub(1)?) / step;
        // away from the ends, where the nodes cannot be centred
        let inner = VALUE_NODES / 2..intervals.checked_sub(VALUE_NODES / 2)?;
        let stride = inner.len().div_ceil(MOST_MEASURED).max(1);
        let errors: Vec<f64> = inner
            .step_by(stride)
            .flat_map(|interval| (1..step).map(move |inside| (interval * step, inside)))
            .map(|(index, inside)| {
                let found = self.over(index, step, inside as f64 / step as f64);
                found - samples[index + inside]
            })
            .collect();
        (!errors.is_empty()).then(|| root_mean_square(errors.into_iter()))
    }
}

fn root_mean_square(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0_u32), |(sum, count), x| (sum + x * x, count + 1));
    (sum / f64::from(count.max(1))).sqrt()
}

/// The polynomial through eight values, at a position counted in nodes from the first of them.
///
/// Source: J.-P. Berrut & L. N. Trefethen, SIAM Review 46 (2004) 501–517, the barycentric form.
fn through_values(position: f64, value: impl Fn(usize) -> f64) -> f64 {
    let (mut above, mut below) = (0.0, 0.0);
    for (node, weight) in BARYCENTRIC.iter().enumerate() {
        let distance = position - node as f64;
        if distance == 0.0 {
            return value(node);
        }
        above += weight / distance * value(node);
        below += weight / distance;
    }
    above / below
}

/// Finest grid of angle, in samples per sample of time at the highest speed.
const MOST_OVERSAMPLING: f64 = 8.0;
/// Fewest samples of time per revolution: with fewer not even the first order is below half the sampling rate.
const FEWEST_PER_REVOLUTION: f64 = 2.0;

/// Shaft angle and speed at every sample.
#[derive(Debug, Clone, Copy)]
pub(super) struct Turning<'a> {
    pub angle: &'a [f64],
    pub speed: &'a [f64],
}

/// A position between two samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Position {
    /// Sample before.
    pub index: usize,
    /// Part of the interval after it, 0 … 1.
    pub fraction: f64,
}

/// Equal steps of angle over the last whole revolutions of a record.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct AngleGrid {
    /// Samples per revolution that the sampling of time resolves at the highest speed: half as many
    /// orders are resolved.
    pub per_revolution: usize,
    /// The grid is this much finer, so that lower speeds lose nothing that would fold.
    pub oversampling: usize,
    /// Share of the time in which even that is coarser than the sampling of time.
    pub coarse_share: f64,
    /// Where its angles are in the record.
    pub positions: Vec<Position>,
}

impl AngleGrid {
    /// The finest grid that a record of `rate` samples a second needs.
    ///
    /// # Errors
    /// [`EstimateError`] where the shaft turns back, does not turn, makes less than one revolution, or turns too fast for the
    /// sampling.
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
        // angles that were measured apart from the speed may rise faster: the grid must not outgrow the record
        let fastest = highest.max(turns * TAU * rate / (angle.len() - 1) as f64);
        let samples = rate * TAU / fastest;
        if samples < FEWEST_PER_REVOLUTION * (1.0 - 1e-9) {
            let speed = fastest;
            return Err(EstimateError::TooFast { speed, rate });
        }
        let per_revolution = (samples * (1.0 - 1e-12)).ceil();
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
            positions: turning.positions(rate, angles),
        })
    }
}

impl Turning<'_> {
    /// Where rising angles are reached.
    fn positions(&self, rate: f64, angles: impl Iterator<Item = f64>) -> Vec<Position> {
        let last = self.angle.len().saturating_sub(2);
        let mut index = 0;
        let position = |angle: f64| {
            while index < last && self.angle[index + 1] <= angle {
                index += 1;
            }
            let fraction = self.fraction(index, 1.0 / rate, angle);
            Position { index, fraction }
        };
        angles.map(position).collect()
    }

    /// Part of an interval at whose end an angle is reached, on the cubic through angles and speeds at both ends: exact
    /// at constant acceleration.
    fn fraction(&self, index: usize, interval: f64, angle: f64) -> f64 {
        let [from, to] = [self.angle[index], self.angle[index + 1]];
        let [v, v1] = [index, index + 1].map(|index| interval * self.speed[index]);
        let rise = to - from;
        let [c2, c3] = [3.0 * rise - 2.0 * v - v1, v + v1 - 2.0 * rise];
        let beyond = |u: f64| u * (v + u * (c2 + u * c3)) - (angle - from);
        let values = [0.0, 1.0].map(beyond);
        // at an end but for round-off
        let end = if values[1] < 0.0 { 1.0 } else { 0.0 };
        root(beyond, [0.0, 1.0], values, 1e-15).unwrap_or(end)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// A sine with so many samples a period, and its derivatives.
    fn sine(per_period: f64, length: usize) -> [Vec<f64>; 3] {
        let angle = |n: usize| TAU * n as f64 / per_period + 0.3;
        let make = |value: fn(f64) -> f64| (0..length).map(|n| value(angle(n))).collect();
        let pace = TAU / per_period;
        let [x, v, a]: [Vec<f64>; 3] = [make(f64::sin), make(f64::cos), make(|t| -t.sin())];
        let v = v.iter().map(|v| v * pace).collect();
        let a = a.iter().map(|a| a * pace * pace).collect();
        [x, v, a]
    }

    #[test]
    fn values_alone_are_interpolated_to_the_seventh_degree() {
        let p = |t: f64| {
            (0..8)
                .rev()
                .fold(0.0, |sum, k| sum * (t / 10.0) + f64::from(k) - 3.5)
        };
        let values: Vec<f64> = (0..12).map(|n| p(f64::from(n))).collect();
        for index in 0..11 {
            for fraction in [0.0, 0.3, 0.99] {
                let found = Interpolation::Values(&values).at(index, fraction);
                assert!(
                    (found - p(index as f64 + fraction)).abs() < 1e-11,
                    "{index} {fraction}"
                );
            }
        }
    }

    /// At six samples a period and fewer the polynomials hardly converge, and the stated error is high.
    #[test]
    fn the_stated_error_is_the_true_one_or_a_higher_one() {
        for per_period in [40.0, 20.0, 10.0, 6.0] {
            let [x, v, a] = sine(per_period, 3000);
            let of = |values, rates| Interpolation::Rates {
                values,
                rates,
                interval: 1.0,
            };
            let pace = TAU / per_period;
            let cases = [
                (of(&x, &v), 1.0, 0.0),
                (of(&v, &a), pace, TAU / 4.0),
                (Interpolation::Values(&x), 1.0, 0.0),
            ];
            for (interpolation, scale, lead) in cases {
                let errors = (8..2900).flat_map(|n| [0.1, 0.35, 0.5, 0.7].map(|u| (n, u)));
                let errors = errors.map(|(n, u)| {
                    let truth = scale * (pace * (n as f64 + u) + 0.3 + lead).sin();
                    interpolation.at(n, u) - truth
                });
                let actual = root_mean_square(errors) / (scale * 0.5_f64.sqrt());
                let stated = interpolation.error().expect("a long record");
                assert!(
                    stated > 0.3 * actual,
                    "{per_period}: {stated:e} for {actual:e}"
                );
                let high = if per_period < 10.0 { 300.0 } else { 5.0 };
                assert!(
                    stated < high * actual + 1e-14,
                    "{per_period}: {stated:e} for {actual:e}"
                );
            }
        }
    }

    #[test]
    fn rest_has_no_error_and_a_short_record_none_that_is_known() {
        assert_eq!(Interpolation::Values(&[2.0; 100]).error(), Some(0.0));
        assert_eq!(Interpolation::Values(&[2.0; 20]).error(), None);
    }

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
        let count = grid.positions.len();
        assert_eq!(count, 12 * 79 * 8); // 80/2π = 12.7 revolutions
        for (n, position) in grid.positions.iter().enumerate() {
            let angle = 80.0 - (count - 1 - n) as f64 * TAU / (79.0 * 8.0);
            let time = (position.index as f64 + position.fraction) / rate;
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

    /// Also where an angle that was measured apart from the speed rises faster than that.
    #[test]
    fn a_grid_of_angle_does_not_outgrow_its_record() {
        let grid = |speed: f64, rise: f64| {
            let angle: Vec<f64> = (0..100).map(|n| rise * f64::from(n)).collect();
            let speed = &vec![speed; angle.len()][..];
            let angle = &angle[..];
            AngleGrid::new(Turning { angle, speed }, 10.0, 0.0)
        };
        for (speed, rise) in [(1e14, 1e13), (300.0, 1e13), (1e14, 1.0), (32.0, 3.2)] {
            let fastest = f64::max(speed, 10.0 * rise);
            match grid(speed, rise) {
                Err(EstimateError::TooFast { speed, rate }) => {
                    assert!(
                        (speed / fastest - 1.0).abs() < 1e-12 && rate == 10.0,
                        "{speed}"
                    );
                }
                other => panic!("{speed} {rise}: {other:?}"),
            }
        }
        // half a revolution from sample to sample, and angles that rise far faster than the speed says
        for (speed, rise) in [(10.0 * PI, PI), (1e-9, 1.0)] {
            let found = grid(speed, rise).expect("two samples a revolution");
            assert!(found.positions.len() <= 150, "{}", found.positions.len());
        }
    }
}
