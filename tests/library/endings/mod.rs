//! Runs that cannot go on: what is said of them, and that they end.

mod stiff;
mod unconstrained;
