//! Damping of two Hertz contacts in series: the approach of each is a fixed part of that of both.

use fearless_simd::{Simd, SimdBase, SimdFloat, dispatch};

use super::contact_damping::DampedRaces;
use super::hertz_law::SMALLEST_DISTANCE;
use super::ring_lanes::{LaneSums, side_by_side};
use super::{CageAngle, HertzLaw, Lanes, Ring, Vector5};

impl Ring<HertzLaw> {
    /// The same force as by [`Ring::damping_force`], balls side by side and without a root of the load:
    ///
    /// ```text
    /// δ_i = s_i δ   s_i = K_i^(−2/3)/(K_inner^(−2/3) + K_outer^(−2/3))   F = Σ_balls Q Σ_i s_i max(c_i s_i δ̇, −1) ∂δ/∂q
    /// ```
    pub(super) fn series_damping(
        &self,
        displacement: &Vector5,
        rate: &Vector5,
        cage: CageAngle,
        races: &DampedRaces,
    ) -> Vector5 {
        dispatch!(self.level, simd => self.series_damping_by(simd, displacement, rate, cage, races))
    }

    #[inline(always)]
    fn series_damping_by<S: Simd>(
        &self,
        simd: S,
        displacement: &Vector5,
        rate: &Vector5,
        cage: CageAngle,
        races: &DampedRaces,
    ) -> Vector5 {
        let law = self.law();
        let (none, pull) = (Lanes::splat(simd, 0.0), Lanes::splat(simd, -1.0));
        let [inner, outer] = races.shares();
        let [inner_loss, outer_loss] = races.coefficients;
        let displacement = &side_by_side(simd, displacement);
        let rate = &side_by_side(simd, rate);
        let mut sums = LaneSums::new(simd);
        for azimuths in &self.lanes {
            let directions = azimuths.turned(simd, cage);
            let axial = directions.axial(self.free_axial, displacement, self.arm);
            let radial = directions.radial(self.free_radial, displacement);
            let axial_rate = directions.axial(0.0, rate, self.arm);
            let radial_rate = directions.radial(0.0, rate);
            let distance = (axial * axial + radial * radial).sqrt();
            // δ ≤ 0: separated
            let approach = (distance - law.distance).max(none);
            let load = law.load_deflection_constant * approach * approach.sqrt();
            let distance = distance + SMALLEST_DISTANCE;
            let approach_rate = (axial * axial_rate + radial * radial_rate) / distance;
            let damped = inner * (inner_loss * inner * approach_rate).max(pull)
                + outer * (outer_loss * outer * approach_rate).max(pull);
            let lateral = load * damped / distance;
            let (push_axial, push_radial) = (lateral * axial, lateral * radial);
            sums.add(&directions, [push_radial, push_axial, push_axial]);
        }
        sums.force(self.arm)
    }
}

#[cfg(test)]
mod tests {
    use super::super::contact_damping::ContactDamping;
    use super::super::{FreePosition, Geometry, HertzSpring};
    use super::*;

    /// Balls side by side bear what each bears by itself, whether pressed together, apart or about to part.
    #[test]
    fn balls_side_by_side_are_damped_as_one_by_one() {
        let geometry = Geometry::new(
            13,
            7.938e-3,
            38.5e-3,
            FreePosition::ContactAngle(0.26),
            0.52,
            0.53,
        )
        .unwrap();
        let springs = [1.1e10, 1.4e10].map(|stiffness| HertzSpring { stiffness });
        let compliance: f64 = springs
            .map(|spring| spring.stiffness.powf(-2.0 / 3.0))
            .iter()
            .sum();
        let law = HertzLaw {
            load_deflection_constant: compliance.powf(-1.5),
            distance: geometry.groove_centre_distance(),
        };
        let ring = Ring::new(&geometry, 0.3, law);
        let loss = ContactDamping {
            inner: 0.3,
            outer: 40.0,
        };
        let races = loss.races(springs).unwrap().unwrap();
        let cage = CageAngle::new(0.7);
        for (place, rate) in [
            (
                [2e-6, -3e-6, 30e-6, 1e-5, 2e-5],
                [1e-3, 2e-3, -1e-3, 0.02, -0.01],
            ),
            ([40e-6, 10e-6, 0.0, 0.0, 1e-4], [0.2, -0.1, 0.3, 1.0, -2.0]),
        ] {
            let alone = ring.damping_force(&place, &rate, cage, 0.0, &races);
            let together = ring.series_damping(&place, &rate, cage, &races);
            let size = alone
                .iter()
                .fold(0.0, |most: f64, part| most.max(part.abs()));
            assert!(size > 1e-3);
            for (alone, together) in alone.iter().zip(&together) {
                assert!(
                    (alone - together).abs() < 1e-13 * size,
                    "{alone} {together}"
                );
            }
        }
    }
}
