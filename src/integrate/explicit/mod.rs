//! Explicit Runge–Kutta pairs on states of fixed size: no allocation, no time carried as a state,
//! and steps that end at breaks of the system and nowhere else.

mod aim;
#[cfg(test)]
mod conditions;
mod crossing;
mod dense;
mod foresight;
mod landing;
mod quintic;
mod substitution;
mod tableau;
mod verner76;
mod walk;

pub(super) use tableau::Pair;
pub(super) use verner76::Verner76;
pub(super) use walk::Walk;
