//! From samples to spectra: windows, one-sided amplitudes, peaks and what they are.

mod aliasing;
mod causes;
mod channel;
mod estimation;
mod leakage;
mod line_kind;
mod motion;
mod order_sums;
mod peaks;
mod recording;
mod run_up;
mod spectrum;
mod transform;
mod whole_spectrum;
mod window;

pub use aliasing::{TopPower, rest_amplitude};
pub use causes::{
    BearingFrequencies, Line, Sources, TOLERANCE_BINS, causes, nearest_cause, other_causes,
};
pub use channel::{Channel, column_unit};
pub use estimation::{
    Axis, CrossPower, Detrend, EstimateError, EstimatedSpectrum, Resampling, Scaling, Segment,
    SpectrumColumn, SpectrumKind, SpectrumQuantity, SpectrumRequest, Welch, envelope, estimate,
};
pub use leakage::{Leak, leak};
pub use line_kind::LineKind;
pub use motion::{
    ChannelStatistics, ClosedCurve, Drift, Kind, LONGEST_PERIOD, Moments, Motion, MotionParts,
    MotionRecorder, MotionSettings, PoincarePoint, Recognition, Section, SectionKind, Series,
    VELOCITY_BAND, VelocityLevel, closed_curve, recognise, velocity_level, zero_one_test,
};
pub use peaks::{MOST_PEAKS, Peak};
pub use recording::{Recording, SampleGrid};
pub use run_up::{
    OrderTracks, Slice, Track, TrackPoint, TrackRecorder, TrackedOrder, Waterfall,
    WaterfallRecorder,
};
pub use spectrum::{ChannelSpectrum, Spectrum};
pub use transform::{Transform, fourier_coefficients};
pub use whole_spectrum::Analysis;
pub use window::Window;
