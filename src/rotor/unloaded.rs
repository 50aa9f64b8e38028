//! Where a shaft rests along its axis without load: preloads are reported there.

use super::structure::Structure;
use crate::bearing::{Geometry, Support};
use crate::numerics::root::root;

/// Component z.
const AXIAL: usize = 2;

/// Part of the forces of all bearings below which their sum is round-off.
const ROUND_OFF: f64 = 1e-9;

/// First step of the search, in parts of [`Geometry::length_scale`].
const FIRST_STEP: f64 = 1e-3;

impl Structure {
    /// Stiffness of springs and couplings against a motion of the shaft along its axis as a rigid body, N/m.
    pub(super) fn axial_stiffness(&self) -> f64 {
        let motion = &self.rigid_motions[AXIAL];
        motion.dot(&(&self.matrices.stiffness * motion))
    }

    /// Axial displacement of every bearing at standstill, in its own orientation, m, with a shaft that moves along its axis as
    /// a rigid body to where nothing pushes it: `k z + Σ s F(s z) = 0`, k the stiffness of springs and couplings, s the facing.
    /// Zero where the bearings balance as they are, or nowhere, as with spring preloads that all press one way.
    pub(super) fn unloaded_axial(&self, supports: &[Support]) -> Vec<f64> {
        let motion = &self.rigid_motions[AXIAL];
        let signs = self
            .attachments
            .iter()
            .map(|attachment| attachment.displacement(motion.as_slice(), &[])[AXIAL]);
        let signs: Vec<f64> = signs.collect();
        let spring = self.axial_stiffness();
        let forces = |place: f64| {
            let pairs = supports.iter().zip(&signs);
            pairs.map(move |(support, sign)| sign * support.axial_force(sign * place))
        };
        let sum = |place: f64| spring * place + forces(place).sum::<f64>();
        let preset: Vec<f64> = forces(0.0).collect();
        let total: f64 = preset.iter().map(|force| force.abs()).sum();
        let pushed: f64 = preset.iter().sum();
        let place = match pushed.abs() <= ROUND_OFF * total {
            true => None,
            false => balance(sum, pushed, supports),
        };
        let place = place.unwrap_or(0.0);
        signs.iter().map(|sign| sign * place).collect()
    }
}

/// Root of a force that rises with the displacement of a shaft in m, from its value at zero.
fn balance(sum: impl Fn(f64) -> f64, pushed: f64, supports: &[Support]) -> Option<f64> {
    let scale = Support::largest(supports, Geometry::length_scale);
    let presets = supports.iter().map(Support::axial_preset);
    let farthest = 4.0 * scale + 2.0 * presets.map(f64::abs).fold(0.0, f64::max);
    let (mut before, mut force) = (0.0, pushed);
    let mut step = -pushed.signum() * FIRST_STEP * scale;
    while step.abs() <= farthest {
        let found = sum(step);
        if found == 0.0 {
            return Some(step);
        }
        if found * pushed < 0.0 {
            let (mut ends, mut values) = ([before, step], [force, found]);
            if step < before {
                (ends, values) = ([step, before], [found, force]);
            }
            return root(&sum, ends, values, f64::EPSILON * scale);
        }
        (before, force) = (step, found);
        step *= 2.0;
    }
    None
}
