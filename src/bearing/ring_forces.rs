//! Sums over the balls of a ring: force, stiffness, and the force against the damping of the contacts.

use fearless_simd::{Simd, SimdBase};

use super::number::Lanes;
use super::ring::{Balls, LaneVector, side_by_side};
use super::{Ball, BallForce, BallLaw, BearingRotation, ForceLaw, Matrix5, Ring, Vector5};
use crate::numerics::registers::in_wide_registers;

impl Ring {
    /// Force and moment that hold the inner ring at a displacement, in N and N m.
    ///
    /// ```text
    /// F = Σ_j (F_r cos φ, F_r sin φ, F_a, N sin φ, −N cos φ)   N_j = R_i F_a,j + couple_j
    /// ```
    pub fn force(
        &self,
        law: &impl ForceLaw,
        displacement: &Vector5,
        rotation: &BearingRotation,
    ) -> Vector5 {
        in_wide_registers!(self.level, simd => {
            let displacement = side_by_side(simd, displacement);
            self.force_by(simd, law, &displacement, rotation)
        })
    }

    /// Force as by [`Ring::force`], for the processor's level `S`.
    #[inline(always)]
    pub(super) fn force_by<S: Simd>(
        &self,
        simd: S,
        law: &impl ForceLaw,
        displacement: &LaneVector<S>,
        rotation: &BearingRotation,
    ) -> Vector5 {
        let mut sums = ForceSums::new(simd, self.arm);
        self.visit(
            simd,
            displacement,
            rotation,
            #[inline(always)]
            |at| sums.add_force(at, law, &law.force(&at.ball, rotation.speed)),
        );
        sums.force()
    }

    /// Force as by [`Ring::force`] and its exact derivative K = ∂F/∂q.
    ///
    /// ```text
    /// K = Σ_j B_jᵀ (∂(F_a, F_r, couple)/∂(A1, A2, T)) B_j        B_j = ∂(A1, A2, T)/∂q
    /// ```
    pub fn force_and_stiffness<L: ForceLaw>(
        &self,
        law: &L,
        displacement: &Vector5,
        rotation: &BearingRotation,
    ) -> (Vector5, Matrix5) {
        match L::FOLLOWS_TILT {
            true => self.force_and_slopes::<3>(law, displacement, rotation),
            false => self.force_and_slopes::<2>(law, displacement, rotation),
        }
    }

    /// Force and derivative, by the first D of A1, A2 and T.
    #[inline(always)]
    fn force_and_slopes<const D: usize>(
        &self,
        law: &impl ForceLaw,
        displacement: &Vector5,
        rotation: &BearingRotation,
    ) -> (Vector5, Matrix5) {
        in_wide_registers!(self.level, simd => {
            let arm = self.arm;
            let zero = Lanes::splat(simd, 0.0);
            let (mut sums, mut slopes) = (ForceSums::new(simd, arm), [[zero; 5]; 5]);
            let displacement = side_by_side(simd, displacement);
            self.visit(
                simd,
                &displacement,
                rotation,
                #[inline(always)]
                |at| {
                    // force of each ball and its slopes by A1, A2 and T
                    let force = law.force(&at.ball.with_slopes::<D>(), rotation.speed);
                    sums.add_force(at, law, &force.value());
                    // N = R_i F_a + couple
                    let moment = force.axial * arm + force.couple;
                    // B_j: how A1, A2 and T follow the ring
                    let axial_slopes = [zero, zero, at.side, arm * at.sin, -arm * at.cos];
                    let radial_slopes = [at.cos, at.sin, zero, zero, zero];
                    let tilt_slopes = [zero, zero, zero, at.sin, -at.cos];
                    // rows of K: F_x, F_y, F_z, M_x, M_y
                    let rows = [
                        (at.cos, force.radial),
                        (at.sin, force.radial),
                        (at.side, force.axial),
                        (at.sin, moment),
                        (-at.cos, moment),
                    ];
                    for (row, (factor, force)) in rows.into_iter().enumerate() {
                        let [by_axial, by_radial] = [factor * force.slopes[0], factor * force.slopes[1]];
                        for column in 0..5 {
                            slopes[row][column] +=
                                by_axial * axial_slopes[column] + by_radial * radial_slopes[column];
                            if D == 3 {
                                slopes[row][column] +=
                                    factor * force.slopes[2] * tilt_slopes[column];
                            }
                        }
                    }
                },
            );
            let mut matrix = Matrix5::zeros();
            for row in 0..5 {
                for column in 0..5 {
                    matrix[(row, column)] = total(&slopes[row][column]);
                }
            }
            (sums.force(), matrix)
        })
    }

    /// Force as by [`Ring::force`], and the force that moves the ring at a rate against the damping of the contacts,
    /// given in the frame that turns with the cage: sums over [`BallLaw::damped`].
    ///
    /// Loads change by A1 and A2, and where the surfaces are not perfect by both drops. Out of line: the laws in one
    /// function take the compiler far longer than each by itself.
    #[inline(never)]
    pub(super) fn damped_force(
        &self,
        law: &impl BallLaw,
        coefficients: [f64; 2],
        [displacement, rate]: [&Vector5; 2],
        rotation: &BearingRotation,
    ) -> [Vector5; 2] {
        in_wide_registers!(self.level, simd => {
            let [displacement, rate] = [side_by_side(simd, displacement), side_by_side(simd, rate)];
            let mut sums = [ForceSums::new(simd, self.arm), ForceSums::new(simd, self.arm)];
            match &self.surfaces {
                None => self.visit_perfect(
                    simd,
                    &displacement,
                    rotation,
                    #[inline(always)]
                    |at| {
                        let rate = self.ball_rate(at, &rate, [Lanes::splat(simd, 0.0); 2]);
                        let forces =
                            law.damped::<_, 2>(&at.ball, &rate, coefficients, rotation.speed);
                        self.add_damped(&mut sums, at, law, &forces);
                    },
                ),
                Some(surfaces) => self.visit_imperfect(
                    simd,
                    surfaces,
                    &displacement,
                    rotation,
                    #[inline(always)]
                    |at| {
                        let speeds = [rotation.cage_speed, rotation.speed];
                        let drops = surfaces.rates(at.first, [&at.cos, &at.sin], rotation, speeds);
                        let drops = drops.map(|rates| Lanes::load_array(simd, rates));
                        let rate = self.ball_rate(at, &rate, drops);
                        let forces =
                            law.damped::<_, 4>(&at.ball, &rate, coefficients, rotation.speed);
                        self.add_damped(&mut sums, at, law, &forces);
                    },
                ),
            }
            let [elastic, damping] = sums;
            [elastic.force(), damping.force()]
        })
    }

    /// Ȧ1, Ȧ2 and Ṫ of balls, with the rates of the drops under them.
    #[inline(always)]
    fn ball_rate<S: Simd>(
        &self,
        at: &Balls<S>,
        rate: &LaneVector<S>,
        drop: [Lanes<S>; 2],
    ) -> Ball<Lanes<S>> {
        let [axial, radial, tilt] = self.components([0.0; 2], rate, [at.cos, at.sin, at.side]);
        Ball {
            axial,
            radial,
            tilt,
            drop,
        }
    }

    /// Adds the elastic forces of balls and those that resist their rates.
    #[inline(always)]
    fn add_damped<L: BallLaw, S: Simd>(
        &self,
        [elastic, damping]: &mut [ForceSums<S>; 2],
        at: &Balls<S>,
        law: &L,
        (force, resisting): &(BallForce<Lanes<S>>, Ball<Lanes<S>>),
    ) {
        elastic.add_force(at, law, force);
        let moment = match L::FOLLOWS_TILT {
            true => resisting.axial + resisting.tilt / self.arm,
            false => resisting.axial,
        };
        damping.add(at, [resisting.radial, resisting.axial, moment]);
    }
}

/// Sums over balls side by side of what each bears.
pub(super) struct ForceSums<S: Simd> {
    sums: [Lanes<S>; 5],
    arm: f64,
}

impl<S: Simd> ForceSums<S> {
    /// Empty sums of a ring whose inner groove centres lie on a circle of a radius in m.
    #[inline(always)]
    pub fn new(simd: S, arm: f64) -> Self {
        let sums = [Lanes::splat(simd, 0.0); 5];
        Self { sums, arm }
    }

    /// Adds the forces of balls; moments are summed over the arm, so that without a couple it stays out of the loop.
    #[inline(always)]
    pub fn add_force<L: ForceLaw>(&mut self, at: &Balls<S>, _law: &L, force: &BallForce<Lanes<S>>) {
        let moment = if L::HAS_COUPLE {
            force.axial + force.couple / self.arm
        } else {
            force.axial
        };
        self.add(at, [force.radial, force.axial, moment]);
    }

    /// Adds radial and axial forces in N, and moments over the arm.
    #[inline(always)]
    fn add(&mut self, at: &Balls<S>, [radial, axial, moment]: [Lanes<S>; 3]) {
        self.sums[0] += radial * at.cos;
        self.sums[1] += radial * at.sin;
        self.sums[2] += axial * at.side;
        self.sums[3] += moment * at.sin;
        self.sums[4] += moment * at.cos;
    }

    /// Force on the ring and its moment, N and N m. A loop: closures that are handed on are not compiled
    /// for wide registers.
    #[inline(always)]
    pub fn force(&self) -> Vector5 {
        let mut sums = [0.0; 5];
        for (sum, lanes) in sums.iter_mut().zip(&self.sums) {
            *sum = total(lanes);
        }
        let [x, y, z, tilt_x, tilt_y] = sums;
        [x, y, z, self.arm * tilt_x, -self.arm * tilt_y]
    }
}

/// Sum of the balls side by side.
#[inline(always)]
fn total<S: Simd>(lanes: &Lanes<S>) -> f64 {
    let [a, b, c, d] = **lanes;
    (a + b) + (c + d)
}
