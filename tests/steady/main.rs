//! Motions that repeat, found directly: against long runs, closed forms and what is known of them.

#[path = "../support/mod.rs"]
mod support;

mod against_runs;
