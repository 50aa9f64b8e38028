//! Vectors in chunks that fit a wide register.
//!
//! Sums over stages or points take chunk after chunk, with the sum of a chunk kept in a register: as fast as code
//! for a fixed number of states.

use std::ops::{Deref, DerefMut};

use fearless_simd::{Simd, SimdBase, f64x4};

/// Numbers of a chunk.
const WIDTH: usize = 4;

/// Neighbouring numbers of a vector.
pub(super) type Chunk = [f64; WIDTH];

/// Number of chunks that hold so many numbers.
pub(super) fn chunks_of(numbers: usize) -> usize {
    numbers.div_ceil(WIDTH)
}

/// A vector, padded to whole chunks. It dereferences to its own numbers, without the padding.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Padded {
    chunks: Vec<Chunk>,
    len: usize,
}

impl Padded {
    /// So many zeros.
    pub fn zeros(len: usize) -> Self {
        Self {
            chunks: vec![[0.0; WIDTH]; chunks_of(len)],
            len,
        }
    }

    /// Some numbers, padded with zeros.
    pub fn from_slice(numbers: &[f64]) -> Self {
        Self::padded_with(numbers, 0.0)
    }

    /// Some numbers, padded with another one.
    pub fn padded_with(numbers: &[f64], padding: f64) -> Self {
        let mut padded = Self::zeros(numbers.len());
        let all = padded.chunks.as_flattened_mut();
        let (own, rest) = all.split_at_mut(numbers.len());
        own.copy_from_slice(numbers);
        rest.fill(padding);
        padded
    }

    /// The chunks.
    #[inline(always)]
    pub fn chunks(&self) -> &[Chunk] {
        &self.chunks
    }

    /// The chunks.
    #[inline(always)]
    pub fn chunks_mut(&mut self) -> &mut [Chunk] {
        &mut self.chunks
    }

    /// Takes the numbers of another vector of the same length.
    #[inline(always)]
    pub fn copy_from(&mut self, other: &Self) {
        self.chunks.copy_from_slice(&other.chunks);
    }
}

impl Deref for Padded {
    type Target = [f64];

    #[inline(always)]
    fn deref(&self) -> &[f64] {
        &self.chunks.as_flattened()[..self.len]
    }
}

impl DerefMut for Padded {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut [f64] {
        &mut self.chunks.as_flattened_mut()[..self.len]
    }
}

/// A chunk in a register. Sums that are written in these are not taken apart again by the compiler, which would rather work
/// on several chunks at a time and collects their numbers one by one.
#[inline(always)]
pub(super) fn in_register<S: Simd>(simd: S, chunk: &Chunk) -> f64x4<S> {
    f64x4::load_array_ref(simd, chunk)
}

/// Adds a factor times a chunk.
#[inline(always)]
pub(super) fn add_scaled(sum: &mut Chunk, factor: f64, chunk: &Chunk) {
    for (sum, value) in sum.iter_mut().zip(chunk) {
        *sum += factor * value;
    }
}

/// Adds a product, entry by entry.
#[inline(always)]
pub(super) fn add_product(sum: &mut Chunk, left: &Chunk, right: &Chunk) {
    for i in 0..WIDTH {
        sum[i] += left[i] * right[i];
    }
}
