//! `cage_jitter` of a bearing.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::bearing::{Geometry, Imperfections};
use crate::rotor::load::SplitMix64;
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Angle, Quantity};

/// Ball passes after which the steps come again.
const STEPS: u64 = 16_384;
/// Uniform numbers whose sum, less its mean, stands for a normal number of deviation 1 and at most half as many in size.
const SUMMED: u64 = 12;

/// A cage that wanders at random: with every ball pass it gains or loses an angle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CageJitterInput {
    /// Standard deviation of the angle gained with one ball pass, for instance "0.2 deg"; at most a twelfth of the spacing of
    /// the balls.
    #[schemars(extend("examples" = ["0.2 deg"], "x-minimum" = 0.0))]
    pub amplitude: Quantity<Angle>,
    /// Seed of the angles, a whole number. Default: 1.
    #[schemars(range(min = 0, max = 4_294_967_295_u32))]
    pub seed: Option<u32>,
}

impl CageJitterInput {
    /// Angles that the cage gains, rad.
    pub fn build(&self, geometry: &Geometry, problems: &mut Problems<'_>) -> Option<Vec<f64>> {
        let amplitude = self.amplitude.si();
        let spacing = std::f64::consts::TAU / geometry.balls() as f64;
        let largest = 2.0 * Imperfections::LARGEST_STEP * spacing / SUMMED as f64;
        if amplitude > largest {
            let message = format!(
                "the cage would wander by {:.3} deg with a ball pass, and might turn backwards",
                amplitude.to_degrees()
            );
            let help = format!("at most {:.3} deg with these balls", largest.to_degrees());
            problems.refuse(Issue::new(".amplitude", message).help(help));
            return None;
        }
        if amplitude == 0.0 {
            return Some(Vec::new());
        }
        let chance = SplitMix64::new(self.seed.unwrap_or(1).into());
        let normal = |pass: u64| {
            let numbers = (0..SUMMED).map(|number| chance.uniform(SUMMED * pass + number));
            numbers.sum::<f64>() - 0.5 * SUMMED as f64
        };
        Some((0..STEPS).map(|pass| amplitude * normal(pass)).collect())
    }
}
