//! How the numbers of a scene change with each of its values, by differences of two sizes.

use super::{Effort, NoAnswer, Point, Scene, Work};

/// How fast a number changes with a value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slope {
    /// Its derivative.
    pub value: f64,
    /// What the difference of half the size changes: the error of that derivative, and more than that of the extrapolated one.
    pub error: f64,
}

impl Slope {
    const UNKNOWN: Self = Self {
        value: f64::NAN,
        error: f64::NAN,
    };

    /// From differences over a step and over half of it, whose leading error falls as the step to the power `order`.
    ///
    /// ```text
    /// D = D(h/2) + (D(h/2) − D(h))/(2ᵏ − 1)
    /// ```
    fn extrapolated(whole: f64, half: f64, order: i32) -> Self {
        let left = (half - whole) / (2f64.powi(order) - 1.0);
        Self {
            value: half + left,
            error: left.abs(),
        }
    }
}

/// Distances of the points of a difference, in steps.
const PLACES: [f64; 4] = [-1.0, -0.5, 0.5, 1.0];

/// The slopes of every number by every value, over steps of these sizes within bounds: central ones, and from one side where
/// the other is beyond a bound or has no answer.
///
/// # Errors
/// [`NoAnswer::Stopped`] where it was to stop.
pub fn slopes(
    scene: Scene<'_>,
    (values, at): (&[f64], &Point),
    steps: &[f64],
    bounds: &[[f64; 2]],
    work: Work<'_>,
) -> Result<Vec<Vec<Slope>>, NoAnswer> {
    let count = PLACES.len();
    let found = work.all(count * values.len(), |task| {
        let (key, place) = (task / count, PLACES[task % count]);
        let mut moved = values.to_vec();
        moved[key] += place * steps[key];
        let [low, high] = bounds[key];
        // a step is what the numbers of the machine make of it
        let step = moved[key] - values[key];
        match (low..=high).contains(&moved[key]) {
            true => scene(&moved, Some(at), Effort::Full).map(|point| (step, point)),
            false => Err(NoAnswer::Failed(String::new())),
        }
    });
    if found
        .iter()
        .any(|one| matches!(one, None | Some(Err(NoAnswer::Stopped))))
    {
        return Err(NoAnswer::Stopped);
    }
    let found: Vec<_> = found.into_iter().map(|one| one?.ok()).collect();
    let of_key = |points: &[Option<(f64, Point)>]| {
        let numbers = 0..at.numbers.len();
        numbers.map(|number| slope(points, at, number)).collect()
    };
    Ok(found.chunks(count).map(of_key).collect())
}

/// The slope of a number by its values at the places of a difference.
fn slope(points: &[Option<(f64, Point)>], at: &Point, number: usize) -> Slope {
    let value = |point: &Point| point.numbers.get(number).map_or(f64::NAN, |own| own.value);
    let here = value(at);
    let difference =
        |first: (f64, f64), second: (f64, f64)| (second.1 - first.1) / (second.0 - first.0);
    let place = |index: usize| {
        points[index]
            .as_ref()
            .map(|(step, point)| (*step, value(point)))
    };
    let (left, right) = ((place(0), place(1)), (place(3), place(2)));
    match (left, right) {
        ((Some(far), Some(near)), (Some(other), Some(closer))) => {
            Slope::extrapolated(difference(far, other), difference(near, closer), 2)
        }
        ((Some(far), Some(near)), _) | (_, (Some(far), Some(near))) => {
            let from = (0.0, here);
            Slope::extrapolated(difference(from, far), difference(from, near), 1)
        }
        _ => Slope::UNKNOWN,
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use super::*;
    use crate::fit::Number;

    /// The slope of `e^x` at 1, with values between two bounds.
    fn of_exponential(bounds: [f64; 2]) -> Slope {
        let scene = |values: &[f64], _: Option<&Point>, _: Effort| {
            let number = Number {
                name: "e".to_owned(),
                unit: String::new(),
                value: values[0].exp(),
                error: 0.0,
            };
            Ok(Point {
                numbers: vec![number],
                ..Point::default()
            })
        };
        let stop = AtomicBool::new(false);
        let work = Work {
            threads: 2,
            stop: &stop,
        };
        let at = scene(&[1.0], None, Effort::Full).unwrap();
        slopes(&scene, (&[1.0], &at), &[1e-3], &[bounds], work).unwrap()[0][0]
    }

    #[test]
    fn the_error_of_a_slope_is_true() {
        let e = std::f64::consts::E;
        let free = of_exponential([0.0, 2.0]);
        assert!(
            (free.value / e - 1.0).abs() < 1e-11 && free.error < 2e-7,
            "{free:?}"
        );
        for bounds in [[1.0, 2.0], [0.0, 1.0]] {
            let held = of_exponential(bounds);
            let off = (held.value - e).abs();
            assert!(
                off < 1e-6 && off < held.error && held.error < 1e-3,
                "{held:?}"
            );
        }
    }
}
