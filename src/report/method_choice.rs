//! Which method of integration was chosen, and why: for people and as JSON.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::integrate::Method;
use crate::scenario;
use crate::study::{MethodChoice, MethodCost};

/// The name that scenarios have for a method.
fn name(method: Method) -> &'static str {
    let named = scenario::methods()
        .iter()
        .find(|named| named.method == method);
    named.map_or("", |named| named.name.as_str())
}

/// A line or more that begin as those of a run do; at most 100 columns.
pub fn method_choice_text(choice: &MethodChoice) -> String {
    let why = choice
        .alone
        .unwrap_or("the cheapest of those tried on the first part of the run");
    let mut out = format!("  method        {}: {why}\n", name(choice.chosen));
    for cost in &choice.tried {
        writeln!(out, "                {}", cost_text(cost)).expect("a String takes everything");
    }
    out
}

fn cost_text(cost: &MethodCost) -> String {
    let (name, tried) = (name(cost.method), 1e3 * cost.tried);
    match cost.expected {
        Some(expected) => format!(
            "{name:<12}  {} evaluations in {tried:.3} ms; about {:.2} ms for the whole run",
            cost.evaluations,
            1e3 * expected
        ),
        None => format!("{name:<12}  given up before {tried:.3} ms of the motion: too many steps"),
    }
}

/// The choice with all that it rests on.
pub fn method_choice_json(choice: &MethodChoice) -> Value {
    let cost = |cost: &MethodCost| {
        json!({
            "method": name(cost.method),
            "evaluations": cost.evaluations,
            "tried_s": cost.tried,
            "expected_s": cost.expected,
        })
    };
    json!({
        "chosen": name(choice.chosen),
        "tried": choice.tried.iter().map(cost).collect::<Value>(),
        "no_other_tried_because": choice.alone,
    })
}
