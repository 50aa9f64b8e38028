//! What the benches of this crate measure from inside: for them alone, without any promise.

pub use crate::analysis::estimation::estimate;
pub use crate::analysis::recording::{Recording, SampleGrid};
pub use crate::bearing::definition::MountedBearing;
pub use crate::bearing::law::{
    Ball, BallLaw, ContactLaw, ForceLaw, HertzFilmLaw, HertzLaw, JonesFilmLaw, JonesLaw,
};
pub use crate::bearing::ring::Ring;
pub use crate::bearing::rotation::BearingRotation;
pub use crate::bearing::support::Support;
pub use crate::bearing::surface::Imperfections;
pub use crate::integrate::System;
pub use crate::report::run_tables::trace_columns;
#[cfg(feature = "parquet")]
pub use crate::report::table::ParquetTable;
pub use crate::report::table::{CsvTable, MatTable, Origin};
pub use crate::rotor::{MotionScale, Rotor, StaticProblem};
pub use crate::scenario::key::time;
pub use crate::simulate::passes::BareRun;
