//! From a derivative to states on a time grid, with error control.

mod settings;

pub use settings::{Counters, Method, Settings};
