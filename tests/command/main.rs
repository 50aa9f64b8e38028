//! The command as a user meets it.

// a test that cannot go on, or meets what it must not, says so and fails
#![allow(clippy::unwrap_used, clippy::panic)]

mod accuracy;
mod analyze;
mod bad_scenarios;
mod bearing;
mod catalogue;
mod compare;
mod documents;
mod endings;
mod faults;
mod fit;
mod flexible;
mod forces;
mod gallery;
mod hard_scenes;
mod help;
mod keys;
mod killed;
mod lines;
mod new;
mod options;
mod releases;
mod rollers;
mod run;
mod schema;
mod seed;
mod severity;
mod spectra;
mod steady;
mod strangers;
mod studies;
mod support;
mod tables;
mod warnings;
