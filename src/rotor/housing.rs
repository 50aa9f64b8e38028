//! What housings do besides holding their bearings: base motion acts on them, and sensors sit on them.

use super::structure::HousingPoint;
use super::{HousingMotion, MOST_HOUSINGS, Rotor};
use crate::bearing::Vector5;

impl Rotor {
    /// Indices of the degrees of freedom of the housings.
    pub(crate) fn housing_freedoms(&self) -> std::ops::Range<usize> {
        let first = if self.structure.housings.is_empty() {
            self.dofs()
        } else {
            self.active_freedoms()
        };
        first..self.dofs()
    }

    /// Adds the inertial forces −m a of the base to those on the degrees of freedom of the housings, at a time in s and
    /// an angle of the shaft in rad.
    pub(super) fn shake_housings(&self, time: f64, angle: f64, sum: &mut [f64]) {
        for housing in &self.structure.housings {
            let force = self.base_force(housing, time, angle);
            housing.point.add_force(1.0, &force, sum);
        }
    }

    /// Inertial force of the base on a housing, N.
    pub(super) fn base_force(&self, housing: &HousingPoint, time: f64, angle: f64) -> Vector5 {
        let mut force = [0.0; 5];
        for load in self.loads.iter().filter(|load| load.acts_on_mass()) {
            load.add(time, angle, housing.mass, &mut force);
        }
        force
    }

    /// Power of these forces at velocities of the degrees of freedom, W.
    pub(super) fn base_power(&self, time: f64, angle: f64, velocity: &[f64]) -> f64 {
        let power = |housing: &HousingPoint| -> f64 {
            let force = self.base_force(housing, time, angle);
            let rate = housing.point.rate(velocity);
            force
                .iter()
                .zip(rate)
                .map(|(force, rate)| force * rate)
                .sum()
        };
        self.structure.housings.iter().map(power).sum()
    }

    /// Motion of the housings of the first bearings; none without any.
    pub(super) fn housing_motions(
        &self,
        place: &[f64],
        velocity: &[f64],
    ) -> Option<[HousingMotion; MOST_HOUSINGS]> {
        let mut motions = [HousingMotion::default(); MOST_HOUSINGS];
        for housing in &self.structure.housings {
            if let Some(motion) = motions.get_mut(housing.bearing) {
                let [x, y, z, ..] = housing.point.displacement(place, &[]);
                motion.displacement = [x, y, z];
                let [x, y, z, ..] = housing.point.rate(velocity);
                motion.velocity = [x, y, z];
            }
        }
        (!self.structure.housings.is_empty()).then_some(motions)
    }

    /// Writes the accelerations of the housings, taken from the derivative of a state.
    pub(crate) fn accelerate_housings(
        &self,
        rate: &[f64],
        motions: &mut Option<[HousingMotion; MOST_HOUSINGS]>,
    ) {
        let (Some(motions), dofs) = (motions, self.dofs()) else {
            return;
        };
        for housing in &self.structure.housings {
            if let Some(motion) = motions.get_mut(housing.bearing) {
                let [x, y, z, ..] = housing.point.rate(&rate[dofs..2 * dofs]);
                motion.acceleration = Some([x, y, z]);
            }
        }
    }
}
