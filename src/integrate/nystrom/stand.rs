//! Where steps begin and end.

use fearless_simd::Simd;

use super::entries::Entries;
use super::factor::Factor;
use super::row::Row;
use super::within::End;

/// A deviation and the force in it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stand<const N: usize> {
    pub time: f64,
    pub state: [f64; N],
    /// f.
    pub push: Row<N>,
}

impl<const N: usize> Stand<N> {
    /// Place, velocity and acceleration q″ = f − 2 B q′.
    #[inline(always)]
    pub fn end<E: Entries<N>, V: Simd>(&self, simd: V, factor: &Factor<E, N>) -> End<N> {
        let velocity = Row::velocity(&self.state);
        let half = factor.half(simd, &velocity);
        End {
            time: self.time,
            place: Row::place(&self.state),
            velocity,
            acceleration: Row::of(|register| {
                self.push.load(simd, register) - half.load(simd, register) * 2.0
            }),
        }
    }
}
