//! Sentences of physics, one test each: of a ball, of a bearing, and of the shaft in motion.

// a test that meets the wrong error says so and fails
#![allow(clippy::panic)]

#[path = "../support/mod.rs"]
mod support;

mod accuracy;
mod ball_law;
mod contact_damping;
mod drive;
mod energy;
mod energy_balance;
mod equilibrium;
mod interruption;
mod linear_rotor;
mod linearisation;
mod loads;
mod ring;
mod spectral_lines;
mod speed;
mod table;
