//! A ball law compiled into a table of polynomials.
//!
//! `chart` gives the coordinates in which a law is smooth, `limits` how far they reach, `polynomial` the
//! interpolation, `strips` the division along the approach, `compile` fills the cells from the exact
//! law, whose evaluations `counted` counts, `law` evaluates them, four balls `side_by_side`, `region`
//! says where balls may come.

mod chart;
mod compile;
mod counted;
mod law;
mod limits;
mod polynomial;
mod region;
mod side_by_side;
mod strips;

pub use compile::{TableError, TableReport};
pub(super) use law::Located;
pub use law::TableLaw;
pub use region::BallRegion;
