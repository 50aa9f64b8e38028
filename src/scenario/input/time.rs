//! `[time]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Quantity, Time};

/// How long to simulate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TimeInput {
    /// Simulated time, for instance "0.5 s".
    #[schemars(extend("x-minimum" = 1e-6))]
    pub duration: Quantity<Time>,
    /// Time at the start that the spectra leave out, so that the transient does not colour
    /// them; shorter than the duration. Default: "0 s".
    #[serde(default)]
    #[schemars(extend("examples" = ["0.2 s"], "x-minimum" = 0.0))]
    pub settle: Quantity<Time>,
}

impl TimeInput {
    /// Time that the spectra are taken of, s.
    pub fn window(&self) -> f64 {
        self.duration.si() - self.settle.si()
    }

    /// Refuses a settle time that leaves nothing.
    pub fn check(&self, problems: &mut Problems<'_>) {
        if self.window() <= 0.0 {
            let message = format!(
                "`settle` must be shorter than the `duration` of {} s",
                self.duration.si()
            );
            let issue = Issue::new("time.settle", message);
            problems.refuse(issue.against("time.duration"));
        }
    }
}
