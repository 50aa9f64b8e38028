//! Critical speeds and branches as JSON.

use serde_json::{Value, json};

use crate::study::campbell::{Branch, Campbell, CriticalSpeed};

/// Critical speeds and what they rest on; the modes stand in `campbell.csv`.
pub fn campbell_json(title: &str, scenario: &Value, campbell: &Campbell) -> Value {
    json!({
        "jeffcott": env!("CARGO_PKG_VERSION"),
        "title": title,
        "scenario": scenario,
        "from_rad_s": campbell.speeds.first(),
        "to_rad_s": campbell.speeds.last(),
        "count": campbell.speeds.len(),
        "orders": campbell.orders,
        "branches": campbell.branches.iter().map(branch).collect::<Value>(),
        "least_assurance": campbell.least_assurance,
        "critical_speeds": critical_speeds(campbell),
    })
}

/// Every crossing of a branch and an order.
pub fn critical_speeds(campbell: &Campbell) -> Value {
    campbell.critical_speeds.iter().map(critical).collect()
}

fn critical(critical: &CriticalSpeed) -> Value {
    json!({
        "order": critical.order,
        "branch": critical.branch + 1,
        "whirl": critical.whirl.to_string(),
        "forward_share": critical.forward_share,
        "speed_rad_s": critical.speed,
        "frequency_Hz": critical.frequency,
        "damping_ratio": critical.damping_ratio,
    })
}

fn branch(branch: &Branch) -> Value {
    let frequency = |mode: Option<&Option<crate::rotor::Mode>>| {
        mode.and_then(|mode| mode.as_ref().map(|mode| mode.damped_frequency()))
    };
    json!({
        "whirl": branch.whirl().to_string(),
        "first_Hz": frequency(branch.modes.first()),
        "last_Hz": frequency(branch.modes.last()),
    })
}
