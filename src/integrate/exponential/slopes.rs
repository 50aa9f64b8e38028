//! Slopes of a motion by its start over the steps that it takes, where few forces make the remainder.
//!
//! Motions Φ next to one obey its equation with the forces linear about it, Φ′ = (A + D ∂w/∂x) Φ. Over a step the part with K is
//! exact, and the rest follows from the values at the step's points, as for the motion itself:
//!
//! ```text
//! X_i = V_x E_i V⁻¹ Φ + Σ_j V_x A_ij V⁻¹ D U_j,   U_j = (∂w/∂x(t + c_j h) − K) X_j
//! Φ₁  = V E V⁻¹ Φ + Σ_j V A_j V⁻¹ D U_j
//! ```
//!
//! All motions share the linear equations for the X_i, as many as the points have states that forces depend on: they are
//! solved at once, without sweeps.

use nalgebra::DMatrix;

use super::nodes::{NODES, POINTS, SPARE, no_points};
use super::remainder::FewForces;
use super::sweeps::{LOCAL_PART, Sweeps, Trial, error_factor};
use crate::integrate::chunks::Padded;

/// Sizes of steps whose operators are kept.
const KEPT: usize = 12;
/// Points after the first.
const LATER: usize = POINTS - 1;

/// The slopes Φ of the state by that at the start of the motion, in units of the states.
pub(super) struct StepSlopes {
    /// At the start of the step that is tried, and at its end.
    pub from: DMatrix<f64>,
    pub to: DMatrix<f64>,
    kept: Vec<StepOperator>,
}

impl StepSlopes {
    /// At the start of a motion of so many states.
    pub fn new(states: usize) -> Self {
        let unity = DMatrix::identity(states, states);
        Self {
            from: unity.clone(),
            to: unity,
            kept: Vec::new(),
        }
    }

    /// Forgets the operators: the linear part is another.
    pub fn clear(&mut self) {
        self.kept.clear();
    }

    /// Takes Φ over a step whose sweeps have converged; the error over what is allowed, none where there are no few
    /// forces.
    pub fn step(&mut self, trial: &Trial<'_>, sweeps: &mut Sweeps) -> f64 {
        let Some(few) = &trial.linear.few_forces else {
            return 0.0;
        };
        let known = self.kept.iter().position(|kept| kept.size == trial.size);
        let position = known.unwrap_or_else(|| {
            self.kept.truncate(KEPT - 1);
            self.kept.insert(0, StepOperator::new(trial, few));
            0
        });
        let operator = &self.kept[position];
        let gains = gains(trial, few, sweeps);
        let Some(sources) = operator.sources(&self.from, few, &gains) else {
            return f64::INFINITY;
        };
        self.to = &operator.end * &sources;
        self.error(trial, operator, &sources, sweeps.crossed)
    }

    /// Error of the polynomial over what is allowed, as that of a motion: what its highest power does to the end of the step.
    fn error(
        &self,
        trial: &Trial<'_>,
        operator: &StepOperator,
        sources: &DMatrix<f64>,
        crossed: bool,
    ) -> f64 {
        let states = self.from.nrows();
        let acting = (sources.nrows() - states) / POINTS;
        let row = |point: usize| states + acting * point;
        let effect = |weights: &[f64; POINTS]| {
            let mut sum = DMatrix::zeros(acting, states);
            for (point, weight) in weights.iter().enumerate() {
                sum += sources.rows(row(point), acting) * *weight;
            }
            operator.end.columns(row(SPARE), acting) * sum
        };
        let allowed = LOCAL_PART * trial.problem.settings.tolerance;
        let size = |effect: &DMatrix<f64>| {
            let ends = effect.iter().zip(self.from.iter().zip(&self.to));
            let parts = ends.map(|(effect, (from, to))| effect / (1.0 + from.abs().max(to.abs())));
            (parts.map(|part| part * part).sum::<f64>() / effect.len() as f64).sqrt()
        };
        let factor = match crossed {
            true => 1.0,
            false => error_factor(NODES.modes.map(|mode| size(&effect(&mode)))),
        };
        factor * size(&effect(&NODES.spare)) / allowed
    }
}

/// ∂w/∂x − K at the points of a step, by x in its units.
fn gains(trial: &Trial<'_>, few: &FewForces, sweeps: &mut Sweeps) -> [DMatrix<f64>; POINTS] {
    let system = trial.problem.system;
    std::array::from_fn(|point| {
        let (time, state) = (trial.time_of(point), sweeps.state_at(trial, point));
        let mut gain = system.force_slopes(time, state, &few.seen, &few.acting) - &few.slopes;
        for (position, mut column) in few.seen.iter().zip(gain.column_iter_mut()) {
            column *= trial.problem.scaling.scale[*position];
        }
        gain
    })
}

/// What a step of a size makes of Φ and of forces at its points, one below the other, in units of the states.
struct StepOperator {
    /// s.
    size: f64,
    /// V_x E_i V⁻¹ and V_x A_ij V⁻¹ D of the points after the first, one below the other.
    seen: DMatrix<f64>,
    /// V E V⁻¹ and V A_j V⁻¹ D of the last point.
    end: DMatrix<f64>,
}

impl StepOperator {
    fn new(trial: &Trial<'_>, few: &FewForces) -> Self {
        let scale = &trial.problem.scaling.scale;
        let (states, seen, acting) = (scale.len(), few.seen.len(), few.acting.len());
        let mut shapes = trial.linear.shapes.to_matrix(states);
        for (mut row, scale) in shapes.row_iter_mut().zip(scale) {
            row /= *scale;
        }
        let shapes_seen = shapes.select_rows(&few.seen);
        // V⁻¹ and V⁻¹ D
        let mut starts = trial.linear.parts.to_matrix(states);
        for (mut column, scale) in starts.column_iter_mut().zip(scale) {
            column *= *scale;
        }
        let [starts, forces] = [starts, few.parts.to_matrix(states)].map(|matrix| padded(&matrix));
        let width = states + POINTS * acting;
        let (mut all_seen, mut end) = (DMatrix::zeros(LATER * seen, width), shapes.clone());
        let (mut to, none) = (Padded::zeros(states), no_points(states));
        for point in 1..POINTS {
            let mut modal = DMatrix::zeros(states, width);
            for (column, from) in starts.iter().enumerate() {
                trial.operator.find_coordinates(point, from, &none, &mut to);
                modal.column_mut(column).copy_from_slice(&to);
            }
            for (own, force) in forces.iter().enumerate() {
                for source in 0..POINTS {
                    trial.operator.find_effect(point, source, force, &mut to);
                    let column = states + acting * source + own;
                    modal.column_mut(column).copy_from_slice(&to);
                }
            }
            let mut rows = all_seen.rows_mut(seen * (point - 1), seen);
            rows.copy_from(&(&shapes_seen * &modal));
            if point == LATER {
                end = &shapes * modal;
            }
        }
        Self {
            size: trial.size,
            seen: all_seen,
            end,
        }
    }

    /// Φ and below it the U_j of all points, where the linear equations for the X_i have a solution.
    fn sources(
        &self,
        from: &DMatrix<f64>,
        few: &FewForces,
        gains: &[DMatrix<f64>; POINTS],
    ) -> Option<DMatrix<f64>> {
        let (states, seen, acting) = (from.nrows(), few.seen.len(), few.acting.len());
        let row = |point: usize| states + acting * point;
        let mut sources = DMatrix::zeros(row(POINTS), states);
        sources.rows_mut(0, states).copy_from(from);
        let first = &gains[0] * from.select_rows(&few.seen);
        sources.rows_mut(states, acting).copy_from(&first);
        // X_i − Σ_j V_x A_ij V⁻¹ D (∂w/∂x − K)_j X_j = V_x E_i V⁻¹ Φ + V_x A_i0 V⁻¹ D U_0
        let known = self.seen.columns(0, row(1)) * sources.rows(0, row(1));
        let mut matrix = DMatrix::identity(LATER * seen, LATER * seen);
        for (point, gain) in gains.iter().enumerate().skip(1) {
            let mut columns = matrix.columns_mut(seen * (point - 1), seen);
            columns -= self.seen.columns(row(point), acting) * gain;
        }
        let found = matrix.lu().solve(&known)?;
        for (point, gain) in gains.iter().enumerate().skip(1) {
            let own = gain * found.rows(seen * (point - 1), seen);
            sources.rows_mut(row(point), acting).copy_from(&own);
        }
        Some(sources)
    }
}

/// The columns of a matrix.
fn padded(matrix: &DMatrix<f64>) -> Vec<Padded> {
    let columns = matrix.as_slice().chunks_exact(matrix.nrows());
    columns.map(Padded::from_slice).collect()
}
