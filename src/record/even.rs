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

#[cfg(test)]
mod tests {
    use super::*;

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
