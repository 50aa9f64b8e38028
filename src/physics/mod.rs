//! Closed-form laws of contact, rolling, films, friction, beams and life, and formulas of standards and makers.
//!
//! Everything here is a pure function of numbers in SI units: no bearing, no shaft, no time. What is not a number leads to what
//! is none.

mod ball_motion;
mod ball_rating;
mod beam;
mod curvature;
mod elliptic;
mod equivalent_load;
mod film;
mod fits;
mod friction;
mod hertz;
mod inertia;
mod kinematics;
mod life_modification;
mod line_contact;
mod material;
mod roller_rating;
mod skf_friction;
mod units;
mod vibration_zones;
mod viscosity;

pub use ball_motion::{BallMotion, Race, RaceControl, controlling_race};
pub use ball_rating::{dynamic_rating, open_groove_factor, rating_factor};
pub use beam::{BeamElement, ElementMatrix};
pub use curvature::{Curvature, inner_race_curvature, outer_race_curvature};
pub use elliptic::{complete_elliptic_first, complete_elliptic_second};
pub use equivalent_load::{equivalent_load, roller_equivalent_load};
pub use film::{FilmContact, FilmInputs, FilmShape, entrainment_speed};
pub use fits::{
    RingFit, STEEL_EXPANSION, inner_ring_fit, outer_ring_fit, thermal_clearance_change,
};
pub use friction::{FrictionFactors, MINERAL_OIL_DENSITY, SMALLEST_ANGULAR_CONTACT};
pub use hertz::{ContactEllipse, HertzContact, HertzError, series_stiffness};
pub use inertia::{ball_mass, centrifugal_force};
pub use kinematics::{BallPass, ball_pass_frequencies, nominal_cage_speed};
pub use life_modification::{
    Contamination, LifeModification, reference_viscosity, reliability_factor,
};
pub use line_contact::{LINE_EXPONENT, LineContact, line_stiffness};
pub use material::{Material, contact_modulus};
pub use roller_rating::{roller_dynamic_rating, roller_rating_factor, roller_static_rating};
pub use skf_friction::{SkfFriction, SkfOperation};
pub use units::PER_MINUTE;
pub use vibration_zones::{
    MachineGroup, MachineSupport, VibrationZone, velocity_band, zone_boundaries,
};
pub use viscosity::ViscosityLaw;

/// A value, or the least one where it is below that; NaN stays NaN, as it does not with `f64::max`.
fn at_least(value: f64, least: f64) -> f64 {
    if value < least { least } else { value }
}

/// A value, or the most one where it is above that; NaN stays NaN.
fn at_most(value: f64, most: f64) -> f64 {
    if value > most { most } else { value }
}
