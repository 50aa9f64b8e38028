//! Exponential collocation: the linear part of a system exactly, the nonlinear remainder by a polynomial.
//!
//! ```text
//! y′ = J y + g(t, y),    g(t, y) = f(t, y) − J y
//! y(t + c_i h) = exp(c_i h J) y(t) + h Σ_j a_ij(hJ) g(t + c_j h, y_j)
//! ```
//!
//! with a frozen J. The sums integrate the polynomial through the values of g exactly beside the linear
//! part; sweeps over the points solve for the y_j. A shaft on preloaded bearings oscillates far faster
//! than what drives it, and nearly linearly: g is small and follows the drive, and so do the steps.
//!
//! All this is done in the coordinates of the modes of J, where its functions are numbers. Any J will do, the remainder
//! takes what it lacks: where the modes are no sound basis, as at critical damping, J is a matrix next to the slopes whose
//! modes are.
//!
//! Sources: Hochbruck & Ostermann, *Exponential integrators*, Acta Numerica 19 (2010) 209–286, sec. 2.1
//! (exponential collocation); Buvoli, *SIAM J. Sci. Comput.* 42 (2020) B1–B27 (its solution by sweeps).

mod basis;
mod dense;
mod linear;
mod nodes;
mod plan;
mod propagator;
mod stepper;
mod sweeps;

pub(super) use stepper::ExponentialStepper;
