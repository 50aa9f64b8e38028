//! A ball law compiled into a table of polynomials: `ball_table`.
//!
//! `chart` gives the coordinates in which a law is smooth across lift-off, `region` where balls may come. An even
//! `grid` divides the range of the coordinates into `cells`, in each of which the forces are polynomials through
//! values at the nodes of `interpolation`. `compile` divides more and more finely, from `draft` to draft, until
//! the measured error is small enough, and says in a `report` what came of it.

mod ball_table;
mod cells;
mod chart;
mod compile;
mod draft;
mod grid;
mod interpolation;
mod region;
mod report;

pub use ball_table::BallTable;
pub use region::BallRegion;
pub use report::{TableError, TableReport};
