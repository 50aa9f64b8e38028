//! From samples to spectra: windows, one-sided amplitudes, peaks and what they are.

mod peaks;
mod spectrum;

pub use peaks::{Line, LineKind, Peak};
pub use spectrum::{Channel, ChannelSpectrum, Spectrum, Window};
