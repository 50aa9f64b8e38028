//! A shaft that bends: sections and discs → beam elements → few coordinates.
//!
//! The shaft is round, so that one plane holds for both: its matrices are assembled once, reduced once, and laid out
//! twice, coupled by the gyroscopic matrix.

mod disc;
mod hub;
mod layout;
mod mesh;
mod reduction;
mod shaft_error;

pub use disc::Disc;
pub(super) use layout::Bending;
pub use mesh::{FlexibleShaft, Mesh, Plane, PointUnbalance};
pub use shaft_error::ShaftError;

#[cfg(test)]
mod motion_tests;
