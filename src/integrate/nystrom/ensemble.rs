//! A walk of motions side by side, with steps in common.

use super::dprkn8::Dprkn8;
use super::entries::Few;
use super::factor::Factor;
use super::walk::Walk;
use crate::integrate::course::Course;
use crate::integrate::{Counters, IntegrateError, System, VelocityDependence};

/// `K` motions side by side in N states: component i belongs to motion number i modulo K.
#[derive(Debug, Clone)]
pub(in crate::integrate) struct EnsembleWalk<const N: usize, const K: usize> {
    walk: Walk<N>,
    factor: Box<Factor<Few<N, K>, N>>,
}

impl<const N: usize, const K: usize> EnsembleWalk<N, K> {
    /// Stands at time 0 in deviations from the origin.
    ///
    /// # Errors
    /// [`VelocityDependence`] where forces know the velocity otherwise than side by side methods can take.
    pub fn new<S: System<N>>(system: &S, deviation: [f64; N]) -> Result<Self, VelocityDependence> {
        let slopes = system.velocity_slopes()?;
        if !Few::<N, K>::holds(&slopes) {
            return Err(VelocityDependence {
                because: "velocities of other freedoms than the tilts depend on each other",
            });
        }
        Ok(Self {
            walk: Walk::new(deviation),
            factor: Box::new(Factor::new(&slopes)),
        })
    }

    /// Work done so far, the same for every motion.
    pub fn counters(&self) -> Counters {
        self.walk.counters()
    }

    /// States at a time that is not before the start of the latest step; walks on as far as needed.
    ///
    /// # Errors
    /// Why the walk ends before that time.
    pub fn states_at<S: System<N>>(
        &mut self,
        course: &Course<'_, S, N>,
        time: f64,
    ) -> Result<[f64; N], IntegrateError> {
        let deviation = self
            .walk
            .deviation_at::<Dprkn8, S, _>(course, &mut self.factor, time)?;
        Ok(course.state(&deviation))
    }
}
