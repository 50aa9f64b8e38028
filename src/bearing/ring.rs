//! The ring sum: one ball law, Z balls, five freedoms.

use fearless_simd::{Level, Simd, dispatch};
use nalgebra::SMatrix;

use super::ring_lanes::{Azimuths, LaneSums, LaneVector, side_by_side};
use super::{BallContact, BallForce, BallLaw, BallTangent, Geometry, LANES, LaneForces, Lanes};

/// Displacement or force of the inner ring: x, y, z, θx, θy or F_x, F_y, F_z, M_x, M_y.
pub type Vector5 = [f64; 5];

/// Derivative of a force by a displacement, both of five components.
pub type Matrix5 = SMatrix<f64, 5, 5>;

/// Cosine and sine of the cage angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CageAngle {
    /// cos ψ_c.
    pub cos: f64,
    /// sin ψ_c.
    pub sin: f64,
}

impl CageAngle {
    /// The cage where it stands at the start.
    pub const START: Self = Self { cos: 1.0, sin: 0.0 };

    /// The cage turned by `angle` in rad.
    #[inline]
    pub fn new(angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { cos, sin }
    }
}

/// What a ball at some azimuth bears.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Around {
    /// Azimuth φ, rad, from +X towards +Y.
    pub azimuth: f64,
    /// Change of the distance of the groove centres from the unloaded one, m.
    pub deformation: f64,
    /// Loads and contact angles.
    pub contact: BallContact,
}

/// All balls of a bearing under one law: the force that holds the inner ring in place.
///
/// ```text
/// A1_j = A sin α0 + z + R_i (θx sin φ_j − θy cos φ_j)   A2_j = A cos α0 + x cos φ_j + y sin φ_j
/// N_j = R_i F_a,j + couple_j
/// F = Σ_j (F_r cos φ, F_r sin φ, F_a, N sin φ, −N cos φ)
/// ```
///
/// The balls never move in the tables: cosines and sines of their azimuths are constants, turned with
/// the cage.
///
/// Source: Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), ch. 7; Jones (1960).
#[derive(Debug, Clone)]
pub struct Ring<L> {
    law: L,
    /// What the processor has.
    pub(super) level: Level,
    pub(super) lanes: Vec<Azimuths>,
    pub(super) azimuths: Vec<f64>,
    pub(super) free_axial: f64,
    pub(super) free_radial: f64,
    pub(super) arm: f64,
}

impl<L: BallLaw> Ring<L> {
    /// Places the balls of `geometry` evenly from azimuth `first_ball` in rad.
    pub fn new(geometry: &Geometry, first_ball: f64, law: L) -> Self {
        let balls = geometry.balls();
        let azimuths: Vec<f64> = (0..balls)
            .map(|ball| first_ball + std::f64::consts::TAU * ball as f64 / balls as f64)
            .collect();
        Self {
            law,
            level: Level::new(),
            lanes: azimuths.chunks(LANES).map(Azimuths::new).collect(),
            azimuths,
            free_axial: geometry.free_axial(),
            free_radial: geometry.free_radial(),
            arm: geometry.inner_groove_radius(),
        }
    }

    /// The same balls in the same places under another law.
    pub(super) fn under<M>(&self, law: M) -> Ring<M> {
        Ring {
            law,
            level: self.level,
            lanes: self.lanes.clone(),
            azimuths: self.azimuths.clone(),
            free_axial: self.free_axial,
            free_radial: self.free_radial,
            arm: self.arm,
        }
    }

    /// Force and moment that hold the inner ring at `displacement`, in N and N m.
    #[inline]
    pub fn force(&self, displacement: &Vector5, cage: CageAngle, speed: f64) -> Vector5 {
        dispatch!(self.level, simd => {
            let displacement = side_by_side(simd, displacement);
            self.force_by(simd, &displacement, cage, speed)
        })
    }

    /// As [`Ring::force`], for the processor's level `S`.
    #[inline(always)]
    pub(super) fn force_by<S: Simd>(
        &self,
        simd: S,
        displacement: &LaneVector<S>,
        cage: CageAngle,
        speed: f64,
    ) -> Vector5 {
        let mut sums = LaneSums::new(simd);
        for azimuths in &self.lanes {
            let directions = azimuths.turned(simd, cage);
            let axial = directions.axial(self.free_axial, displacement, self.arm);
            let radial = directions.radial(self.free_radial, displacement);
            let balls = self.law.forces(axial, radial, speed);
            sums.add(
                &directions,
                [balls.radial, balls.axial, self.moment(&balls)],
            );
        }
        sums.force(self.arm)
    }

    /// Moments over the arm, so that without a couple the arm stays out of the loop.
    #[inline(always)]
    pub(super) fn moment<S: Simd>(&self, balls: &LaneForces<S>) -> Lanes<S> {
        if L::HAS_COUPLE {
            balls.axial + balls.couple / self.arm
        } else {
            balls.axial
        }
    }

    /// Force as by [`Ring::force`] and its exact derivative K = ∂F/∂q.
    pub fn force_and_stiffness(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> (Vector5, Matrix5) {
        self.assemble(displacement, cage, |axial, radial| {
            self.law.force_and_tangent(axial, radial, speed)
        })
    }

    /// Loads and contact angles of every ball, ball 0 first.
    pub fn contacts(
        &self,
        displacement: Vector5,
        cage: CageAngle,
        speed: f64,
    ) -> impl Iterator<Item = BallContact> {
        self.placed(displacement, cage)
            .map(move |ball| self.law.contact(ball.axial, ball.radial, speed))
    }

    /// What a ball at each of `positions` azimuths from +X on would bear, or, where `None`, what
    /// every ball bears with the cage where it starts.
    pub fn around(
        &self,
        displacement: &Vector5,
        speed: f64,
        positions: Option<usize>,
    ) -> Vec<Around> {
        let at = |azimuth| self.at_azimuth(displacement, azimuth, speed);
        match positions {
            None => self.azimuths.iter().copied().map(at).collect(),
            Some(count) => (0..count)
                .map(|index| at(std::f64::consts::TAU * index as f64 / count as f64))
                .collect(),
        }
    }

    fn at_azimuth(&self, displacement: &Vector5, azimuth: f64, speed: f64) -> Around {
        let (sin, cos) = azimuth.sin_cos();
        let ball = self.place(displacement, sin, cos);
        let distance = ball.axial.hypot(ball.radial);
        Around {
            azimuth,
            deformation: distance - self.free_axial.hypot(self.free_radial),
            contact: self.law.contact(ball.axial, ball.radial, speed),
        }
    }
}

impl<L> Ring<L> {
    /// Law of its balls.
    pub fn law(&self) -> &L {
        &self.law
    }

    /// Sum over the balls of what `ball` gives for the place (A1, A2) of its inner groove centre.
    #[inline]
    pub(super) fn assemble(
        &self,
        displacement: &Vector5,
        cage: CageAngle,
        mut ball: impl FnMut(f64, f64) -> (BallForce, BallTangent),
    ) -> (Vector5, Matrix5) {
        let (mut force, mut stiffness) = ([0.0; 5], Matrix5::zeros());
        for place in self.placed(*displacement, cage) {
            let (push, tangent) = ball(place.axial, place.radial);
            let (sin, cos) = (place.sin, place.cos);
            let moment = self.arm * push.axial + push.couple;
            let moment_rate = [0, 1].map(|j| self.arm * tangent[0][j] + tangent[2][j]);
            let (axial_rate, radial_rate) = self.place_slopes(&place);
            let rows = [
                (cos, push.radial, tangent[1]),
                (sin, push.radial, tangent[1]),
                (1.0, push.axial, tangent[0]),
                (sin, moment, moment_rate),
                (-cos, moment, moment_rate),
            ];
            for (row, (factor, value, rate)) in rows.into_iter().enumerate() {
                force[row] += factor * value;
                for column in 0..5 {
                    stiffness[(row, column)] +=
                        factor * (rate[0] * axial_rate[column] + rate[1] * radial_rate[column]);
                }
            }
        }
        (force, stiffness)
    }

    /// Azimuths of the balls, their cage where it starts, with the place (A1, A2) of their inner
    /// groove centres.
    pub(super) fn places(&self, displacement: Vector5) -> impl Iterator<Item = (f64, [f64; 2])> {
        self.azimuths
            .iter()
            .copied()
            .zip(self.placed(displacement, CageAngle::START))
            .map(|(azimuth, ball)| (azimuth, [ball.axial, ball.radial]))
    }

    /// Every ball at its azimuth, with the place of its inner groove centre.
    pub(super) fn placed(
        &self,
        displacement: Vector5,
        cage: CageAngle,
    ) -> impl Iterator<Item = PlacedBall> {
        (0..self.azimuths.len()).map(move |ball| self.placed_ball(ball, &displacement, cage))
    }

    /// The same of one of the balls.
    #[inline(always)]
    pub(super) fn placed_ball(
        &self,
        ball: usize,
        displacement: &Vector5,
        cage: CageAngle,
    ) -> PlacedBall {
        let lanes = &self.lanes[ball / LANES];
        let lane = ball % LANES;
        let (sin_0, cos_0) = (lanes.sin[lane], lanes.cos[lane]);
        let cos = cos_0 * cage.cos - sin_0 * cage.sin;
        let sin = sin_0 * cage.cos + cos_0 * cage.sin;
        self.place(displacement, sin, cos)
    }

    /// dA1/dq and dA2/dq of a ball.
    #[inline(always)]
    pub(super) fn place_slopes(&self, ball: &PlacedBall) -> (Vector5, Vector5) {
        let (sin, cos) = (ball.sin, ball.cos);
        (
            [0.0, 0.0, 1.0, self.arm * sin, -self.arm * cos],
            [cos, sin, 0.0, 0.0, 0.0],
        )
    }

    /// The inner groove centre at an azimuth.
    fn place(&self, displacement: &Vector5, sin: f64, cos: f64) -> PlacedBall {
        let [x, y, z, tilt_x, tilt_y] = *displacement;
        PlacedBall {
            // in the order of the balls side by side: the same bytes
            axial: (self.free_axial + z) + (self.arm * tilt_x * sin - self.arm * tilt_y * cos),
            radial: self.free_radial + (x * cos + y * sin),
            cos,
            sin,
        }
    }
}

/// A ball at its azimuth, with the place (A1, A2) of its inner groove centre.
pub(super) struct PlacedBall {
    pub axial: f64,
    pub radial: f64,
    cos: f64,
    sin: f64,
}

/// The same components. Keeps what a function out of line is given, or returns, from sharing its memory
/// with what is worked out in place: reading that as a whole right after writing it in parts waits for the
/// parts.
#[inline(always)]
pub(crate) fn in_registers([x, y, z, tilt_x, tilt_y]: Vector5) -> Vector5 {
    [x, y, z, tilt_x, tilt_y]
}

/// A vector turned by a right angle about Z: the generator of rotations.
pub(crate) fn quarter_turn(vector: &Vector5) -> Vector5 {
    let [x, y, _, tilt_x, tilt_y] = *vector;
    [-y, x, 0.0, -tilt_y, tilt_x]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::{HertzLaw, catalogue};

    #[test]
    fn every_width_of_registers_gives_the_same_bytes() {
        let bearing = catalogue::find("7205C").expect("in the catalogue");
        let bearing = bearing.bearing().expect("a bearing");
        let law = HertzLaw {
            load_deflection_constant: bearing.load_deflection_constant().expect("a contact"),
            distance: bearing.geometry.groove_centre_distance(),
        };
        let best = Ring::new(&bearing.geometry, 0.1, law);
        let mut levels = vec![Level::baseline()];
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        levels.extend(best.level.as_sse4_2().map(Level::Sse4_2));
        for level in levels {
            let other = Ring {
                level,
                ..best.clone()
            };
            for step in 0..500 {
                let part = f64::from(step) * 0.37;
                let place = [3e-5, 2e-5, 4e-5, 1e-3, 2e-3].map(|size| size * part.sin());
                let cage = CageAngle::new(part);
                assert_eq!(
                    best.force(&place, cage, 0.0).map(f64::to_bits),
                    other.force(&place, cage, 0.0).map(f64::to_bits)
                );
            }
        }
    }
}
