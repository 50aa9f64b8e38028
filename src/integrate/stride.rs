//! A step over surfaces at which the derivative is not smooth, and the error that it has for them.

use super::course::Course;
use super::{Sides, System};

/// Error of a step over its size and what a surface adds over a short part at its end, over that part:
/// ∫ x^(3/2), for none of it need be seen.
const CROSSED_AT_END: f64 = 0.4;

/// A step from one time and deviation to another.
pub(super) struct Stride<'a, 'c, S, const N: usize> {
    pub course: &'a Course<'c, S, N>,
    /// Its ends, s.
    pub times: [f64; 2],
    pub deviations: [&'a [f64; N]; 2],
    /// s.
    pub size: f64,
}

impl<S: System<N>, const N: usize> Stride<'_, '_, S, N> {
    /// How far both ends are past a surface.
    pub fn ends_past(&self, surface: u32) -> [f64; 2] {
        std::array::from_fn(|end| {
            let state = self.course.state(self.deviations[end]);
            self.course.system.past(surface, self.times[end], &state)
        })
    }

    /// Error of going over a surface somewhere, over the tolerance, by a method whose error is a part of its size and
    /// what the surface adds over all of it.
    pub fn error_over(&self, surface: u32, crossed: f64) -> f64 {
        let [from, to] = self.ends_past(surface);
        let (past, apart) = (from.max(to), (from - to).abs());
        let anywhere = crossed * self.weight(surface, apart);
        let at_end = CROSSED_AT_END * past / apart * self.weight(surface, past);
        anywhere.min(at_end)
    }

    /// Error of a step that was to end on a surface, over the tolerance, by how far its ends are past it.
    pub fn error_beside(&self, surface: u32, [from, to]: [f64; 2]) -> f64 {
        let part = to.abs() / (from - to).abs();
        CROSSED_AT_END * part * self.weight(surface, to.abs())
    }

    /// Change of the state over the step by what a surface adds at a distance, over the tolerance.
    fn weight(&self, surface: u32, distance: f64) -> f64 {
        let added = self.course.system.added(surface, self.times[1], distance);
        self.course.norm(self.deviations[0], &added) * self.size
    }
}

/// Error of a quadrature by weights at nodes of 0 … 1, root mean square over the places where a power 3/2 begins.
#[cfg(test)]
pub(super) fn error_over_a_kink(weights: &[f64], nodes: &[f64]) -> f64 {
    const PLACES: u32 = 2000;
    let error = |place: f64| {
        let value = |node: &f64| (node - place).max(0.0).powf(1.5);
        let terms = weights.iter().zip(nodes);
        let sum: f64 = terms.map(|(weight, node)| weight * value(node)).sum();
        // ∫ x^(3/2) = 2/5 x^(5/2)
        0.4 * (1.0 - place).powf(2.5) - sum
    };
    let places = (0..=PLACES).map(|place| f64::from(place) / f64::from(PLACES));
    let squares: f64 = places.map(|place| error(place).powi(2)).sum();
    (squares / f64::from(PLACES + 1)).sqrt()
}

/// Surfaces of a set.
pub(super) fn each(mut surfaces: Sides) -> impl Iterator<Item = u32> {
    std::iter::from_fn(move || {
        let surface = surfaces.trailing_zeros();
        (surfaces != 0).then(|| {
            surfaces &= surfaces - 1;
            surface
        })
    })
}
