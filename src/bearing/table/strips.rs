//! Division of the root of the approach into strips of unequal width, and of strips into cells.

use super::law::{INSIDE, ROUNDING, whole};
use crate::bearing::{LANES, Lanes};
use fearless_simd::Simd;

/// Bins over the whole range: the narrowest strip is one of them.
pub(super) const BINS: usize = 8192;

/// One strip and its cells along |A1|, all of a width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Strip {
    /// Scale and shift that map v onto x = −1 … 1: `x = v scale − shift`.
    map: [f64; 2],
    /// Scale and shift that map τ onto the cells.
    scale: f64,
    shift: f64,
    first_cell: usize,
}

/// Strips over `start` … `end`, each a whole number of bins.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Strips {
    middle: f64,
    inverse_half: f64,
    /// Strip of every bin.
    of_bin: Vec<u16>,
    strips: Vec<Strip>,
}

/// Place of a ball in its cell.
#[derive(Debug, Clone, Copy)]
pub(super) struct InCell {
    pub(super) cell: usize,
    /// Along the root of the approach, −1 … 1.
    pub(super) x: f64,
    /// Along |A1|, −½ … ½.
    pub(super) t: f64,
}

impl Strips {
    /// Strips that follow one another, each from its first bin on, with its number of cells.
    pub(super) fn new([start, end]: [f64; 2], first_bins: &[usize], cells: &[usize]) -> Self {
        let width = (end - start) / BINS as f64;
        let mut of_bin = vec![0; BINS];
        let (mut strips, mut first_cell) = (Vec::with_capacity(cells.len()), 0);
        for (strip, (&first, &cells)) in first_bins.iter().zip(cells).enumerate() {
            let next = first_bins.get(strip + 1).copied().unwrap_or(BINS);
            of_bin[first..next].fill(strip as u16);
            let [low, high] = [first, next].map(|bin| start + bin as f64 * width);
            strips.push(Strip {
                map: [2.0 / (high - low), (high + low) / (high - low)],
                scale: 0.5 * cells as f64 * INSIDE,
                shift: 0.5 * cells as f64 - 0.5,
                first_cell,
            });
            first_cell += cells;
        }
        Self {
            middle: 0.5 * (start + end),
            inverse_half: 2.0 / (end - start),
            of_bin,
            strips,
        }
    }

    /// The range of v as −1 … 1.
    #[inline(always)]
    pub(super) fn part<S: Simd>(&self, root: Lanes<S>) -> Lanes<S> {
        (root - self.middle) * self.inverse_half
    }

    /// Bins of parts of the range.
    #[inline(always)]
    pub(super) fn bins<S: Simd>(part: Lanes<S>) -> [usize; LANES] {
        let half = 0.5 * BINS as f64;
        whole(part * (half * INSIDE) + (half - 0.5))
    }

    /// The cell of v and τ in a bin.
    #[inline(always)]
    pub(super) fn locate(&self, bin: usize, root: f64, along: f64) -> InCell {
        let strip = &self.strips[usize::from(self.of_bin[bin])];
        let place = along * strip.scale + strip.shift;
        let column = place + ROUNDING;
        InCell {
            cell: strip.first_cell + column.to_bits() as u32 as usize,
            x: root * strip.map[0] - strip.map[1],
            t: place - (column - ROUNDING),
        }
    }

    /// dx/dv and dt/dτ in a bin.
    pub(super) fn rates(&self, bin: usize) -> [f64; 2] {
        let strip = &self.strips[usize::from(self.of_bin[bin])];
        [strip.map[0], strip.scale]
    }
}
