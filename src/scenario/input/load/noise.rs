//! `noise` of `[[load]]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::random_shocks::first_seed;
use super::{Loads, components, moving};
use crate::rotor::Freedoms;
use crate::rotor::load::{Noise, NoiseBand};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Frequency, Quantity};

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
    #[serde(default = "some_lines")]
    #[schemars(range(min = 8, max = 4096))]
    pub lines: u32,
    /// Seed, a whole number: the same one gives the same noise. Default: 1.
    #[serde(default = "first_seed")]
    #[schemars(range(min = 0, max = 4_294_967_295_u32))]
    pub seed: u32,
}

fn some_lines() -> u32 {
    64
}

impl NoiseInput {
    /// The noise, as far as nothing contradicts it.
    pub fn build(&self, freedoms: Freedoms, problems: &mut Problems<'_>) -> Option<Noise> {
        let (low, high) = (self.low.si(), self.high.si());
        let rms = moving(&self.rms, ".rms", freedoms, problems);
        for (key, _) in components::KEYS
            .into_iter()
            .zip(rms)
            .filter(|(_, rms)| *rms < 0.0)
        {
            let message = format!("`{key}` must be positive: it is a root mean square");
            problems.refuse(Issue::new(format!(".rms.{key}"), message));
        }
        if high <= low {
            let message = format!("`high` must be above the `low` of {low} Hz");
            let issue = Issue::new(".high", message);
            problems.refuse(issue.against(".low"));
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
