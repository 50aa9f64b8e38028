//! A ball law compiled into a table of polynomials.
//!
//! `chart` gives the coordinates in which a law is smooth: a `loaded_chart` where no ball lifts off, a
//! `lifting_chart` across lift-off. `limits` says how far they reach, `region` where balls may come.
//! `compile` fills the `cells` from the exact law, whose evaluations `counted` counts, by `polynomial`
//! interpolation of its `reduced` forces, and says what came of it in a `report`; `strips` divide the approach.
//! `ball_table` looks balls up, four `side_by_side`, and `law` is the law that the table stands for.

mod ball_table;
mod cells;
mod chart;
mod compile;
mod counted;
mod law;
mod lifting_chart;
mod limits;
mod loaded_chart;
mod polynomial;
mod reduced;
mod region;
mod report;
mod side_by_side;
mod strips;

pub(super) use ball_table::{BallTable, Located};
pub(super) use chart::{Chart, Coordinates};
pub use law::TableLaw;
pub use region::BallRegion;
pub use report::{TableError, TableReport};
