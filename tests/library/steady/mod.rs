//! Motions that repeat, found directly: against long runs, closed forms and what is known of them.

mod against_runs;
mod closed_form;
mod doubling;
mod hysteresis;
mod refusal;
mod slopes;

use std::sync::atomic::{AtomicBool, AtomicU64};

use crate::scenario;
use crate::simulate::Model;
use crate::steady::{Steady, SteadyError, SteadyQuestion, steady};

/// The model of a shipped scenario.
fn shipped(name: &str) -> Model {
    let path = format!("{}/scenarios/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let scenario = scenario::load(path.as_ref()).expect("a shipped scenario");
    scenario.model.expect("a motion")
}

fn search(model: &Model, multiple: Option<u32>) -> Result<Steady, SteadyError> {
    let stop = AtomicBool::new(false);
    let stop = &stop;
    steady(&SteadyQuestion {
        model,
        multiple,
        stop,
        integrated: &AtomicU64::new(0),
    })
}

/// The motion that a scene settles to.
fn found(model: &Model) -> Steady {
    search(model, None).expect("a steady motion")
}
