//! The tables of a scenario file, one a file: plain structs that mirror the text, the
//! descriptions that editors show, and what each table becomes in the model.

mod axial;
mod bearing;
mod components;
mod damping;
mod drive;
mod geometry;
mod initial;
mod integrator;
mod load;
mod material;
mod model;
mod oil;
mod output;
mod scenario;
mod set;
mod shaft;
mod spectrum;
mod speed;
mod statics;
mod study;
mod time;
mod torsion;
mod written;

pub use output::Output;
pub use scenario::{Questions, ScenarioInput};
pub use written::TableFormat;
