//! Sums over the balls of a ring: force, stiffness, and the force against the damping of the contacts.

use fearless_simd::{Simd, SimdBase, SimdFloat};

use super::number::{Dual, Lanes};
use super::ring::{Balls, Consumer, LaneVector, side_by_side};
use super::{BallForce, BallLaw, BearingRotation, ForceLaw, Matrix5, Ring, Vector5};
use crate::registers::in_wide_registers;

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

    /// As [`Ring::force`], for the processor's level `S`.
    #[inline(always)]
    pub(super) fn force_by<S: Simd>(
        &self,
        simd: S,
        law: &impl ForceLaw,
        displacement: &LaneVector<S>,
        rotation: &BearingRotation,
    ) -> Vector5 {
        let mut force = Force {
            law,
            speed: rotation.speed,
            arm: self.arm,
            sums: ForceSums::new(simd),
        };
        self.visit(simd, displacement, rotation, &mut force);
        force.sums.force(self.arm)
    }

    /// Force as by [`Ring::force`] and its exact derivative K = ∂F/∂q.
    pub fn force_and_stiffness(
        &self,
        law: &impl ForceLaw,
        displacement: &Vector5,
        rotation: &BearingRotation,
    ) -> (Vector5, Matrix5) {
        in_wide_registers!(self.level, simd => {
            let mut stiffness = Stiffness {
                law,
                speed: rotation.speed,
                arm: self.arm,
                sums: ForceSums::new(simd),
                slopes: [[Lanes::splat(simd, 0.0); 5]; 5],
            };
            self.visit(simd, &side_by_side(simd, displacement), rotation, &mut stiffness);
            let mut matrix = Matrix5::zeros();
            for row in 0..5 {
                for column in 0..5 {
                    matrix[(row, column)] = total(&stiffness.slopes[row][column]);
                }
            }
            (stiffness.sums.force(self.arm), matrix)
        })
    }

    /// Force as by [`Ring::force`], and the force that moves the ring at a rate against the damping of the contacts,
    /// given in the frame that turns with the cage.
    #[inline(always)]
    pub(super) fn damped_force_by<S: Simd>(
        &self,
        simd: S,
        (law, coefficients): (&impl BallLaw, [f64; 2]),
        [displacement, rate]: &[LaneVector<S>; 2],
        rotation: &BearingRotation,
    ) -> [Vector5; 2] {
        match &self.surfaces {
            None => {
                self.damped_by::<S, 2>(simd, (law, coefficients), [displacement, rate], rotation)
            }
            Some(_) => {
                self.damped_by::<S, 4>(simd, (law, coefficients), [displacement, rate], rotation)
            }
        }
    }

    /// The same, where the approaches change by the first D of A1, A2 and both drops.
    #[inline(always)]
    fn damped_by<S: Simd, const D: usize>(
        &self,
        simd: S,
        (law, coefficients): (&impl BallLaw, [f64; 2]),
        [displacement, rate]: [&LaneVector<S>; 2],
        rotation: &BearingRotation,
    ) -> [Vector5; 2] {
        let mut damped = DampedForce::<_, S, D> {
            ring: self,
            law,
            coefficients,
            rate,
            rotation,
            elastic: ForceSums::new(simd),
            damping: ForceSums::new(simd),
        };
        self.visit(simd, displacement, rotation, &mut damped);
        [
            damped.elastic.force(self.arm),
            damped.damping.force(self.arm),
        ]
    }
}

/// Sums over balls side by side of what each bears.
pub(super) struct ForceSums<S: Simd>([Lanes<S>; 5]);

impl<S: Simd> ForceSums<S> {
    #[inline(always)]
    pub fn new(simd: S) -> Self {
        Self([Lanes::splat(simd, 0.0); 5])
    }

    /// Adds the forces of balls; moments are summed over the arm, so that without a couple it stays out of the loop.
    #[inline(always)]
    pub fn add_force<L: ForceLaw>(
        &mut self,
        at: &Balls<S>,
        _law: &L,
        force: &BallForce<Lanes<S>>,
        arm: f64,
    ) {
        let moment = if L::HAS_COUPLE {
            force.axial + force.couple / arm
        } else {
            force.axial
        };
        self.add(at, [force.radial, force.axial, moment]);
    }

    /// Adds radial and axial forces in N, and moments over the arm that [`ForceSums::force`] is given.
    #[inline(always)]
    fn add(&mut self, at: &Balls<S>, [radial, axial, moment]: [Lanes<S>; 3]) {
        self.0[0] += radial * at.cos;
        self.0[1] += radial * at.sin;
        self.0[2] += axial * at.weight;
        self.0[3] += moment * at.sin;
        self.0[4] += moment * at.cos;
    }

    /// Force on the ring and its moment, N and N m. A loop: closures that are handed on are not compiled
    /// for wide registers.
    #[inline(always)]
    pub fn force(&self, arm: f64) -> Vector5 {
        let mut sums = [0.0; 5];
        for (sum, lanes) in sums.iter_mut().zip(&self.0) {
            *sum = total(lanes);
        }
        let [x, y, z, tilt_x, tilt_y] = sums;
        [x, y, z, arm * tilt_x, -arm * tilt_y]
    }
}

/// Sum of the balls side by side.
#[inline(always)]
pub(super) fn total<S: Simd>(lanes: &Lanes<S>) -> f64 {
    let [a, b, c, d] = **lanes;
    (a + b) + (c + d)
}

/// The force of a law.
struct Force<'a, L, S: Simd> {
    law: &'a L,
    speed: f64,
    arm: f64,
    sums: ForceSums<S>,
}

impl<L: ForceLaw, S: Simd> Consumer<S> for Force<'_, L, S> {
    #[inline(always)]
    fn take(&mut self, at: &Balls<S>) {
        let force = self.law.force(&at.ball, self.speed);
        self.sums.add_force(at, self.law, &force, self.arm);
    }
}

/// The force of a law and its slopes by the displacement.
struct Stiffness<'a, L, S: Simd> {
    law: &'a L,
    speed: f64,
    arm: f64,
    sums: ForceSums<S>,
    slopes: [[Lanes<S>; 5]; 5],
}

impl<L: ForceLaw, S: Simd> Consumer<S> for Stiffness<'_, L, S> {
    #[inline(always)]
    fn take(&mut self, at: &Balls<S>) {
        let force = self.law.force(&at.ball.with_slopes(), self.speed);
        self.sums.add_force(at, self.law, &force.value(), self.arm);
        let BallForce {
            axial,
            radial,
            couple,
        } = force;
        let moment: Dual<Lanes<S>, 2> = axial * self.arm + couple;
        // ∂(A1, A2)/∂q
        let zero = Lanes::splat(at.cos.witness(), 0.0);
        let [tilt_x, tilt_y] = [self.arm * at.sin, -self.arm * at.cos];
        let axial_slopes = [zero, zero, at.weight, tilt_x, tilt_y];
        let radial_slopes = [at.cos, at.sin, zero, zero, zero];
        let rows = [
            (at.cos, radial),
            (at.sin, radial),
            (at.weight, axial),
            (at.sin, moment),
            (-at.cos, moment),
        ];
        for (row, (factor, force)) in rows.into_iter().enumerate() {
            let [by_axial, by_radial] = [factor * force.slopes[0], factor * force.slopes[1]];
            for column in 0..5 {
                self.slopes[row][column] +=
                    by_axial * axial_slopes[column] + by_radial * radial_slopes[column];
            }
        }
    }
}

/// The force of a law and that against the damping of the contacts, [`super::ContactDamping`].
struct DampedForce<'a, L, S: Simd, const D: usize> {
    ring: &'a Ring,
    law: &'a L,
    /// c of both races, inner first, s/m.
    coefficients: [f64; 2],
    rate: &'a LaneVector<S>,
    rotation: &'a BearingRotation,
    elastic: ForceSums<S>,
    damping: ForceSums<S>,
}

impl<L: BallLaw, S: Simd, const D: usize> Consumer<S> for DampedForce<'_, L, S, D> {
    #[inline(always)]
    fn take(&mut self, at: &Balls<S>) {
        let ball = at.ball.with_slopes_by::<D>();
        let response = self.law.response(&ball, self.rotation.speed);
        let force = response.force.value();
        self.elastic.add_force(at, self.law, &force, self.ring.arm);
        let approaches = self.law.elastic_approaches(&response);
        let [axial_rate, radial_rate] = self.ring.components([0.0; 2], self.rate, [at.cos, at.sin]);
        let zero = Lanes::splat(at.cos.witness(), 0.0);
        let drop_rates = if D == 4 {
            self.ring.drop_rates(at, self.rotation)
        } else {
            [zero; 2]
        };
        let [mut axial, mut radial] = [zero; 2];
        for (race, approach) in approaches.into_iter().enumerate() {
            // F_d = Σ Q max(c δ̇, −1) ∂δ/∂A
            let [by_axial, by_radial] = [approach.slopes[0], approach.slopes[1]];
            let mut rate = by_axial * axial_rate + by_radial * radial_rate;
            for (slope, drop_rate) in approach.slopes[2..].iter().zip(&drop_rates) {
                rate += *slope * *drop_rate;
            }
            let limit = Lanes::splat(at.cos.witness(), -1.0);
            let damped = response.load[race].value * (self.coefficients[race] * rate).max(limit);
            axial += damped * by_axial;
            radial += damped * by_radial;
        }
        self.damping.add(at, [radial, axial, axial]);
    }
}
