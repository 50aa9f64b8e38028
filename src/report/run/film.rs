//! The end of a run as a page shows it in motion: the shaft and every ball with its load.

use std::collections::VecDeque;
use std::f64::consts::TAU;

use serde_json::{Value, json};

use crate::bearing::Support;
use crate::report::figure::narrow;
use crate::report::terminal::{MICRO, MILLI};
use crate::rotor::{BallContacts, RotorDefinition, Sample};
use crate::simulate::LAST_BALLS;

/// Most frames that are shown.
const MOST_FRAMES: usize = 240;
/// Angle of the shaft that is shown, rad: two revolutions.
const SHOWN: f64 = 2.0 * TAU;

/// The last samples of a run with the loads of their balls.
#[derive(Debug, Clone, Default)]
pub(super) struct Film {
    samples: VecDeque<(Sample, Vec<f32>)>,
}

impl Film {
    /// Takes a sample with its balls.
    pub fn take(&mut self, sample: &Sample, balls: &BallContacts) {
        if self.samples.len() == LAST_BALLS {
            self.samples.pop_front();
        }
        let inner = balls.bearings().iter().flat_map(|balls| &balls.load[0]);
        let loads = inner.map(|load| *load as f32).collect();
        self.samples.push_back((sample.without_bearings(), loads));
    }

    /// Times in s, angles in rad, displacements in µm and µrad, and of every bearing its sizes in mm, how its cage turns
    /// and the loads of its balls at the inner race in N; none of a run without samples.
    pub fn json(&self, rotor: &RotorDefinition) -> Option<Value> {
        let last = self.samples.back()?.0.angle;
        let shown = self.samples.iter();
        let shown = shown.filter(|(sample, _)| sample.angle >= last - SHOWN);
        let shown: Vec<_> = shown.collect();
        let every = shown.len().div_ceil(MOST_FRAMES);
        let frames: Vec<_> = shown.into_iter().step_by(every.max(1)).collect();
        let of =
            |value: &dyn Fn(&Sample) -> f64| narrow(frames.iter().map(|(sample, _)| value(sample)));
        let displacements = (0..5).map(|axis| of(&|sample| MICRO * sample.displacement[axis]));
        let mut first = 0;
        let observed = rotor.flexible.as_ref().map_or(0.0, |shaft| shaft.observed);
        let supports = rotor.rolling_supports().unwrap_or_default();
        let cages = supports.iter().map(Support::cage_ratio);
        let bearings = rotor.bearings.iter().zip(cages).map(|(bearing, cage)| {
            let geometry = &bearing.bearing.geometry;
            let known = frames[0].1.len() >= first + geometry.all_balls();
            let balls = if known { geometry.all_balls() } else { 0 };
            let range = first..first + balls;
            let loads = frames.iter().flat_map(|(_, loads)| &loads[range.clone()]);
            let bearing = json!({
                // from the point that the displacements are of
                "position": MILLI * (bearing.position - observed),
                "pitch": MILLI * geometry.pitch_diameter(),
                "ball": MILLI * geometry.ball_diameter(),
                "balls": geometry.balls(),
                "rows": geometry.rows(),
                // length of a roller; a ball has none
                "length": geometry.rollers().map_or(0.0, |own| MILLI * own.length),
                "firstBall": bearing.first_ball,
                "cage": cage,
                "loads": (balls > 0).then(|| narrow(loads.map(|load| f64::from(*load)))),
            });
            first += balls;
            bearing
        });
        Some(json!({
            "bearings": bearings.collect::<Value>(),
            // as differences, for the time may be long compared with a revolution
            "start": frames[0].0.time,
            "times": of(&|sample| sample.time - frames[0].0.time),
            "angles": of(&|sample| sample.angle - frames[0].0.angle),
            "startAngle": frames[0].0.angle,
            "displacements": displacements.collect::<Value>(),
        }))
    }
}
