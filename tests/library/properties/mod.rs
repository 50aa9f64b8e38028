//! Sentences of physics, one test each: of a ball, of a bearing, and of the shaft in motion.

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
mod rollers;
mod spectral_lines;
mod speed;
mod table;
