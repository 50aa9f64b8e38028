//! Closed-form laws of solid contact and rolling kinematics, one law per file.
//!
//! Everything here is a pure function of numbers in SI units: no bearing, no shaft, no time.

mod curvature;
mod elliptic;
mod hertz;
mod kinematics;
mod material;

pub use curvature::{Curvature, inner_race_curvature, outer_race_curvature};
pub use elliptic::{complete_elliptic_first, complete_elliptic_second};
pub use hertz::{ContactEllipse, HertzContact, HertzError, series_stiffness};
pub use kinematics::{BallPass, ball_pass_frequencies, nominal_cage_speed};
pub use material::{Material, contact_modulus};
