//! Which law of the contacts was chosen, and why: for people and as JSON.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::study::{ContactChoice, Rung, RungDifference};

/// A line or two that begin as those of a run do; at most 100 columns.
pub fn contact_choice_text(choice: &ContactChoice) -> String {
    let mut out = format!("  contact       {}: ", choice.chosen);
    if let Some(failure) = &choice.failure {
        out +=
            &format!("the laws could not be compared ({failure}), so the most exact one stays\n");
        return out;
    }
    let allowed = format!("(allowed {:e})", choice.model_error);
    out += &match (
        difference(choice, choice.chosen),
        choice.chosen == choice.top,
    ) {
        (_, true) if choice.rungs.is_empty() => "there is none that is cheaper".to_owned(),
        (_, true) => format!("none that is cheaper stays close to it {allowed}"),
        (Some(largest), false) => {
            format!(
                "the cheapest within {largest:.1e} of {} {allowed}",
                choice.top
            )
        }
        (None, false) => String::new(),
    };
    out += "\n";
    for rung in &choice.rungs {
        writeln!(out, "                {}", rung_text(rung)).expect("a String takes everything");
    }
    out
}

fn difference(choice: &ContactChoice, rung: Rung) -> Option<f64> {
    let found = choice.rungs.iter().find(|other| other.rung == rung)?;
    Some(found.result.as_ref().ok()?.largest())
}

fn rung_text(rung: &RungDifference) -> String {
    match &rung.result {
        Ok(difference) => format!(
            "{:<12}  force {:.1e}, change {:.1e}, stiffness {:.1e}, worst at {:.1} rad/s",
            rung.rung.to_string(),
            difference.force,
            difference.change,
            difference.stiffness,
            difference.speed
        ),
        Err(reason) => format!("{:<12}  not available: {reason}", rung.rung.to_string()),
    }
}

/// The choice with all that it rests on.
pub fn contact_choice_json(choice: &ContactChoice) -> Value {
    let rung = |rung: &RungDifference| {
        let difference = rung.result.as_ref().ok();
        json!({
            "contact": rung.rung.to_string(),
            "force_relative": difference.map(|difference| difference.force),
            "force_change_relative": difference.map(|difference| difference.change),
            "stiffness_relative": difference.map(|difference| difference.stiffness),
            "worst_at_rad_s": difference.map(|difference| difference.speed),
            "note": rung.result.as_ref().err(),
        })
    };
    json!({
        "chosen": choice.chosen.to_string(),
        "compared_with": choice.top.to_string(),
        "model_error": choice.model_error,
        "cheaper": choice.rungs.iter().map(rung).collect::<Value>(),
        "motion_looked_at_m": choice.motion,
        "speeds_looked_at_rad_s": choice.speeds,
        "failure": choice.failure,
    })
}
