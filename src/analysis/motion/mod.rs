//! What a steady motion is like: statistics, points once per revolution and per ball pass, its period,
//! and whether it has settled.

mod chaos;
mod closed_curve;
mod drift;
mod hermite;
mod moments;
mod parts;
mod period;
mod recorder;
mod section;
mod velocity;

pub use closed_curve::ClosedCurve;
#[cfg(test)]
pub use closed_curve::closed_curve;
pub use drift::Drift;
pub use moments::Moments;
pub use parts::MotionParts;
pub use period::{Kind, LONGEST_PERIOD, Recognition};
#[cfg(test)]
pub use period::{Series, recognise};
pub use recorder::{ChannelStatistics, Motion, MotionRecorder, MotionSettings};
pub use section::{PoincarePoint, Section, SectionKind};
pub use velocity::VelocityLevel;
