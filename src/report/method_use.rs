//! Which method carried a run whose method was left open, and why: for people and as JSON.

use serde_json::{Value, json};

use super::wrapped;
use crate::integrate::{Method, MethodUse, Stretch};
use crate::scenario;

/// Changes that are told to people.
const SHOWN: usize = 3;

/// The name that scenarios have for a method.
fn name(method: Method) -> &'static str {
    let named = scenario::methods()
        .iter()
        .find(|named| named.method == method);
    named.map_or("", |named| named.name.as_str())
}

/// What a simulated second was found to cost, for comparison alone.
fn cost(stretch: &Stretch) -> Option<String> {
    let rate = stretch.rate?;
    Some(format!("{} {:.3} ms", name(stretch.method), 1e3 * rate))
}

/// Characters before the text of a line.
const INDENT: usize = 16;

/// Two lines or more that begin as those of a run do.
pub(super) fn method_use_text(used: &MethodUse) -> String {
    let costs: Vec<String> = used.stretches.iter().filter_map(cost).collect();
    let why = match costs.len() {
        0 => "the run is over before anything could be compared".to_owned(),
        1 => format!(
            "expected cost of a second: {}; no other promised to pay for its trial",
            costs[0]
        ),
        _ => format!("expected cost of a second: {}", costs.join(", ")),
    };
    let course = wrapped(&format!("  method        {}", course(used)), INDENT);
    let why = wrapped(&format!("{:INDENT$}{why}", ""), INDENT);
    format!("{course}\n{why}\n")
}

/// `verner76, exponential from 1.234 ms on`.
fn course(used: &MethodUse) -> String {
    let changes = &used.changes;
    let told: Vec<String> = changes
        .iter()
        .take(SHOWN)
        .map(|change| match change.time {
            0.0 => name(change.method).to_owned(),
            time => format!("{} from {:.3} ms on", name(change.method), 1e3 * time),
        })
        .collect();
    let more = changes.len().saturating_sub(SHOWN);
    let most = used.main().map_or("", |main| name(main.method));
    match more {
        0 => told.join(", "),
        _ => format!(
            "{}, {more} more changes; {most} for most of the time",
            told.join(", ")
        ),
    }
}

/// All methods that could be chosen with what each did and costs, and where they changed.
pub(super) fn method_use_json(used: &MethodUse) -> Value {
    let stretch = |stretch: &Stretch| {
        json!({
            "method": name(stretch.method),
            "covered_s": stretch.covered,
            "steps": stretch.counters.steps,
            "evaluations": stretch.counters.evaluations,
            "expected_cost_of_a_second_s": stretch.rate,
        })
    };
    json!({
        "main": used.main().map(|main| name(main.method)),
        "why": "least expected cost of a simulated second, by evaluations, linear parts and step sizes at fixed prices",
        "methods": used.stretches.iter().map(stretch).collect::<Value>(),
        "changes": used
            .changes
            .iter()
            .map(|change| json!({ "time_s": change.time, "method": name(change.method) }))
            .collect::<Value>(),
    })
}
