//! Which method carried a run whose method was left open, and why: for people and as JSON.

use serde::Serialize;

use crate::integrate::{ChangeReason, Method, MethodUse};
use crate::scenario;

/// The name that scenarios have for a method.
fn name(method: Method) -> &'static str {
    let named = scenario::methods()
        .iter()
        .find(|named| named.method == method);
    named.map_or("", |named| named.name.as_str())
}

fn why(first: Method) -> &'static str {
    match first {
        Method::Verner76 => "a ball may part from a race on this motion",
        _ => "no ball is expected to part from a race on this motion",
    }
}

fn why_changed(reason: ChangeReason) -> &'static str {
    match reason {
        ChangeReason::Crossings => "balls part from a race again and again",
        ChangeReason::NoStep => "exponential can take no further step",
    }
}

/// `exponential: no ball is expected to part from a race on this motion; verner76 from 1.234 ms on: …`
pub(super) fn method_use_text(used: &MethodUse) -> String {
    let mut line = format!("{}: {}", name(used.first), why(used.first));
    if let Some((reason, time)) = used.change {
        let [latest, why] = [name(used.latest()), why_changed(reason)];
        line.push_str(&format!("; {latest} from {:.3} ms on: {why}", 1e3 * time));
    }
    line
}

/// Which method carried a run, and why.
#[derive(Debug, Serialize)]
pub(super) struct MethodUseSummary {
    /// The method of the first step.
    method: &'static str,
    /// Why it was chosen.
    why: &'static str,
    /// The method that went on from it, if any.
    change: Option<MethodChange>,
}

/// Where another method went on, and why.
#[derive(Debug, Serialize)]
struct MethodChange {
    time_s: f64,
    method: &'static str,
    why: &'static str,
}

impl From<&MethodUse> for MethodUseSummary {
    fn from(used: &MethodUse) -> Self {
        Self {
            method: name(used.first),
            why: why(used.first),
            change: used.change.map(|(reason, time)| MethodChange {
                time_s: time,
                method: name(used.latest()),
                why: why_changed(reason),
            }),
        }
    }
}
