//! Where the marks of a tacho stand around the shaft: slots and strips of a tape are seldom even, and a tape has a joint.

use std::f64::consts::TAU;

/// Fewest revolutions that the marks are found by.
const FEWEST: usize = 8;
/// Part of their distance by which a mark is elsewhere than evenly spaced ones, at least, and that in its standard errors.
const UNEVEN: f64 = 0.02;
const SURE: f64 = 4.0;

/// The marks of a tacho.
pub(super) struct Marks {
    /// Number of them around the shaft.
    count: f64,
    /// Their places in parts of a revolution from the first one on; none where they are even.
    places: Vec<f64>,
}

impl Marks {
    /// By the pulses of some revolutions, at places in time, of so many marks around the shaft.
    ///
    /// Between four pulses of one mark the angle is the cubic through them; the place of another mark is the mean over all
    /// revolutions of where its pulse lies on these.
    pub fn of_pulses(pulses: &[f64], count: f64) -> Self {
        let mut marks = Self {
            count,
            places: Vec::new(),
        };
        let number = count as usize;
        if count.fract() != 0.0 || number < 2 || pulses.len() < (FEWEST + 3) * number {
            return marks;
        }
        let found: Vec<[f64; 2]> = (0..number)
            .map(|mark| mean_place(pulses, number, mark))
            .collect();
        let is_uneven = |(mark, [place, error]): (usize, &[f64; 2])| {
            let off = (place - mark as f64 / count).abs();
            off > UNEVEN / count && off > SURE * error
        };
        if found.iter().enumerate().any(is_uneven) {
            marks.places = found.into_iter().map(|[place, _]| place).collect();
        }
        marks
    }

    /// Angle of a pulse from the first one on, rad.
    pub fn angle(&self, pulse: usize) -> f64 {
        let Some(number) = Some(self.places.len()).filter(|number| *number > 0) else {
            return TAU / self.count * pulse as f64;
        };
        TAU * ((pulse / number) as f64 + self.places[pulse % number])
    }
}

/// Place of a mark in parts of a revolution with its standard error.
fn mean_place(pulses: &[f64], number: usize, mark: usize) -> [f64; 2] {
    // the first and the last revolution have no pulse beyond them
    let revolutions = (pulses.len() - 1 - mark) / number - 2;
    let place = |revolution: usize| {
        let nodes = [0, 1, 2, 3].map(|node| pulses[(revolution + node) * number]);
        revolutions_at(nodes, pulses[(revolution + 1) * number + mark])
    };
    let places: Vec<f64> = (0..revolutions).map(place).collect();
    let mean = places.iter().sum::<f64>() / revolutions as f64;
    let scatter: f64 = places.iter().map(|own| (own - mean).powi(2)).sum();
    [mean, scatter.sqrt() / revolutions as f64]
}

/// Revolutions at a time, by Lagrange's cubic through −1, 0, 1 and 2 at four times.
fn revolutions_at(nodes: [f64; 4], time: f64) -> f64 {
    let part = |own: usize| {
        let others = (0..4).filter(|other| *other != own);
        let weight: f64 = others
            .map(|other| (time - nodes[other]) / (nodes[own] - nodes[other]))
            .product();
        weight * (own as f64 - 1.0)
    };
    (0..4).map(part).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pulses of a shaft that runs up from 10 to 30 revolutions a second in 20 s.
    fn pulses(places: &[f64]) -> Vec<f64> {
        let turned =
            (0..300).flat_map(|turn| places.iter().map(move |place| f64::from(turn) + place));
        // 10 t + t²/2
        turned
            .map(|turned| (100.0 + 2.0 * turned).sqrt() - 10.0)
            .collect()
    }

    #[test]
    fn uneven_marks_are_found_while_a_shaft_runs_up() {
        let places = [0.0, 0.31, 0.5, 0.74];
        let marks = Marks::of_pulses(&pulses(&places), 4.0);
        for (pulse, place) in [(2, 0.5), (5, 1.31), (403, 100.74)] {
            assert!((marks.angle(pulse) / TAU - place).abs() < 1e-4, "{pulse}");
        }
    }

    #[test]
    fn even_marks_stay_even() {
        let even: Vec<f64> = (0..60).map(|mark| f64::from(mark) / 60.0).collect();
        let marks = Marks::of_pulses(&pulses(&even), 60.0);
        assert!(marks.places.is_empty());
        assert!((marks.angle(90) - 1.5 * TAU).abs() < 1e-12);
        // too few revolutions, one mark, and a gear between tacho and shaft
        let few = pulses(&[0.0, 0.3])[..20].to_vec();
        for (pulses, count) in [(few, 2.0), (pulses(&[0.0]), 1.0), (pulses(&[0.0]), 2.5)] {
            assert!(Marks::of_pulses(&pulses, count).places.is_empty());
        }
    }
}
