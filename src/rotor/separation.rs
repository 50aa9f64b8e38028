//! The derivative as what is linear in the degrees of freedom, and forces that few of them decide: those of the ball
//! bearings, of other laws of force and of what drives the shaft from outside.
//!
//! ```text
//! M q̈ + (C + ω G) q̇ + (K − ω H) q = f₀ + w(t, q, q̇)
//! ```
//!
//! with f₀ the constant forces. w acts at bearings, unbalances and varying loads, and depends on the place of the bearings;
//! on their velocity too where contacts are damped or other laws ask for it.

use nalgebra::DMatrix;

use super::{Attachment, Rotor};
use crate::integrate::Separated;
use crate::numerics::registers::in_wide_registers;

impl Rotor {
    /// Both parts of the derivative about a state at a time. None of a rigid shaft, whose coordinates are as few as those of
    /// its bearings, and none where G and H change with the speed.
    pub(super) fn separation(&self, time: f64, state: &[f64]) -> Option<Separated> {
        let speed = self.steady_from(0.0)?;
        if self.is_augmented() || self.elements.on_rigid_shaft {
            return None;
        }
        let (dofs, linear) = (self.dofs(), &self.linear);
        let (seen, acting) = self.seen_and_acting();
        // A = (0 1, −M⁻¹ (K − ω H) −M⁻¹ (C + ω G)), c = (0, M⁻¹ f₀)
        let held = [linear.by_place(speed), linear.by_rate(speed)];
        let mut matrix = DMatrix::zeros(2 * dofs, 2 * dofs);
        linear.write_state_matrix(&held, &mut matrix);
        let mut constant = vec![0.0; 2 * dofs];
        constant[dofs..].copy_from_slice(&self.excitation.constant_force[..dofs]);
        linear.mass.accelerate(&mut constant[dofs..]);
        // D = (0, M⁻¹)
        let mut inputs = DMatrix::zeros(2 * dofs, acting.len());
        for (mut column, own) in inputs.column_iter_mut().zip(&acting) {
            column[dofs + own] = 1.0;
            linear.mass.accelerate(&mut column.as_mut_slice()[dofs..]);
        }
        let slopes = self.few_force_slopes(time, state, &seen, &acting);
        Some(Separated {
            constant,
            matrix,
            seen,
            acting,
            inputs,
            slopes,
        })
    }

    /// Positions of the states that w depends on, and the degrees of freedom that it acts on.
    fn seen_and_acting(&self) -> (Vec<usize>, Vec<usize>) {
        let (dofs, excitation) = (self.dofs(), &self.excitation);
        let moving = |mut coordinates: Vec<usize>| {
            coordinates.retain(|own| *own < dofs);
            coordinates.sort_unstable();
            coordinates.dedup();
            coordinates
        };
        let bearings = self.elements.bearings().map(|own| own.attachment);
        let laws = self.elements.laws().map(|(attachment, _)| attachment);
        let bearings = bearings.chain(laws);
        let bearings = moving(bearings.flat_map(Attachment::coordinates).collect());
        let mut acting = bearings.clone();
        let unbalances = excitation.unbalances.iter().map(|own| own.point);
        let loads = excitation.load_places.iter().map(|own| own.point);
        acting.extend(unbalances.chain(loads).flat_map(|own| own.coordinates));
        if excitation.loads.iter().any(|load| load.acts_on_mass()) {
            acting = (0..dofs).collect();
        }
        let mut seen = bearings;
        if self.elements.by_rate {
            seen.extend_from_within(..);
            let places = seen.len() / 2;
            seen[places..].iter_mut().for_each(|rate| *rate += dofs);
        }
        (seen, moving(acting))
    }

    /// ∂w/∂x, of the forces `acting` by the states `seen`: of bearings and laws alone.
    pub(super) fn few_force_slopes(
        &self,
        time: f64,
        state: &[f64],
        seen: &[usize],
        acting: &[usize],
    ) -> DMatrix<f64> {
        let dofs = self.dofs();
        let mut held = [(); 2].map(|()| DMatrix::zeros(dofs, dofs));
        let rotation = self.excitation.speed.at(time);
        let at = self.instant(state, &rotation);
        for (bearing, motion) in self.elements.bearings_at(&at) {
            self.add_bearing_slopes(&bearing, &motion, &mut held);
        }
        self.add_law_slopes(&at, &mut held);
        DMatrix::from_fn(acting.len(), seen.len(), |row, column| {
            let (row, column) = (acting[row], seen[column]);
            -held[column / dofs][(row, column % dofs)]
        })
    }

    /// Writes w for [`Rotor::separation`].
    pub(super) fn few_forces(&self, time: f64, state: &[f64], forces: &mut [f64]) {
        let forces = &mut forces[..self.dofs()];
        let rotation = self.excitation.speed.at(time);
        let at = self.instant(state, &rotation);
        forces.fill(0.0);
        in_wide_registers!(self.elements.level, simd => {
            self.excitation
                .add_varying_forces::<false>(time, &rotation, &at.phases, forces);
            self.elements.add_forces(simd, &at, forces);
        });
    }
}
