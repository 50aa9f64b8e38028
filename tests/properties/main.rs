//! Sentences of physics, one test each: of a ball, of a bearing, and of the shaft in motion.

#[path = "../support/mod.rs"]
mod support;

mod accuracy;
mod ball_law;
mod energy;
mod equilibrium;
mod interruption;
mod linear_rotor;
mod ring;
mod spectral_lines;
