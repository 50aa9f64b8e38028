//! A signal between its samples, and how far that is off.

use std::f64::consts::TAU;

use super::EstimateError;

/// Samples of the polynomial through values alone.
const STENCIL: usize = 8;
/// Binomial weights of the barycentric form on [`STENCIL`] equal distances, (−1)^j C(7, j).
const BARYCENTRIC: [f64; STENCIL] = [1.0, -7.0, 21.0, -35.0, 35.0, -21.0, 7.0, -1.0];
/// Most intervals that the error is measured in.
const MOST_MEASURED: usize = 4096;

/// Uniform samples of a signal and how it runs between them.
#[derive(Debug, Clone, Copy)]
pub(super) enum Interpolation<'a> {
    /// Of a signal with its first two derivatives per second: the quintic that keeps all three.
    Quintic(Motion<'a>),
    /// The derivative of that quintic: a velocity.
    QuinticRate(Motion<'a>),
    /// Of values alone: the polynomial of degree seven through the nearest eight.
    Values(&'a [f64]),
}

/// A displacement with its derivatives at samples `interval` seconds apart.
#[derive(Debug, Clone, Copy)]
pub(super) struct Motion<'a> {
    pub displacement: &'a [f64],
    pub velocity: &'a [f64],
    pub acceleration: &'a [f64],
    pub interval: f64,
}

impl Interpolation<'_> {
    /// Value at `fraction` of the way from sample `index` to the next.
    pub fn at(&self, index: usize, fraction: f64) -> f64 {
        self.over(index, 1, fraction)
    }

    /// The same from samples `step` apart, of which `index` is one.
    fn over(&self, index: usize, step: usize, fraction: f64) -> f64 {
        match self {
            Self::Quintic(motion) => motion.quintic(index, step).value(fraction),
            Self::QuinticRate(motion) => motion.quintic(index, step).rate(fraction),
            Self::Values(values) => through_values(values, index, step, fraction),
        }
    }

    fn samples(&self) -> &[f64] {
        match self {
            Self::Quintic(motion) => motion.displacement,
            Self::QuinticRate(motion) => motion.velocity,
            Self::Values(values) => values,
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
        let wide = self.wide();
        let [near, far] = [self.measured(wide)?, self.measured(2 * wide)?];
        let mean = samples.iter().sum::<f64>() / samples.len() as f64;
        let swing = root_mean_square(samples.iter().map(|x| x - mean));
        if near == 0.0 || swing == 0.0 {
            return Some(0.0);
        }
        // the power of the interval with which the error grows, none where it does not
        let order = (far / near).log2().max(0.0);
        Some(near * (wide as f64).powf(-order) / swing)
    }

    /// Intervals over which the error is measured: the derivative of the quintic is more exact halfway
    /// than elsewhere.
    fn wide(&self) -> usize {
        match self {
            Self::QuinticRate(_) => 3,
            Self::Quintic(_) | Self::Values(_) => 2,
        }
    }

    /// Root mean square of the error from samples `step` apart.
    fn measured(&self, step: usize) -> Option<f64> {
        let samples = self.samples();
        let intervals = (samples.len().checked_sub(1)?) / step;
        // away from the ends, where the stencil cannot be centred
        let inner = STENCIL / 2..intervals.checked_sub(STENCIL / 2)?;
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

impl Motion<'_> {
    /// The quintic from sample `index` to the one `step` further.
    fn quintic(&self, index: usize, step: usize) -> Quintic {
        let length = step as f64 * self.interval;
        let end = |index: usize| {
            [
                self.displacement[index],
                length * self.velocity[index],
                length * length * self.acceleration[index],
            ]
        };
        Quintic::new(end(index), end(index + step), length)
    }
}

/// The polynomial of degree five that has value and two derivatives at both ends of an interval:
///
/// `p(u) = p₀ + p₀′u + ½p₀″u² + c₃u³ + c₄u⁴ + c₅u⁵`, u = 0 … 1
///
/// Its error is h⁶ f⁽⁶⁾/46080 at most, for a sine with n samples a period 1.3/n⁶ of its amplitude.
struct Quintic {
    coefficients: [f64; 6],
    length: f64,
}

impl Quintic {
    fn new([x, v, a]: [f64; 3], [x1, v1, a1]: [f64; 3], length: f64) -> Self {
        // what is left at the end after the first three terms
        let position = x1 - x - v - 0.5 * a;
        let slope = v1 - v - a;
        let curve = a1 - a;
        Self {
            coefficients: [
                x,
                v,
                0.5 * a,
                10.0 * position - 4.0 * slope + 0.5 * curve,
                -15.0 * position + 7.0 * slope - curve,
                6.0 * position - 3.0 * slope + 0.5 * curve,
            ],
            length,
        }
    }

    fn value(&self, u: f64) -> f64 {
        self.coefficients
            .iter()
            .rev()
            .fold(0.0, |sum, c| sum * u + c)
    }

    /// Derivative per second.
    fn rate(&self, u: f64) -> f64 {
        let terms = self.coefficients.iter().enumerate().skip(1).rev();
        let slope = terms.fold(0.0, |sum, (power, c)| sum * u + power as f64 * c);
        slope / self.length
    }
}

/// The polynomial through the eight samples about the place, `step` apart; at the ends of the record
/// through the last eight, and through the nearest sample where there are fewer.
///
/// Source: J.-P. Berrut & L. N. Trefethen, SIAM Review 46 (2004) 501–517, the barycentric form.
fn through_values(values: &[f64], index: usize, step: usize, fraction: f64) -> f64 {
    let before = index / step;
    let after = (values.len() - 1 - index) / step;
    if before + after + 1 < STENCIL {
        return values[if fraction < 0.5 {
            index
        } else {
            (index + step).min(values.len() - 1)
        }];
    }
    let left = (STENCIL / 2 - 1)
        .max(STENCIL - 1 - after.min(STENCIL - 1))
        .min(before);
    let place = left as f64 + fraction;
    let (mut above, mut below) = (0.0, 0.0);
    for (node, weight) in BARYCENTRIC.iter().enumerate() {
        let value = values[index - left * step + node * step];
        let distance = place - node as f64;
        if distance == 0.0 {
            return value;
        }
        above += weight / distance * value;
        below += weight / distance;
    }
    above / below
}

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
    use std::f64::consts::TAU;

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
    fn a_quintic_is_itself() {
        let p = |t: f64| 1.0 + t * (2.0 - t * (0.5 + t * (1.0 - t * (0.3 + 0.1 * t))));
        let v = |t: f64| 2.0 - t * (1.0 + t * (3.0 - t * (1.2 + 0.5 * t)));
        let a = |t: f64| -1.0 - t * (6.0 - t * (3.6 + 2.0 * t));
        let quintic = Quintic::new(
            [p(0.0), 2.0 * v(0.0), 4.0 * a(0.0)],
            [p(2.0), 2.0 * v(2.0), 4.0 * a(2.0)],
            2.0,
        );
        for u in [0.0, 0.2, 0.5, 0.9, 1.0] {
            assert!((quintic.value(u) - p(2.0 * u)).abs() < 1e-13);
            assert!((quintic.rate(u) - v(2.0 * u)).abs() < 1e-12);
        }
    }

    #[test]
    fn values_alone_are_interpolated_to_the_seventh_degree_everywhere() {
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
            let motion = Motion {
                displacement: &x,
                velocity: &v,
                acceleration: &a,
                interval: 1.0,
            };
            let pace = TAU / per_period;
            let cases = [
                (Interpolation::Quintic(motion), 1.0, 0.0),
                (Interpolation::QuinticRate(motion), pace, TAU / 4.0),
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
