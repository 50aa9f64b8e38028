//! Where steps begin and end.

use super::entries::Entries;
use super::factor::Factor;
use super::within::End;

/// A deviation and the force in it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stand<const N: usize> {
    pub time: f64,
    pub state: [f64; N],
    /// f; the first N/2 components are used, as in all vectors of freedoms.
    pub push: [f64; N],
}

impl<const N: usize> Stand<N> {
    /// Place, velocity and acceleration q″ = f − 2 B q′.
    #[inline(always)]
    pub fn end<E: Entries<N>>(&self, factor: &Factor<E, N>) -> End<N> {
        let mut velocity = [0.0; N];
        velocity[..N / 2].copy_from_slice(&self.state[N / 2..]);
        let mut acceleration = self.push;
        for (acceleration, half) in acceleration.iter_mut().zip(factor.half(&velocity)) {
            *acceleration -= 2.0 * half;
        }
        End {
            time: self.time,
            place: self.state,
            velocity,
            acceleration,
        }
    }
}
