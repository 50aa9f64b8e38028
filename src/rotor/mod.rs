//! The shaft as a concentrated mass: freedoms, unbalance, loads, damping, supports.

mod definition;
mod sample;

pub use definition::{
    CageMotion, Damping, FREEDOMS, Freedoms, InitialPosition, InitialState, RotorDefinition,
    STANDARD_GRAVITY, Shaft,
};
pub use sample::Sample;
