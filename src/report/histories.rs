//! What a run observed of its bearings, for people.

use super::terminal::{Lines, clearance_text};
use crate::simulate::{BearingHistory, EventCount, EventKind, Spread};

/// Two lines a bearing: what its balls did, and its life.
pub(super) fn put_histories(out: &mut Lines, bearings: &[BearingHistory]) {
    for (index, bearing) in bearings.iter().enumerate() {
        // one bearing needs no number
        let name = match bearings.len() {
            1 => String::new(),
            _ => format!("bearing {}: ", index + 1),
        };
        if let Some(clearance) = &bearing.clearance {
            out.line("clearance", format!("{name}{}", clearance_text(clearance)));
        }
        if let Some(zone) = &bearing.load_zone {
            let loaded = balls_loaded(&zone.balls, bearing.balls);
            out.line("load zone", format!("{name}{loaded}{}", losses(bearing)));
        }
        // the start is left out where enough remains
        let life = bearing
            .life
            .map(|life| match life.after_settle.rating_life() {
                Some(_) => life.after_settle,
                None => life.whole_run,
            });
        if let Some((life, hours)) = life.and_then(|life| life.rating_life().zip(life.hours())) {
            let text = format!("{life:.4e} million revolutions, {hours:.3e} h of this motion");
            out.line("life L10r", name + &text);
        }
    }
}

/// `all 12 balls loaded` or `3 to 5 of 12 balls loaded, mean 4.21`.
fn balls_loaded(loaded: &Spread, balls: usize) -> String {
    if loaded.smallest == balls as f64 {
        return format!("all {balls} balls loaded");
    }
    format!(
        "{} to {} of {balls} balls loaded, mean {:.2}",
        loaded.smallest, loaded.largest, loaded.mean
    )
}

/// `; contact lost 12 times, from 0.1 s to 0.4 s` and the same of a preload, where they happened.
fn losses(bearing: &BearingHistory) -> String {
    let mut text = String::new();
    for (kind, name) in [
        (EventKind::ContactLost, "contact"),
        (EventKind::PreloadLost, "preload"),
    ] {
        let EventCount { count, span } = bearing.events(kind);
        match span {
            None => {}
            Some([time, _]) if count == 1 => text += &format!("; {name} lost once, at {time:.4} s"),
            Some([first, last]) => {
                text += &format!("; {name} lost {count} times, {first:.4} s to {last:.4} s");
            }
        }
    }
    text
}
