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

pub use chaos::zero_one_test;
pub use closed_curve::{ClosedCurve, closed_curve};
pub use drift::Drift;
pub use moments::Moments;
pub use parts::MotionParts;
pub use period::{Kind, LONGEST_PERIOD, Recognition, Series, recognise};
pub use recorder::{ChannelStatistics, Motion, MotionRecorder, MotionSettings};
pub use section::{PoincarePoint, Section, SectionKind};
pub use velocity::{VELOCITY_BAND, VelocityLevel, velocity_level};
