//! Motion within a step from place, velocity and acceleration at its ends and at the ends of the steps
//! before it: no evaluation is needed.

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

/// Place, velocity and acceleration of every freedom at the end of a step; the first N/2 components are
/// used.
#[derive(Debug, Clone, Copy)]
pub(super) struct End<const N: usize> {
    pub time: f64,
    pub place: [f64; N],
    pub velocity: [f64; N],
    pub acceleration: [f64; N],
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
}

impl<const N: usize> Within<N> {
    /// Through the start of a step and its end.
    pub fn new(start: &End<N>, end: &End<N>) -> Self {
        let zero = [[0.0; N]; TERMS];
        let mut within = Self {
            start: start.time,
            size: end.time - start.time,
            terms: 0,
            nodes: [0.0; TERMS],
            factors: zero,
            latest: zero,
        };
        within.add(start);
        within.add(end);
        within
    }

    /// Goes through a further end as well, of at most [`ENDS`].
    pub fn add(&mut self, end: &End<N>) {
        let node = (end.time - self.start) / self.size;
        for same in 0..3 {
            let term = self.terms;
            self.nodes[term] = node;
            let mut difference = end.place;
            for order in 1..=term {
                let before = std::mem::replace(&mut self.latest[order - 1], difference);
                if order <= same {
                    difference = self.derivative(end, order);
                    continue;
                }
                let inverse = (node - self.nodes[term - order]).recip();
                for i in 0..N / 2 {
                    difference[i] = (difference[i] - before[i]) * inverse;
                }
            }
            self.latest[term] = difference;
            self.factors[term] = difference;
            self.terms += 1;
        }
    }

    /// h q′ or h² q″/2: divided differences of one node.
    fn derivative(&self, end: &End<N>, order: usize) -> [f64; N] {
        if order == 1 {
            end.velocity.map(|velocity| self.size * velocity)
        } else {
            let half = 0.5 * self.size * self.size;
            end.acceleration.map(|acceleration| half * acceleration)
        }
    }

    /// Whether the error is no larger than is allowed of place and velocity; leaves out what does not
    /// better the motion.
    ///
    /// The error of the quintic is that of the terms of the next end. That of the whole is below the terms of its last end, by
    /// as much as these are below those of the end before it.
    pub fn is_within(&mut self, allowed: impl Fn(usize) -> f64) -> bool {
        if self.terms <= QUINTIC {
            return false;
        }
        let end_from = |first: usize| {
            let terms = first..first + 3;
            terms.map(|term| self.excess(term, &allowed)).sum::<f64>()
        };
        if end_from(QUINTIC) <= 1.0 {
            self.terms = QUINTIC;
            return true;
        }
        let (last, before) = (end_from(self.terms - 3), end_from(self.terms - 6));
        // not so where it is no number
        last * (last / before).clamp(LEAST_PART, 1.0) <= 1.0
    }

    /// A term over what is allowed, at its largest.
    fn excess(&self, term: usize, allowed: &impl Fn(usize) -> f64) -> f64 {
        let mut excess = 0.0;
        for part in PARTS {
            let [place, velocity] = self.basis(term, part).map(f64::abs);
            for i in 0..N / 2 {
                let factor = self.factors[term][i].abs();
                let most = (place / allowed(i)).max(velocity / (allowed(N / 2 + i) * self.size));
                // a sum: no number stays none
                excess += (factor * most).powi(2);
            }
        }
        excess.sqrt()
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
