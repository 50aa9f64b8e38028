//! How the end of a motion depends on its start: the variational equations.

use std::cell::RefCell;
use std::sync::atomic::AtomicBool;

use fearless_simd::Level;
use nalgebra::DMatrix;

use super::exponential::ExponentialStepper;
use super::problem::Problem;
use super::stepper::{MethodStepper, Start};
use super::{
    Counters, Grid, IntegrateError, Integration, Method, Prepared, Scaling, Settings, States,
    System,
};
use crate::numerics::panels::Panels;
use crate::numerics::registers::in_wide_registers;

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

/// A system with the slopes of its states by the start next to them: the state first, then Φ column by
/// column.
struct Augmented<'a> {
    system: &'a dyn System,
    /// Units of the states.
    scale: &'a [f64],
    /// Vector instructions of the processor.
    level: Level,
    /// Room for `∂f/∂y`, also in panels.
    slopes: RefCell<(DMatrix<f64>, Panels)>,
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
        let (jacobian, panels) = &mut *self.slopes.borrow_mut();
        self.system.linearisation(time, state, jacobian);
        // Φ̇ = ∂f/∂y Φ, column by column
        panels.set(jacobian, states);
        rates.fill(0.0);
        in_wide_registers!(self.level, {
            let pairs = rates.chunks_exact_mut(states);
            for (rates, column) in pairs.zip(columns.chunks_exact(states)) {
                panels.add_product(1.0, column, rates);
            }
        });
    }

    fn next_break(&self, after: f64) -> f64 {
        self.system.next_break(after)
    }

    fn event_count(&self) -> usize {
        self.system.event_count()
    }

    fn events(&self, time: f64, all: &[f64], values: &mut [f64]) {
        self.system
            .events(time, &all[..self.system.states()], values);
    }

    fn event(&self, event: usize, time: f64, all: &[f64]) -> f64 {
        let own = &all[..self.system.states()];
        self.system.event(event, time, own)
    }

    /// A force F that grows with the power n of the distance δ has the stiffness n F/δ; neighbouring motions are a unit
    /// of each component apart at the start.
    fn force_jump(&self, event: usize, time: f64, distance: f64, rate: &mut [f64]) {
        let (own, slopes) = rate.split_at_mut(self.system.states());
        self.system.force_jump(event, time, distance, own);
        let exponent = self.system.event_exponent(event);
        let length = self.scale[..own.len() / 2]
            .iter()
            .copied()
            .fold(0.0, f64::max);
        let columns = slopes.chunks_exact_mut(own.len());
        for (column, scale) in columns.zip(self.scale) {
            for (slope, force) in column.iter_mut().zip(&*own) {
                *slope = exponent * force / distance * length / scale;
            }
        }
    }

    /// Power of the states; that of their slopes is one less, and as whole or broken.
    fn event_exponent(&self, event: usize) -> f64 {
        self.system.event_exponent(event)
    }
}

/// Integrates a motion from time 0 together with its slopes by the start:
///
/// ```text
/// ẏ = f(t, y),   Φ̇ = ∂f/∂y(t, y) Φ,   Φ(0) = 1
/// ```
///
/// Both are kept to the tolerance of `settings`, whatever method they name: where few forces make what is not linear, by
/// exponential steps, which go on with what another motion has `prepared`, else by Verner's pair 7(6).
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
    prepared: &mut Option<Prepared>,
) -> Result<Variation, IntegrateError> {
    if system.separated(0.0, start).is_some() {
        let problem = Problem {
            system,
            scaling: scaling.clone(),
            settings: *settings,
            stop,
            progress: None,
            interval: duration,
            end: duration,
        };
        if let Some(found) = few_forces_variation(&problem, start, prepared)? {
            return Ok(found);
        }
    }
    let states = system.states();
    let augmented = Augmented {
        system,
        scale: &scaling.scale,
        level: Level::new(),
        slopes: RefCell::new((DMatrix::zeros(states, states), Panels::default())),
    };
    let grid = Grid {
        interval: duration,
        count: 2,
    };
    let settings = Settings {
        method: Method::Verner76,
        ..*settings
    };
    let mut start = start.to_vec();
    start.extend_from_slice(DMatrix::<f64>::identity(states, states).as_slice());
    let units = augmented_scaling(scaling);
    let mut integration = Integration::new(&augmented, units, grid, settings, stop, &start);
    let mut ends = States::with_capacity(start.len(), 2);
    integration.advance(2, &mut ends)?;
    let (end, slopes) = ends.as_slice()[start.len()..].split_at(states);
    Ok(Variation {
        end: end.to_vec(),
        slopes: DMatrix::from_column_slice(states, states, slopes),
        counters: integration.counters(),
    })
}

/// A motion with its slopes by exponential steps; none where the remainder of its equation is not one of few forces.
fn few_forces_variation(
    problem: &Problem<'_>,
    start: &[f64],
    prepared: &mut Option<Prepared>,
) -> Result<Option<Variation>, IntegrateError> {
    let from = start.iter().zip(&problem.scaling.origin);
    let from = Start {
        time: 0.0,
        deviation: from.map(|(state, origin)| state - origin).collect(),
        counters: Counters::default(),
    };
    let mut stepper = ExponentialStepper::with_slopes(problem, &from);
    let mut going_on = prepared.take().unwrap_or_else(|| Prepared::nothing(&from));
    if let Some(steps) = going_on.steps.take() {
        stepper.take_over(steps, problem);
    }
    while stepper.reached().time < problem.end {
        stepper.step(problem)?;
        if !stepper.has_slopes() {
            return Ok(None);
        }
    }
    let mut end = start.to_vec();
    problem.write_state(stepper.reached().deviation, &mut end);
    let (slopes, counters) = (stepper.slopes(problem), stepper.reached().counters);
    going_on.steps = Box::new(stepper).into_prepared();
    *prepared = Some(going_on);
    Ok(slopes.map(|slopes| Variation {
        end,
        slopes,
        counters,
    }))
}

/// Slopes of states by states from those of numbers in units of the states.
fn in_units(mut slopes: DMatrix<f64>, scale: &[f64]) -> DMatrix<f64> {
    for (column, mut entries) in slopes.column_iter_mut().enumerate() {
        for (row, entry) in entries.iter_mut().enumerate() {
            *entry *= scale[row] / scale[column];
        }
    }
    slopes
}

/// Slopes `∂(end)/∂(start)` over a duration of a system that is linear in its states, with the same slopes at all times:
///
/// ```text
/// Φ = exp(A T),   A = ∂f/∂y
/// ```
///
/// by scaling and squaring.
///
/// Source: N. J. Higham, *SIAM J. Matrix Anal. Appl.* 26 (2005) 1179–1193.
pub fn linear_variation(system: &dyn System, scaling: &Scaling, duration: f64) -> DMatrix<f64> {
    let states = system.states();
    let mut slopes = DMatrix::zeros(states, states);
    system.linearisation(0.0, &scaling.origin, &mut slopes);
    scaling.scale_jacobian(&mut slopes);
    in_units((slopes * duration).exp(), &scaling.scale)
}

/// Units of the state, and of its slopes as they follow from them.
fn augmented_scaling(scaling: &Scaling) -> Scaling {
    let scale = &scaling.scale;
    let slopes = scale
        .iter()
        .flat_map(|column| scale.iter().map(move |row| row / column));
    let states = scale.len();
    let mut origin = scaling.origin.clone();
    origin.resize(states + states * states, 0.0);
    Scaling {
        origin,
        scale: scale.iter().copied().chain(slopes).collect(),
        time: scaling.time,
    }
}
