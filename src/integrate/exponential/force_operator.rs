//! What few forces at the points of a step do, whatever the number of modes.
//!
//! ```text
//! x_i = V_x (E_i z + c_i) + Σ_j B_ij u_j     B_ij = V_x A_ij V⁻¹ D,   c_i = Σ_j A_ij V⁻¹ (c + A y₀)
//! z₁  = E z + c_end + Σ_j A_j V⁻¹ D u_j
//! ```
//!
//! The B_ij are as few as the states x and the forces u, so that sweeps over the points leave the modes alone: these follow
//! once the forces are known.

use super::matrix::ChunkMatrix;
use super::nodes::{POINTS, no_points};
use super::propagator::Propagator;
use super::remainder::FewForces;
use crate::integrate::chunks::Padded;

/// Points after the first.
pub(super) const LATER: usize = POINTS - 1;

/// What forces do over a step of a size.
#[derive(Debug, Clone)]
pub(super) struct ForceOperator {
    /// c_i of the points after the first.
    pub constant: Vec<Padded>,
    /// B_ij of each point after the first, side by side.
    pub seen: Vec<ChunkMatrix>,
    /// A_j V⁻¹ D of the end, side by side.
    pub end: ChunkMatrix,
}

impl ForceOperator {
    /// Over the step of a propagator, within code for wide registers.
    #[inline(always)]
    pub fn new(few: &FewForces, propagator: &Propagator) -> Self {
        let (states, forces) = (few.constant.len(), few.acting.len());
        let all = |rows| ChunkMatrix::zeros(rows, POINTS * forces);
        let (mut seen, mut end) = (vec![all(few.seen.len()); LATER], all(states));
        let [mut part, mut moved] = [(); 2].map(|()| Padded::zeros(states));
        for source in 0..POINTS {
            let own = forces * source..forces * (source + 1);
            for (seen, point) in seen.iter_mut().zip(1..) {
                propagator.find_function(point, source, few.pairs, &mut moved);
                few.transfer
                    .multiply::<false>(&moved, seen.columns_mut(own.clone()));
            }
            for (force, column) in own.enumerate() {
                part.chunks_mut().copy_from_slice(few.parts.column(force));
                propagator.find_effect(LATER, source, &part, &mut moved);
                let column = end.columns_mut(column..column + 1);
                column.copy_from_slice(moved.chunks());
            }
        }
        let mut constants = no_points(states);
        for (points, constant) in constants.iter_mut().zip(few.constant.chunks()) {
            *points = [*constant; POINTS];
        }
        let from = Padded::zeros(states);
        let constant = (1..POINTS).map(|point| {
            propagator.find_coordinates(point, &from, &constants, &mut moved);
            moved.clone()
        });
        Self {
            constant: constant.collect(),
            seen,
            end,
        }
    }
}
