//! Peaks of a number along the only axis of a study, and how wide they are.

use serde::Serialize;

use super::digest::{ColumnDigest, Digest};

/// Numbers whose peaks are told, by the end of their columns.
const TOLD: [&str; 2] = ["_rms_m", "_order_1_m"];

/// An order that is less than this part of the motion of its channel is round-off or noise.
const LEAST_PART: f64 = 0.01;

/// A peak of a response curve.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct ResponsePeak {
    /// Name of the number.
    number: String,
    /// `up` or `down`: how the runs came to their values.
    direction: &'static str,
    /// Value of the axis at the top of the parabola through three runs.
    at: f64,
    /// The number there.
    height: f64,
    /// Values of the axis on either side at which half the power is left, where the curve falls so far.
    half_power_from: Option<f64>,
    half_power_to: Option<f64>,
    /// What lies between them.
    bandwidth: Option<f64>,
}

/// The peaks of a study of one axis on a grid.
pub(super) fn peaks(digest: &Digest) -> Vec<ResponsePeak> {
    if digest.axes.len() != 1 || !digest.is_complete() {
        return Vec::new();
    }
    let columns = digest.columns.iter().enumerate();
    let told = columns.filter(|(_, column)| {
        TOLD.iter().any(|end| column.name.ends_with(end)) && tells(digest, column)
    });
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

/// Whether a number is a fair part of the motion of its channel, as far as that is known.
fn tells(digest: &Digest, column: &ColumnDigest) -> bool {
    let channel = column.name.split('_').next().unwrap_or_default();
    let whole = digest.column(&format!("{channel}_rms_m"));
    whole.is_none_or(|whole| column.highest >= LEAST_PART * digest.columns[whole].highest)
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
    let [from, to] = half_power(curve, place, height);
    ResponsePeak {
        number: number.to_owned(),
        direction: if down { "down" } else { "up" },
        at,
        height,
        half_power_from: from,
        half_power_to: to,
        bandwidth: to.zip(from).map(|(to, from)| to - from),
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
        let bandwidth = found.bandwidth.expect("a bandwidth");
        assert!((bandwidth - 2.0 * damping).abs() < 1e-3 * 2.0 * damping + 1e-4);
    }
}
