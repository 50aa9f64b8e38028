//! Which law of contact was chosen, and why.

use super::terminal::Lines;
use crate::study::{ContactChoice, FidelityDifference};

/// The law that was chosen for the contacts, and why.
pub(super) fn add_contact_choice(out: &mut Lines, choice: &ContactChoice) {
    let why = why_contact(choice);
    out.line("contact", format!("{}: {why}", choice.chosen));
    if choice.failure.is_none() {
        let cheaper = choice.cheaper.iter();
        cheaper.for_each(|level| out.more(level_text(level)));
    }
}

pub(super) fn why_contact(choice: &ContactChoice) -> String {
    if let Some(failure) = &choice.failure {
        return format!("the laws could not be compared ({failure}), so the most exact one stays");
    }
    let allowed = format!("(allowed {:e})", choice.model_error);
    if choice.chosen == choice.top {
        return if choice.cheaper.is_empty() {
            "there is none that is cheaper".to_owned()
        } else {
            format!("none that is cheaper stays close to it {allowed}")
        };
    }
    let mut cheaper = choice.cheaper.iter();
    let chosen = cheaper.find(|level| level.fidelity == choice.chosen);
    let difference = chosen.and_then(|level| level.result.as_ref().ok());
    difference.map_or_else(String::new, |difference| {
        let (largest, top) = (difference.largest(), choice.top);
        format!("the cheapest within {largest:.1e} of {top} {allowed}")
    })
}

pub(super) fn level_text(level: &FidelityDifference) -> String {
    let name = level.fidelity.to_string();
    match &level.result {
        Ok(difference) => format!(
            "{name:<12}  force {:.1e}, change {:.1e}, stiffness {:.1e}, worst at {:.1} rad/s",
            difference.force, difference.change, difference.stiffness, difference.speed
        ),
        Err(reason) => format!("{name:<12}  not available: {reason}"),
    }
}
