//! From samples to spectra: windows, one-sided amplitudes, peaks and what they are.

mod causes;
mod channel;
mod peaks;
mod recorder;
mod spectrum;
mod transform;
mod window;

pub use causes::{Line, LineKind, causes, nearest_cause};
pub use channel::Channel;
pub use peaks::{MOST_PEAKS, Peak};
pub use recorder::{Analysis, Recorder};
pub use spectrum::{ChannelSpectrum, Spectrum};
pub use transform::{Transform, fourier_coefficients};
pub use window::Window;
