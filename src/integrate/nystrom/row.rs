//! Vectors of freedoms in whole registers.

use std::ops::{Deref, DerefMut};

use fearless_simd::{Simd, SimdBase, f64x4};

/// A register of four numbers.
pub(super) type Lanes<S> = f64x4<S>;

/// A vector of N/2 freedoms; what stands behind them is zero as far as a register reaches over it. It is written
/// and read in whole registers: reading as a whole what was just written in parts waits for the parts.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(32))]
pub(in crate::integrate) struct Row<const N: usize>([f64; N]);

impl<const N: usize> Row<N> {
    pub const ZERO: Self = Self([0.0; N]);
    /// Number of registers that hold the freedoms.
    pub const REGISTERS: usize = (N / 2).div_ceil(4);

    /// The place of a state.
    #[inline(always)]
    pub fn place(state: &[f64; N]) -> Self {
        let mut row = Self::ZERO;
        row.0[..N / 2].copy_from_slice(&state[..N / 2]);
        row
    }

    /// The velocity of a state.
    #[inline(always)]
    pub fn velocity(state: &[f64; N]) -> Self {
        let mut row = Self::ZERO;
        row.0[..N / 2].copy_from_slice(&state[N / 2..]);
        row
    }

    /// The state of a place and a velocity.
    #[inline(always)]
    pub fn state(place: &Self, velocity: &Self) -> [f64; N] {
        let mut state = place.0;
        state[N / 2..].copy_from_slice(&velocity.0[..N / 2]);
        state
    }

    #[inline(always)]
    pub fn load<S: Simd>(&self, simd: S, register: usize) -> Lanes<S> {
        match self.0.as_chunks().0.get(register) {
            Some(whole) => simd.load_array_ref_f64x4(whole),
            None => {
                // one freedom, in less than a register
                let mut part = [0.0; 4];
                part[..N].copy_from_slice(&self.0);
                simd.load_array_f64x4(part)
            }
        }
    }

    #[inline(always)]
    pub fn store<S: Simd>(&mut self, register: usize, lanes: Lanes<S>) {
        match self.0.as_chunks_mut().0.get_mut(register) {
            Some(whole) => lanes.witness().store_array_f64x4(lanes, whole),
            None => self
                .0
                .copy_from_slice(&lanes.witness().as_array_f64x4(lanes)[..N]),
        }
    }

    /// A row whose registers are these.
    #[inline(always)]
    pub fn of<S: Simd>(registers: impl Fn(usize) -> Lanes<S>) -> Self {
        let mut row = Self::ZERO;
        for register in 0..Self::REGISTERS {
            row.store(register, registers(register));
        }
        row
    }
}

impl<const N: usize> From<[f64; N]> for Row<N> {
    fn from(vector: [f64; N]) -> Self {
        Self(vector)
    }
}

impl<const N: usize> Deref for Row<N> {
    type Target = [f64; N];

    #[inline(always)]
    fn deref(&self) -> &[f64; N] {
        &self.0
    }
}

impl<const N: usize> DerefMut for Row<N> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut [f64; N] {
        &mut self.0
    }
}
