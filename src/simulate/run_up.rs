//! The largest motion of a run whose speed changes.

use serde::Serialize;

use super::Model;
use crate::analysis::Channel;
use crate::rotor::{FREEDOMS, Rotor, Sample};

/// Where a distance from the static equilibrium is largest.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct Extreme {
    /// The distance, m or rad.
    pub amplitude: f64,
    /// When, s.
    #[serde(rename = "time_s")]
    pub time: f64,
    /// Speed of the shaft then, rad/s.
    #[serde(rename = "speed_rad_s")]
    pub speed: f64,
}

/// The largest motion of a run whose speed changes: from the settle time on, or of the whole run where the speed is constant
/// after it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct RunUp {
    /// Distance across the shaft, √(x² + y²), each from its static equilibrium.
    pub radial: Extreme,
    /// Of every freedom that moves.
    #[serde(skip)]
    pub axes: Vec<(Channel, Extreme)>,
    /// Lowest and highest speed, rad/s.
    #[serde(rename = "speeds_rad_s")]
    pub speeds: [f64; 2],
}

/// Takes the samples for a [`RunUp`].
pub(super) struct RunUpRecorder {
    found: RunUp,
    equilibrium: [f64; FREEDOMS],
    start: f64,
}

impl RunUpRecorder {
    /// None where the speed is constant.
    pub fn new(model: &Model, rotor: &Rotor) -> Option<Self> {
        rotor.steady_from(0.0).is_none().then(|| {
            let changes_late = rotor.steady_from(model.settle).is_none();
            let axes = model.rotor.shaft.freedoms.axes().iter();
            Self {
                found: RunUp {
                    radial: Extreme::default(),
                    axes: axes
                        .map(|axis| (Channel::Displacement(*axis), Extreme::default()))
                        .collect(),
                    speeds: [f64::INFINITY, f64::NEG_INFINITY],
                },
                equilibrium: rotor.equilibrium().displacement,
                start: if changes_late { model.settle } else { 0.0 },
            }
        })
    }

    /// Takes a sample.
    pub fn record(&mut self, sample: &Sample) {
        if sample.time < self.start {
            return;
        }
        let (time, speed) = (sample.time, sample.speed);
        let take = |known: &mut Extreme, amplitude: f64| {
            if amplitude > known.amplitude {
                *known = Extreme {
                    amplitude,
                    time,
                    speed,
                };
            }
        };
        let from_rest = |axis: usize| sample.displacement[axis] - self.equilibrium[axis];
        take(&mut self.found.radial, from_rest(0).hypot(from_rest(1)));
        for (channel, known) in &mut self.found.axes {
            if let Channel::Displacement(axis) = channel {
                take(known, from_rest(*axis).abs());
            }
        }
        let [lowest, highest] = self.found.speeds;
        self.found.speeds = [lowest.min(speed), highest.max(speed)];
    }

    /// What was found; none without samples.
    pub fn finish(self) -> Option<RunUp> {
        let [lowest, highest] = self.found.speeds;
        (lowest <= highest).then_some(self.found)
    }
}
