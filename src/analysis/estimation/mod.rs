//! Spectra as people of signal processing ask for them: scalings, windows, averages, orders,
//! envelopes, whirls, cross spectra.

mod estimated;
mod estimator;
mod interpolation;
mod request;
mod welch;

pub use estimated::{EstimatedSpectrum, Resampling, SpectrumColumn, SpectrumQuantity};
pub use estimator::estimate;
pub use request::{Axis, EstimateError, Scaling, Segment, SpectrumKind, SpectrumRequest};
pub use welch::{Detrend, Welch, envelope};
