//! From samples to spectra: windows, one-sided amplitudes, peaks and what they are.

mod aliasing;
mod causes;
mod channel;
mod estimation;
mod kurtogram;
mod leakage;
mod line_kind;
mod motion;
mod noise_floor;
mod order_sums;
mod peaks;
mod recording;
mod run_up;
mod spectrum;
mod transform;
mod whole_spectrum;
mod window;

pub(crate) use aliasing::TopPower;
pub(crate) use causes::other_causes;
pub use causes::{BearingFrequencies, Line, Sources, causes, nearest_cause};
pub use channel::Channel;
pub(crate) use channel::column_unit;
pub use estimation::{
    Axis, Detrend, EstimateError, EstimatedSpectrum, Resampling, Scaling, Segment, SpectrumColumn,
    SpectrumKind, SpectrumQuantity, SpectrumRequest, estimate,
};
#[cfg(test)]
pub(crate) use estimation::{Welch, envelope};
pub(crate) use leakage::{Leak, leak};
pub use line_kind::LineKind;
pub use motion::{
    ChannelStatistics, ClosedCurve, Drift, Kind, Moments, Motion, PoincarePoint, Recognition,
    Section, SectionKind, VelocityLevel,
};
pub(crate) use motion::{LONGEST_PERIOD, MotionParts, MotionRecorder, MotionSettings};
#[cfg(test)]
pub(crate) use motion::{Series, closed_curve, recognise};
pub(crate) use noise_floor::{NoiseFloor, magnitude};
#[cfg(test)]
pub(crate) use peaks::MOST_PEAKS;
pub use peaks::Peak;
pub use recording::{Recording, SampleGrid};
pub use run_up::{OrderTracks, Slice, Track, TrackPoint, TrackedOrder, Waterfall};
pub(crate) use run_up::{TrackRecorder, WaterfallRecorder};
pub use spectrum::{ChannelSpectrum, Spectrum};
pub(crate) use transform::{Transform, fourier_coefficients};
pub use whole_spectrum::Analysis;
pub use window::Window;
