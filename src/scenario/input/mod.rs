//! The tables of a scenario file: plain structs that mirror the text, the
//! descriptions that editors show, and what each table becomes in the model.

mod bearing;
mod cage_jitter;
mod components;
mod damping;
mod defect;
mod fit;
mod flexible;
mod geometry;
mod housing;
mod linear;
mod load;
mod machine;
mod oil;
mod output;
mod ratings;
mod scenario;
mod settings;
mod shaft;
mod spectrum;
mod speed;
mod study;
mod unbalance;
mod waviness;

pub use output::{Output, TableFormat};
pub use ratings::RatingsInput;
pub use scenario::{Questions, ScenarioInput};
