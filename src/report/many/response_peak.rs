//! Peaks of a number along the only axis of a study, and how wide they are.

use serde_json::{Value, json};

use super::digest::Digest;

/// Numbers whose peaks are told, by the end of their columns.
const TOLD: [&str; 2] = ["_rms_m", "_order_1_m"];

/// A peak of a response curve.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ResponsePeak {
    number: String,
    down: bool,
    /// Value of the axis, and the number there, at the top of the parabola through three runs.
    at: f64,
    height: f64,
    /// Values of the axis on either side at which half the power is left, where the curve falls so far.
    half_power: [Option<f64>; 2],
}

impl ResponsePeak {
    pub fn json(&self) -> Value {
        let [below, above] = self.half_power;
        json!({
            "number": self.number,
            "direction": if self.down { "down" } else { "up" },
            "at": self.at,
            "height": self.height,
            "half_power_from": below,
            "half_power_to": above,
            "bandwidth": above.zip(below).map(|(above, below)| above - below),
        })
    }
}

/// The peaks of a study of one axis on a grid.
pub(super) fn peaks(digest: &Digest) -> Vec<ResponsePeak> {
    if digest.axes.len() != 1 || !digest.is_complete() {
        return Vec::new();
    }
    let columns = digest.columns.iter().enumerate();
    let told = columns.filter(|(_, column)| TOLD.iter().any(|end| column.name.ends_with(end)));
    told.flat_map(|(index, column)| {
        [false, true].into_iter().flat_map(move |down| {
            let rows = digest.rows.iter().filter(|row| row.down == down);
            let mut curve: Vec<_> = rows
                .map(|row| (row.values[0], row.numbers[index]))
                .collect();
            curve.retain(|(_, value)| value.is_finite());
            curve.sort_by(|a, b| a.0.total_cmp(&b.0));
            tops(&curve)
                .into_iter()
                .map(move |place| peak(&column.name, down, &curve, place))
        })
    })
    .collect()
}

/// Places in a curve that are higher than both neighbours, by half the power than the valleys that part
/// them from anything higher.
fn tops(curve: &[(f64, f64)]) -> Vec<usize> {
    let higher = |k: usize| curve[k].1 > curve[k - 1].1 && curve[k].1 > curve[k + 1].1;
    let inner = 1..curve.len().saturating_sub(1);
    inner
        .filter(|k| higher(*k))
        .filter(|k| {
            half_power(curve, *k, curve[*k].1)
                .iter()
                .any(Option::is_some)
        })
        .collect()
}

fn peak(number: &str, down: bool, curve: &[(f64, f64)], place: usize) -> ResponsePeak {
    let [(a, fa), (b, fb), (c, fc)] = [curve[place - 1], curve[place], curve[place + 1]];
    // the parabola by divided differences
    let first = (fb - fa) / (b - a);
    let second = ((fc - fb) / (c - b) - first) / (c - a);
    let at = 0.5 * (a + b) - 0.5 * first / second;
    let height = fa + first * (at - a) + second * (at - a) * (at - b);
    ResponsePeak {
        number: number.to_owned(),
        down,
        at,
        height,
        half_power: half_power(curve, place, height),
    }
}

/// Where the curve falls to 1/√2 of the height, on either side, between runs linearly; none where it rises
/// above the height before, or ends.
fn half_power(curve: &[(f64, f64)], place: usize, height: f64) -> [Option<f64>; 2] {
    let level = height * std::f64::consts::FRAC_1_SQRT_2;
    let below = curve[..=place].iter().rev().copied().collect::<Vec<_>>();
    [&below[..], &curve[place..]].map(|side| {
        let pair = side
            .windows(2)
            .take_while(|pair| pair[0].1 <= height)
            .find(|pair| pair[1].1 <= level)?;
        let part = (pair[0].1 - level) / (pair[0].1 - pair[1].1);
        Some(pair[0].0 + part * (pair[1].0 - pair[0].0))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Amplitude of an oscillator of damping ratio ζ at frequency ratio r; its half-power bandwidth is 2ζ for
    /// small ζ.
    #[test]
    fn the_bandwidth_of_an_oscillator_is_twice_its_damping_ratio() {
        let damping = 0.02;
        let amplitude = |r: f64| 1.0 / ((1.0 - r * r).powi(2) + (2.0 * damping * r).powi(2)).sqrt();
        let curve: Vec<_> = (0..=4000)
            .map(|k| 0.8 + 1e-4 * f64::from(k))
            .map(|r| (r, amplitude(r)))
            .collect();
        let found = tops(&curve);
        assert_eq!(found.len(), 1);
        let found = peak("x_rms_m", false, &curve, found[0]);
        assert!((found.at - (1.0 - 2.0 * damping * damping).sqrt()).abs() < 1e-6);
        let [Some(below), Some(above)] = found.half_power else {
            panic!("no bandwidth");
        };
        assert!((above - below - 2.0 * damping).abs() < 1e-3 * 2.0 * damping + 1e-4);
    }
}
