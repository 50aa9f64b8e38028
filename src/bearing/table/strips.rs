//! Division of the root of the approach into strips of unequal width.

use super::law::{INSIDE, ROUNDING, whole};
use crate::bearing::{LANES, Lanes};

/// Bins over the whole range: the narrowest strip is one of them.
pub(super) const BINS: usize = 8192;

/// Strips over `start` … `end`, each a whole number of bins.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Strips {
    middle: f64,
    inverse_half: f64,
    /// First cell of the strip of every bin.
    first_cells: Vec<u16>,
    /// v at the ends of the strips.
    edges: Vec<f64>,
}

impl Strips {
    /// Strips that follow one another, each from its first bin on, of `cells` cells each.
    pub(super) fn new([start, end]: [f64; 2], first_bins: &[usize], cells: usize) -> Self {
        let width = (end - start) / BINS as f64;
        let mut first_cells = vec![0; BINS];
        let mut edges = vec![start];
        for (strip, &first) in first_bins.iter().enumerate() {
            let next = first_bins.get(strip + 1).copied().unwrap_or(BINS);
            first_cells[first..next].fill((strip * cells) as u16);
            edges.push(start + next as f64 * width);
        }
        Self {
            middle: 0.5 * (start + end),
            inverse_half: 2.0 / (end - start),
            first_cells,
            edges,
        }
    }

    pub(super) fn count(&self) -> usize {
        self.edges.len() - 1
    }

    /// v at x in −1 … 1 of a strip.
    pub(super) fn root(&self, strip: usize, x: f64) -> f64 {
        let (low, high) = (self.edges[strip], self.edges[strip + 1]);
        0.5 * (low + high) + 0.5 * (high - low) * x
    }

    /// Scale and shift that map v onto x in a strip: `x = v scale − shift`.
    pub(super) fn map(&self, strip: usize) -> [f64; 2] {
        let (low, high) = (self.edges[strip], self.edges[strip + 1]);
        [2.0 / (high - low), (high + low) / (high - low)]
    }

    /// The range as −1 … 1.
    #[inline(always)]
    pub(super) fn part(&self, root: Lanes) -> Lanes {
        (root - Lanes::splat(self.middle)) * Lanes::splat(self.inverse_half)
    }

    /// Bins of parts of the range.
    #[inline(always)]
    pub(super) fn bins(&self, part: Lanes) -> [usize; LANES] {
        let half = 0.5 * BINS as f64 * INSIDE;
        let place = part * Lanes::splat(half) + Lanes::splat(half - 0.5);
        whole(place + Lanes::splat(ROUNDING))
    }

    /// First cell of the strip of a bin.
    #[inline(always)]
    pub(super) fn first_cell(&self, bin: usize) -> usize {
        usize::from(self.first_cells[bin])
    }
}
