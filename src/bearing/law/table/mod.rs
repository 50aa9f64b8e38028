//! A ball law compiled into a table of polynomials: `ball_table`.
//!
//! `chart` says where balls may come and gives the coordinates in which a law is smooth across lift-off. An even grid
//! divides the range of the coordinates into `cells`, in each of which the forces are polynomials through values at
//! nodes. `compile` divides more and more finely, until the measured error is small enough.

mod ball_table;
mod cells;
mod chart;
mod compile;
mod roller_cells;

pub use ball_table::BallTable;
pub use chart::BallRegion;
pub use compile::{TableError, TableReport};
pub(super) use roller_cells::RollerCells;
