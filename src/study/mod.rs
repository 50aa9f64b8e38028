//! Many questions in a row: one number of a scenario takes many values; one scene is run by many methods
//! and in many configurations.

pub(crate) mod accuracy;
pub(crate) mod campbell;
mod contact_choice;
mod contact_points;
mod critical_speeds;
mod fidelity;
pub(crate) mod linear_response;
pub(crate) mod many;
pub(crate) mod plan;
mod resonance_places;

pub(crate) use contact_choice::{
    ContactChoice, ContactQuestion, FidelityDifference, choose_contact,
};
pub(crate) use fidelity::Fidelity;
pub(crate) use plan::Variable;

pub use crate::quasi_static::{QuasiStatic, StaticQuestion, quasi_static};
pub use crate::rotor::{Equilibrium, EquilibriumError};
