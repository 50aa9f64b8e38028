//! The stair past the wait: a [`Model`](crate::simulate::Model) goes in, the motion that it settles to comes out, found directly
//! instead of waiting for the start to die. No files, no clock, no printing.
//!
//! [`steady`] finds the motion of a scene, [`response`] follows it along a parameter.

mod basis;
mod error;
mod flight;
mod lines;
mod motion;
mod places;
mod response;
mod rotor_map;
mod search;
mod swing;

pub use basis::Base;
pub(crate) use basis::bases;
pub use error::SteadyError;
pub use lines::{SteadyLine, SteadyLines};
pub use motion::{Measured, Steady, SteadyQuestion, steady};
pub use response::{Response, ResponsePoint, ResponseQuestion, response};
pub use swing::Swing;

pub use crate::shooting::{Multipliers, SpecialKind};
