//! Exponential collocation: the linear part of a system exactly, the nonlinear remainder by a polynomial.
//!
//! ```text
//! y′ = J y + g(t, y),    g(t, y) = f(t, y) − J y
//! y(t + c_i h) = exp(c_i h J) y(t) + h Σ_j a_ij(hJ) g(t + c_j h, y_j)
//! ```
//!
//! with a frozen J. The sums integrate the polynomial through the values of g exactly together with the linear
//! part; sweeps over the points solve for the y_j. A shaft on preloaded bearings oscillates far faster
//! than what drives it, and nearly linearly: g is small and follows the drive, and so do the steps.
//!
//! All this is done in the coordinates z of the modes of J, y = V z with J V = V Λ, where its functions are numbers. A step
//! of the size h is
//!
//! ```text
//! z_i = E_i z + Σ_j A_ij g_j,   g_j = V⁻¹ g(t + c_j h, V z_j)        E_i = exp(c_i h Λ)
//! ```
//!
//! with the E_i and A_ij of `propagator.rs`, the g_j of `remainder.rs`, and the solution for the z_i by the sweeps of
//! `sweeps.rs`. Where the system knows that its remainder depends on few states and is made of few forces, the sweeps go over
//! these alone, whatever the number of modes: `force_operator.rs` and `force_sweeps.rs`. Changes of a start go through the
//! same step, in `slopes.rs`.
//!
//! Any J will do, the remainder takes what it lacks: where the modes are no sound basis, as at critical damping, J is a
//! matrix next to the slopes whose modes are.
//!
//! Sources: Hochbruck & Ostermann, *Exponential integrators*, Acta Numerica 19 (2010) 209–286, sec. 2.1
//! (exponential collocation); Buvoli, *SIAM J. Sci. Comput.* 42 (2020) B1–B27 (its solution by sweeps).

mod basis;
mod dense;
mod force_operator;
mod force_sweeps;
mod functions;
mod linear;
mod matrix;
mod nodes;
mod plan;
mod propagator;
mod remainder;
mod slopes;
mod stepper;
mod sweeps;

pub(super) use stepper::{ExponentialStepper, PreparedSteps};
