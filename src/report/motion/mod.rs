//! A steady motion: points of its sections, its orbit, and what it is like.

mod orbit_figure;
mod poincare_table;
mod summary;
mod text;

pub(super) use orbit_figure::orbit_figure;
pub(super) use poincare_table::write_poincare;
pub(super) use summary::MotionSummary;
pub(super) use text::put_motion;
