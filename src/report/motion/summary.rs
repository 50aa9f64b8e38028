//! A steady motion in the summary.

use serde::Serialize;

use crate::analysis::{Channel, Drift, Kind, Motion};

/// Everything about a steady motion but its points.
#[derive(Debug, Serialize)]
pub(in super::super) struct MotionSummary<'a> {
    #[serde(flatten)]
    motion: &'a Motion,
    settling: Option<Settling<'a>>,
}

/// Whether a motion has settled.
#[derive(Debug, Serialize)]
struct Settling<'a> {
    meaning: &'static str,
    channel: &'static str,
    #[serde(flatten)]
    drift: &'a Drift,
    /// Not known of an irregular motion, whose statistics move by themselves.
    settled: Option<bool>,
}

impl<'a> From<&'a Motion> for MotionSummary<'a> {
    fn from(motion: &'a Motion) -> Self {
        let irregular = matches!(motion.recognition.kind, Kind::Irregular { .. });
        let settling = |drift: &'a Drift| Settling {
            meaning: "change of mean and RMS from the second to the last third, in parts of the RMS of \
                      the motion, of the freedom that changes most",
            channel: Channel::Displacement(drift.freedom).name(),
            drift,
            settled: (!irregular).then(|| drift.is_settled()),
        };
        Self {
            motion,
            settling: motion.drift.as_ref().map(settling),
        }
    }
}
