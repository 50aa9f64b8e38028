//! Statistics of a signal: moments, and how they drift.

use std::f64::consts::TAU;

use serde::{Serialize, Serializer};

use crate::rotor::{FREEDOMS, Sample};

/// Moments of the values taken so far, in one pass.
///
/// Source: P. Pébay, *Formulas for robust, one-pass parallel computation of covariances and
/// arbitrary-order statistical moments*, Sandia report SAND2008-6212 (2008), eq. 2.1 and 3.1 for one more value.
///
/// ```
/// use jeffcott::analysis::Moments;
/// let sine = |n| 5.0 + 2.0 * (std::f64::consts::TAU * f64::from(n) / 1000.0).cos();
/// let moments: Moments = (0..1000).map(sine).collect();
/// // a sine: RMS 2/√2, crest factor √2, kurtosis 3/2
/// assert!((moments.mean() - 5.0).abs() < 1e-12);
/// assert!((moments.rms() - 2f64.sqrt()).abs() < 1e-12);
/// assert!((moments.crest_factor().unwrap() - 2f64.sqrt()).abs() < 1e-12);
/// assert!((moments.kurtosis().unwrap() - 1.5).abs() < 1e-12);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moments {
    count: f64,
    mean: f64,
    /// Sums of the second, third and fourth powers of the distances from the mean.
    powers: [f64; 3],
    lowest: f64,
    highest: f64,
    /// Vibration below it is round-off.
    floor: f64,
}

impl Serialize for Moments {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map([
            ("mean", Some(self.mean())),
            ("rms", Some(self.rms())),
            ("peak", Some(self.peak())),
            ("peak_to_peak", Some(self.peak_to_peak())),
            ("crest_factor", self.crest_factor()),
            ("kurtosis", self.kurtosis()),
        ])
    }
}

impl Default for Moments {
    fn default() -> Self {
        Self {
            count: 0.0,
            mean: 0.0,
            powers: [0.0; 3],
            lowest: f64::INFINITY,
            highest: f64::NEG_INFINITY,
            floor: 0.0,
        }
    }
}

impl FromIterator<f64> for Moments {
    fn from_iter<I: IntoIterator<Item = f64>>(values: I) -> Self {
        let mut moments = Self::default();
        values.into_iter().for_each(|value| moments.take(value));
        moments
    }
}

impl Moments {
    /// Takes one more value.
    pub fn take(&mut self, value: f64) {
        let before = self.count;
        let count = before + 1.0;
        let distance = value - self.mean;
        let part = distance / count;
        let square = distance * part * before;
        let [second, third, _] = self.powers;
        self.powers[2] += square * part * part * (count * count - 3.0 * count + 3.0)
            + 6.0 * part * part * second
            - 4.0 * part * third;
        self.powers[1] += square * part * (count - 2.0) - 3.0 * part * second;
        self.powers[0] += square;
        self.count = count;
        self.mean += part;
        self.lowest = self.lowest.min(value);
        self.highest = self.highest.max(value);
    }

    /// Sum of the squared distances from the mean.
    pub(super) fn scatter(&self) -> f64 {
        self.powers[0]
    }

    /// Mean; zero of no values.
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// Root of the mean square distance from the mean: the RMS of the vibration.
    pub fn rms(&self) -> f64 {
        if self.count > 0.0 {
            (self.powers[0] / self.count).sqrt()
        } else {
            0.0
        }
    }

    /// Largest distance from the mean, either way; zero of no values.
    pub fn peak(&self) -> f64 {
        let (above, below) = (self.highest - self.mean, self.mean - self.lowest);
        above.max(below).max(0.0)
    }

    /// Distance from the lowest to the highest value; zero of no values.
    pub fn peak_to_peak(&self) -> f64 {
        (self.highest - self.lowest).max(0.0)
    }

    /// Lowest and highest value; not finite of no values.
    pub(crate) fn extremes(&self) -> [f64; 2] {
        [self.lowest, self.highest]
    }

    /// Takes a vibration of an RMS below `floor` for none.
    #[must_use]
    pub(super) fn above(self, floor: f64) -> Self {
        Self { floor, ..self }
    }

    /// Largest magnitude of the values; zero of none.
    pub(crate) fn magnitude(&self) -> f64 {
        self.highest.max(-self.lowest).max(0.0)
    }

    /// Whether there is a vibration of finite moments, above round-off where a floor of it is known.
    fn vibrates(&self) -> bool {
        let rms = self.rms();
        rms > 0.0 && rms >= self.floor && self.powers.iter().all(|power| power.is_finite())
    }

    /// Peak over RMS; none without vibration.
    pub fn crest_factor(&self) -> Option<f64> {
        self.vibrates().then(|| self.peak() / self.rms())
    }

    /// Fourth moment over the square of the second, 3 for Gaussian noise; none without vibration.
    pub fn kurtosis(&self) -> Option<f64> {
        let [second, _, fourth] = self.powers;
        self.vibrates()
            .then(|| self.count * fourth / (second * second))
    }
}

/// A motion whose statistics move by less than this part of it has settled.
pub const SETTLED: f64 = 0.02;

/// How far mean and RMS of a freedom move from one window to one that ends with the record.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Drift {
    /// The freedom that moves most, 0 … 4.
    #[serde(skip)]
    pub freedom: usize,
    /// Change of its mean, in parts of the RMS of the motion.
    pub mean: f64,
    /// Change of its RMS, in the same parts.
    pub rms: f64,
    /// Length of both windows, s.
    #[serde(rename = "window_s")]
    pub window: f64,
    /// Time from one to the other, s: whole revolutions of a shaft that turns.
    #[serde(rename = "apart_s")]
    pub apart: f64,
}

impl Drift {
    /// The larger of both changes.
    pub(crate) fn largest(&self) -> f64 {
        self.mean.abs().max(self.rms.abs())
    }

    /// Whether the motion has settled.
    pub fn is_settled(&self) -> bool {
        self.largest() < SETTLED
    }
}

/// Two windows of whole revolutions as far apart as makes the ball passes whole, too, as nearly as can be: a motion that repeats
/// with the shaft then has the same mean and RMS in both, whatever part of its period a window ends with.
///
/// Returns length and distance in revolutions, about a third of `whole` revolutions each; none of less than two. `passes` are
/// the ball passes a revolution.
fn windows(whole: usize, passes: &[f64]) -> Option<[usize; 2]> {
    if whole < 2 {
        return None;
    }
    // a motion that repeats every other revolution is the most common of the others
    let off = |revolutions: usize| {
        let cycles = passes
            .iter()
            .chain(&[0.5])
            .map(|order| order * revolutions as f64);
        cycles
            .map(|cycles| (cycles - cycles.round()).abs())
            .fold(0.0, f64::max)
    };
    let third = (whole as f64 / 3.0).round() as usize;
    let apart = ((whole / 4).max(1)..=third.max(1))
        .rev()
        .min_by(|a, b| off(*a).total_cmp(&off(*b)))?;
    // a Hann window of two periods or more hides those that do not fit
    let length = (whole / 3).max(2).min(whole - apart);
    Some([length, apart])
}

/// Takes samples of the freedoms at equal times over a record of known ends.
///
/// Mean and RMS are weighted by a Hann window, so that a vibration of no whole number of periods in it hardly moves them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct DriftRecorder {
    /// Where the windows begin, s.
    starts: [f64; 2],
    /// Their length, s; none of a record that holds no two of them.
    length: Option<f64>,
    /// Where the sums count from.
    origin: Option<[f64; FREEDOMS]>,
    /// Of both windows Σ w, and of every freedom Σ w x and Σ w x².
    sums: [(f64, [[f64; 2]; FREEDOMS]); 2],
}

impl DriftRecorder {
    /// For samples from `start` to `end`, s, of a shaft that takes `revolution` seconds a turn, by its ball passes a revolution;
    /// of one that does not turn the last two thirds.
    pub fn new([start, end]: [f64; 2], revolution: Option<f64>, passes: &[f64]) -> Self {
        let third = (end - start) / 3.0;
        let found = match revolution {
            None => Some([third; 2]),
            Some(revolution) => {
                let whole = ((end - start) / revolution).round() as usize;
                windows(whole, passes).map(|found| found.map(|count| count as f64 * revolution))
            }
        };
        let [length, apart] = found.unwrap_or_default();
        Self {
            starts: [end - length - apart, end - length],
            length: found.map(|_| length),
            origin: None,
            sums: [(0.0, [[0.0; 2]; FREEDOMS]); 2],
        }
    }

    /// Takes a sample.
    pub fn record(&mut self, sample: &Sample) {
        let Some(length) = self.length else { return };
        let origin = self.origin.get_or_insert(sample.displacement);
        for (start, (weights, sums)) in self.starts.iter().zip(&mut self.sums) {
            let part = (sample.time - start) / length;
            if !(0.0..1.0).contains(&part) {
                continue;
            }
            let weight = 0.5 - 0.5 * (TAU * part).cos();
            *weights += weight;
            for axis in 0..FREEDOMS {
                let distance = sample.displacement[axis] - origin[axis];
                sums[axis][0] += weight * distance;
                sums[axis][1] += weight * distance * distance;
            }
        }
    }

    /// The freedom that moves most, lengths and angles made comparable by `levers`, in parts of `scale`;
    /// none where a window holds too little.
    pub fn finish(&self, levers: &[f64; FREEDOMS], scale: f64) -> Option<Drift> {
        let [second, last] = &self.sums;
        let window = self.length?;
        if !(second.0 > 0.0 && last.0 > 0.0 && scale > 0.0) {
            return None;
        }
        let statistics = |(weight, sums): &(f64, [[f64; 2]; FREEDOMS]), axis: usize| {
            let [first, square] = sums[axis].map(|sum| sum / weight);
            [first, (square - first * first).max(0.0).sqrt()]
        };
        let drifts = levers.iter().enumerate().map(|(freedom, lever)| {
            let (before, after) = (statistics(second, freedom), statistics(last, freedom));
            let change = |index: usize| lever * (after[index] - before[index]) / scale;
            Drift {
                freedom,
                mean: change(0),
                rms: change(1),
                window,
                apart: self.starts[1] - self.starts[0],
            }
        });
        drifts.max_by(|a, b| a.largest().total_cmp(&b.largest()))
    }
}

/// Parts of a record that a growth is followed through.
const GROWTH_PARTS: usize = 6;

/// Growth over a record, as a factor from its first part to its last, from which on a motion diverges.
const DIVERGING: f64 = 10.0;

/// Takes samples at equal times for the RMS in equal parts of a record of known ends.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct GrowthRecorder {
    start: f64,
    /// Length of a part, s.
    length: f64,
    parts: [[Moments; FREEDOMS]; GROWTH_PARTS],
}

impl GrowthRecorder {
    /// For samples from `start` to `end`, s.
    pub fn new([start, end]: [f64; 2]) -> Self {
        Self {
            start,
            length: (end - start) / GROWTH_PARTS as f64,
            parts: Default::default(),
        }
    }

    /// Takes a sample.
    pub fn record(&mut self, sample: &Sample) {
        let part = ((sample.time - self.start) / self.length) as usize;
        let moments = &mut self.parts[part.min(GROWTH_PARTS - 1)];
        for (moments, value) in moments.iter_mut().zip(sample.displacement) {
            moments.take(value);
        }
    }

    /// Whether the RMS grows tenfold over the record, by the same factor or a larger one from each part to the next: the way
    /// into a resonance and a beat grow ever more slowly.
    pub fn is_exponential(&self, levers: &[f64; FREEDOMS]) -> bool {
        let size = |moments: &[Moments; FREEDOMS]| {
            let sizes = moments.iter().zip(levers);
            sizes
                .map(|(own, lever)| lever * own.rms())
                .fold(0.0, f64::max)
        };
        let least = DIVERGING.powf(1.0 / (GROWTH_PARTS - 1) as f64);
        let sizes = self.parts.each_ref().map(size);
        let mut pairs = sizes.windows(2);
        pairs.all(|pair| pair[0] > 0.0 && pair[1] > least * pair[0])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn values() -> Vec<f64> {
        let value = |n| 1e-3 + (0.37 * f64::from(n)).sin().powi(3);
        (0..1003).map(value).collect()
    }

    #[test]
    fn moments_are_those_about_the_mean() {
        let values = values();
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let power = |n: i32| {
            let powers = values.iter().map(|value| (value - mean).powi(n));
            powers.sum::<f64>() / count
        };
        let moments: Moments = values.iter().copied().collect();
        assert!((moments.mean() - mean).abs() < 1e-15);
        assert!((moments.rms() - power(2).sqrt()).abs() < 1e-14);
        let kurtosis = moments.kurtosis().expect("a vibration");
        let expected = power(4) / power(2).powi(2);
        assert!((kurtosis - expected).abs() < 1e-13, "{kurtosis}");
        let highest = values.iter().copied().fold(0.0, f64::max);
        assert_eq!(moments.highest, highest);
    }

    /// Of a sine of one cycle a revolution the record holds so many: its mean moved by a fifth between thirds of five.
    #[test]
    fn what_repeats_every_revolution_does_not_drift() {
        for (revolutions, samples) in [
            (2, 128.0),
            (3, 128.0),
            (5, 128.0),
            (5, 100.3),
            (7, 128.0),
            (10, 41.7),
            (23, 64.0),
        ] {
            let mut recorder =
                DriftRecorder::new([0.5 / samples, f64::from(revolutions)], Some(1.0), &[]);
            let sample = |time: f64| Sample {
                time,
                displacement: [
                    (TAU * time).cos() + 0.3 * (2.0 * TAU * time + 1.0).sin(),
                    0.0,
                    0.0,
                    0.0,
                    0.0,
                ],
                ..Sample::default()
            };
            let count = (f64::from(revolutions) * samples + 1e-9) as u32;
            (1..=count).for_each(|n| recorder.record(&sample(f64::from(n) / samples)));
            let drift = recorder.finish(&[1.0; FREEDOMS], 0.7).expect("a drift");
            assert!(drift.largest() < 2e-5, "{revolutions}: {drift:?}");
        }
    }

    #[test]
    fn only_a_motion_that_goes_on_growing_diverges() {
        let grows = |size: fn(f64) -> f64| {
            let mut recorder = GrowthRecorder::new([0.0, 1.0]);
            for n in 0..1000 {
                let time = f64::from(n) * 1e-3;
                let x = size(time) * (300.0 * time).cos();
                recorder.record(&Sample {
                    time,
                    displacement: [5.0 + x, 0.0, 0.0, 0.0, 0.0],
                    ..Sample::default()
                });
            }
            recorder.is_exponential(&[1.0; FREEDOMS])
        };
        assert!(grows(|time| (8.0 * time).exp()));
        assert!(grows(|time| 1e-12 * (3.0 * time).exp()));
        // it grows sevenfold; at resonance; a beat; into a limit cycle
        assert!(!grows(|time| (2.0 * time).exp()));
        assert!(!grows(|time| time));
        assert!(!grows(|time| (1.5 * time).sin()));
        assert!(!grows(|time| (1.0 + (12.0 - 20.0 * time).exp()).recip()));
        assert!(!grows(|_| 1.0));
    }

    #[test]
    fn windows_are_whole_revolutions_that_fit_the_ball_passes() {
        assert_eq!(windows(1, &[]), None);
        assert_eq!(windows(5, &[]), Some([2, 2]));
        assert_eq!(windows(9, &[]), Some([3, 2]));
        assert_eq!(windows(40, &[3.08]), Some([13, 12])); // 36.96 ball passes
        assert_eq!(windows(39, &[3.25]), Some([13, 12]));
    }
}
