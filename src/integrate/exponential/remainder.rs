//! The nonlinear remainder at a state.
//!
//! Of a system by its whole derivative it is found in modal coordinates:
//!
//! ```text
//! y = V z,   V⁻¹ g = V⁻¹ f(t, y₀ + y) − Λ z
//! ```
//!
//! and of one whose derivative is separated, f = c + A y + D w(t, y) with J = A + D K, by its few forces u at the few states
//! x that w depends on, whatever the number of modes:
//!
//! ```text
//! x = V_x z,   u = w(t, x₀ + x) − K x,   V⁻¹ g = V⁻¹ (c + A y₀) + V⁻¹ D u
//! ```
//!
//! with V_x the rows of V for x.

use nalgebra::{DMatrix, DVector};

use super::basis::Basis;
use super::linear::LinearPart;
use super::matrix::ChunkMatrix;
use super::nodes::{POINTS, Points};
use crate::integrate::chunks::{Padded, add_scaled, chunks_of};
use crate::integrate::problem::Problem;
use crate::integrate::{Separated, System};

/// The remainder of a separated derivative, by its forces.
#[derive(Debug, Clone)]
pub(super) struct FewForces {
    /// Positions of x among the states, and of w among the forces that the system writes.
    pub seen: Vec<usize>,
    pub acting: Vec<usize>,
    /// K.
    pub slopes: DMatrix<f64>,
    /// V_x.
    pub shapes: ChunkMatrix,
    /// −K.
    against: ChunkMatrix,
    /// D and V⁻¹ D.
    pub inputs: ChunkMatrix,
    pub parts: ChunkMatrix,
    /// V_x F V⁻¹ D, column after column in chunks, of a function F of the linear part by the numbers of it that
    /// [`Propagator::find_function`] finds.
    ///
    /// [`Propagator::find_function`]: super::propagator::Propagator::find_function
    pub transfer: ChunkMatrix,
    /// Pairs of conjugate modes.
    pub pairs: usize,
    /// V⁻¹ (c + A y₀).
    pub constant: Padded,
}

impl FewForces {
    /// About an origin y₀, with the modes of A + D K as basis.
    pub fn new(separated: &Separated, basis: &Basis, origin: &[f64]) -> Self {
        let from = DVector::from_column_slice(origin);
        let rate = &separated.matrix * from + DVector::from_column_slice(&separated.constant);
        let shapes = basis.shapes.select_rows(&separated.seen);
        let parts = &basis.parts * &separated.inputs;
        Self {
            transfer: transfer(basis, &shapes, &parts),
            pairs: basis.eigenvalues.iter().filter(|of| of.im > 0.0).count(),
            shapes: ChunkMatrix::from_matrix(&shapes),
            against: ChunkMatrix::from_matrix(&-&separated.slopes),
            inputs: ChunkMatrix::from_matrix(&separated.inputs),
            parts: ChunkMatrix::from_matrix(&parts),
            constant: Padded::from_slice((&basis.parts * rate).as_slice()),
            seen: separated.seen.clone(),
            acting: separated.acting.clone(),
            slopes: separated.slopes.clone(),
        }
    }

    /// Finds the modal coordinates of the remainder that the forces at the points of a step make.
    #[inline(always)]
    pub fn find_modal(&self, forces: &Points, modal: &mut Points) {
        for (modal, constant) in modal.iter_mut().zip(self.constant.chunks()) {
            *modal = [*constant; POINTS];
        }
        for (force, own) in (0..self.acting.len()).map(|force| (force, &forces[force / 4])) {
            let parts = self.parts.column(force);
            for (modal, part) in modal.iter_mut().zip(parts) {
                for (modal, own) in modal.iter_mut().zip(own) {
                    add_scaled(modal, own[force % 4], part);
                }
            }
        }
    }

    /// Finds x₀ + x among the states.
    fn find_state(&self, origin: &Padded, deviation: &Padded, state: &mut Padded) {
        for (position, deviation) in self.seen.iter().zip(&**deviation) {
            state[*position] = origin[*position] + deviation;
        }
    }
}

/// [`FewForces::transfer`]: of a pair of coordinates x and x', which a function a + i b makes a x + b x' and a x' − b x, the
/// columns for a and b; of a coordinate by itself that for a.
fn transfer(basis: &Basis, shapes: &DMatrix<f64>, parts: &DMatrix<f64>) -> ChunkMatrix {
    let (states, forces, rows) = (basis.eigenvalues.len(), parts.ncols(), shapes.nrows());
    let padded = 4 * chunks_of(rows);
    let mut transfer = DMatrix::zeros(padded * forces, states);
    for (coordinate, eigenvalue) in basis.eigenvalues.iter().enumerate() {
        let product = |own: usize, other: usize| shapes.column(own) * parts.row(other);
        let through = if eigenvalue.im > 0.0 {
            let partner = coordinate + 1;
            product(coordinate, coordinate) + product(partner, partner)
        } else if eigenvalue.im < 0.0 {
            let partner = coordinate - 1;
            product(partner, coordinate) - product(coordinate, partner)
        } else {
            product(coordinate, coordinate)
        };
        for (force, column) in through.column_iter().enumerate() {
            let mut entries = transfer.view_mut((padded * force, coordinate), (rows, 1));
            entries.copy_from(&column);
        }
    }
    ChunkMatrix::from_matrix(&transfer)
}

/// An evaluation of the remainder.
#[derive(Debug, Clone)]
pub(super) struct Evaluation {
    /// The scaling's origin y₀.
    origin: Padded,
    /// y₀ + y, or of it what the forces depend on, and f or w there.
    pub state: Padded,
    rate: Padded,
    /// What was found: the modal coordinates of g, or u.
    pub remainder: Padded,
}

impl Evaluation {
    /// Room for those of a problem.
    pub fn new(problem: &Problem<'_>) -> Self {
        let zeros = Padded::zeros(problem.system.states());
        Self {
            origin: Padded::from_slice(&problem.scaling.origin),
            state: zeros.clone(),
            rate: zeros.clone(),
            remainder: zeros,
        }
    }

    /// Finds the modal coordinates of the remainder at those of a state, and its deviation, within code for wide registers.
    /// What J would do to y₀ itself stays in g.
    #[inline(always)]
    pub fn evaluate(
        &mut self,
        linear: &LinearPart,
        system: &dyn System,
        time: f64,
        coordinates: &Padded,
        deviation: &mut Padded,
    ) {
        // V⁻¹ f(t, y₀ + V z) − Λ z
        linear.find_deviation(coordinates, deviation);
        let parts = self.origin.chunks().iter().zip(deviation.chunks());
        for (state, (origin, deviation)) in self.state.chunks_mut().iter_mut().zip(parts) {
            for i in 0..4 {
                state[i] = origin[i] + deviation[i];
            }
        }
        system.derivative(time, &self.state, &mut self.rate);
        linear.find_remainder(&self.rate, coordinates, &mut self.remainder);
    }

    /// Finds the forces of the remainder, u, at the few states x that they depend on, within code for wide registers.
    #[inline(always)]
    pub fn evaluate_forces(
        &mut self,
        few: &FewForces,
        system: &dyn System,
        time: f64,
        seen: &Padded,
    ) {
        few.find_state(&self.origin, seen, &mut self.state);
        system.forces(time, &self.state, &mut self.rate);
        for (force, acting) in self.remainder.iter_mut().zip(&few.acting) {
            *force = self.rate[*acting];
        }
        // w − K x
        few.against
            .multiply::<true>(seen, self.remainder.chunks_mut());
    }

    /// Finds the state at a deviation that [`Evaluation::evaluate`] found, as far as forces and event functions depend on it.
    pub fn find_state(&mut self, linear: &LinearPart, problem: &Problem<'_>, deviation: &Padded) {
        match &linear.few_forces {
            Some(few) => few.find_state(&self.origin, deviation, &mut self.state),
            None => problem.write_state(deviation, &mut self.state),
        }
    }
}
