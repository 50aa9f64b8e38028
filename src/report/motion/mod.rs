//! A steady motion: points of its sections, its orbit, and what it is like.

mod json;
mod orbit_figure;
mod poincare_csv;
mod text;

pub(super) use json::motion_json;
pub(super) use orbit_figure::orbit_figure;
pub(super) use poincare_csv::write_poincare;
pub(super) use text::write_motion;
