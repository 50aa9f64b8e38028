//! What the benches of this crate measure from inside, and what its Python package calls: for them alone, without any
//! promise.

pub use crate::analysis::causes::{BearingFrequencies, Sources, causes, nearest_cause};
pub use crate::analysis::estimation::{
    Axis, Detrend, EstimateError, Scaling, Segment, SpectrumKind, SpectrumRequest, estimate,
};
pub use crate::analysis::recording::{Recording, SampleGrid};
pub use crate::bearing::definition::MountedBearing;
pub use crate::bearing::law::{
    Ball, BallLaw, ContactLaw, ForceLaw, HertzFilmLaw, HertzLaw, JonesFilmLaw, JonesLaw,
};
pub use crate::bearing::ring::Ring;
pub use crate::bearing::rotation::BearingRotation;
pub use crate::bearing::support::Support;
pub use crate::integrate::System;
pub use crate::report::run::tables::trace_columns;
#[cfg(feature = "parquet")]
pub use crate::report::table::ParquetTable;
pub use crate::report::table::{CsvTable, Origin};
pub use crate::rotor::{Freedoms, MotionScale, Rotor, StaticProblem};
pub use crate::scenario::document::written;
pub use crate::scenario::fit_file::{load_fit, parse_fit};
pub use crate::scenario::study_file::{StudyFile, load_study, parse_study};
pub use crate::scenario::typed::{frequency, method, position, speed, time, tolerance};
pub use crate::simulate::bare_run::BareRun;
pub use crate::study::many::Shard;
pub use crate::table::{Column, ColumnKind, Table};
