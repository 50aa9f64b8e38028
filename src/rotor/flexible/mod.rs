//! A shaft that bends: sections and discs → beam elements → few coordinates.
//!
//! The shaft is round, so that one plane holds for both: its matrices are assembled once, reduced once, and laid out
//! twice, coupled by the gyroscopic matrix.

mod layout;
mod mesh;
mod reduction;

pub(super) use layout::Bending;
pub use mesh::{Disc, FlexibleShaft, Mesh, Plane, PointUnbalance, ShaftError};

#[cfg(test)]
mod motion_tests;
