//! Which method carried a run whose method was left open, and why: for people and as JSON.

use serde_json::{Value, json};

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

/// The method of the first step, why it, and where and why another went on.
pub(super) fn method_use_json(used: &MethodUse) -> Value {
    json!({
        "method": name(used.first),
        "why": why(used.first),
        "change": used.change.map(|(reason, time)| json!({
            "time_s": time,
            "method": name(used.latest()),
            "why": why_changed(reason),
        })),
    })
}
