//! Motion within a step from place, velocity and acceleration at its ends and at the ends of the steps
//! before it: no evaluation is needed.

use super::row::Row;

/// Ends of steps that a polynomial goes through at most.
pub(super) const ENDS: usize = 6;
/// Numbers that it goes through, three at an end.
const TERMS: usize = 3 * ENDS;
/// Terms of the polynomial through the ends of the step alone.
const QUINTIC: usize = 6;
/// Parts of the step at which terms are looked at.
const PARTS: [f64; 2] = [0.3, 0.7];
/// Least part of the terms of its last end that the error of a polynomial is taken to be.
const LEAST_PART: f64 = 0.1;

/// Place, velocity and acceleration of every freedom at the end of a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct End<const N: usize> {
    pub time: f64,
    pub place: Row<N>,
    pub velocity: Row<N>,
    pub acceleration: Row<N>,
}

/// Hermite's polynomial in Newton's form, of degree five through the step's start and end, and of three
/// more for each end of a step before it that it goes through as well.
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
    /// Divided differences up to the latest node.
    latest: [[f64; N]; TERMS],
    /// The terms of the end before the last over what is allowed.
    excess_before: f64,
}

impl<const N: usize> Within<N> {
    /// Through nothing yet.
    pub const NONE: Self = Self {
        start: 0.0,
        size: 0.0,
        terms: 0,
        nodes: [0.0; TERMS],
        factors: [[0.0; N]; TERMS],
        latest: [[0.0; N]; TERMS],
        excess_before: 0.0,
    };

    /// Begins anew: through the start of a step and its end.
    #[inline(always)]
    pub fn begin(&mut self, start: &End<N>, end: &End<N>) {
        self.start = start.time;
        self.size = end.time - start.time;
        self.terms = 0;
        self.excess_before = 0.0;
        self.add(start);
        self.add(end);
    }

    /// Goes through a further end as well, of at most [`ENDS`].
    #[inline(always)]
    pub fn add(&mut self, end: &End<N>) {
        let node = (end.time - self.start) / self.size;
        for same in 0..3 {
            let term = self.terms;
            self.nodes[term] = node;
            let mut difference = *end.place;
            for order in 1..=term {
                let before = &mut self.latest[order - 1];
                let inverse = (node - self.nodes[term - order]).recip();
                for i in 0..N / 2 {
                    let next = (difference[i] - before[i]) * inverse;
                    before[i] = difference[i];
                    difference[i] = next;
                }
                if order <= same {
                    difference = self.derivative(end, order);
                }
            }
            self.latest[term] = difference;
            self.factors[term] = difference;
            self.terms += 1;
        }
    }

    /// h q′ or h² q″/2: divided differences of one node.
    #[inline(always)]
    fn derivative(&self, end: &End<N>, order: usize) -> [f64; N] {
        if order == 1 {
            end.velocity.map(|velocity| self.size * velocity)
        } else {
            let half = 0.5 * self.size * self.size;
            end.acceleration.map(|acceleration| half * acceleration)
        }
    }

    /// Whether the error is no larger than is allowed of place and velocity, after a further end; leaves
    /// out what does not better the motion. `per` are the inverses of what is allowed.
    ///
    /// The error of the quintic is that of the terms of the next end. That of the whole is below the
    /// terms of its last end, by as much as these are below those of the end before it.
    #[inline(always)]
    pub fn is_within(&mut self, per: &[f64; N]) -> bool {
        let last = self.excess(per);
        if self.terms == QUINTIC + 3 && last <= 1.0 {
            self.terms = QUINTIC;
            return true;
        }
        let before = std::mem::replace(&mut self.excess_before, last);
        // not so where it is no number
        last * (last / before).clamp(LEAST_PART, 1.0) <= 1.0
    }

    /// The terms of the last end over what is allowed.
    #[inline(always)]
    fn excess(&self, per: &[f64; N]) -> f64 {
        let mut excess = 0.0;
        for part in PARTS {
            let last = self.terms - 3;
            let mut basis = self.basis(last, part);
            for term in last..self.terms {
                let [place, velocity] = [basis[0].abs(), basis[1].abs() / self.size];
                let mut squares = 0.0;
                for i in 0..N / 2 {
                    let most = (place * per[i]).max(velocity * per[N / 2 + i]);
                    squares += (self.factors[term][i] * most).powi(2);
                }
                excess += squares;
                basis = self.next(basis, term, part);
            }
        }
        excess.sqrt()
    }

    /// What the factor of the term after one is multiplied by, and its slope.
    #[inline(always)]
    fn next(&self, [value, slope]: [f64; 2], term: usize, part: f64) -> [f64; 2] {
        let away = part - self.nodes[term];
        [value * away, slope * away + value]
    }

    /// What a factor is multiplied by at a part of the step, and its slope by that part.
    #[inline(always)]
    fn basis(&self, term: usize, part: f64) -> [f64; 2] {
        (0..term).fold([1.0, 0.0], |basis, term| self.next(basis, term, part))
    }

    /// Place and velocity at a time, s.
    #[inline(always)]
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
