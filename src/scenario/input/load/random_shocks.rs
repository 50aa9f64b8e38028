//! `random_shocks` of `[[load]]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Loads, Surroundings, moving};
use crate::rotor::load::{RandomShocks, ShockStatistics};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Frequency, Quantity, Time};

/// Most shocks of a run.
const MOST_SHOCKS: f64 = 1e6;

/// Half-sine shocks that come independently of each other.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RandomShocksInput {
    /// Peak of the largest shock in each freedom.
    #[schemars(extend("examples" = [{ "y": "-2 kN" }]))]
    pub peak: Loads,
    /// Peak of the smallest shock as a part of the largest, 0 to 1; in between all are equally
    /// likely. Default: 0.
    #[serde(default)]
    #[schemars(range(min = 0.0, max = 1.0))]
    pub least: f64,
    /// Duration of each shock, for instance "4 ms".
    #[schemars(extend("examples" = ["4 ms"], "x-minimum" = 1e-6))]
    pub duration: Quantity<Time>,
    /// Mean number of shocks a second, for instance "5 Hz".
    #[schemars(extend("examples" = ["5 Hz"], "x-minimum" = 1e-6))]
    pub rate: Quantity<Frequency>,
    /// Seed, a whole number: the same one gives the same shocks. Default: 1.
    #[serde(default = "first_seed")]
    #[schemars(range(min = 0, max = 4_294_967_295_u32))]
    pub seed: u32,
}

/// Seed where none is given.
pub(super) fn first_seed() -> u32 {
    1
}

impl RandomShocksInput {
    /// The shocks of the run, unless there are too many.
    pub fn build(&self, around: Surroundings, problems: &mut Problems<'_>) -> Option<RandomShocks> {
        let expected = self.rate.si() * around.duration;
        if expected > MOST_SHOCKS {
            let message = format!(
                "about {expected:.1e} shocks are too many: at most {MOST_SHOCKS:e} in a run"
            );
            let issue = Issue::new(".rate", message);
            problems.refuse(issue.against("time.duration"));
            return None;
        }
        let statistics = ShockStatistics {
            peak: moving(&self.peak, ".peak", around.freedoms, problems),
            least: self.least,
            duration: self.duration.si(),
            rate: self.rate.si(),
            seed: self.seed.into(),
        };
        Some(RandomShocks::new(&statistics, around.duration))
    }
}
