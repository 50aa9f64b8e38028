//! Units that results are shown in: how many of them make one of the SI unit.

/// m → µm, rad → µrad.
pub(super) const MICRO: f64 = 1e6;
/// s → ms, rad → mrad, m/s → mm/s, N m → N mm.
pub(super) const MILLI: f64 = 1e3;
/// rad/s → revolutions a minute.
pub(super) const PER_MINUTE: f64 = 30.0 / std::f64::consts::PI;
/// rad/s → Hz.
pub(super) const PER_SECOND: f64 = 0.5 / std::f64::consts::PI;
