//! Closed-form laws of solid contact and rolling kinematics, one law per file.
//!
//! Everything here is a pure function of numbers in SI units: no bearing, no shaft, no time.

mod ball_motion;
mod curvature;
mod elliptic;
mod film;
mod friction;
mod hertz;
mod inertia;
mod kinematics;
mod material;

pub use ball_motion::{BallMotion, Race, RaceControl, controlling_race};
pub use curvature::{Curvature, inner_race_curvature, outer_race_curvature};
pub use elliptic::{complete_elliptic_first, complete_elliptic_second};
pub use film::{FilmContact, FilmInputs, entrainment_speed};
pub use friction::{FrictionFactors, MINERAL_OIL_DENSITY, SMALLEST_ANGULAR_CONTACT};
pub use hertz::{ContactEllipse, HertzContact, HertzError, series_stiffness};
pub use inertia::{ball_inertia, ball_mass, centrifugal_force, gyroscopic_moment};
pub use kinematics::{BallPass, ball_pass_frequencies, nominal_cage_speed};
pub use material::{Material, contact_modulus};
