//! The tables of a scenario file: plain structs that mirror the text, the
//! descriptions that editors show, and what each table becomes in the model.

mod arrangement;
mod ball_bearing;
mod ball_sizes;
mod bearing;
mod channel_name;
mod components;
mod contradictions;
mod damping;
mod disc;
mod element;
mod fit;
mod flexible;
mod geometry;
mod held;
mod identity;
mod imperfections;
mod load;
mod material;
mod measured;
mod oil;
mod output;
mod questions;
mod random_load;
mod ratings;
mod record;
mod recorded;
mod roller;
mod rotor;
mod scenario;
mod settings;
mod shaft;
mod spectrum;
mod speed;
mod support;
mod unbalance;

pub use output::{Output, TableFormat, Turning};
pub use questions::Questions;
pub use ratings::RatingsInput;
pub use record::{RecordFileInput, RecordInput, RecordSpeedInput, SignalInput};
pub use recorded::Recorded;
pub use scenario::ScenarioInput;
pub use spectrum::build as build_spectra;

/// What a key is that is not given.
fn number<const NUMBER: u32>() -> u32 {
    NUMBER
}
