//! An explicit Runge–Kutta pair whose steps end at breaks of the system, on event surfaces where crossing them
//! would spoil a step, and nowhere else.

#[cfg(test)]
mod conditions_tests;
mod crossing;
mod dense;
mod foresight;
mod landing;
mod plan;
mod stepper;
mod substitution;
mod verner76;

pub(super) use stepper::ExplicitStepper;
pub(super) use verner76::STABILITY;
