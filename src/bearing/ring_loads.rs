//! Loads of all balls of a ring, a few side by side.

use fearless_simd::{Simd, SimdBase, SimdFloat, dispatch};

use super::ring_lanes::side_by_side;
use super::{BallContact, CageAngle, HertzLaw, LANES, Lanes, Ring, Vector5};

impl Ring<HertzLaw> {
    /// Loads and approaches of the balls as by [`Ring::contacts`], to the last bit, their angles zero.
    pub(super) fn loads(&self, displacement: &Vector5, cage: CageAngle, balls: &mut [BallContact]) {
        dispatch!(self.level, simd => self.loads_by(simd, displacement, cage, balls));
    }

    /// As [`Ring::loads`], for the processor's level `S`.
    #[inline(always)]
    fn loads_by<S: Simd>(
        &self,
        simd: S,
        displacement: &Vector5,
        cage: CageAngle,
        balls: &mut [BallContact],
    ) {
        let displacement = &side_by_side(simd, displacement);
        let law = self.law();
        let none = Lanes::splat(simd, 0.0);
        for (azimuths, balls) in self.lanes.iter().zip(balls.chunks_mut(LANES)) {
            let directions = azimuths.turned(simd, cage);
            let axial = directions.axial(self.free_axial, displacement, self.arm);
            let radial = directions.radial(self.free_radial, displacement);
            let reach = (axial * axial + radial * radial).sqrt() - law.distance;
            let approach = reach.max(none);
            let load = law.load_deflection_constant * approach * approach.sqrt();
            for (lane, ball) in balls.iter_mut().enumerate() {
                *ball = BallContact {
                    approach: reach[lane],
                    load_inner: load[lane],
                    load_outer: load[lane],
                    ..BallContact::default()
                };
            }
        }
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
                ring.loads(&place, cage, &mut balls);
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
