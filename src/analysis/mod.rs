//! From samples to spectra: windows, one-sided amplitudes, peaks and what they are.

mod aliasing;
mod causes;
mod channel;
mod estimation;
mod leakage;
mod peaks;
mod recorder;
mod spectrum;
mod transform;
mod window;

pub use aliasing::{TopPower, rest_amplitude};
pub use causes::{Line, LineKind, causes, nearest_cause};
pub use channel::Channel;
pub use estimation::{
    Axis, CrossPower, Detrend, EstimateError, EstimatedSpectrum, Recording, Resampling, SampleGrid,
    Scaling, Segment, SpectrumColumn, SpectrumKind, SpectrumQuantity, SpectrumRequest, Welch,
    envelope, estimate,
};
pub use leakage::{Leak, leak};
pub use peaks::{MOST_PEAKS, Peak};
pub use recorder::{Analysis, Recorder};
pub use spectrum::{ChannelSpectrum, Spectrum};
pub use transform::{Transform, fourier_coefficients};
pub use window::Window;
