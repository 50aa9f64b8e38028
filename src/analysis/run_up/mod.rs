//! What a shaft does while its speed changes: short-time spectra, and orders of the shaft's angle.

mod order_tracks;
mod waterfall;

pub use order_tracks::{OrderTracks, Track, TrackPoint, TrackRecorder, TrackedOrder};
pub use waterfall::{Slice, Waterfall, WaterfallRecorder};
