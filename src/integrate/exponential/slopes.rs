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

use super::force_operator::{ForceOperator, LATER};
use super::nodes::{NODES, POINTS, SPARE};
use super::propagator::KEPT;
use super::remainder::FewForces;
use super::sweeps::{LOCAL_PART, Sweeps, Trial, error_factor};
use crate::integrate::chunks::Padded;

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
        let Some((few, forces)) = trial.few_forces() else {
            return 0.0;
        };
        let known = self.kept.iter().position(|kept| kept.size == trial.size);
        let position = known.unwrap_or_else(|| {
            self.kept.truncate(KEPT - 1);
            self.kept.insert(0, StepOperator::new(trial, few, forces));
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
            let sum = DMatrix::from_fn(acting, states, |own, column| {
                let points = weights.iter().enumerate();
                let parts =
                    points.map(|(point, weight)| weight * sources[(row(point) + own, column)]);
                parts.sum::<f64>()
            });
            operator.end.columns(row(SPARE), acting) * sum
        };
        let allowed = LOCAL_PART * trial.problem.settings.tolerance;
        let part = |from: f64, to: f64| 1.0 / (1.0 + from.abs().max(to.abs()));
        let inverse = self.from.zip_map(&self.to, part);
        let size = |effect: &DMatrix<f64>| {
            let squares = effect.component_mul(&inverse).norm_squared();
            (squares / effect.len() as f64).sqrt()
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
    fn new(trial: &Trial<'_>, few: &FewForces, forces: &ForceOperator) -> Self {
        let scale = &trial.problem.scaling.scale;
        let (states, seen, sources) = (scale.len(), few.seen.len(), POINTS * few.acting.len());
        let mut shapes = trial.linear.shapes.to_matrix(states, states);
        for (mut row, scale) in shapes.row_iter_mut().zip(scale) {
            row /= *scale;
        }
        let shapes_seen = shapes.select_rows(&few.seen);
        let mut starts = trial.linear.parts.to_matrix(states, states);
        for (mut column, scale) in starts.column_iter_mut().zip(scale) {
            column *= *scale;
        }
        let width = states + sources;
        let mut all_seen = DMatrix::zeros(LATER * seen, width);
        let (mut free, mut to) = (starts.clone(), Padded::zeros(states));
        for point in 1..POINTS {
            for (mut free, start) in free.column_iter_mut().zip(starts.column_iter()) {
                let start = Padded::from_slice(start.as_slice());
                trial.operator.find_free(point, &start, &mut to);
                free.copy_from_slice(&to);
            }
            let mut rows = all_seen.rows_mut(seen * (point - 1), seen);
            rows.columns_mut(0, states)
                .copy_from(&(&shapes_seen * &free));
            let mut by_forces = forces.seen[point - 1].to_matrix(seen, sources);
            for (mut row, position) in by_forces.row_iter_mut().zip(&few.seen) {
                row /= scale[*position];
            }
            rows.columns_mut(states, sources).copy_from(&by_forces);
        }
        // of the last point, the end
        let mut modal = free.resize_horizontally(width, 0.0);
        modal
            .columns_mut(states, sources)
            .copy_from(&forces.end.to_matrix(states, sources));
        Self {
            size: trial.size,
            seen: all_seen,
            end: &shapes * modal,
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
