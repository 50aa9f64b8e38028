//! Where balls side by side stand, and what they bear together.

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
    /// Of at most [`LANES`] azimuths in rad.
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
        let cos = simd.load_array_ref_f64x4(&self.cos);
        let sin = simd.load_array_ref_f64x4(&self.sin);
        Directions {
            cos: cos * cage.cos - sin * cage.sin,
            sin: sin * cage.cos + cos * cage.sin,
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
    /// in m is that of the tilt.
    #[inline(always)]
    pub fn axial(
        &self,
        start: f64,
        [_, _, z, tilt_x, tilt_y]: &LaneVector<S>,
        arm: f64,
    ) -> Lanes<S> {
        (start + *z) + (arm * *tilt_x * self.sin - arm * *tilt_y * self.cos)
    }

    /// Its radial components there.
    #[inline(always)]
    pub fn radial(&self, start: f64, [x, y, ..]: &LaneVector<S>) -> Lanes<S> {
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
}
