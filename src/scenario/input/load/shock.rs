//! `shock` of `[[load]]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{PerFreedom, moving};
use crate::rotor::Freedoms;
use crate::rotor::load::Shock;
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Quantity, Time, si};

/// Half-sine shocks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShockInput<A> {
    /// Peak of each freedom.
    pub peak: A,
    /// Duration of a shock, for instance "4 ms".
    #[schemars(extend("examples" = ["4 ms"], "x-minimum" = 1e-6))]
    pub duration: Quantity<Time>,
    /// Time at which the first one begins. Default: "0 s".
    #[serde(default)]
    #[schemars(extend("examples" = ["0.1 s"], "x-minimum" = 0.0))]
    pub at: Quantity<Time>,
    /// Time from the begin of one shock to that of the next, at least the duration. Without it
    /// there is one shock.
    #[schemars(extend("examples" = ["0.2 s"], "x-minimum" = 1e-6))]
    pub every: Option<Quantity<Time>>,
}

impl<A: PerFreedom> ShockInput<A> {
    /// The shock or shocks.
    pub fn build(&self, freedoms: Freedoms, problems: &mut Problems<'_>) -> Shock {
        let (duration, every) = (self.duration.si(), si(&self.every));
        if every.is_some_and(|every| every < duration) {
            let message = format!(
                "`every` must be at least the `duration` of {duration} s: shocks do not overlap"
            );
            let issue = Issue::new(".every", message);
            problems.refuse(issue.against(".duration"));
        }
        Shock {
            peak: moving(&self.peak, ".peak", freedoms, problems),
            duration,
            start: self.at.si(),
            every,
        }
    }
}
