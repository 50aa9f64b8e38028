//! From samples to spectra: windows, one-sided amplitudes, peaks and what they are.

mod causes;
mod channel;
pub(crate) mod estimation;
mod hermite;
mod kurtogram;
mod line_kind;
mod motion;
mod noise_floor;
mod order_tracks;
mod peaks;
pub(crate) mod recording;
mod sampling_errors;
mod spall_signal;
mod spectrum;
mod transform;
mod waterfall;
mod window;

pub(crate) use causes::other_causes;
pub use causes::{
    BearingFrequencies, Line, LineSurfaces, Precision, Sources, causes, nearest_cause,
};
pub use channel::Channel;
pub(crate) use channel::column_unit;
pub(crate) use estimation::estimate;
pub use estimation::{
    Axis, Detrend, EnvelopeLine, EstimateError, EstimatedSpectrum, Resampling, Scaling, Segment,
    SpectrumColumn, SpectrumKind, SpectrumQuantity, SpectrumRequest,
};
#[cfg(test)]
pub(crate) use estimation::{Welch, envelope};
use hermite::Hermite;
pub use line_kind::LineKind;
pub use motion::{
    ChannelLevel, ChannelStatistics, ClosedCurve, Drift, Kind, Moments, Motion, PoincarePoint,
    Recognition, Section, SectionKind, VelocityLevel,
};
pub(crate) use motion::{LONGEST_PERIOD, MotionRecorder, MotionSettings};
#[cfg(test)]
pub(crate) use motion::{Series, closed_curve, recognise};
pub(crate) use noise_floor::{NoiseFloor, magnitude};
pub(crate) use order_tracks::TrackRecorder;
pub use order_tracks::{OrderTracks, Track, TrackPoint, TrackedOrder};
#[cfg(test)]
pub(crate) use peaks::MOST_PEAKS;
pub use peaks::Peak;
pub(crate) use recording::{Recording, SampleGrid};
pub(crate) use sampling_errors::{Leak, TopPower, leak};
pub(crate) use spall_signal::SpallRecorder;
pub use spall_signal::{SpallInstants, SpallSignal};
pub(crate) use spectrum::Analysis;
pub use spectrum::{ChannelSpectrum, Spectrum};
pub(crate) use transform::{Transform, fourier_coefficients};
pub(crate) use waterfall::WaterfallRecorder;
pub use waterfall::{Slice, Waterfall};
pub use window::Window;
