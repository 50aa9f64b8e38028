//! A shaft on its bearings: degrees of freedom, unbalance, loads, damping, static equilibrium, motion.
//!
//! A [`RotorDefinition`] is plain data. A `Structure` says which coordinates it has and between
//! which points its bearings sit; [`Rotor::assemble`] finds its static equilibrium and makes
//! of it a [`Rotor`], whose derivative is a pure function of time and state.

mod action;
mod assembly;
mod bodies;
mod coefficient_table;
mod coefficients;
mod coordinate;
mod coupling;
mod damping;
mod definition;
mod drive;
mod element;
mod energy;
mod equilibrium;
mod error;
mod excitation;
mod flexible;
mod force_law;
mod forcing;
mod harmonic_motion;
mod lift_off;
mod linear_law;
mod linear_matrices;
mod linear_part;
mod linearisation;
pub mod load;
mod massless;
mod matrices;
mod modes;
mod motion;
mod motion_scale;
mod observation;
mod phases;
mod point;
mod receptance;
mod rub;
mod separation;
mod shaft_shapes;
mod speed_profile;
mod squeeze_film;
mod stability;
mod static_search;
mod structure;
mod surface_passing;
mod system;
mod tabulation;
mod unbalance;
mod unconstrained;
mod unloaded;

pub(crate) use crate::bearing::CageMotion;
pub(crate) use assembly::build_supports;
pub use bodies::{Body, BodyMotion, MOST_HOUSINGS};
pub use coefficient_table::CoefficientTable;
pub use coupling::Coupling;
pub use definition::{
    Damping, FREEDOMS, Freedoms, InitialPosition, InitialState, RotorDefinition, STANDARD_GRAVITY,
    Shaft,
};
pub use drive::{Drive, DriveMoments};
pub use energy::{EnergyBalance, Works};
pub use equilibrium::{Equilibrium, EquilibriumError, FREEDOM_NAMES, StaticProblem};
pub(crate) use equilibrium::{axial_hold_warning, static_place};
pub use error::RotorError;
pub use flexible::{Disc, FlexibleShaft, Mesh, Plane, PointUnbalance, ShaftError};
pub use force_law::{ElementLaw, ForceElement};
pub use forcing::{Forcing, ForcingCause, Unrepeated};
pub(crate) use harmonic_motion::HarmonicMotion;
pub use linear_law::LinearLaw;
pub use linear_matrices::LinearMatrices;
pub use load::{Load, LoadKind};
pub use modes::{Mode, NaturalFrequency, Whirl};
pub use motion::Rotor;
pub use motion_scale::MotionScale;
pub use observation::{BallContacts, MOST_BEARINGS, Sample};
pub(crate) use point::Attachment;
pub(crate) use receptance::Excursion;
pub use receptance::Pickup;
pub use rub::Rub;
pub(crate) use shaft_shapes::ShaftShape;
pub use speed_profile::{Rotation, SpeedPoint, SpeedProfile};
pub use squeeze_film::SqueezeFilm;
pub(crate) use stability::GrowingMotion;
pub use tabulation::Tabulation;
pub use unbalance::PlaneUnbalance;
pub use unconstrained::{UnconstrainedError, check_constraints, unconstrained_warning};

/// Σ a_i b_i.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
