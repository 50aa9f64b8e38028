//! Spectra as people of signal processing ask for them: scalings, windows, averages, orders,
//! envelopes, whirls, cross spectra.

mod angle_grid;
mod detrend;
mod envelope;
mod error;
mod estimated;
mod estimator;
mod interpolation;
mod request;
mod scaling;
mod unit;
mod welch;

pub use detrend::Detrend;
pub use envelope::envelope;
pub use error::EstimateError;
pub use estimated::{EstimatedSpectrum, Resampling, SpectrumColumn, SpectrumQuantity};
pub use estimator::estimate;
pub use request::{Axis, Segment, SpectrumKind, SpectrumRequest};
pub use scaling::Scaling;
pub use welch::Welch;
