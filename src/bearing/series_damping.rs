//! Damping of two Hertz contacts in series, by itself and with the elastic force: the approach of each contact is a
//! fixed part of that of both.

use fearless_simd::{Simd, SimdBase, SimdFloat, dispatch};

use super::contact_damping::DampedRaces;
use super::hertz_law::SMALLEST_DISTANCE;
use super::ring_lanes::{LaneSums, LaneVector, side_by_side};
use super::{CageAngle, HertzLaw, Lanes, Ring, Vector5};

/// Which forces are summed up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Sum {
    /// That against the damping alone.
    Damping,
    /// That and the elastic one.
    Whole,
}

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
        dispatch!(self.level, simd => {
            let motion = [displacement, rate].map(|vector| side_by_side(simd, vector));
            self.series_sum(simd, Sum::Damping, &motion, cage, races)
        })
    }

    /// This force and the elastic one of [`Ring::force_by`] in one pass over the balls, for the processor's
    /// level `S`.
    #[inline(always)]
    pub(super) fn damped_force_by<S: Simd>(
        &self,
        simd: S,
        motion: &[LaneVector<S>; 2],
        cage: CageAngle,
        races: &DampedRaces,
    ) -> Vector5 {
        self.series_sum(simd, Sum::Whole, motion, cage, races)
    }

    #[inline(always)]
    fn series_sum<S: Simd>(
        &self,
        simd: S,
        sum: Sum,
        [displacement, rate]: &[LaneVector<S>; 2],
        cage: CageAngle,
        races: &DampedRaces,
    ) -> Vector5 {
        let law = self.law();
        let (none, one) = (Lanes::splat(simd, 0.0), Lanes::splat(simd, 1.0));
        let elastic = if sum == Sum::Whole { one } else { none };
        let [inner, outer] = races.shares();
        let [inner_loss, outer_loss] = races.losses();
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
            let per_distance = one / (distance + SMALLEST_DISTANCE);
            let approach_rate = (axial * axial_rate + radial * radial_rate) * per_distance;
            let damped = inner * (inner_loss * approach_rate).max(-one)
                + outer * (outer_loss * approach_rate).max(-one);
            let lateral = load * (elastic + damped) * per_distance;
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

    /// Places and rates of balls that are all pressed, and of some that are apart or about to part.
    const MOTIONS: [[Vector5; 2]; 2] = [
        [
            [2e-6, -3e-6, 30e-6, 1e-5, 2e-5],
            [1e-3, 2e-3, -1e-3, 0.02, -0.01],
        ],
        [[40e-6, 10e-6, 0.0, 0.0, 1e-4], [0.2, -0.1, 0.3, 1.0, -2.0]],
    ];

    /// A ring of unlike races, damped.
    fn damped() -> (Ring<HertzLaw>, DampedRaces) {
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
        (ring, races)
    }

    /// What one pass over the balls sums up is what two do, whether balls are pressed together or apart.
    #[test]
    fn elastic_force_and_damping_come_in_one_pass() {
        let (ring, races) = damped();
        let cage = CageAngle::new(0.7);
        for [place, rate] in MOTIONS {
            let elastic = ring.force(&place, cage, 0.0);
            let damping = ring.series_damping(&place, &rate, cage, &races);
            let whole = dispatch!(ring.level, simd => {
                let motion = [&place, &rate].map(|vector| side_by_side(simd, vector));
                ring.damped_force_by(simd, &motion, cage, &races)
            });
            let size = elastic.iter().chain(&damping);
            let size = size.fold(0.0, |most: f64, part| most.max(part.abs()));
            for axis in 0..5 {
                let apart = whole[axis] - (elastic[axis] + damping[axis]);
                assert!(apart.abs() < 1e-14 * size, "{axis}: {apart:e} of {size:e}");
            }
        }
    }

    /// Balls side by side bear what each bears by itself, whether pressed together, apart or about to part.
    #[test]
    fn balls_side_by_side_are_damped_as_one_by_one() {
        let (ring, races) = damped();
        let cage = CageAngle::new(0.7);
        for [place, rate] in MOTIONS {
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
