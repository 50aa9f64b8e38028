//! The nonlinear remainder at a state, in modal coordinates.
//!
//! Of a system by its whole derivative:
//!
//! ```text
//! y = V z,   V⁻¹ g = V⁻¹ f(t, y₀ + y) − Λ z
//! ```
//!
//! and of one whose derivative is separated, f = c + A y + D w(t, y) with J = A + D K, by the few states x that w depends on
//! and its few forces, whatever the number of modes:
//!
//! ```text
//! x = V_x z,   V⁻¹ g = V⁻¹ (c + A y₀) + V⁻¹ D (w(t, x₀ + x) − K x)
//! ```
//!
//! with V_x the rows of V for x. A change δz of a motion so changes the remainder by `V⁻¹ D (∂w/∂x − K) V_x δz`.

use fearless_simd::Level;
use nalgebra::{DMatrix, DVector};

use super::basis::Basis;
use super::linear::LinearPart;
use super::matrix::ChunkMatrix;
use crate::integrate::chunks::Padded;
use crate::integrate::problem::Problem;
use crate::integrate::{Separated, System};
use crate::numerics::registers::in_wide_registers;

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
    /// V⁻¹ D.
    pub parts: ChunkMatrix,
    /// V⁻¹ (c + A y₀).
    constant: Padded,
}

impl FewForces {
    /// About an origin y₀, with the modes of A + D K as basis.
    pub fn new(separated: &Separated, basis: &Basis, origin: &[f64]) -> Self {
        let from = DVector::from_column_slice(origin);
        let rate = &separated.matrix * from + DVector::from_column_slice(&separated.constant);
        let product = |matrix: &DMatrix<f64>| ChunkMatrix::from_matrix(&(&basis.parts * matrix));
        Self {
            shapes: ChunkMatrix::from_matrix(&basis.shapes.select_rows(&separated.seen)),
            against: ChunkMatrix::from_matrix(&-&separated.slopes),
            parts: product(&separated.inputs),
            constant: Padded::from_slice((&basis.parts * rate).as_slice()),
            seen: separated.seen.clone(),
            acting: separated.acting.clone(),
            slopes: separated.slopes.clone(),
        }
    }

    /// Finds x₀ + x among the states.
    fn find_state(&self, origin: &Padded, deviation: &Padded, state: &mut Padded) {
        for (position, deviation) in self.seen.iter().zip(&**deviation) {
            state[*position] = origin[*position] + deviation;
        }
    }
}

/// An evaluation of the remainder.
#[derive(Debug, Clone)]
pub(super) struct Evaluation {
    /// The scaling's origin y₀.
    origin: Padded,
    /// y₀ + y, or of it what the forces depend on, and f or w there.
    pub state: Padded,
    rate: Padded,
    /// w − K x.
    forces: Padded,
    /// The modal coordinates of g that were found.
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
            forces: zeros.clone(),
            remainder: zeros,
        }
    }

    /// Finds the remainder at modal coordinates, and the deviation there: all of y, or x alone. What J would do to y₀ itself
    /// stays in g.
    #[inline(always)]
    pub fn evaluate(
        &mut self,
        linear: &LinearPart,
        system: &dyn System,
        time: f64,
        coordinates: &Padded,
        deviation: &mut Padded,
    ) {
        if let Some(few) = &linear.few_forces {
            let level = linear.level;
            return self.evaluate_few(level, few, system, time, coordinates, deviation);
        }
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

    /// Evaluates few forces. Out of line, so that the loop over the points stays short where there are none.
    #[inline(never)]
    fn evaluate_few(
        &mut self,
        level: Level,
        few: &FewForces,
        system: &dyn System,
        time: f64,
        coordinates: &Padded,
        deviation: &mut Padded,
    ) {
        // x = V_x z
        let shapes = &few.shapes;
        in_wide_registers!(
            level,
            shapes.multiply::<false>(coordinates, deviation.chunks_mut())
        );
        few.find_state(&self.origin, deviation, &mut self.state);
        system.forces(time, &self.state, &mut self.rate);
        for (force, acting) in self.forces.iter_mut().zip(&few.acting) {
            *force = self.rate[*acting];
        }
        in_wide_registers!(level, {
            // w − K x
            few.against
                .multiply::<true>(deviation, self.forces.chunks_mut());
            // V⁻¹ (c + A y₀) + V⁻¹ D (w − K x)
            self.remainder.copy_from(&few.constant);
            few.parts
                .multiply::<true>(&self.forces, self.remainder.chunks_mut());
        });
    }

    /// Finds the state at a deviation that [`Evaluation::evaluate`] found, as far as forces and event functions depend on it.
    pub fn find_state(&mut self, linear: &LinearPart, problem: &Problem<'_>, deviation: &Padded) {
        match &linear.few_forces {
            Some(few) => few.find_state(&self.origin, deviation, &mut self.state),
            None => problem.write_state(deviation, &mut self.state),
        }
    }
}
