//! Coordinates without mass, of a shaft that is elastic between discs: they follow the others by the springs alone.

use nalgebra::{DMatrix, DVector};

use super::structure::{Structure, UnbalancedPoint};
use super::{FREEDOMS, RotorDefinition, ShaftError};

impl Structure {
    /// Displacement of the last `count` coordinates by that of the degrees of freedom, `−K_ss⁻¹ K_sd`; none where nothing
    /// holds them.
    pub(super) fn followers_by_stiffness(&self, count: usize) -> Option<DMatrix<f64>> {
        let first = self.coordinates.len() - count;
        let own = self.matrices.stiffness.view((first, first), (count, count));
        let moved = self.matrices.stiffness.view((first, 0), (count, self.dofs));
        own.into_owned().lu().solve(&-moved)
    }

    /// A stiffness of all coordinates as it meets the degrees of freedom, with the massless ones following.
    pub fn condensed(&self, mut stiffness: DMatrix<f64>) -> DMatrix<f64> {
        let (count, dofs) = (self.followers.nrows(), self.dofs);
        if count > 0 {
            let first = self.coordinates.len() - count;
            let by_followers = stiffness.view((0, first), (dofs, count)) * &self.followers;
            let mut own = stiffness.view_mut((0, 0), (dofs, dofs));
            own += by_followers;
        }
        stiffness
    }

    /// Constant forces on all coordinates as they act on the degrees of freedom, `f_d − K_ds K_ss⁻¹ f_s`.
    pub fn carried(&self, mut forces: Vec<f64>) -> Vec<f64> {
        let count = self.followers.nrows();
        let on_followers = forces.split_off(forces.len() - count);
        forces.truncate(self.dofs);
        if count > 0 {
            let stiffness = &self.matrices.stiffness;
            let first = self.coordinates.len() - count;
            let own = stiffness.view((first, first), (count, count));
            let moved = own
                .into_owned()
                .lu()
                .solve(&DVector::from_vec(on_followers));
            let held = stiffness.view((0, first), (self.dofs, count));
            let carried = held * moved.unwrap_or_else(|| DVector::zeros(count));
            for (sum, part) in forces.iter_mut().zip(&carried) {
                *sum -= part;
            }
        }
        forces
    }

    /// Checks that nothing acts on massless coordinates but springs of constant stiffness and constant loads; `damping` is C.
    ///
    /// # Errors
    /// [`ShaftError::Followers`] names all coordinates where something does.
    pub fn check_followers(
        &self,
        definition: &RotorDefinition,
        damping: &DMatrix<f64>,
    ) -> Result<(), ShaftError> {
        let mut acts: Vec<f64> = damping.column_iter().map(|column| column.amax()).collect();
        for UnbalancedPoint { point, unbalance } in &self.unbalances {
            let force = unbalance.phasor(1.0).map(|part| part.norm());
            point.add_force(1.0, &force, &mut acts);
        }
        for (load, place) in definition.loads.iter().zip(&self.load_places) {
            if !load.acts_on_mass() {
                let varying = load.kind.main_vibration().amplitude.map(f64::abs);
                let force = load.kind.static_part().map(f64::abs);
                place.point.add_force(1.0, &varying, &mut acts);
                place.point.add_force(1.0, &force, &mut acts);
            }
        }
        for (attachment, _) in self.laws() {
            attachment.add_force_bound(&[1.0; FREEDOMS], &mut acts);
        }
        let first = self.coordinates.len() - self.followers.nrows();
        let names = self.coordinates.iter().zip(acts).skip(first);
        let names = names.filter(|(_, acts)| *acts != 0.0);
        let names: Vec<_> = names.map(|(own, _)| own.name.as_str()).collect();
        match names.is_empty() {
            true => Ok(()),
            false => Err(ShaftError::Followers(names.join(", "))),
        }
    }
}
