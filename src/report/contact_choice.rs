//! Which law of the contacts was chosen, and why: for people.

use std::fmt::Write;

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
