//! Step sizes that were used of late, with what carries a state over them.

use super::linear::LinearPart;
use super::propagator::{Functions, Propagator, functions};

/// Sizes that are kept.
const KEPT: usize = 12;

/// A step size with its operator.
#[derive(Debug, Clone)]
struct Size<const N: usize> {
    size: f64,
    /// When it was asked for last.
    used: u64,
    propagator: Propagator<N>,
}

/// Operators of one linear part by their sizes, and the functions over a sample interval.
#[derive(Debug, Clone)]
pub(super) struct Propagators<const N: usize> {
    kept: Vec<Size<N>>,
    clock: u64,
    samples: Option<Functions<N>>,
}

impl<const N: usize> Propagators<N> {
    pub fn new() -> Self {
        Self {
            kept: Vec::with_capacity(KEPT),
            clock: 0,
            samples: None,
        }
    }

    /// Forgets all: the linear part is another.
    pub fn clear(&mut self) {
        self.kept.clear();
        self.samples = None;
    }

    /// The operator over a step.
    pub fn of(&mut self, part: &LinearPart<N>, size: f64) -> &Propagator<N> {
        self.clock += 1;
        let index = match self.kept.iter().position(|known| known.size == size) {
            Some(index) => index,
            None => self.build(part, size),
        };
        let known = &mut self.kept[index];
        known.used = self.clock;
        &known.propagator
    }

    /// Builds an operator in place of none or of the one that was not used for longest.
    fn build(&mut self, part: &LinearPart<N>, size: f64) -> usize {
        let built = Size {
            size,
            used: self.clock,
            propagator: Propagator::new(&part.modes, size, part.level),
        };
        if self.kept.len() < KEPT {
            self.kept.push(built);
            return self.kept.len() - 1;
        }
        let index = (0..KEPT).min_by_key(|&index| self.kept[index].used);
        let index = index.unwrap_or(0);
        self.kept[index] = built;
        index
    }

    /// The functions over an interval of samples.
    pub fn samples(&mut self, part: &LinearPart<N>, interval: f64) -> &Functions<N> {
        self.samples
            .get_or_insert_with(|| functions(&part.modes.eigenvalues, interval))
    }
}
