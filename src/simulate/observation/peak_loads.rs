//! The hardest that balls are pressed in a run, and whether Hertz contact still means something there.

use crate::bearing::{BallLoads, PERMISSIBLE_PRESSURE, Support};
use crate::simulate::SimulateError;

const RACES: [&str; 2] = ["inner", "outer"];

/// Largest load of a ball at each race of a bearing, N, and its time, s.
#[derive(Debug, Default)]
pub(super) struct PeakLoads([(f64, f64); 2]);

impl PeakLoads {
    pub fn take(&mut self, time: f64, balls: &BallLoads) {
        for (peak, &load) in self.0.iter_mut().zip(&balls.largest) {
            if load > peak.0 {
                *peak = (load, time);
            }
        }
    }

    /// What to know of the peaks in a bearing of a number; nothing where the static equilibrium is as hard pressed,
    /// which has its own warnings.
    ///
    /// # Errors
    /// [`SimulateError::BeyondContact`] where a ball is pressed into its races by more than its radius.
    pub fn warnings(
        &self,
        number: usize,
        support: &Support,
        at_rest: [f64; 2],
    ) -> Result<Vec<String>, SimulateError> {
        let radius = 0.5 * support.definition().bearing.geometry.ball_diameter();
        let mut warnings = Vec::new();
        for (race, contact) in support.contacts().iter().enumerate() {
            let (load, time) = self.0[race];
            let ellipse = contact.ellipse(load);
            if ellipse.approach > radius {
                return Err(SimulateError::BeyondContact {
                    bearing: number,
                    time,
                    load,
                    approach: ellipse.approach,
                    radius,
                });
            }
            let known = contact.ellipse(at_rest[race]).peak_pressure > PERMISSIBLE_PRESSURE;
            if ellipse.peak_pressure > PERMISSIBLE_PRESSURE && !known {
                warnings.push(format!(
                    "bearing {number}: at t = {time:.4e} s a ball is pressed onto the {} race with {load:.0} N, \
                     {:.0} MPa where ISO 76 permits {:.0}: the race keeps a dent, and the model knows none",
                    RACES[race],
                    ellipse.peak_pressure / 1e6,
                    PERMISSIBLE_PRESSURE / 1e6
                ));
            }
        }
        Ok(warnings)
    }
}
