//! How the end of a known motion depends on its start, by the series of Magnus.
//!
//! ```text
//! Φ̇ = A(t) Φ,   A = ∂f/∂y along the motion,   over a step of h: Φ ← exp(Ω) Φ
//! Ω = α₁ + α₃/12 + [−20α₁ − α₃ + C₁, α₂ + C₂]/240,   C₁ = [α₁, α₂],   C₂ = −[α₁, 2α₃ + C₁]/60
//! α₁ = 9/4 A₀ − 15 A₂,   α₂ = 12 A₁,   α₃ = 180 A₂ − 15 A₀,   A_i = h ∫ s^i A ds over −½ … ½
//! ```
//!
//! of sixth order. What does not change along the motion is solved exactly, whatever the step, so that A is
//! asked for where it changes and not where the motion swings.
//!
//! Source: Blanes, Casas, Oteo & Ros, *The Magnus expansion and some of its applications*, Physics Reports
//! 470 (2009) 151–238, sec. 5.4; the integrals by five points at equal distances, exact to degree 5.

use nalgebra::{Const, SMatrix};

use super::{Linearised, Scaling, Square};

/// Intervals of the grid that the shortest step goes over: one beside each of its five points.
pub const SHORTEST: usize = 4;

/// Weights of the five points in A₀, A₁ and A₂.
const MOMENTS: [[f64; 5]; 3] = [
    [
        7.0 / 90.0,
        32.0 / 90.0,
        12.0 / 90.0,
        32.0 / 90.0,
        7.0 / 90.0,
    ],
    [-7.0 / 180.0, -16.0 / 180.0, 0.0, 16.0 / 180.0, 7.0 / 180.0],
    [
        13.0 / 840.0,
        32.0 / 840.0,
        -20.0 / 840.0,
        32.0 / 840.0,
        13.0 / 840.0,
    ],
];

/// Most halvings of a step before it is tried again.
const MOST_HALVINGS: u32 = 2;

/// Slopes of the end of a motion by its start.
#[derive(Debug, Clone, PartialEq)]
pub struct SlopesAlong<const N: usize> {
    /// `∂(end)/∂(start)`, rows by component of the end.
    pub slopes: SMatrix<f64, N, N>,
    /// How often the system was asked for its slopes.
    pub linearisations: u64,
}

/// Slopes of a motion from time 0 on that is known at times `interval` apart, to about `tolerance` in the
/// units of `scaling`. The number of intervals must be a power of two, [`SHORTEST`] at least.
///
/// `None` where these times stand too far apart, and where the motion meets a break or a surface at which
/// the system is not smooth.
///
/// ```
/// # use jeffcott::integrate::{Linearised, Scaling, System, slopes_along};
/// # use nalgebra::SMatrix;
/// /// ẋ = x cos t, so that x(t) = x(0) exp(sin t).
/// struct Swelling;
/// impl System<1> for Swelling {
///     fn derivative(&self, time: f64, state: &[f64; 1], rate: &mut [f64; 1]) {
///         rate[0] = state[0] * time.cos();
///     }
/// }
/// impl Linearised<1> for Swelling {
///     fn linearisation(&self, time: f64, state: &[f64; 1]) -> (SMatrix<f64, 1, 1>, [f64; 1]) {
///         (SMatrix::from_element(time.cos()), [-state[0] * time.sin()])
///     }
/// }
/// let states: Vec<[f64; 1]> = (0..=16).map(|k| [(0.1 * f64::from(k)).sin().exp()]).collect();
/// let found = slopes_along(&Swelling, &Scaling::IDENTITY, 1e-6, 0.1, &states).expect("a smooth motion");
/// assert!((found.slopes[(0, 0)] - 1.6_f64.sin().exp()).abs() < 1e-6);
/// ```
pub fn slopes_along<S, const N: usize>(
    system: &S,
    scaling: &Scaling<N>,
    tolerance: f64,
    interval: f64,
    states: &[[f64; N]],
) -> Option<SlopesAlong<N>>
where
    S: Linearised<N>,
    Const<N>: Square,
{
    let intervals = states.len().saturating_sub(1);
    if intervals < SHORTEST || !intervals.is_power_of_two() {
        return None;
    }
    let mut along = Along {
        system,
        scaling,
        tolerance,
        interval,
        states,
        known: vec![None; states.len()],
        slopes: SMatrix::identity(),
    };
    if !along.is_smooth() {
        return None;
    }
    along.go(0, intervals)?;
    Some(SlopesAlong {
        linearisations: along.known.iter().flatten().count() as u64,
        slopes: along.in_units(),
    })
}

struct Along<'a, S, const N: usize> {
    system: &'a S,
    scaling: &'a Scaling<N>,
    tolerance: f64,
    interval: f64,
    states: &'a [[f64; N]],
    /// A at the times asked for so far, scaled.
    known: Vec<Option<SMatrix<f64, N, N>>>,
    /// Φ where the steps have come to, scaled.
    slopes: SMatrix<f64, N, N>,
}

impl<S, const N: usize> Along<'_, S, N>
where
    S: Linearised<N>,
    Const<N>: Square,
{
    fn time(&self, point: usize) -> f64 {
        point as f64 * self.interval
    }

    /// Whether no break and no surface stands between the ends of the motion.
    fn is_smooth(&self) -> bool {
        let end = self.time(self.states.len() - 1);
        let sides = |(point, state)| self.system.surroundings(self.time(point), state).sides;
        let mut all = self.states.iter().enumerate().map(sides);
        let first = all.next();
        self.system.next_break(0.5 * self.interval) > end - 0.5 * self.interval
            && all.all(|sides| Some(sides) == first)
    }

    /// Goes over some intervals, in one step or in parts.
    fn go(&mut self, first: usize, intervals: usize) -> Option<()> {
        let (exponent, error) = self.exponent(first, intervals);
        let share = intervals as f64 / (self.states.len() - 1) as f64;
        let excess = error / (self.tolerance * share);
        if excess <= 1.0 {
            self.slopes = exponent.exp() * self.slopes;
            return Some(());
        }
        let part = intervals >> halvings(excess);
        if part < SHORTEST {
            return None;
        }
        (0..intervals / part).try_for_each(|number| self.go(first + number * part, part))
    }

    /// Ω of a step and a bound of its error: that of fourth order by every other point is off by `e ~ h⁵`, and
    /// what changes in the step is of a size `v ~ h²`, so that `e (e/v)^⅔ ~ h⁷` is of the order of the error:
    /// four times as large and more on swings of varying stiffness.
    fn exponent(&mut self, first: usize, intervals: usize) -> (SMatrix<f64, N, N>, f64) {
        let step = intervals as f64 * self.interval;
        let points: [_; 5] =
            std::array::from_fn(|k| self.slopes_at(first + k * intervals / 4) * step);
        let [mean, tilt, bend] = MOMENTS.map(|weights| {
            let pairs = points.iter().zip(weights);
            pairs.fold(SMatrix::zeros(), |sum, (point, weight)| {
                sum + point * weight
            })
        });
        let linear = (points[4] - points[0]) / 12.0;
        let coarse = (points[0] + points[2] * 4.0 + points[4]) / 6.0;
        let lower = coarse - commutator(&coarse, &linear);
        let exponent = sixth_order(&mean, &tilt, &bend);
        let off = (exponent - lower).amax();
        let change = (linear * 12.0).amax() + (points[2] - coarse).amax();
        // where nothing changes, both differ by round-off alone
        let ratio = if off < change { off / change } else { 1.0 };
        (exponent, off * ratio.powf(2.0 / 3.0))
    }

    /// A at a point of the grid, scaled.
    fn slopes_at(&mut self, point: usize) -> SMatrix<f64, N, N> {
        if let Some(known) = self.known[point] {
            return known;
        }
        let (slopes, _) = self
            .system
            .linearisation(self.time(point), &self.states[point]);
        let scale = &self.scaling.scale;
        let scaled =
            SMatrix::from_fn(|row, column| slopes[(row, column)] * scale[column] / scale[row]);
        self.known[point] = Some(scaled);
        scaled
    }

    /// Φ in the units of the system.
    fn in_units(&self) -> SMatrix<f64, N, N> {
        let scale = &self.scaling.scale;
        SMatrix::from_fn(|row, column| self.slopes[(row, column)] * scale[row] / scale[column])
    }
}

/// Halvings that make a local error of h⁷, in shares of h, smaller by a factor.
fn halvings(excess: f64) -> u32 {
    let needed = (excess.log2() / 6.0).ceil();
    (needed as u32).clamp(1, MOST_HALVINGS)
}

/// Ω from the integrals A₀, A₁ and A₂.
fn sixth_order<const N: usize>(
    mean: &SMatrix<f64, N, N>,
    tilt: &SMatrix<f64, N, N>,
    bend: &SMatrix<f64, N, N>,
) -> SMatrix<f64, N, N> {
    let constant = mean * 2.25 - bend * 15.0;
    let linear = tilt * 12.0;
    let square = bend * 180.0 - mean * 15.0;
    let first = commutator(&constant, &linear);
    let second = commutator(&constant, &(square * 2.0 + first)) / -60.0;
    let outer = commutator(&(first - constant * 20.0 - square), &(linear + second));
    constant + square / 12.0 + outer / 240.0
}

fn commutator<const N: usize>(
    left: &SMatrix<f64, N, N>,
    right: &SMatrix<f64, N, N>,
) -> SMatrix<f64, N, N> {
    left * right - right * left
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrate::{Surroundings, System};

    /// ẍ = −(1 + depth cos t) x: Mathieu's equation, whose slopes do not depend on the motion.
    struct Mathieu {
        depth: f64,
        break_at: f64,
        wall_at: f64,
    }

    const SMOOTH: Mathieu = Mathieu {
        depth: 0.3,
        break_at: f64::INFINITY,
        wall_at: f64::INFINITY,
    };

    impl System<2> for Mathieu {
        fn derivative(&self, time: f64, state: &[f64; 2], rate: &mut [f64; 2]) {
            *rate = [state[1], -(1.0 + self.depth * time.cos()) * state[0]];
        }

        fn next_break(&self, after: f64) -> f64 {
            if after < self.break_at {
                self.break_at
            } else {
                f64::INFINITY
            }
        }

        fn surroundings(&self, time: f64, _state: &[f64; 2]) -> Surroundings {
            Surroundings {
                sides: u128::from(time > self.wall_at),
                nearest: 0.0,
            }
        }
    }

    impl Linearised<2> for Mathieu {
        fn linearisation(&self, time: f64, state: &[f64; 2]) -> (SMatrix<f64, 2, 2>, [f64; 2]) {
            let stiffness = 1.0 + self.depth * time.cos();
            let rate = self.depth * time.sin() * state[0];
            (
                SMatrix::<f64, 2, 2>::new(0.0, 1.0, -stiffness, 0.0),
                [0.0, rate],
            )
        }
    }

    fn found(system: &Mathieu, tolerance: f64, intervals: usize) -> Option<SlopesAlong<2>> {
        let interval = std::f64::consts::TAU / intervals as f64;
        let states = vec![[0.0; 2]; intervals + 1];
        slopes_along(system, &Scaling::IDENTITY, tolerance, interval, &states)
    }

    /// Slopes over a period by the classical method of fourth order in very short steps.
    fn by_short_steps(system: &Mathieu) -> SMatrix<f64, 2, 2> {
        let (steps, mut slopes) = (20_000, SMatrix::<f64, 2, 2>::identity());
        let step = std::f64::consts::TAU / f64::from(steps);
        for number in 0..steps {
            let slopes_at = |part: f64| {
                let time = (f64::from(number) + part) * step;
                system.linearisation(time, &[0.0; 2]).0
            };
            let [start, middle, end] = [0.0, 0.5, 1.0].map(slopes_at);
            let first = start * slopes;
            let second = middle * (slopes + first * (0.5 * step));
            let third = middle * (slopes + second * (0.5 * step));
            let fourth = end * (slopes + third * step);
            slopes += (first + second * 2.0 + third * 2.0 + fourth) * (step / 6.0);
        }
        slopes
    }

    #[test]
    fn slopes_of_a_swing_of_varying_stiffness_keep_the_tolerance() {
        let expected = by_short_steps(&SMOOTH);
        for tolerance in [1e-3, 1e-6, 1e-9] {
            let found = found(&SMOOTH, tolerance, 4096).expect("a fine grid");
            let error = (found.slopes - expected).amax();
            println!("{tolerance:e}: {error:e}, {} looks", found.linearisations);
            assert!(error < tolerance, "{tolerance:e}: {error:e}");
        }
    }

    /// Halving the longest steps of all divides the error by 2^6.
    #[test]
    fn the_series_is_of_sixth_order() {
        let expected = by_short_steps(&SMOOTH);
        let error = |steps: usize| {
            let mut along = Along {
                system: &SMOOTH,
                scaling: &Scaling::IDENTITY,
                tolerance: f64::INFINITY,
                interval: std::f64::consts::TAU / (SHORTEST * steps) as f64,
                states: &vec![[0.0; 2]; SHORTEST * steps + 1],
                known: vec![None; SHORTEST * steps + 1],
                slopes: SMatrix::identity(),
            };
            for step in 0..steps {
                along
                    .go(SHORTEST * step, SHORTEST)
                    .expect("any error will do");
            }
            (along.slopes - expected).amax()
        };
        let order = (error(8) / error(16)).log2();
        assert!((order - 6.0).abs() < 0.4, "{order}");
    }

    /// A stiffness that never changes is solved in a single step.
    #[test]
    fn what_does_not_change_takes_a_single_step() {
        let steady = Mathieu {
            depth: 0.0,
            ..SMOOTH
        };
        let found = found(&steady, 1e-9, 64).expect("a smooth motion");
        assert_eq!(found.linearisations, 5);
        assert!((found.slopes - SMatrix::identity()).amax() < 1e-13);
    }

    #[test]
    fn breaks_surfaces_and_coarse_grids_are_refused() {
        assert!(
            found(
                &Mathieu {
                    break_at: 2.0,
                    ..SMOOTH
                },
                1e-6,
                256
            )
            .is_none()
        );
        assert!(
            found(
                &Mathieu {
                    wall_at: 2.0,
                    ..SMOOTH
                },
                1e-6,
                256
            )
            .is_none()
        );
        assert!(found(&SMOOTH, 1e-9, 16).is_none());
        assert!(found(&SMOOTH, 1e-3, 100).is_none());
    }
}
