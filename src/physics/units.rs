//! Units besides those of the SI.

use std::f64::consts::PI;

/// Revolutions a minute in a rad/s.
pub const PER_MINUTE: f64 = 30.0 / PI;
