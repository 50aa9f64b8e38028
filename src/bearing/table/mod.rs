//! A ball law compiled into a table of polynomials.
//!
//! `chart` gives the coordinates in which a law is smooth, `polynomial` the interpolation, `strips`
//! the division along the approach, `compile` fills the cells from the exact law, `law` evaluates
//! them, `region` says where balls may come.

mod chart;
mod compile;
mod law;
mod polynomial;
mod region;
mod strips;

pub use compile::{TableError, TableReport};
pub use law::TableLaw;
pub use region::BallRegion;
