//! Critical speeds and branches as JSON.

use serde::Serialize;
use serde_json::Value;

use super::super::Destination;
use crate::rotor::{Mode, Whirl};
use crate::study::campbell::{Branch, Campbell, CriticalSpeed};

/// Critical speeds and what they rest on.
#[derive(Serialize)]
struct CampbellSummary<'a> {
    #[serde(rename = "from_rad_s")]
    from: Option<&'a f64>,
    #[serde(rename = "to_rad_s")]
    to: Option<&'a f64>,
    count: usize,
    orders: &'a [f64],
    branches: Vec<BranchSummary>,
    least_assurance: f64,
    critical_speeds: &'a [CriticalSpeed],
}

/// A branch by its ends.
#[derive(Serialize)]
struct BranchSummary {
    whirl: Whirl,
    #[serde(rename = "first_Hz")]
    first: Option<f64>,
    #[serde(rename = "last_Hz")]
    last: Option<f64>,
}

/// Critical speeds and what they rest on; the modes stand in `campbell.csv`.
pub fn campbell_json(destination: &Destination<'_>, campbell: &Campbell) -> Value {
    let summary = CampbellSummary {
        from: campbell.speeds.first(),
        to: campbell.speeds.last(),
        count: campbell.speeds.len(),
        orders: &campbell.orders,
        branches: campbell.branches.iter().map(branch).collect(),
        least_assurance: campbell.least_assurance,
        critical_speeds: &campbell.critical_speeds,
    };
    destination.document(summary)
}

fn branch(branch: &Branch) -> BranchSummary {
    let frequency = |mode: Option<&Option<Mode>>| mode?.as_ref().map(Mode::damped_frequency);
    BranchSummary {
        whirl: branch.whirl(),
        first: frequency(branch.modes.first()),
        last: frequency(branch.modes.last()),
    }
}
