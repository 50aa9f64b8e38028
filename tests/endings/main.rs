//! How a run ends early, what it keeps, and how it goes on.

#[path = "../support/mod.rs"]
mod support;

mod command;
mod failure;
mod loose;
mod parts;
mod restart_file;
mod stiff;
