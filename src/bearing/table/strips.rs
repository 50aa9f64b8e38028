//! Division of the root of the approach into strips of unequal width.

use crate::bearing::Lanes;

/// Bins over the whole range: the narrowest strip is one of them.
pub(super) const BINS: usize = 8192;

/// Strips over `start` … `end`, each a whole number of bins.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Strips {
    /// Bins a unit.
    rate: f64,
    start: f64,
    end: f64,
    /// Strip of every bin.
    of_bin: Vec<u16>,
    /// Scale and shift that map a strip onto −1 … 1.
    maps: Vec<[f64; 2]>,
}

impl Strips {
    /// Strips that follow one another, each from its first bin on.
    pub(super) fn new([start, end]: [f64; 2], first_bins: &[usize]) -> Self {
        let width = (end - start) / BINS as f64;
        let mut of_bin = vec![0; BINS];
        let mut maps = Vec::with_capacity(first_bins.len());
        for (strip, &first) in first_bins.iter().enumerate() {
            let next = first_bins.get(strip + 1).copied().unwrap_or(BINS);
            of_bin[first..next].fill(strip as u16);
            let (low, high) = (start + first as f64 * width, start + next as f64 * width);
            maps.push([2.0 / (high - low), (high + low) / (high - low)]);
        }
        Self {
            rate: BINS as f64 / (end - start),
            start,
            end,
            of_bin,
            maps,
        }
    }

    /// Start of the first strip and end of the last one.
    pub(super) fn range(&self) -> [f64; 2] {
        [self.start, self.end]
    }

    pub(super) fn count(&self) -> usize {
        self.maps.len()
    }

    /// Root of the approach at x in −1 … 1 of a strip.
    pub(super) fn root(&self, strip: usize, x: f64) -> f64 {
        let [scale, shift] = self.maps[strip];
        (x + shift) / scale
    }

    /// dx/dv in a strip.
    pub(super) fn rate_in(&self, strip: usize) -> f64 {
        self.maps[strip][0]
    }

    /// Places along the bins, whose whole part is the bin.
    #[inline(always)]
    pub(super) fn bins(&self, root: Lanes) -> Lanes {
        (root - Lanes::splat(self.start)) * Lanes::splat(self.rate)
    }

    /// The strip of a bin and x in it; bins past the end count as the last.
    #[inline(always)]
    pub(super) fn locate(&self, bin: usize, root: f64) -> (usize, f64) {
        let strip = usize::from(self.of_bin[bin.min(BINS - 1)]);
        let [scale, shift] = self.maps[strip];
        (strip, root * scale - shift)
    }
}
