//! Slopes of a motion by its start over the steps that it takes, where few forces make the remainder.
//!
//! Motions Φ next to one obey its equation with the forces linear about it, Φ′ = (A + D ∂w/∂x) Φ. Over a step the part with K is
//! exact, and the rest follows from the values at the step's points, as for the motion itself, in modal coordinates Z = V⁻¹ Φ:
//!
//! ```text
//! X_i = V_x E_i Z + Σ_j V_x A_ij V⁻¹ D U_j,   U_j = (∂w/∂x(t + c_j h) − K) X_j
//! Z₁  = E Z + Σ_j A_j V⁻¹ D U_j
//! ```
//!
//! All motions share the linear equations for the X_i, as many as the points have states that forces depend on: they are
//! solved at once, without sweeps. Every matrix is kept transposed, so that the numbers of all motions lie side by side.

use nalgebra::{DMatrix, DMatrixView, DVector, DVectorView};

use super::force_operator::{ForceOperator, LATER};
use super::linear::LinearPart;
use super::nodes::{NODES, POINTS, SPARE};
use super::propagator::KEPT;
use super::remainder::FewForces;
use super::sweeps::{LOCAL_PART, Sweeps, Trial, error_factor};
use crate::integrate::chunks::Padded;
use crate::numerics::elimination::solve_equations;

/// The slopes Φ of the state by that at the start of the motion, in the modal coordinates of the linear part.
pub(super) struct StepSlopes {
    /// At the start of the step that is tried, and at its end: Zᵀ, a row for every unit of a state at the start of the motion.
    pub from: DMatrix<f64>,
    pub to: DMatrix<f64>,
    /// What units of all states come to in each modal coordinate.
    units: Vec<f64>,
    kept: Vec<StepOperator>,
}

impl StepSlopes {
    /// At the start of a motion, in units of the states.
    pub fn new(units: &[f64]) -> Self {
        let from = DMatrix::from_diagonal(&units.to_vec().into());
        Self {
            to: from.clone(),
            from,
            units: units.to_vec(),
            kept: Vec::new(),
        }
    }

    /// Goes over to the modal coordinates of another linear part, with the units of the states.
    pub fn change(&mut self, before: &LinearPart, now: &LinearPart, units: &[f64]) {
        self.kept.clear();
        let states = units.len();
        let [shapes, parts] =
            [&before.shapes, &now.parts].map(|matrix| matrix.to_matrix(states, states).transpose());
        self.from = &self.from * shapes * &parts;
        let size = |column: usize| {
            let entries = parts.column(column);
            let squares = entries
                .iter()
                .zip(units)
                .map(|(part, unit)| (part * unit).powi(2));
            squares.sum::<f64>().sqrt()
        };
        self.units = (0..states).map(size).collect();
    }

    /// Φ, by the states at the start as they are.
    pub fn by_states(&self, linear: &LinearPart, units: &[f64]) -> DMatrix<f64> {
        let mut slopes = linear.shapes.to_matrix(units.len(), units.len()) * self.from.transpose();
        for (mut column, unit) in slopes.column_iter_mut().zip(units) {
            column /= *unit;
        }
        slopes
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
        let Some(sources) = operator.sources(trial, &self.from, few, &gains) else {
            return f64::INFINITY;
        };
        let [states, acting] = [self.from.nrows(), few.acting.len()];
        operator.move_freely(&self.from, &mut self.to);
        let by_forces = sources.columns(states, POINTS * acting);
        self.to.gemm(1.0, &by_forces, &operator.end, 1.0);
        self.error(trial, operator, by_forces, sweeps.crossed)
    }

    /// Error of the polynomial at the end of the step, over what is allowed.
    ///
    /// With the Legendre coefficients of the forces falling by the factor θ from each degree to the next, as in the estimate for
    /// the motion, the polynomial of degree n lacks about θ of what Lobatto points one fewer would lack, c_n (P_n − P_{n−2}),
    /// which moves slow modes little. Beside it the quadrature by these points misses the degree 2n, smaller by θ^n than
    /// the highest: for n = 6 that is the third power of what the estimate for the motion has for θ². Where an event surface is
    /// crossed, both factors are 1.
    fn error(
        &self,
        trial: &Trial<'_>,
        operator: &StepOperator,
        by_forces: DMatrixView<'_, f64>,
        crossed: bool,
    ) -> f64 {
        let acting = by_forces.ncols() / POINTS;
        let sum = |weights: &[f64; POINTS]| {
            let mut sum = DMatrix::zeros(by_forces.nrows(), acting);
            for (point, weight) in weights.iter().enumerate() {
                let own = by_forces.columns(acting * point, acting);
                sum.zip_apply(&own, |sum, own| *sum += weight * own);
            }
            sum
        };
        let coefficients = NODES.modes.map(|mode| sum(&mode));
        let factor = match crossed {
            true => 1.0,
            false => error_factor(coefficients.each_ref().map(|sum| operator.size(sum))),
        };
        let [_, _, highest] = coefficients;
        let smooth = factor.sqrt() * self.part(&(highest * &operator.left_out));
        let at_spare = operator.end.rows(acting * SPARE, acting);
        let rough = factor.powi(3) * self.part(&(sum(&NODES.spare) * at_spare));
        smooth.max(rough) / (LOCAL_PART * trial.problem.settings.tolerance)
    }

    /// Root mean square of the change of Φ by an effect, as a part of the units and of Φ itself.
    fn part(&self, effect: &DMatrix<f64>) -> f64 {
        let columns = effect.column_iter().zip(&self.units).enumerate();
        let parts = columns.map(|(column, (effect, unit))| {
            let now = self
                .from
                .column(column)
                .norm()
                .max(self.to.column(column).norm());
            effect.norm_squared() / (unit + now).powi(2)
        });
        (parts.sum::<f64>() / effect.len() as f64).sqrt()
    }
}

/// ∂w/∂x − K at the points of a step, by x in its units, transposed.
fn gains(trial: &Trial<'_>, few: &FewForces, sweeps: &mut Sweeps) -> [DMatrix<f64>; POINTS] {
    let system = trial.problem.system;
    std::array::from_fn(|point| {
        let (time, state) = (trial.time_of(point), sweeps.state_at(trial, point));
        let gain = system.force_slopes(time, state, &few.seen, &few.acting) - &few.slopes;
        let mut gain = gain.transpose();
        for (position, mut row) in few.seen.iter().zip(gain.row_iter_mut()) {
            row *= trial.problem.scaling.scale[*position];
        }
        gain
    })
}

/// What a step of a size makes of Z and of forces at its points, one beside the other, transposed.
struct StepOperator {
    /// s.
    size: f64,
    /// V_x, and V_x E_i and V_x A_ij V⁻¹ D of the points after the first, by x in its units.
    shapes: DMatrix<f64>,
    seen: DMatrix<f64>,
    /// What E makes of each coordinate by itself, and by its partner.
    free: Vec<[f64; 2]>,
    /// A_j V⁻¹ D of the last point.
    end: DMatrix<f64>,
    /// Effect on the end of [`Nodes::left_out`] of each force.
    ///
    /// [`Nodes::left_out`]: super::nodes::Nodes::left_out
    left_out: DMatrix<f64>,
    /// What each force does to the rates of the states, over their units.
    sizes: Vec<f64>,
}

impl StepOperator {
    fn new(trial: &Trial<'_>, few: &FewForces, forces: &ForceOperator) -> Self {
        let scale = &trial.problem.scaling.scale;
        let (states, seen, acting) = (scale.len(), few.seen.len(), few.acting.len());
        let sources = POINTS * acting;
        let mut shapes = few.shapes.to_matrix(seen, states).transpose();
        for (mut column, position) in shapes.column_iter_mut().zip(&few.seen) {
            column /= scale[*position];
        }
        let mut all_seen = DMatrix::zeros(states + sources, LATER * seen);
        // rows by the coordinate that E moves
        let mut moved = DMatrix::zeros(states, states);
        let [mut one, mut to] = [(); 2].map(|()| Padded::zeros(states));
        for point in 1..POINTS {
            for (coordinate, mut moved) in moved.row_iter_mut().enumerate() {
                one.fill(0.0);
                one[coordinate] = 1.0;
                trial.operator.find_free(point, &one, &mut to);
                moved
                    .iter_mut()
                    .zip(&*to)
                    .for_each(|(moved, to)| *moved = *to);
            }
            let mut columns = all_seen.columns_mut(seen * (point - 1), seen);
            columns.rows_mut(0, states).copy_from(&(&moved * &shapes));
            let mut by_forces = forces.seen[point - 1].to_matrix(seen, sources).transpose();
            for (mut column, position) in by_forces.column_iter_mut().zip(&few.seen) {
                column /= scale[*position];
            }
            columns.rows_mut(states, sources).copy_from(&by_forces);
        }
        let end = forces.end.to_matrix(states, sources).transpose();
        let mut left_out = DMatrix::zeros(acting, states);
        for (point, weight) in NODES.left_out.iter().enumerate() {
            left_out += *weight * end.rows(acting * point, acting);
        }
        let parts = few.inputs.to_matrix(states, acting);
        let unit = DVector::from_column_slice(scale);
        let size = |column: DVectorView<'_, f64>| column.component_div(&unit).norm();
        Self {
            size: trial.size,
            free: (0..states)
                .map(|own| match own < 2 * few.pairs {
                    true => [moved[(own, own)], moved[(own ^ 1, own)]],
                    false => [moved[(own, own)], 0.0],
                })
                .collect(),
            shapes,
            seen: all_seen,
            end,
            left_out,
            sizes: parts.column_iter().map(size).collect(),
        }
    }

    /// Size of forces of all motions by what they do to the rates of the states.
    fn size(&self, forces: &DMatrix<f64>) -> f64 {
        let columns = forces.column_iter().zip(&self.sizes);
        let squares = columns.map(|(force, size)| force.norm_squared() * size * size);
        squares.sum::<f64>().sqrt()
    }

    /// E Z.
    fn move_freely(&self, from: &DMatrix<f64>, to: &mut DMatrix<f64>) {
        for (own, [by_itself, by_partner]) in self.free.iter().enumerate() {
            let mut to = to.column_mut(own);
            to.copy_from(&from.column(own));
            to *= *by_itself;
            if *by_partner != 0.0 {
                to.axpy(*by_partner, &from.column(own ^ 1), 1.0);
            }
        }
    }

    /// Z and beside it the U_j of all points, where the linear equations for the X_i have a solution.
    fn sources(
        &self,
        trial: &Trial<'_>,
        from: &DMatrix<f64>,
        few: &FewForces,
        gains: &[DMatrix<f64>; POINTS],
    ) -> Option<DMatrix<f64>> {
        let (states, seen, acting) = (from.nrows(), few.seen.len(), few.acting.len());
        let row = |point: usize| states + acting * point;
        let mut sources = DMatrix::zeros(states, row(POINTS));
        sources.columns_mut(0, states).copy_from(from);
        let first = from * &self.shapes;
        sources
            .columns_mut(states, acting)
            .gemm(1.0, &first, &gains[0], 0.0);
        // X_i − Σ_j V_x A_ij V⁻¹ D (∂w/∂x − K)_j X_j = V_x E_i Z + V_x A_i0 V⁻¹ D U_0
        let count = LATER * seen;
        let mut equations = DMatrix::zeros(count + states, count);
        equations.rows_mut(0, count).fill_diagonal(1.0);
        for (point, gain) in gains.iter().enumerate().skip(1) {
            let mut own = equations.rows_mut(seen * (point - 1), seen);
            own.gemm(-1.0, gain, &self.seen.rows(row(point), acting), 1.0);
        }
        let (known, by_known) = (sources.columns(0, row(1)), self.seen.rows(0, row(1)));
        equations
            .rows_mut(count, states)
            .gemm(1.0, &known, &by_known, 0.0);
        if !solve_equations(trial.linear.level, &mut equations) {
            return None;
        }
        let found = equations.rows(count, states);
        for (point, gain) in gains.iter().enumerate().skip(1) {
            let mut own = sources.columns_mut(row(point), acting);
            own.gemm(1.0, &found.columns(seen * (point - 1), seen), gain, 0.0);
        }
        Some(sources)
    }
}
