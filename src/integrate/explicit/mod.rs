//! Steps of an explicit Runge–Kutta pair that end at breaks of the system, on event surfaces where crossing them
//! would spoil a step, and nowhere else.

mod crossing;
mod plan;
mod stepper;
mod verner76;

pub(super) use stepper::ExplicitStepper;
