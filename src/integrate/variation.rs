//! How the end of a motion depends on its start: the variational equations.

use std::cell::RefCell;
use std::sync::atomic::AtomicBool;

use nalgebra::DMatrix;

use super::explicit::ExplicitStepper;
use super::problem::Problem;
use super::{Counters, IntegrateError, Scaling, Settings, System};

/// Distance of a break from either end of the motion, as a part of its duration, below which it counts
/// as standing there.
const BREAK_SLACK: f64 = 1e-9;

/// The end of a motion and its slopes by the start.
#[derive(Debug, Clone, PartialEq)]
pub struct Variation {
    /// State at the end.
    pub end: Vec<f64>,
    /// `∂(end)/∂(start)`, rows by component of the end.
    pub slopes: DMatrix<f64>,
    /// Work done.
    pub counters: Counters,
}

/// A system with the slopes of its states by the start beside them: the state first, then Φ column by
/// column.
struct Augmented<'a> {
    system: &'a dyn System,
    /// Room for `∂f/∂y` and `∂f/∂t`.
    slopes: RefCell<(DMatrix<f64>, Vec<f64>)>,
}

impl System for Augmented<'_> {
    fn states(&self) -> usize {
        let states = self.system.states();
        states + states * states
    }

    fn derivative(&self, time: f64, all: &[f64], rate: &mut [f64]) {
        let states = self.system.states();
        let (state, columns) = all.split_at(states);
        let (own, rates) = rate.split_at_mut(states);
        self.system.derivative(time, state, own);
        let (jacobian, by_time) = &mut *self.slopes.borrow_mut();
        self.system.linearisation(time, state, jacobian, by_time);
        rates.fill(0.0);
        let columns = columns.chunks_exact(states);
        for (rates, column) in rates.chunks_exact_mut(states).zip(columns) {
            let slopes = jacobian.as_slice().chunks_exact(states);
            for (slopes, value) in slopes.zip(column) {
                for (rate, slope) in rates.iter_mut().zip(slopes) {
                    *rate += slope * value;
                }
            }
        }
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
/// Both are kept to the tolerance of `settings` by Verner's pair 7(6), whatever method they name.
///
/// # Errors
/// [`IntegrateError`] where the integration cannot go on.
pub fn variation(
    system: &dyn System,
    scaling: &Scaling,
    settings: &Settings,
    stop: &AtomicBool,
    duration: f64,
    start: &[f64],
) -> Result<Variation, IntegrateError> {
    let states = system.states();
    let augmented = Augmented {
        system,
        slopes: RefCell::new((DMatrix::zeros(states, states), vec![0.0; states])),
    };
    let scaling = augmented_scaling(scaling);
    let problem = Problem {
        system: &augmented,
        scaling: &scaling,
        settings,
        stop,
        end: duration,
        slack: BREAK_SLACK * duration,
    };
    let own = start.iter().zip(&scaling.origin);
    let mut deviation: Vec<f64> = own.map(|(state, origin)| state - origin).collect();
    deviation.extend_from_slice(DMatrix::<f64>::identity(states, states).as_slice());
    let mut stepper = ExplicitStepper::new(&problem, 0.0, &deviation, 0.0, Counters::default());
    let mut end = deviation;
    stepper.state_at(&problem, duration, &mut end)?;
    Ok(Variation {
        slopes: DMatrix::from_column_slice(states, states, &end[states..]),
        end: end[..states].to_vec(),
        counters: stepper.counters(),
    })
}

/// Units of the state, and of its slopes as they follow from them.
fn augmented_scaling(scaling: &Scaling) -> Scaling {
    let Scaling {
        origin,
        scale,
        time,
    } = scaling;
    let slopes = scale
        .iter()
        .flat_map(|column| scale.iter().map(move |row| row / column));
    let states = scale.len();
    let mut all_origins = origin.clone();
    all_origins.resize(states + states * states, 0.0);
    Scaling {
        origin: all_origins,
        scale: scale.iter().copied().chain(slopes).collect(),
        time: *time,
    }
}
