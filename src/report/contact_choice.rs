//! Which law of the contacts was chosen, and why: for people.

use super::terminal::Lines;
use crate::study::{ContactChoice, Rung, RungDifference};

/// A line or two that begin as those of a run do; at most 100 columns.
pub fn contact_choice_text(choice: &ContactChoice) -> String {
    let mut out = Lines::default();
    out.line("contact", format!("{}: {}", choice.chosen, why(choice)));
    if choice.failure.is_none() {
        choice
            .rungs
            .iter()
            .for_each(|rung| out.more(rung_text(rung)));
    }
    out.text()
}

fn why(choice: &ContactChoice) -> String {
    if let Some(failure) = &choice.failure {
        return format!("the laws could not be compared ({failure}), so the most exact one stays");
    }
    let allowed = format!("(allowed {:e})", choice.model_error);
    if choice.chosen == choice.top {
        return if choice.rungs.is_empty() {
            "there is none that is cheaper".to_owned()
        } else {
            format!("none that is cheaper stays close to it {allowed}")
        };
    }
    difference(choice, choice.chosen).map_or_else(String::new, |largest| {
        format!(
            "the cheapest within {largest:.1e} of {} {allowed}",
            choice.top
        )
    })
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
