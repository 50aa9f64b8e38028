//! Numbers that a ball law computes with: plain, side by side in a register, or with slopes.

use std::ops::{Add, Div, Mul, Sub};

use fearless_simd::{ExtractToken, Simd, SimdBase, SimdFloat};

/// Numbers of a few balls side by side, in registers as wide as the processor's level `S` has them.
/// The lanes are the same at every level and no products are fused, so that results are the same, bit
/// by bit.
pub type Lanes<S> = fearless_simd::f64x4<S>;

/// Number of balls side by side.
pub const LANES: usize = 4;

/// What a law computes with: `f64`, [`Lanes`], or a [`Dual`](super::dual::Dual) of either, which carries slopes along.
pub trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
{
    /// A constant of the same kind.
    fn constant(self, value: f64) -> Self;

    /// √x. The slope at zero is zero: a load that starts there as x√x has none either.
    fn sqrt(self) -> Self;

    /// max(x, 0), its slope zero where x is not positive.
    fn positive(self) -> Self;

    /// A function that is not written in these operations.
    fn apply<const K: usize, const M: usize>(
        function: &impl Function<K, M>,
        at: [Self; K],
    ) -> [Self; M];
}

/// A [`Number`] without slopes.
pub trait Plain: Number {
    /// A function with its slopes.
    fn with_slopes<const K: usize, const M: usize>(
        function: &impl Function<K, M>,
        at: [Self; K],
    ) -> ([Self; M], [[Self; K]; M]);

    /// `value` where this number is positive, else zero.
    fn if_positive(self, value: Self) -> Self;

    /// This number, or `least` where it is less.
    fn at_least(self, least: f64) -> Self;
}

/// M functions of K numbers that are not written in the operations of a [`Number`], such as the solution of an equation.
pub trait Function<const K: usize, const M: usize> {
    /// Values and their slopes, a row for each value.
    fn with_slopes(&self, at: [f64; K]) -> ([f64; M], [[f64; K]; M]);

    /// Values alone.
    #[inline]
    fn values(&self, at: [f64; K]) -> [f64; M] {
        self.with_slopes(at).0
    }

    /// Values for balls side by side: the same numbers as by [`Function::values`].
    #[inline(always)]
    fn side_by_side<S: Simd>(&self, at: [Lanes<S>; K]) -> [Lanes<S>; M] {
        let simd = at[0].token();
        let mut positions = [[0.0; K]; LANES];
        for k in 0..K {
            for lane in 0..LANES {
                positions[lane][k] = at[k][lane];
            }
        }
        let found = one_by_one(self, &positions);
        let mut values = [Lanes::splat(simd, 0.0); M];
        for m in 0..M {
            let [a, b, c, d] = &found;
            values[m] = Lanes::load_array(simd, [a[m], b[m], c[m], d[m]]);
        }
        values
    }
}

/// Out of line: costly functions gain nothing from the wide registers that the loop over the balls is
/// compiled for.
#[inline(never)]
fn one_by_one<const K: usize, const M: usize>(
    function: &(impl Function<K, M> + ?Sized),
    positions: &[[f64; K]; LANES],
) -> [[f64; M]; LANES] {
    let mut found = [function.values(positions[0]); LANES];
    for lane in 1..LANES {
        found[lane] = if positions[lane] == positions[lane - 1] {
            found[lane - 1]
        } else {
            function.values(positions[lane])
        };
    }
    found
}

impl Number for f64 {
    #[inline(always)]
    fn constant(self, value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    #[inline(always)]
    fn positive(self) -> Self {
        self.if_positive(self)
    }

    #[inline(always)]
    fn apply<const K: usize, const M: usize>(
        function: &impl Function<K, M>,
        at: [Self; K],
    ) -> [Self; M] {
        function.values(at)
    }
}

impl Plain for f64 {
    #[inline(always)]
    fn with_slopes<const K: usize, const M: usize>(
        function: &impl Function<K, M>,
        at: [Self; K],
    ) -> ([Self; M], [[Self; K]; M]) {
        function.with_slopes(at)
    }

    #[inline(always)]
    fn if_positive(self, value: Self) -> Self {
        if self > 0.0 { value } else { 0.0 }
    }

    #[inline(always)]
    fn at_least(self, least: f64) -> Self {
        self.max(least)
    }
}

impl<S: Simd> Number for Lanes<S> {
    #[inline(always)]
    fn constant(self, value: f64) -> Self {
        Self::splat(self.token(), value)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        SimdFloat::sqrt(self)
    }

    #[inline(always)]
    fn positive(self) -> Self {
        self.max(self.constant(0.0))
    }

    #[inline(always)]
    fn apply<const K: usize, const M: usize>(
        function: &impl Function<K, M>,
        at: [Self; K],
    ) -> [Self; M] {
        function.side_by_side(at)
    }
}

impl<S: Simd> Plain for Lanes<S> {
    #[inline(always)]
    fn with_slopes<const K: usize, const M: usize>(
        function: &impl Function<K, M>,
        at: [Self; K],
    ) -> ([Self; M], [[Self; K]; M]) {
        let zero = at[0].constant(0.0);
        let (mut values, mut slopes) = ([zero; M], [[zero; K]; M]);
        for lane in 0..LANES {
            let mut position = [0.0; K];
            for k in 0..K {
                position[k] = at[k][lane];
            }
            let (value, slope) = function.with_slopes(position);
            for m in 0..M {
                values[m][lane] = value[m];
                for k in 0..K {
                    slopes[m][k][lane] = slope[m][k];
                }
            }
        }
        (values, slopes)
    }

    #[inline(always)]
    fn if_positive(self, value: Self) -> Self {
        let simd = self.token();
        let zero = self.constant(0.0);
        simd.select_f64x4(simd.simd_gt_f64x4(self, zero), value, zero)
    }

    #[inline(always)]
    fn at_least(self, least: f64) -> Self {
        self.max(self.constant(least))
    }
}
