//! placeholder
pub mod analysis;
pub mod bearing;
pub mod cli;
pub mod integrate;
pub mod physics;
pub mod report;
pub mod rotor;
pub mod scenario;
pub mod simulate;
