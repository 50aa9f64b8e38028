//! Samples at equal times: gaps are bridged, uneven times made even.

/// Puts straight lines in place of what is missing, at the ends the nearest value; how many were.
pub(crate) fn bridge(values: &mut [f64]) -> usize {
    let missing = values.iter().filter(|value| !value.is_finite()).count();
    if missing == 0 || missing == values.len() {
        return missing;
    }
    let mut known: Option<usize> = None;
    for index in 0..values.len() {
        if !values[index].is_finite() {
            continue;
        }
        let first = known.map_or(0, |known| known + 1);
        for gap in first..index {
            values[gap] = match known {
                None => values[index],
                Some(before) => {
                    let part = (gap - before) as f64 / (index - before) as f64;
                    values[before] + part * (values[index] - values[before])
                }
            };
        }
        known = Some(index);
    }
    let last = known.unwrap_or(0);
    let value = values[last];
    values[last..].fill(value);
    missing
}

/// Values at equal times, on straight lines between those that are known.
pub(crate) fn at_even_times(times: &[f64], values: &[f64], rate: f64) -> Vec<f64> {
    let mut after = 1;
    let at = |index: usize| {
        let time = times[0] + index as f64 / rate;
        while after + 1 < times.len() && times[after] < time {
            after += 1;
        }
        let [from, to] = [times[after - 1], times[after]];
        let part = ((time - from) / (to - from)).clamp(0.0, 1.0);
        values[after - 1] + part * (values[after] - values[after - 1])
    };
    (0..times.len()).map(at).collect()
}

/// The value at a place between samples, on a straight line; beyond the ends the nearest. Of the places of samples their very values.
pub(crate) fn on_line(values: &[f64], place: f64) -> f64 {
    let last = values.len() - 1;
    let place = place.clamp(0.0, last as f64);
    let place = match (place - place.round()).abs() < 1e-6 {
        true => place.round(),
        false => place,
    };
    let before = place as usize;
    let after = values[(before + 1).min(last)];
    values[before] + (place - before as f64) * (after - values[before])
}

/// Samples on either side that a value between samples rests on.
const REACH: isize = 32;

/// The value at a place between samples of a signal that holds little from 0.45 of its rate on; beyond the ends the nearest samples count.
///
/// ```text
/// x(p) = Σ_k w(p − k) sinc(p − k) x_k / Σ_k w(p − k) sinc(p − k),  w the window of Blackman and Harris over 64 samples
/// ```
///
/// What its samples hold is mirrored at multiples of their rate with less than 1e-4 of its height.
pub(crate) fn between(values: &[f64], place: f64) -> f64 {
    let last = values.len() as isize - 1;
    let sample = |index: isize| values[index.clamp(0, last) as usize];
    let (before, fraction) = (place.floor() as isize, place - place.floor());
    if !(1e-9..1.0 - 1e-9).contains(&fraction) {
        return sample(place.round() as isize);
    }
    let (mut sum, mut weights) = (0.0, 0.0);
    for step in 1 - REACH..=REACH {
        let distance = fraction - step as f64;
        let c = (std::f64::consts::PI * distance / REACH as f64).cos();
        // cosines of the double and the threefold angle
        let window = 0.35875
            + 0.48829 * c
            + 0.14128 * (2.0 * c * c - 1.0)
            + 0.01168 * c * (4.0 * c * c - 3.0);
        // sin π(p − k) has one size for all k, which the sum of weights takes out, and alternates in sign
        let sign = if step % 2 == 0 { 1.0 } else { -1.0 };
        let weight = sign * window / distance;
        sum += weight * sample(before + step);
        weights += weight;
    }
    sum / weights
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tone_runs_between_its_samples() {
        for frequency in [0.01, 0.2, 0.4] {
            let tone = |place: f64| (std::f64::consts::TAU * frequency * place + 0.3).cos();
            let samples: Vec<f64> = (0..200).map(|n| tone(f64::from(n))).collect();
            for place in [64.0, 70.25, 80.5, 99.999, 120.0 + 1e-12] {
                let error = between(&samples, place) - tone(place);
                assert!(error.abs() < 1e-4, "{frequency} {place}: {error}");
            }
        }
        assert_eq!(between(&[2.0; 3], 9.5), 2.0);
    }

    #[test]
    fn gaps_are_bridged() {
        let mut values = [f64::NAN, 1.0, f64::NAN, f64::NAN, 4.0, f64::INFINITY];
        assert_eq!(bridge(&mut values), 4);
        assert_eq!(values, [1.0, 1.0, 2.0, 3.0, 4.0, 4.0]);
    }

    #[test]
    fn uneven_times_become_even() {
        let even = at_even_times(&[0.0, 1.0, 3.0], &[0.0, 2.0, 6.0], 2.0 / 3.0);
        assert_eq!(even, [0.0, 3.0, 6.0]);
    }
}
