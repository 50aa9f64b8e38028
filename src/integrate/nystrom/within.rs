//! Motion within a step from place, velocity and acceleration at its ends and at the ends of the steps
//! before it: no evaluation is needed.

/// Ends of steps that a polynomial goes through.
pub(super) const ENDS: usize = 4;
/// Numbers that it goes through, three at an end.
const TERMS: usize = 3 * ENDS;
/// Terms of the polynomial through the ends of the step alone.
const QUINTIC: usize = 6;
/// Parts of the step at which terms are looked at.
const PARTS: [f64; 2] = [0.3, 0.7];

/// Place, velocity and acceleration of every freedom at the end of a step; the first N/2 components are
/// used.
#[derive(Debug, Clone, Copy)]
pub(super) struct End<const N: usize> {
    pub time: f64,
    pub place: [f64; N],
    pub velocity: [f64; N],
    pub acceleration: [f64; N],
}

/// Hermite's polynomial in Newton's form: of degree five through the step's start and end, of degree 8
/// and 11 through those of one or two steps before it as well.
///
/// Source: e.g. J. Stoer & R. Bulirsch, *Introduction to Numerical Analysis*, sec. 2.1.5.
#[derive(Debug, Clone)]
pub(super) struct Within<const N: usize> {
    start: f64,
    size: f64,
    terms: usize,
    /// Where the terms vanish, in steps from the start.
    nodes: [f64; TERMS],
    factors: [[f64; N]; TERMS],
}

impl<const N: usize> Within<N> {
    /// Through the start of a step, its end, and the starts of the steps before it, the latest first.
    pub fn new(ends: &[End<N>]) -> Self {
        let (start, size) = (ends[0].time, ends[1].time - ends[0].time);
        let terms = 3 * ends.len();
        let mut nodes = [0.0; TERMS];
        for (index, node) in nodes[..terms].iter_mut().enumerate() {
            *node = (ends[index / 3].time - start) / size;
        }
        let mut factors = [[0.0; N]; TERMS];
        for (index, factors) in factors[..terms].iter_mut().enumerate() {
            *factors = ends[index / 3].place;
        }
        for order in 1..terms {
            for index in (order..terms).rev() {
                let end = &ends[index / 3];
                let width = nodes[index] - nodes[index - order];
                for i in 0..N / 2 {
                    factors[index][i] = if width != 0.0 {
                        (factors[index][i] - factors[index - 1][i]) / width
                    } else if order == 1 {
                        size * end.velocity[i]
                    } else {
                        0.5 * size * size * end.acceleration[i]
                    };
                }
            }
        }
        Self {
            start,
            size,
            terms,
            nodes,
            factors,
        }
    }

    /// Whether a term at most is as large as is allowed of place and velocity; leaves out what does not
    /// better the motion.
    pub fn settle(&mut self, allowed: impl Fn(usize) -> f64) -> bool {
        let good = |term: usize| {
            PARTS.into_iter().all(|part| {
                let [place, velocity] = self.basis(term, part);
                (0..N / 2).all(|i| {
                    let factor = self.factors[term][i].abs();
                    // not so where it is no number
                    factor * place.abs() <= allowed(i)
                        && factor * velocity.abs() <= allowed(N / 2 + i) * self.size
                })
            })
        };
        if self.terms > QUINTIC && good(QUINTIC) {
            self.terms = QUINTIC;
            return true;
        }
        self.terms > QUINTIC && good(self.terms - 1)
    }

    /// What a factor is multiplied by at a part of the step, and its slope by that part.
    fn basis(&self, term: usize, part: f64) -> [f64; 2] {
        let (mut value, mut slope) = (1.0, 0.0);
        for node in &self.nodes[..term] {
            slope = slope * (part - node) + value;
            value *= part - node;
        }
        [value, slope]
    }

    /// Place and velocity at a time, s.
    pub fn at(&self, time: f64) -> [f64; N] {
        let part = (time - self.start) / self.size;
        let (mut place, mut slope) = ([0.0; N], [0.0; N]);
        for (node, factors) in self.nodes.iter().zip(&self.factors).take(self.terms).rev() {
            let away = part - node;
            for i in 0..N / 2 {
                slope[i] = slope[i] * away + place[i];
                place[i] = place[i] * away + factors[i];
            }
        }
        for i in 0..N / 2 {
            place[N / 2 + i] = slope[i] / self.size;
        }
        place
    }
}

#[cfg(test)]
#[path = "within_tests.rs"]
mod tests;
