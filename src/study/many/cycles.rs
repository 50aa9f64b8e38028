//! Runs that last so many cycles at their own speed.

use std::f64::consts::TAU;

use crate::analysis::SectionKind;
use crate::bearing::ContactLaw;
use crate::rotor::{CageMotion, RotorDefinition};

/// How long a run is, in revolutions of its shaft or in ball passes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cycles {
    /// What counts as a cycle.
    pub of: SectionKind,
    /// Cycles that settle.
    pub settle: u32,
    /// Cycles after them.
    pub kept: u32,
}

/// Why a run has no cycles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum CyclesError {
    /// Its speed changes, or is zero.
    #[error(
        "cycles are counted at a constant speed above zero only; give the times by `[time]` of the base"
    )]
    Speed,
    /// No ball passes.
    #[error(
        "no ball passes here: the cage stands or all bearings are linear; count revolutions, or set \
         model.contact and model.cage"
    )]
    BallPass,
}

impl Cycles {
    /// Settle time and duration of a run of this shaft, s.
    ///
    /// ```text
    /// T = 2π/ω   T = 2π/(ω_c Z) for a pass of the first bearing's Z balls
    /// ```
    ///
    /// # Errors
    /// [`CyclesError`] where it has no such cycles.
    pub fn times(&self, rotor: &RotorDefinition) -> Result<[f64; 2], CyclesError> {
        let steady = rotor.speed_points.is_empty() && rotor.drive.is_none();
        if !steady || rotor.speed <= 0.0 {
            return Err(CyclesError::Speed);
        }
        let cycle = TAU / (rotor.speed * self.order(rotor)?);
        let cycles = [self.settle, self.settle.saturating_add(self.kept)];
        Ok(cycles.map(|count| f64::from(count) * cycle))
    }

    /// Cycles a revolution.
    fn order(&self, rotor: &RotorDefinition) -> Result<f64, CyclesError> {
        if self.of == SectionKind::Revolution {
            return Ok(1.0);
        }
        let passing = rotor
            .bearings
            .iter()
            .find(|bearing| bearing.law != ContactLaw::Linear);
        match (rotor.cage, passing) {
            (CageMotion::Rolling, Some(bearing)) => {
                Ok(bearing.bearing.geometry.ball_pass(TAU).outer)
            }
            _ => Err(CyclesError::BallPass),
        }
    }
}
