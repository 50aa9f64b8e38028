//! What a spectrum is estimated from: samples that are in memory, or an envelope that is made block by block.

use std::mem;
use std::ops::Range;

use realfft::RealFftPlanner;

use super::envelope::Envelopes;

/// Samples of the blocks that the envelope of a long signal is made in, and at either end of a block those that are left to its
/// neighbours.
const BLOCK: usize = 1 << 20;
const EDGE: usize = 1 << 14;

/// A signal that is read from its start to its end in pieces that may overlap.
pub trait Signal {
    /// Number of samples.
    fn length(&self) -> usize;

    /// The samples of a range, which begins nowhere before the last one did.
    fn read(&mut self, range: Range<usize>) -> &[f64];

    /// Whether all that was read is nowhere further from its mean than a floor.
    fn is_at_rest(&self, floor: f64) -> bool;
}

impl Signal for &[f64] {
    fn length(&self) -> usize {
        self.len()
    }

    fn read(&mut self, range: Range<usize>) -> &[f64] {
        &self[range]
    }

    fn is_at_rest(&self, floor: f64) -> bool {
        let mut spread = Spread::default();
        spread.add(self);
        spread.is_within(floor)
    }
}

/// The envelope of a signal between two frequencies, both included; of a long signal it takes the memory of a block and of what is
/// read at once.
pub struct EnvelopeSignal<'a> {
    samples: &'a [f64],
    rate: f64,
    band: [f64; 2],
    block: usize,
    edge: usize,
    planner: RealFftPlanner<f64>,
    /// Where the values that are held begin.
    start: usize,
    values: Vec<f64>,
    spread: Spread,
}

impl<'a> EnvelopeSignal<'a> {
    /// Of a signal of `rate` samples a second, in a band in Hz.
    pub fn new(samples: &'a [f64], rate: f64, band: [f64; 2]) -> Self {
        Self {
            samples,
            rate,
            band,
            block: BLOCK,
            edge: EDGE,
            planner: RealFftPlanner::new(),
            start: 0,
            values: Vec::new(),
            spread: Spread::default(),
        }
    }

    /// All of it.
    pub fn collect(mut self) -> Vec<f64> {
        self.read(0..self.samples.len());
        self.values
    }

    /// Adds what the next block holds. Blocks overlap by an edge on either side of which they do not know the envelope well.
    fn extend(&mut self) {
        let length = self.samples.len();
        let end = self.start + self.values.len();
        let first = end
            .saturating_sub(self.edge)
            .min(length.saturating_sub(self.block));
        let last = (first + self.block).min(length);
        let kept = if last == length {
            last
        } else {
            last - self.edge
        };
        let planner = mem::take(&mut self.planner);
        let mut block = Envelopes::planned(&self.samples[first..last], self.rate, planner);
        let found = &block.envelope(self.band)[end - first..kept - first];
        self.spread.add(found);
        self.values.extend_from_slice(found);
        self.planner = block.into_planner();
    }
}

impl Signal for EnvelopeSignal<'_> {
    fn length(&self) -> usize {
        self.samples.len()
    }

    fn read(&mut self, range: Range<usize>) -> &[f64] {
        self.values.drain(..range.start - self.start);
        self.start = range.start;
        self.values
            .reserve_exact(range.len().saturating_sub(self.values.len()));
        while self.values.len() < range.len() {
            self.extend();
        }
        &self.values[..range.len()]
    }

    fn is_at_rest(&self, floor: f64) -> bool {
        self.spread.is_within(floor)
    }
}

/// Mean and extremes of values.
#[derive(Debug, Clone, Copy)]
struct Spread {
    count: usize,
    sum: f64,
    lowest: f64,
    highest: f64,
}

impl Default for Spread {
    fn default() -> Self {
        Self {
            count: 0,
            sum: 0.0,
            lowest: f64::INFINITY,
            highest: f64::NEG_INFINITY,
        }
    }
}

impl Spread {
    fn add(&mut self, values: &[f64]) {
        self.count += values.len();
        for value in values {
            self.sum += value;
            self.lowest = self.lowest.min(*value);
            self.highest = self.highest.max(*value);
        }
    }

    fn is_within(&self, floor: f64) -> bool {
        let mean = self.sum / self.count as f64;
        mean - self.lowest < floor && self.highest - mean < floor
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Away from its ends the envelope of the whole signal, read at once or in segments that overlap.
    #[test]
    fn blocks_make_one_envelope() {
        let swell = |n: i32| (2.0 + (0.01 * f64::from(n)).cos()) * (1.3 * f64::from(n)).sin();
        let samples: Vec<f64> = (0..20_000).map(swell).collect();
        let band = [0.1, 0.3];
        let whole = Envelopes::new(&samples, 1.0).envelope(band);
        let signal = || EnvelopeSignal {
            block: 4096,
            edge: 512,
            ..EnvelopeSignal::new(&samples, 1.0, band)
        };
        let blocks = signal().collect();
        assert_eq!(blocks.len(), 20_000);
        for (a, b) in whole.iter().zip(&blocks).skip(500).take(19_000) {
            assert!((a - b).abs() < 5e-3, "{a} {b}");
        }
        let mut read = signal();
        for start in (0..17_000).step_by(1500) {
            assert_eq!(read.read(start..start + 3000), &blocks[start..start + 3000]);
        }
        // from 1 to 3, but for the ends
        assert!(!read.is_at_rest(0.9) && read.is_at_rest(2.0));
    }
}
