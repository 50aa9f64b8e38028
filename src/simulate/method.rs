//! Whether a method of integration serves a model.

use super::Model;
use crate::rotor::{Freedoms, SpeedPoint};

/// Why a Nyström method does not serve a model: the forces know the velocity, or more is integrated than
/// a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum MethodMismatch {
    /// The contacts are damped.
    #[error("{NYSTROM}: the damping of contacts changes with the place of the shaft; {OTHERS}")]
    ContactDamping,
    /// Gyroscopic moments change with the speed.
    #[error("{NYSTROM}: gyroscopic moments change with the speed of the shaft; {OTHERS}")]
    Gyroscopic,
    /// A drive decides the speed.
    #[error("{NYSTROM}: with a drive the motion itself decides the speed of the shaft; {OTHERS}")]
    Drive,
    /// The energy is accounted for.
    #[error(
        "{NYSTROM}: the energy balance integrates works beside the motion, forces times velocity; {OTHERS}"
    )]
    Energy,
}

const NYSTROM: &str = "Nyström methods (dprkn8, dprkn12) need forces that depend on the velocity by \
                       constant coefficients alone";
const OTHERS: &str = "set method = \"verner76\" or \"dop853\"";

impl Model {
    /// Whether the method of integration serves the model.
    ///
    /// # Errors
    /// [`MethodMismatch`] says what stands against it.
    pub fn check_method(&self) -> Result<(), MethodMismatch> {
        if !self.integrator.method.is_nystrom() {
            return Ok(());
        }
        let rotor = &self.rotor;
        if rotor.drive.is_some() {
            return Err(MethodMismatch::Drive);
        }
        if self.energy {
            return Err(MethodMismatch::Energy);
        }
        let mut bearings = rotor.bearings.iter();
        if bearings.any(|bearing| !bearing.contact_damping.is_none()) {
            return Err(MethodMismatch::ContactDamping);
        }
        let tilts = rotor.shaft.freedoms == Freedoms::All && rotor.shaft.inertia_polar != 0.0;
        let changes = |point: &SpeedPoint| point.speed != rotor.speed;
        if tilts && rotor.speed_points.iter().any(changes) {
            return Err(MethodMismatch::Gyroscopic);
        }
        Ok(())
    }
}
