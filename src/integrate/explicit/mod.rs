//! Explicit Runge–Kutta pairs whose steps end at breaks of the system, on event surfaces where crossing them
//! would spoil a step, and nowhere else.

#[cfg(test)]
mod conditions_tests;
mod crossing;
mod dense;
mod landing;
mod pair;
mod plan;
mod stepper;
mod substitution;
mod verner76;

use super::Method;
use super::problem::Problem;
use super::stepper::{MethodStepper, Start};
use stepper::ExplicitStepper;
use verner76::Verner76;

/// The stepper of a method that is an explicit pair.
pub(super) fn stepper(
    method: Method,
    problem: &Problem<'_>,
    start: &Start,
) -> Option<Box<dyn MethodStepper>> {
    match method {
        Method::Verner76 => Some(Box::new(ExplicitStepper::<Verner76>::new(problem, start))),
        _ => None,
    }
}
