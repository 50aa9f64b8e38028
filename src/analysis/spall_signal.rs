//! The time between entry and impact of a spall, measured in the acceleration of the shaft.
//!
//! Accelerations towards the defect are averaged over the passes of the balls at equal places of these, as synchronous
//! averages are: samples of many passes resolve one of them finer than the sampling does. Where a ball enters, the
//! acceleration leaves a straight line as a parabola does; where it strikes the far edge, its slope falls the most.

use nalgebra::{Matrix3, Vector3};
use serde::Serialize;

use crate::bearing::RacePass;
use crate::rotor::Sample;

/// Bins in the time from entry to impact, and fewest of them.
const BINS: f64 = 40.0;
const FEWEST_BINS: f64 = 8.0;
/// Samples that a bin is to have.
const SAMPLES: f64 = 4.0;
/// Part of the time from entry to impact over which slopes are taken on either side of the impact.
const SLOPES_OVER: f64 = 0.6;
/// Times from entry to impact around the known impact in which the measured one is sought.
const SOUGHT_IN: f64 = 2.0;
/// Where the entry is sought: times from entry to impact before the impact.
const ENTRY_IN: [f64; 2] = [1.5, 0.65];
/// Instants of an entry that are tried.
const TRIALS: u32 = 160;
/// A parabola leaves the line where it makes the squares of the errors less by this factor.
const LEAVES: f64 = 4.0;

/// What the signal of one spall shows, averaged over the passes of its balls. Times count from the known impact.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct SpallSignal {
    /// Number of the bearing, from 1.
    pub bearing: usize,
    /// `the outer race` or `the inner race`.
    pub on: String,
    /// Of its middle, rad.
    #[serde(rename = "angle_rad")]
    pub angle: f64,
    /// Length along the race, m.
    #[serde(rename = "length_m")]
    pub length: f64,
    /// Ball passes that were averaged.
    pub passes: f64,
    /// Time from entry to impact by kinematics, s.
    #[serde(rename = "entry_to_impact_s")]
    pub known: f64,
    /// The same as measured; none where the signal does not show the spall.
    #[serde(flatten)]
    pub measured: Option<SpallInstants>,
    /// Acceleration towards the spall in m/s² over the time in s of one pass.
    #[serde(skip)]
    pub signal: Vec<(f64, f64)>,
}

/// Instants found in a signal, s from the known impact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SpallInstants {
    /// Start of the parabola.
    #[serde(rename = "measured_entry_s")]
    pub entry: f64,
    /// Largest fall of the slope.
    #[serde(rename = "measured_impact_s")]
    pub impact: f64,
    /// From one to the other.
    #[serde(rename = "measured_entry_to_impact_s")]
    pub apart: f64,
    /// How much longer that is than the known time, as a part of it.
    pub deviation: f64,
}

/// Averages the signal of one spall.
#[derive(Debug, Clone)]
pub(crate) struct SpallRecorder {
    bearing: usize,
    pass: RacePass,
    cage_ratio: f64,
    /// Angular speed, rad/s.
    speed: f64,
    settle: f64,
    /// Sums of places and accelerations, and how many.
    bins: Vec<([f64; 2], u32)>,
    first_angle: Option<f64>,
    last_angle: f64,
}

impl SpallRecorder {
    /// Of a shaft of constant speed in rad/s behind the settle time, with `samples` to come; none where they do not resolve
    /// the pass, or no ball passes.
    pub fn new(
        bearing: usize,
        pass: RacePass,
        cage_ratio: f64,
        speed: f64,
        [settle, samples]: [f64; 2],
    ) -> Option<Self> {
        let part = pass.half_angle() / pass.middle.period;
        let bins = (BINS / part).min(samples / SAMPLES);
        let resolves = bins * part >= FEWEST_BINS && speed > 0.0;
        (resolves && pass.middle.rate(cage_ratio) != 0.0).then(|| Self {
            bearing,
            pass,
            cage_ratio,
            speed,
            settle,
            bins: vec![([0.0; 2], 0); bins as usize],
            first_angle: None,
            last_angle: 0.0,
        })
    }

    /// Takes a sample.
    pub fn record(&mut self, sample: &Sample) {
        let Some(acceleration) = sample.acceleration.filter(|_| sample.time >= self.settle) else {
            return;
        };
        // it turns with the ring that it is on
        let towards = self.pass.angle - self.pass.middle.by_shaft * sample.angle;
        let [x, y, _, tilt_x, tilt_y] = acceleration;
        let (sin, cos) = towards.sin_cos();
        let position = self.pass.position;
        let value = (x + tilt_y * position) * cos + (y - tilt_x * position) * sin;
        let middle = &self.pass.middle;
        let rate = middle.rate(self.cage_ratio);
        let passed = (middle.offset + rate * sample.angle) / middle.period.copysign(rate);
        let place = (passed + 0.5).rem_euclid(1.0);
        let bin = (place * self.bins.len() as f64) as usize;
        let Some((sums, count)) = self.bins.get_mut(bin) else {
            return;
        };
        sums[0] += place - 0.5;
        sums[1] += value;
        *count += 1;
        self.first_angle.get_or_insert(sample.angle);
        self.last_angle = sample.angle;
    }

    /// What the signal shows.
    pub fn finish(self) -> Option<SpallSignal> {
        let period = self.pass.middle.period;
        let rate = self.pass.middle.rate(self.cage_ratio).abs();
        let time_of_pass = period / (rate * self.speed);
        let known = self.pass.half_angle() / (rate * self.speed);
        let filled = self.bins.iter().filter(|(_, count)| *count > 0);
        let signal: Vec<_> = filled
            .map(|(sums, count)| {
                let [place, value] = sums.map(|sum| sum / f64::from(*count));
                (place * time_of_pass, value)
            })
            .collect();
        let turned = self.last_angle - self.first_angle?;
        Some(SpallSignal {
            bearing: self.bearing + 1,
            on: self.pass.on.to_string(),
            angle: self.pass.angle,
            length: self.pass.length,
            passes: turned * rate / period,
            known,
            measured: instants(&signal, known),
            signal,
        })
    }
}

/// Entry and impact in a signal whose times count from the known impact, in the order of its times.
fn instants(signal: &[(f64, f64)], known: f64) -> Option<SpallInstants> {
    let impact = impact(signal, known)?;
    let entry = entry(signal, ENTRY_IN.map(|times| impact - times * known))?;
    let apart = impact - entry;
    Some(SpallInstants {
        entry,
        impact,
        apart,
        deviation: apart / known - 1.0,
    })
}

/// Where the slope falls the most: where the lines on both sides meet.
fn impact(signal: &[(f64, f64)], known: f64) -> Option<f64> {
    let near = SLOPES_OVER * known;
    let sought = signal
        .iter()
        .filter(|(time, _)| time.abs() <= SOUGHT_IN * known);
    let kinks = sought.filter_map(|&(time, _)| {
        let [before, after] =
            [[time - near, time], [time, time + near]].map(|span| line(within(signal, span), time));
        let ([level, slope], [next_level, next_slope]) = (before?, after?);
        let fall = slope - next_slope;
        let meet = ((next_level - level) / fall).clamp(-near, near);
        (fall > 0.0).then_some((fall, time + meet))
    });
    let steepest = kinks.max_by(|a, b| a.0.total_cmp(&b.0));
    steepest.map(|(_, time)| time)
}

/// Where a parabola leaves a straight line upwards within a span of times.
fn entry(signal: &[(f64, f64)], span: [f64; 2]) -> Option<f64> {
    let points = within(signal, span);
    let width = span[1] - span[0];
    let trials = (1..TRIALS).map(|trial| span[0] + width * f64::from(trial) / f64::from(TRIALS));
    let errors = trials.filter_map(|time| Some((parabola_error(points, span, time)?, time)));
    let (least, time) = errors.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let [level, slope] = line(points, span[0])?;
    let straight: f64 = points
        .iter()
        .map(|(at, value)| (value - level - slope * (at - span[0])).powi(2))
        .sum();
    (straight >= LEAVES * least).then_some(time)
}

/// Squares of the errors of a line and a parabola that leaves it upwards at a time; none where it leaves it downwards.
fn parabola_error(points: &[(f64, f64)], [start, end]: [f64; 2], time: f64) -> Option<f64> {
    let width = end - start;
    let row = |at: f64| {
        let beyond = ((at - time) / width).max(0.0);
        Vector3::new(1.0, (at - start) / width, beyond * beyond)
    };
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for (at, value) in points {
        let row = row(*at);
        matrix += row * row.transpose();
        right += row * *value;
    }
    let found = matrix.cholesky()?.solve(&right);
    let errors = points
        .iter()
        .map(|(at, value)| (value - row(*at).dot(&found)).powi(2));
    (found[2] > 0.0).then(|| errors.sum())
}

/// Points within a span of times.
fn within(signal: &[(f64, f64)], [start, end]: [f64; 2]) -> &[(f64, f64)] {
    let first = signal.partition_point(|(time, _)| *time < start);
    let past = signal.partition_point(|(time, _)| *time <= end);
    &signal[first..past.max(first)]
}

/// Value at a time, and slope, of the straight line that fits points best; none through fewer than three.
fn line(points: &[(f64, f64)], time: f64) -> Option<[f64; 2]> {
    if points.len() < 3 {
        return None;
    }
    let count = points.len() as f64;
    let [at, value] = points.iter().fold([0.0; 2], |[at, value], point| {
        [at + point.0 / count, value + point.1 / count]
    });
    let (mut square, mut product) = (0.0, 0.0);
    for point in points {
        square += (point.0 - at).powi(2);
        product += (point.0 - at) * (point.1 - value);
    }
    let slope = product / square;
    slope
        .is_finite()
        .then_some([value + slope * (time - at), slope])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A line, a parabola from −1 on, and a fall from 0 on.
    fn spall(time: f64) -> f64 {
        let rise = (time + 1.0).clamp(0.0, 1.0).powi(2);
        let fall = 3.0 * time.max(0.0);
        0.2 * time + rise - fall
    }

    #[test]
    fn entry_and_impact_are_found_where_they_are() {
        let signal = |shape: fn(f64) -> f64| -> Vec<_> {
            let times = (-400..400).map(|step| f64::from(step) / 40.0 + 3e-3);
            times.map(|time| (time, shape(time))).collect()
        };
        let found = instants(&signal(spall), 1.0).expect("a spall");
        assert!(found.impact.abs() < 0.02, "{found:?}");
        assert!((found.entry + 1.0).abs() < 0.02, "{found:?}");
        // a sine of the shaft shows none
        assert_eq!(instants(&signal(|time| (0.1 * time).sin()), 1.0), None);
    }
}
