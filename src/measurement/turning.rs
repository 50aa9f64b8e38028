//! How a shaft turned while it was measured: at a constant speed, or by a channel of speed or pulses.

use std::f64::consts::TAU;

use super::marks::Marks;
use crate::analysis::Channel;

/// Part of its mean by which a speed may change and count as constant.
const STEADY: f64 = 0.01;
/// Revolutions over which a speed is averaged before that is judged, and fewest such averages; of shorter records samples are.
const AVERAGED: f64 = 10.0;
const FEWEST_AVERAGES: usize = 3;
/// Part of the interval between pulses of which the speed is made to which their places are known at least, and fewest such
/// intervals.
const KNOWN: f64 = 0.002;
const FEWEST_INTERVALS: f64 = 8.0;
/// Parts of the range of a tacho that a pulse falls below before the next may rise, and rises above.
const LEVELS: [f64; 2] = [0.4, 0.6];

/// Most pulses that are missed in a row.
const MOST_MISSED: f64 = 2.0;
/// Part of all pulses up to which pulses are missed; where more intervals are long, the marks are uneven.
const MOST_MISSES: f64 = 0.1;
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
    /// long as those before and after it, which are alike, has missed pulses, which are put in. Of pulses whose places are not
    /// known to a small part of the interval between them, as at a low rate or of many pulses a revolution, some are passed over.
    /// Marks that stand unevenly around the shaft are found by the pulses of several revolutions.
    ///
    /// # Errors
    /// [`TachoError`] of fewer than three pulses.
    pub fn from_tacho(
        tacho: &[f64],
        pulses_per_revolution: f64,
        rate: f64,
    ) -> Result<TachoTurning, TachoError> {
        let (places, known) = pulses(tacho);
        let (places, missed) = with_missed(places);
        let [first, _, .., last] = places[..] else {
            let pulses = places.len();
            return Err(TachoError { pulses });
        };
        let marks = Marks::of_pulses(&places, pulses_per_revolution);
        let kept = far_enough_apart(&places, known);
        let pulses: Vec<(f64, f64)> = kept
            .iter()
            .map(|pulse| (places[*pulse], marks.angle(*pulse)))
            .collect();
        let range = first.ceil() as usize..last.floor() as usize + 1;
        let (mut angle, mut speed) = (Vec::new(), Vec::new());
        let mut pulse = 0;
        for sample in range.clone() {
            while pulse + 2 < pulses.len() && pulses[pulse + 1].0 <= sample as f64 {
                pulse += 1;
            }
            let [(from, turned), (to, then)] = [pulses[pulse], pulses[pulse + 1]];
            // Hermite's cubic over an interval of length h, u from 0 to 1
            let (h, step) = (to - from, then - turned);
            let u = (sample as f64 - from) / h;
            let [v, v1] = [pulse, pulse + 1].map(|pulse| h * slope(&pulses, pulse));
            let [c2, c3] = [3.0 * step - 2.0 * v - v1, v + v1 - 2.0 * step];
            angle.push(turned + u * (v + u * (c2 + u * c3)));
            speed.push(((v + u * (2.0 * c2 + 3.0 * u * c3)) / h * rate).max(0.0));
        }
        Ok(TachoTurning {
            turning: Self::Measured { angle, speed },
            range,
            missed,
        })
    }

    /// Mean, lowest and highest speed, rad/s: one number where it is constant but for a hundredth.
    pub fn speeds(&self) -> [f64; 3] {
        match (self, self.steady()) {
            (Self::Constant(speed), _) => [*speed; 3],
            (_, Some(steady)) => [steady; 3],
            (Self::Measured { speed, .. }, None) => mean_and_range(speed),
        }
    }

    /// The speed, rad/s, where it is constant but for a hundredth, by its means over some revolutions where the record has several.
    pub fn steady(&self) -> Option<f64> {
        let (angle, speed) = match self {
            Self::Constant(speed) => return (*speed > 0.0).then_some(*speed),
            Self::Measured { angle, speed } => (angle, speed),
        };
        let [mean, lowest, highest] = mean_and_range(speed);
        let [lowest, highest] = match averages(angle, speed) {
            means if means.len() < FEWEST_AVERAGES => [lowest, highest],
            means => {
                let [_, lowest, highest] = mean_and_range(&means);
                [lowest, highest]
            }
        };
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

/// Mean, least and greatest value.
fn mean_and_range(values: &[f64]) -> [f64; 3] {
    let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
    let none = [mean, f64::INFINITY, 0.0];
    values.iter().fold(none, |[mean, lowest, highest], value| {
        [mean, value.min(lowest), value.max(highest)]
    })
}

/// Means of the speed over equal angles of about ten revolutions.
fn averages(angle: &[f64], speed: &[f64]) -> Vec<f64> {
    let (Some(first), Some(last)) = (angle.first(), angle.last()) else {
        return Vec::new();
    };
    let count = ((last - first) / (AVERAGED * TAU)).floor();
    let count = count.clamp(0.0, speed.len() as f64) as usize;
    let end = |part: usize| {
        let turned = first + (last - first) * part as f64 / count as f64;
        angle.partition_point(|angle| *angle < turned)
    };
    let parts = (0..count).map(|part| &speed[end(part)..end(part + 1)]);
    let filled = parts.filter(|part| !part.is_empty());
    filled.map(|part| mean_and_range(part)[0]).collect()
}

/// Angle a sample at a pulse of places and angles: of the parabola through it and those beside it.
fn slope(pulses: &[(f64, f64)], pulse: usize) -> f64 {
    let chord = |pulse: usize| {
        let [(from, turned), (to, then)] = [pulses[pulse], pulses[pulse + 1]];
        (to - from, (then - turned) / (to - from))
    };
    match pulse {
        0 => chord(0).1,
        _ if pulse + 1 == pulses.len() => chord(pulse - 1).1,
        _ => {
            let [(before, slower), (after, faster)] = [chord(pulse - 1), chord(pulse)];
            (slower * after + faster * before) / (before + after)
        }
    }
}

/// Places between samples where a tacho rises through the middle of its range, and to how many samples they are known on average.
///
/// The place of a rise within one sample, as of a digital tacho, is known to that sample. Over n samples it is a straight line but for
/// its curvature, and is known to about 1/n² of a sample.
fn pulses(tacho: &[f64]) -> (Vec<f64>, f64) {
    let ends = tacho
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
            [value.min(low), value.max(high)]
        });
    let level = |part: f64| ends[0] + part * (ends[1] - ends[0]);
    let ([low, high], middle) = (LEVELS.map(level), level(0.5));
    let (mut pulses, mut known, mut rise) = (Vec::new(), 0.0, None);
    // the last sample below the lower level, since the last pulse
    let mut armed: Option<usize> = None;
    for (index, pair) in tacho.windows(2).enumerate() {
        let [before, after] = [pair[0], pair[1]];
        if before < low {
            armed = Some(index);
        }
        let Some(last_low) = armed else {
            continue;
        };
        if before < middle && after >= middle {
            rise = Some(index as f64 + (middle - before) / (after - before));
        }
        if after > high {
            if let Some(rise) = rise.take() {
                pulses.push(rise);
                known += ((index + 1 - last_low) as f64).powi(-2);
            }
            armed = None;
        }
    }
    let known = known / pulses.len().max(1) as f64;
    (pulses, known)
}

/// Numbers of the pulses, from the first to the last one, between which are intervals of which the uncertainty of their places is a small
/// part.
fn far_enough_apart(places: &[f64], known: f64) -> Vec<usize> {
    let all = places[places.len() - 1] - places[0];
    let least = (known / KNOWN).min(all / FEWEST_INTERVALS);
    let mut kept = vec![0];
    for (pulse, place) in places.iter().enumerate() {
        if place - places[kept[kept.len() - 1]] >= least && pulse > 0 {
            kept.push(pulse);
        }
    }
    let last = places.len() - 1;
    if kept[kept.len() - 1] != last {
        if kept.len() > 1 {
            kept.pop();
        }
        kept.push(last);
    }
    kept
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
    if missed.len() as f64 > MOST_MISSES * pulses.len() as f64 {
        return (pulses, Vec::new());
    }
    let mut all = [pulses, missed.clone()].concat();
    all.sort_by(f64::total_cmp);
    (all, missed)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rotor::load::SplitMix64;

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

    /// Two slots of a constant speed, 0.3 and 0.33 of a revolution apart: they are no missed pulses, and no changing speed.
    #[test]
    fn uneven_slots_are_no_changing_speed() {
        for apart in [0.3, 1.0 / 3.0] {
            let tacho = |n: u32| {
                let turned = 25.013 * f64::from(n) / 5000.0 + 0.2;
                f64::from(turned.fract() < 0.03 || (turned - apart).fract() < 0.03)
            };
            let tacho: Vec<f64> = (0..40_000).map(tacho).collect();
            let found = Turning::from_tacho(&tacho, 2.0, 5000.0).expect("pulses");
            assert!(found.missed.is_empty());
            let speed = found.turning.steady().expect("a steady speed");
            assert!((speed / (25.013 * TAU) - 1.0).abs() < 1e-4, "{speed}");
            let Turning::Measured { speed, .. } = &found.turning else {
                panic!("it was measured");
            };
            let [_, lowest, highest] = mean_and_range(speed);
            assert!(highest - lowest < 0.02 * highest, "{lowest} {highest}");
        }
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

    /// What a digital tacho shows of a shaft by its revolutions at a time, at so many samples a second for 8 s.
    fn turning_of(pulses: f64, rate: f64, revolutions: impl Fn(f64) -> f64) -> Turning {
        let shows = |n: u32| f64::from((pulses * revolutions(f64::from(n) / rate)).fract() < 0.3);
        let tacho: Vec<f64> = (0..(8.0 * rate) as u32).map(shows).collect();
        let found = Turning::from_tacho(&tacho, pulses, rate);
        found.expect("pulses").turning
    }

    #[test]
    fn rises_known_to_a_sample_leave_a_constant_speed_constant() {
        for (pulses, rate, hertz) in [
            (1.0, 10_000.0, 101.3),
            (1.0, 5000.0, 49.7),
            (60.0, 51_200.0, 25.013),
            (60.0, 10_000.0, 25.013),
        ] {
            let turning = turning_of(pulses, rate, |time| hertz * time + 0.2);
            let speed = turning.steady().expect("a steady speed") / TAU;
            assert!((speed / hertz - 1.0).abs() < 2e-5, "{hertz} Hz: {speed}");
            assert_eq!(turning.speeds(), [TAU * speed; 3]);
        }
    }

    /// From 600 to 3000 rpm; the speeds at the ends are those of the middle of an interval of a twentieth of a second.
    #[test]
    fn an_encoder_at_a_low_rate_follows_a_run_up() {
        let turning = turning_of(60.0, 10_000.0, |time| (10.0 + 2.5 * time) * time);
        assert_eq!(turning.steady(), None);
        let Turning::Measured { speed, .. } = turning else {
            panic!("it was measured");
        };
        for (sample, speed) in speed.iter().enumerate().skip(500).step_by(97) {
            let expected = TAU * (10.0 + 5.0 * sample as f64 / 10_000.0);
            assert!((speed / expected - 1.0).abs() < 0.012, "{sample}: {speed}");
        }
    }

    #[test]
    fn noise_and_a_dropout_leave_a_speed_steady() {
        let noise = SplitMix64::new(3);
        let noisy = |n: u64| 157.0 * (1.0 + 0.07 * (noise.uniform(n) - 0.5));
        let dropout = |n: u64| if n == 25_000 { 0.0 } else { 157.0 };
        let kinds: [&dyn Fn(u64) -> f64; 2] = [&noisy, &dropout];
        for kind in kinds {
            let turning = Turning::from_speed((0..50_000).map(kind).collect(), 5000.0);
            let speed = turning.steady().expect("a steady speed");
            assert!((speed / 157.0 - 1.0).abs() < 1e-3, "{speed}");
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
