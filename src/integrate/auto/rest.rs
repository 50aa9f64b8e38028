//! What goes on about a state at rest while the shaft turns.

use crate::integrate::course::Course;
use crate::integrate::look::Look;
use crate::integrate::{Linearised, System};

/// Looks at it.
const LOOKS: usize = 16;
/// Part of the way to the next look over which it is seen how fast what drives the motion changes.
const GLANCE: f64 = 1e-3;
/// Part of the scale of the motion below which what drives it is taken for rounding.
const ROUNDING: f64 = 1e-9;

/// A state at rest over some time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rest {
    /// How often surfaces go over it, as where balls come out of a zone of load, 1/s.
    pub crossings: f64,
    /// Mean frequency of what drives it, rad/s: root of the mean squares of its rate and of itself about its
    /// mean; 0 where nothing does.
    pub frequency: f64,
}

impl Rest {
    /// The origin of a course from time 0 on, s.
    pub fn over<S: Linearised<N>, const N: usize>(span: f64, course: &Course<'_, S, N>) -> Self {
        let interval = span / LOOKS as f64;
        let times = std::array::from_fn::<_, LOOKS, _>(|look| look as f64 * interval);
        let glance = GLANCE * interval;
        let drives = |time| scaled_drive(course, time);
        let looks = times.map(|time| [drives(time), drives(time + glance)]);
        let until_end = times.into_iter().chain([span]);
        Self {
            crossings: f64::from(crossings(course, until_end)) / span,
            frequency: mean_frequency(&looks, glance, course.scaling.time),
        }
    }
}

/// How often surfaces go over the origin from one time to the next, s.
fn crossings<S: System<N>, const N: usize>(
    course: &Course<'_, S, N>,
    times: impl Iterator<Item = f64>,
) -> u32 {
    let (system, origin) = (course.system, &course.scaling.origin);
    let (mut looked, mut count) = (None::<Look<N>>, 0);
    for time in times {
        if looked.is_some_and(|looked| looked.is_clear(system, time, origin)) {
            continue;
        }
        let look = Look::around(system, time, *origin);
        if let Some(before) = looked.replace(look) {
            count += (before.sides ^ look.sides).count_ones();
        }
    }
    count
}

/// Rate of the origin, in scales of the motion per second.
fn scaled_drive<S: System<N>, const N: usize>(course: &Course<'_, S, N>, time: f64) -> [f64; N] {
    let mut rate = [0.0; N];
    course
        .system
        .derivative(time, &course.scaling.origin, &mut rate);
    std::array::from_fn(|i| rate[i] / course.scaling.scale[i])
}

/// Of what is known at looks and a glance after each, s, of a motion that takes some time, s.
fn mean_frequency<const N: usize>(looks: &[[[f64; N]; 2]], glance: f64, time: f64) -> f64 {
    let count = looks.len() as f64;
    let (mut swing, mut rate) = (0.0, 0.0);
    for i in 0..N {
        let mean = looks.iter().map(|[at, _]| at[i]).sum::<f64>() / count;
        swing += looks
            .iter()
            .map(|[at, _]| (at[i] - mean).powi(2))
            .sum::<f64>();
        let change = |[at, after]: &[[f64; N]; 2]| ((after[i] - at[i]) / glance).powi(2);
        rate += looks.iter().map(change).sum::<f64>();
    }
    if swing.sqrt() * time > ROUNDING * count.sqrt() {
        (rate / swing).sqrt()
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mean_frequency_is_that_of_two_cosines_by_their_squares_and_none_of_rounding() {
        let at =
            |size: f64, time: f64| [3.0 + size * (50.0 * time).cos(), size * (80.0 * time).sin()];
        let looks = |size: f64| -> Vec<_> {
            let times = (0..1000).map(|look| f64::from(look) * std::f64::consts::TAU / 1e4);
            times
                .map(|time| [at(size, time), at(size, time + 1e-6)])
                .collect()
        };
        let expected = ((50.0_f64.powi(2) + 80.0_f64.powi(2)) / 2.0).sqrt();
        let found = mean_frequency(&looks(2.0), 1e-6, 1e-3);
        assert!(
            (found - expected).abs() < 1e-3 * expected,
            "{found}, {expected}"
        );
        assert_eq!(mean_frequency(&looks(1e-12), 1e-6, 1e-3), 0.0);
    }
}
