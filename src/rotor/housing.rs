//! What housings do besides holding their bearings: base motion acts on them, and sensors sit on them.

use super::{HousingMotion, MOST_HOUSINGS, Rotor};

impl Rotor {
    /// Indices of the degrees of freedom of the housings.
    pub(crate) fn housing_freedoms(&self) -> std::ops::Range<usize> {
        let housings = self.structure.housings.iter();
        let firsts = housings.map(|housing| housing.point.coordinates()[0]);
        firsts.min().unwrap_or(self.dofs())..self.dofs()
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
