//! Loads that are drawn: noise, and shocks at random times.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::components::{self};
use super::load::{LoadContext, Loads, moving};
use super::number;
use crate::rotor::Freedoms;
use crate::rotor::load::{Noise, NoiseBand, RandomShocks, ShockStatistics};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Frequency, Quantity, Time};

/// Noise of a flat spectrum between two frequencies, as a sum of cosines.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NoiseInput {
    /// Root mean square in each freedom, positive.
    #[schemars(extend("examples" = [{ "y": "100 N" }]))]
    pub rms: Loads,
    /// Lowest frequency.
    #[schemars(extend("examples" = ["10 Hz"], "x-minimum" = 0.0))]
    pub low: Quantity<Frequency>,
    /// Highest frequency, above the lowest.
    #[schemars(extend("examples" = ["500 Hz"], "x-minimum" = 0.0))]
    pub high: Quantity<Frequency>,
    /// Number of cosines in each freedom, 8 to 4096; each costs time at every step. Default: 64.
    #[serde(default = "number::<64>")]
    #[schemars(range(min = 8, max = 4096))]
    pub lines: u32,
    /// Seed, a whole number: the same one gives the same noise. Default: 1.
    #[serde(default = "number::<1>")]
    #[schemars(range(min = 0, max = 4_294_967_295_u32))]
    pub seed: u32,
}

impl NoiseInput {
    /// The noise, as far as nothing contradicts it.
    pub fn build(&self, freedoms: Freedoms, problems: &mut Problems<'_>) -> Option<Noise> {
        let (low, high) = (self.low.si(), self.high.si());
        let rms = moving(&self.rms, ".rms", freedoms, problems);
        let keys = components::KEYS.iter().zip(rms);
        for (key, _) in keys.filter(|(_, rms)| *rms < 0.0) {
            let message = format!("`{key}` must be positive: it is a root mean square");
            problems.refuse(Issue::new(format!(".rms.{key}"), message));
        }
        if high <= low {
            let message = format!("`high` must be above the `low` of {low} Hz");
            problems.refuse(Issue::new(".high", message).against(".low"));
            return None;
        }
        Some(Noise::new(&NoiseBand {
            rms,
            low,
            high,
            lines: self.lines,
            seed: self.seed.into(),
        }))
    }
}

/// Most shocks of a run.
pub const MOST_SHOCKS: f64 = 1e6;

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
    #[serde(default = "number::<1>")]
    #[schemars(range(min = 0, max = 4_294_967_295_u32))]
    pub seed: u32,
}

impl RandomShocksInput {
    /// The shocks of the run, unless there are too many.
    pub fn build(&self, context: LoadContext, problems: &mut Problems<'_>) -> Option<RandomShocks> {
        let expected = self.rate.si() * context.duration;
        if expected > MOST_SHOCKS {
            let message = format!(
                "about {expected:.1e} shocks are too many: at most {MOST_SHOCKS:e} in a run"
            );
            problems.refuse(Issue::new(".rate", message).against("time.duration"));
            return None;
        }
        let statistics = ShockStatistics {
            peak: moving(&self.peak, ".peak", context.freedoms, problems),
            least: self.least,
            duration: self.duration.si(),
            rate: self.rate.si(),
            seed: self.seed.into(),
        };
        Some(RandomShocks::new(&statistics, context.duration))
    }
}
