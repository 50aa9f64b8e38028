//! How the end of a motion depends on its start: the variational equations.

use std::sync::atomic::AtomicBool;

use nalgebra::SMatrix;

use super::course::Course;
use super::explicit::{Verner76, Walk};
use super::{Counters, IntegrateError, Linearised, Scaling, Settings, System};

/// Distance of a break from either end of the motion, as a part of its duration, below which it counts
/// as standing there.
const BREAK_SLACK: f64 = 1e-9;

/// The end of a motion and its slopes by the start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Variation<const N: usize> {
    /// State at the end.
    pub end: [f64; N],
    /// `∂(end)/∂(start)`, rows by component of the end.
    pub slopes: SMatrix<f64, N, N>,
    /// Work done.
    pub counters: Counters,
}

/// A system of N states with their slopes by the start beside them: the state first, then Φ column by
/// column.
struct Augmented<'a, S, const N: usize> {
    system: &'a S,
}

impl<S, const N: usize, const A: usize> System<A> for Augmented<'_, S, N>
where
    S: Linearised<N>,
{
    fn derivative(&self, time: f64, all: &[f64; A], rate: &mut [f64; A]) {
        let system = self.system;
        let (state, slopes) = all.split_at(N);
        let state: [f64; N] = std::array::from_fn(|i| state[i]);
        let mut own = [0.0; N];
        system.derivative(time, &state, &mut own);
        let (jacobian, _) = system.linearisation(time, &state);
        let product = jacobian * SMatrix::<f64, N, N>::from_column_slice(slopes);
        rate[..N].copy_from_slice(&own);
        rate[N..].copy_from_slice(product.as_slice());
    }

    fn next_break(&self, after: f64) -> f64 {
        self.system.next_break(after)
    }
}

/// Integrates a motion from time 0 together with its slopes by the start:
///
/// ```text
/// ẏ = f(t, y),   Φ̇ = ∂f/∂y(t, y) Φ,   Φ(0) = 1
/// ```
///
/// Both are kept to the tolerance of `settings` by Verner's pair 7(6), whatever method they name; `A` must be
/// `N + N²`.
///
/// # Errors
/// [`IntegrateError`] where the integration cannot go on.
pub fn variation<S, const N: usize, const A: usize>(
    system: &S,
    scaling: &Scaling<N>,
    settings: &Settings,
    stop: &AtomicBool,
    duration: f64,
    start: &[f64; N],
) -> Result<Variation<N>, IntegrateError>
where
    S: Linearised<N>,
{
    const { assert!(A == N + N * N, "the state and its slopes by the start") };
    let augmented = Augmented::<S, N> { system };
    let scaling = augmented_scaling::<N, A>(scaling);
    let course = Course {
        system: &augmented,
        scaling: &scaling,
        settings,
        stop,
        end: duration,
        slack: BREAK_SLACK * duration,
    };
    let deviation = std::array::from_fn(|i| match i {
        i if i < N => start[i] - scaling.origin[i],
        i => f64::from(u8::from((i - N).is_multiple_of(N + 1))),
    });
    let mut walk = Walk::new(0.0, deviation, 0.0, Counters::default());
    let end = walk.state_at::<Verner76, _>(&course, duration)?;
    Ok(Variation {
        end: std::array::from_fn(|i| end[i]),
        slopes: SMatrix::from_column_slice(&end[N..]),
        counters: walk.counters(),
    })
}

/// Units of the state, and of its slopes as they follow from them.
fn augmented_scaling<const N: usize, const A: usize>(scaling: &Scaling<N>) -> Scaling<A> {
    let row_and_column = |i: usize| ((i - N) % N, (i - N) / N);
    Scaling {
        origin: std::array::from_fn(|i| if i < N { scaling.origin[i] } else { 0.0 }),
        scale: std::array::from_fn(|i| {
            if i < N {
                return scaling.scale[i];
            }
            let (row, column) = row_and_column(i);
            scaling.scale[row] / scaling.scale[column]
        }),
        time: scaling.time,
    }
}
