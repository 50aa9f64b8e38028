//! From samples to spectra: windows, one-sided amplitudes, peaks and what they are.

mod causes;
mod channel;
mod line_kind;
mod peaks;
mod recorder;
mod spectrum;
mod transform;
mod window;

pub use causes::{
    BearingFrequencies, Line, Sources, TOLERANCE_BINS, causes, nearest_cause, other_causes,
};
pub use channel::Channel;
pub use line_kind::LineKind;
pub use peaks::{MOST_PEAKS, Peak};
pub use recorder::{Analysis, Recorder};
pub use spectrum::{ChannelSpectrum, Spectrum};
pub use transform::{Transform, fourier_coefficients};
pub use window::Window;
