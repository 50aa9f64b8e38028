//! Where balls side by side stand, and what they bear together.

use std::ops::{Add, Mul};

use fearless_simd::{Simd, SimdBase};

use super::{CageAngle, LANES, Lanes, Vector5};

/// Azimuths of a few balls in the cage's frame; a lane without a ball has zeros throughout.
#[derive(Debug, Clone, Copy)]
#[repr(align(32))]
pub(super) struct Azimuths {
    pub cos: [f64; LANES],
    pub sin: [f64; LANES],
    weight: [f64; LANES],
}

impl Azimuths {
    /// Of at most [`LANES`] azimuths in rad, of balls of one ring or of a ball of as many rings.
    pub fn new(azimuths: &[f64]) -> Self {
        let [mut cos, mut sin, mut weight] = [[0.0; LANES]; 3];
        for (lane, azimuth) in azimuths.iter().enumerate() {
            (sin[lane], cos[lane]) = azimuth.sin_cos();
            weight[lane] = 1.0;
        }
        Self { cos, sin, weight }
    }

    /// The azimuths with the cage turned: no displacement enters, so that this can be worked out before one
    /// is known.
    #[inline(always)]
    pub fn turned<S: Simd>(&self, simd: S, cage: CageAngle) -> Directions<S> {
        self.turned_by(simd, [cage.cos, cage.sin])
    }

    /// As [`Azimuths::turned`] by the cosine and sine of a cage, or of the cage of each lane.
    #[inline(always)]
    pub fn turned_by<S: Simd, A: Copy>(
        &self,
        simd: S,
        [cage_cos, cage_sin]: [A; 2],
    ) -> Directions<S>
    where
        Lanes<S>: Mul<A, Output = Lanes<S>>,
    {
        let cos = simd.load_array_ref_f64x4(&self.cos);
        let sin = simd.load_array_ref_f64x4(&self.sin);
        Directions {
            cos: cos * cage_cos - sin * cage_sin,
            sin: sin * cage_cos + cos * cage_sin,
            weight: simd.load_array_ref_f64x4(&self.weight),
        }
    }
}

/// A displacement or velocity of a ring, the same for balls side by side.
pub(super) type LaneVector<S> = [Lanes<S>; 5];

/// The same vector for balls side by side. Number by number: what was just written in parts is then not
/// read as a whole.
#[inline(always)]
pub(super) fn side_by_side<S: Simd>(simd: S, [x, y, z, tilt_x, tilt_y]: &Vector5) -> LaneVector<S> {
    [
        Lanes::splat(simd, *x),
        Lanes::splat(simd, *y),
        Lanes::splat(simd, *z),
        Lanes::splat(simd, *tilt_x),
        Lanes::splat(simd, *tilt_y),
    ]
}

/// Directions from the axis to balls side by side.
#[derive(Clone, Copy)]
pub(super) struct Directions<S: Simd> {
    cos: Lanes<S>,
    sin: Lanes<S>,
    /// One for a ball, zero for a lane without.
    weight: Lanes<S>,
}

impl<S: Simd> Directions<S> {
    /// Axial components, where the balls are, of a ring's displacement or velocity, from `start` on; `arm`
    /// in m is that of the tilt. Both are the same in all lanes, or a number a lane.
    #[inline(always)]
    pub fn axial<A>(&self, start: A, [_, _, z, tilt_x, tilt_y]: &LaneVector<S>, arm: A) -> Lanes<S>
    where
        A: Copy + Add<Lanes<S>, Output = Lanes<S>> + Mul<Lanes<S>, Output = Lanes<S>>,
    {
        (start + *z) + (arm * *tilt_x * self.sin - arm * *tilt_y * self.cos)
    }

    /// Its radial components there.
    #[inline(always)]
    pub fn radial<A>(&self, start: A, [x, y, ..]: &LaneVector<S>) -> Lanes<S>
    where
        A: Add<Lanes<S>, Output = Lanes<S>>,
    {
        start + (*x * self.cos + *y * self.sin)
    }
}

/// Sums over balls side by side of what each bears.
pub(super) struct LaneSums<S: Simd>([Lanes<S>; 5]);

impl<S: Simd> LaneSums<S> {
    /// Nothing yet.
    #[inline(always)]
    pub fn new(simd: S) -> Self {
        Self([Lanes::splat(simd, 0.0); 5])
    }

    /// Adds radial and axial forces in N, and moments over the arm that [`LaneSums::force`] is given.
    #[inline(always)]
    pub fn add(&mut self, directions: &Directions<S>, [radial, axial, moment]: [Lanes<S>; 3]) {
        let Directions { cos, sin, weight } = *directions;
        self.0[0] += radial * cos;
        self.0[1] += radial * sin;
        self.0[2] += axial * weight;
        self.0[3] += moment * sin;
        self.0[4] += moment * cos;
    }

    /// Force on the ring and its moment, N and N m. A loop: closures that are handed on are not compiled
    /// for wide registers.
    #[inline(always)]
    pub fn force(&self, arm: f64) -> Vector5 {
        let mut sums = [0.0; 5];
        for (sum, lanes) in sums.iter_mut().zip(&self.0) {
            let [a, b, c, d] = **lanes;
            *sum = (a + b) + (c + d);
        }
        let [x, y, z, tilt_x, tilt_y] = sums;
        [x, y, z, arm * tilt_x, -arm * tilt_y]
    }

    /// The same where every lane is a ring of its own.
    #[inline(always)]
    pub fn forces(&self, arm: Lanes<S>) -> LaneVector<S> {
        let [x, y, z, tilt_x, tilt_y] = self.0;
        [x, y, z, arm * tilt_x, -(arm * tilt_y)]
    }
}
