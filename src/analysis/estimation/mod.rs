//! Spectra as people of signal processing ask for them: scalings, windows, averages, orders,
//! envelopes, whirls, cross spectra.

mod estimator;
mod interpolation;
mod request;
mod welch;

pub use estimator::estimate;
pub use request::{
    Axis, EstimateError, EstimatedSpectrum, Resampling, Scaling, Segment, SpectrumColumn,
    SpectrumKind, SpectrumQuantity, SpectrumRequest,
};
pub use welch::{Detrend, Welch, envelope};
