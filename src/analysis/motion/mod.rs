//! What a steady motion is like: statistics, points once per revolution and per ball pass, its period,
//! and whether it has settled.

mod closed_curve;
mod moments;
mod period;
mod recorder;
mod section;

pub use closed_curve::ClosedCurve;
#[cfg(test)]
pub use closed_curve::closed_curve;
pub use moments::{Drift, Moments, VelocityLevel};
pub use period::{Kind, LONGEST_PERIOD, Recognition};
#[cfg(test)]
pub use period::{Series, recognise};
pub use recorder::{ChannelStatistics, Motion, MotionParts, MotionRecorder, MotionSettings};
pub use section::{PoincarePoint, Section, SectionKind};
