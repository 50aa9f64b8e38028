//! How a shaft turned while it was measured: at a constant speed, or by a channel of speed or pulses.

use std::f64::consts::TAU;

use crate::analysis::Channel;

/// Part of its mean by which a speed may change and count as constant.
const STEADY: f64 = 0.01;
/// Parts of the range of a tacho that a pulse falls below before the next may rise, and rises above.
const LEVELS: [f64; 2] = [0.4, 0.6];

/// Most pulses that are missed in a row.
const MOST_MISSED: f64 = 2.0;
/// Parts by which intervals between pulses may differ about one with missed pulses, and by which that one may differ from a
/// multiple of them.
const ALIKE: f64 = 0.2;
const MULTIPLE: f64 = 0.15;

/// How a shaft turned, by a tacho.
#[derive(Debug, Clone)]
pub struct TachoTurning {
    /// Angles and speeds between the first and the last pulse.
    pub turning: Turning,
    /// The samples between these.
    pub range: std::ops::Range<usize>,
    /// Places between samples of pulses that the tacho missed.
    pub missed: Vec<f64>,
}

/// How a shaft turned.
#[derive(Debug, Clone)]
pub enum Turning {
    /// At a constant speed, rad/s.
    Constant(f64),
    /// By angle in rad and speed in rad/s at every sample.
    Measured {
        /// Angles, which do not fall.
        angle: Vec<f64>,
        /// Speeds.
        speed: Vec<f64>,
    },
}

/// Why a channel is no tacho.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error(
    "the tacho has {pulses} pulses, from which no speed follows: is this its channel, and are its pulses a sample long or more?"
)]
pub struct TachoError {
    /// Pulses found.
    pulses: usize,
}

impl Turning {
    /// By speeds at every sample; angles by the trapezoidal rule.
    pub fn from_speed(speed: Vec<f64>, rate: f64) -> Self {
        let mut angle = Vec::with_capacity(speed.len());
        let mut turned = 0.0;
        for (index, value) in speed.iter().enumerate() {
            if index > 0 {
                turned += 0.5 * (speed[index - 1] + value) / rate;
            }
            angle.push(turned);
        }
        Self::Measured { angle, speed }
    }

    /// By a tacho of some pulses a revolution, from the first pulse to the last one, between which it is known.
    ///
    /// A pulse is where the tacho rises through the middle of its range, between samples on a straight line; between pulses the angle
    /// is the cubic through those of both ends with the slopes of the pulses around them. An interval twice or three times as
    /// long as those before and after it, which are alike, has missed pulses, which are put in.
    ///
    /// # Errors
    /// [`TachoError`] of fewer than three pulses.
    pub fn from_tacho(
        tacho: &[f64],
        pulses_per_revolution: f64,
        rate: f64,
    ) -> Result<TachoTurning, TachoError> {
        let (pulses, missed) = with_missed(pulses(tacho));
        let [first, _, .., last] = pulses[..] else {
            let pulses = pulses.len();
            return Err(TachoError { pulses });
        };
        let step = TAU / pulses_per_revolution;
        let slope = |pulse: usize| {
            let (before, after) = (pulse.saturating_sub(1), (pulse + 1).min(pulses.len() - 1));
            step * (after - before) as f64 / (pulses[after] - pulses[before])
        };
        let range = first.ceil() as usize..last.floor() as usize + 1;
        let (mut angle, mut speed) = (Vec::new(), Vec::new());
        let mut pulse = 0;
        for sample in range.clone() {
            while pulse + 2 < pulses.len() && pulses[pulse + 1] <= sample as f64 {
                pulse += 1;
            }
            // Hermite's cubic over an interval of length h, u from 0 to 1
            let h = pulses[pulse + 1] - pulses[pulse];
            let u = (sample as f64 - pulses[pulse]) / h;
            let [v, v1] = [pulse, pulse + 1].map(|pulse| h * slope(pulse));
            let [c2, c3] = [3.0 * step - 2.0 * v - v1, v + v1 - 2.0 * step];
            angle.push(step * pulse as f64 + u * (v + u * (c2 + u * c3)));
            speed.push(((v + u * (2.0 * c2 + 3.0 * u * c3)) / h * rate).max(0.0));
        }
        Ok(TachoTurning {
            turning: Self::Measured { angle, speed },
            range,
            missed,
        })
    }

    /// Mean, lowest and highest speed, rad/s.
    pub fn speeds(&self) -> [f64; 3] {
        match self {
            Self::Constant(speed) => [*speed; 3],
            Self::Measured { speed, .. } => {
                let mean = speed.iter().sum::<f64>() / speed.len().max(1) as f64;
                let none = [mean, f64::INFINITY, 0.0];
                speed.iter().fold(none, |[mean, lowest, highest], speed| {
                    [mean, speed.min(lowest), speed.max(highest)]
                })
            }
        }
    }

    /// The speed, rad/s, where it is constant but for a hundredth.
    pub fn steady(&self) -> Option<f64> {
        let [mean, lowest, highest] = self.speeds();
        (mean > 0.0 && highest - lowest <= STEADY * mean).then_some(mean)
    }

    /// Angle and speed of so many samples.
    pub fn columns(&self, rate: f64, length: usize) -> [(Channel, Vec<f64>); 2] {
        let (angle, speed) = match self {
            Self::Constant(speed) => {
                let angle = (0..length).map(|sample| speed * sample as f64 / rate);
                (angle.collect(), vec![*speed; length])
            }
            Self::Measured { angle, speed } => (angle.clone(), speed.clone()),
        };
        [(Channel::Angle, angle), (Channel::Speed, speed)]
    }
}

/// Places between samples where a tacho rises through the middle of its range.
fn pulses(tacho: &[f64]) -> Vec<f64> {
    let ends = tacho
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
            [value.min(low), value.max(high)]
        });
    let level = |part: f64| ends[0] + part * (ends[1] - ends[0]);
    let ([low, high], middle) = (LEVELS.map(level), level(0.5));
    let (mut pulses, mut armed, mut rise) = (Vec::new(), false, None);
    for (index, pair) in tacho.windows(2).enumerate() {
        let [before, after] = [pair[0], pair[1]];
        armed |= before < low;
        if armed && before < middle && after >= middle {
            rise = Some(index as f64 + (middle - before) / (after - before));
        }
        if armed && after > high {
            pulses.extend(rise.take());
            armed = false;
        }
    }
    pulses
}

/// Pulses with those that were missed among them, and these.
fn with_missed(pulses: Vec<f64>) -> (Vec<f64>, Vec<f64>) {
    let mut missed = Vec::new();
    for four in pulses.windows(4) {
        let [before, own, after] = [0, 1, 2].map(|interval| four[interval + 1] - four[interval]);
        let usual = 0.5 * (before + after);
        let count = (own / usual).round();
        let is_multiple =
            (own / usual - count).abs() <= MULTIPLE && (before - after).abs() <= ALIKE * usual;
        if is_multiple && (2.0..=MOST_MISSED + 1.0).contains(&count) {
            let between = (1..count as u32).map(|part| four[1] + f64::from(part) * own / count);
            missed.extend(between);
        }
    }
    let mut all = [pulses, missed.clone()].concat();
    all.sort_by(f64::total_cmp);
    (all, missed)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of 25 revolutions a second one pulse is lost, later two in a row.
    #[test]
    fn a_missed_pulse_is_put_in() {
        let tacho = |n: u32| {
            let is_lost = [40, 71, 72].contains(&(n / 400));
            f64::from(n % 400 < 40 && !is_lost)
        };
        let tacho: Vec<f64> = (0..40_000).map(tacho).collect();
        let found = Turning::from_tacho(&tacho, 1.0, 10_000.0).expect("pulses");
        let places: Vec<f64> = found
            .missed
            .iter()
            .map(|place| (place / 400.0).round())
            .collect();
        assert_eq!(places, [40.0, 71.0, 72.0]);
        let speed = found.turning.steady().expect("a steady speed");
        assert!((speed / (25.0 * TAU) - 1.0).abs() < 1e-9, "{speed}");
    }

    /// A shaft that starts has long intervals, and has missed nothing.
    #[test]
    fn a_start_from_rest_misses_nothing() {
        let pulses: Vec<f64> = (0..40).map(|n| 1000.0 * f64::from(n).sqrt()).collect();
        assert_eq!(with_missed(pulses.clone()), (pulses, vec![]));
    }

    /// A shaft that runs up from 10 to 30 Hz in 10 s, with a pulse of a tenth of a revolution.
    #[test]
    fn a_tacho_gives_angle_and_speed() {
        let rate = 10_000.0;
        let angle = |t: f64| TAU * (10.0 * t + t * t);
        let tacho = |n: u32| {
            let part = (angle(f64::from(n) / rate) / TAU).fract();
            if part < 0.1 { 5.0 } else { 0.2 }
        };
        let tacho: Vec<f64> = (0..100_000).map(tacho).collect();
        let found = Turning::from_tacho(&tacho, 1.0, rate).expect("pulses");
        let TachoTurning {
            turning,
            range,
            missed,
        } = found;
        assert_eq!(turning.steady(), None);
        assert!(missed.is_empty());
        let Turning::Measured {
            angle: found,
            speed,
        } = turning
        else {
            panic!("it changes");
        };
        let offset = angle(range.start as f64 / rate) - found[0];
        for index in (0..found.len()).step_by(997) {
            let t = (range.start + index) as f64 / rate;
            // a pulse is known to a sample
            let known = TAU * 30.0 / rate;
            assert!((found[index] + offset - angle(t)).abs() < known, "{t}");
            let expected = TAU * (10.0 + 2.0 * t);
            assert!((speed[index] / expected - 1.0).abs() < 0.02, "{t}");
        }
    }

    #[test]
    fn what_has_no_pulses_is_no_tacho() {
        let error = Turning::from_tacho(&[0.0, 1.0, 0.0, 0.0], 1.0, 1.0).expect_err("one pulse");
        assert_eq!(error, TachoError { pulses: 1 });
        assert!(Turning::from_tacho(&[], 1.0, 1.0).is_err());
    }

    #[test]
    fn speeds_that_hardly_change_are_steady() {
        let speed: Vec<f64> = (0..1000).map(|n| 100.0 + 0.3 * f64::from(n % 2)).collect();
        let turning = Turning::from_speed(speed, 100.0);
        assert!((turning.steady().expect("steady") - 100.15).abs() < 1e-9);
        let Turning::Measured { angle, .. } = turning else {
            panic!("it was measured");
        };
        assert!((angle[999] - 9.99 * 100.15).abs() < 0.01);
    }
}
