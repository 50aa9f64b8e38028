//! From samples to spectra: windows, one-sided amplitudes, peaks and what they are.

pub(crate) mod causes;
mod channel;
mod channel_name;
pub(crate) mod estimation;
mod hermite;
mod kurtogram;
mod line_kind;
mod motion;
mod noise_floor;
mod order_tracks;
mod peaks;
pub(crate) mod recording;
mod rotor_channels;
mod sampling_errors;
mod spectrum;
mod transform;
mod waterfall;
mod window;

pub use causes::Line;
pub(crate) use causes::other_causes;
pub(crate) use causes::{
    BearingFrequencies, LineSurfaces, Precision, Sources, causes, nearest_cause,
};
pub(crate) use channel::BodyQuantity;
pub use channel::{Channel, Part};
pub(crate) use estimation::estimate;
pub(crate) use estimation::{
    Axis, Detrend, EstimateError, Resampling, Scaling, Segment, SpectrumKind, SpectrumRequest,
};
pub use estimation::{EnvelopeLine, EstimatedSpectrum, SpectrumColumn, SpectrumQuantity};
#[cfg(test)]
pub(crate) use estimation::{Envelopes, Welch};
use hermite::Hermite;
pub use line_kind::{Characteristic, LineKind};
pub(crate) use motion::{ChannelLevel, Section, SectionKind, VelocityLevel};
pub use motion::{ChannelStatistics, Drift, Kind, Moments, Motion, Recognition};
pub(crate) use motion::{LONGEST_PERIOD, MotionRecorder, MotionSettings};
pub(crate) use motion::{LevelRecorder, Rate, velocity_rate};
#[cfg(test)]
pub(crate) use motion::{Series, closed_curve, recognise};
pub(crate) use noise_floor::{NoiseFloor, is_above_noise, magnitude, noise_around};
pub(crate) use order_tracks::TrackRecorder;
pub use order_tracks::{OrderTracks, Track, TrackPoint, TrackedOrder};
#[cfg(test)]
pub(crate) use peaks::MOST_PEAKS;
pub use peaks::Peak;
pub(crate) use recording::{Recording, SampleGrid};
use sampling_errors::Leak;
pub(crate) use sampling_errors::{ChannelCheck, TopPower, leak};
pub(crate) use spectrum::Analysis;
pub use spectrum::{ChannelSpectrum, Spectrum};
pub(crate) use transform::{Transform, fourier_coefficients};
pub(crate) use waterfall::WaterfallRecorder;
pub use waterfall::{Slice, Waterfall};
pub use window::Window;
