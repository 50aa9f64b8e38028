//! Lines, kinds of motion, maps of run-ups and natural frequencies over the speed: against closed forms,
//! signals of known answer and motions that are known.

#[path = "../support/mod.rs"]
mod support;

mod campbell;
mod command;
mod kinds;
mod maps;
mod named;
mod settling;
