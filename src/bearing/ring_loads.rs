//! Force of a ring and loads of its balls in one pass.

use fearless_simd::{Simd, SimdBase, SimdFloat, dispatch};

use super::hertz_law::SMALLEST_DISTANCE;
use super::ring_lanes::{LaneSums, side_by_side};
use super::{BallContact, CageAngle, HertzLaw, LANES, Lanes, Ring, Vector5};

impl Ring<HertzLaw> {
    /// Force as by [`Ring::force`]; leaves loads and approaches of the balls as by [`Ring::contacts`] in `balls`, both
    /// to the last bit. Their angles stay as they are.
    pub(super) fn force_and_loads(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
        balls: &mut [BallContact],
    ) -> Vector5 {
        dispatch!(self.level, simd => self.force_and_loads_by(simd, displacement, cage, balls))
    }

    /// As [`Ring::force_and_loads`], for the processor's level `S`.
    #[inline(always)]
    fn force_and_loads_by<S: Simd>(
        &self,
        simd: S,
        displacement: &Vector5,
        cage: CageAngle,
        balls: &mut [BallContact],
    ) -> Vector5 {
        let displacement = &side_by_side(simd, displacement);
        let law = self.law();
        let none = Lanes::splat(simd, 0.0);
        let mut sums = LaneSums::new(simd);
        for (azimuths, balls) in self.lanes.iter().zip(balls.chunks_mut(LANES)) {
            let directions = azimuths.turned(simd, cage);
            let axial = directions.axial(self.free_axial, displacement, self.arm);
            let radial = directions.radial(self.free_radial, displacement);
            let distance = (axial * axial + radial * radial).sqrt();
            let reach = distance - law.distance;
            let approach = reach.max(none);
            let load = law.load_deflection_constant * approach * approach.sqrt();
            let lateral = load / (distance + SMALLEST_DISTANCE);
            let push = lateral * axial;
            sums.add(&directions, [lateral * radial, push, push]);
            for (lane, ball) in balls.iter_mut().enumerate() {
                ball.approach = reach[lane];
                ball.load_inner = load[lane];
                ball.load_outer = load[lane];
            }
        }
        sums.force(self.arm)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::catalogue;

    #[test]
    fn loads_side_by_side_are_those_of_the_balls_one_by_one() {
        for name in ["7205C", "6306"] {
            let bearing = catalogue::find(name).expect("in the catalogue");
            let bearing = bearing.bearing().expect("a bearing");
            let law = HertzLaw {
                load_deflection_constant: bearing.load_deflection_constant().expect("a contact"),
                distance: bearing.geometry.groove_centre_distance(),
            };
            let ring = Ring::new(&bearing.geometry, 0.1, law);
            let mut balls = vec![BallContact::default(); bearing.geometry.balls()];
            for step in 0..500 {
                let part = f64::from(step) * 0.37;
                let place = [3e-5, 2e-5, 4e-5, 1e-3, 2e-3].map(|size| size * part.sin());
                let cage = CageAngle::new(part);
                let force = ring.force_and_loads(&place, cage, &mut balls);
                assert_eq!(force, ring.force(&place, cage, 0.0));
                let alone: Vec<_> = ring.contacts(place, cage, 0.0).collect();
                assert_eq!(balls.len(), alone.len());
                for (ball, alone) in balls.iter().zip(&alone) {
                    let bits = |ball: &BallContact| {
                        [ball.load_inner, ball.load_outer, ball.approach].map(f64::to_bits)
                    };
                    assert_eq!(bits(ball), bits(alone));
                }
            }
        }
    }
}
