//! A ball law compiled into a table of polynomials.
//!
//! `chart` gives the coordinates in which a law is smooth: a `loaded_chart` where no ball lifts off, a
//! `lifting_chart` across lift-off. `limits` says how far they reach, `region` where balls may come.
//! `compile` makes a table from the exact law, whose evaluations `counted` counts, and says what came of it in a
//! `report`: by `polynomial` interpolation of its `reduced` forces, `dividing` the approach into strips and these
//! `across` into `cells`. A `division` finds the cells again, by `even_strips` or by `strips` of unequal width.
//! `ball_table` looks balls up, four `side_by_side`, and `law` is the law that the table stands for.

mod across;
mod ball_table;
mod cells;
mod chart;
mod compile;
mod counted;
mod dividing;
mod division;
mod even_strips;
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
pub(super) use division::{Division, Search};
pub use law::TableLaw;
pub use region::BallRegion;
pub use report::{TableError, TableReport};
