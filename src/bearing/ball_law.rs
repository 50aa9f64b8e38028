//! The seam of the design: the law of one ball.

use fearless_simd::{Simd, SimdBase};

/// What the inner ring presses onto one ball, in the ball's own plane.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BallForce {
    /// Axial force F_a, N.
    pub axial: f64,
    /// Radial force F_r, N.
    pub radial: f64,
    /// Moment about the inner groove centre, N m; zero without gyroscopic friction. The moment of
    /// the ball about the shaft axis' normal is `N = R_i F_a + couple`.
    pub couple: f64,
}

/// Numbers of a few balls side by side, in registers as wide as the processor's level `S` has them.
/// The lanes are the same at every level and no products are fused, so that results are the same, bit
/// by bit.
pub type Lanes<S> = fearless_simd::f64x4<S>;

/// Number of balls side by side.
pub const LANES: usize = 4;

/// Forces on balls side by side, as [`BallForce`].
#[derive(Debug, Clone, Copy)]
pub struct LaneForces<S: Simd> {
    /// Axial forces F_a, N.
    pub axial: Lanes<S>,
    /// Radial forces F_r, N.
    pub radial: Lanes<S>,
    /// Moments about the inner groove centres, N m.
    pub couple: Lanes<S>,
}

/// Exact derivative of a [`BallForce`]: rows axial, radial, couple; columns A1, A2.
pub type BallTangent = [[f64; 2]; 3];

/// State of one ball's two contacts, for people to read.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BallContact {
    /// Normal load at the inner race, N.
    pub load_inner: f64,
    /// Normal load at the outer race, N.
    pub load_outer: f64,
    /// Contact angle at the inner race, rad.
    pub angle_inner: f64,
    /// Contact angle at the outer race, rad.
    pub angle_outer: f64,
    /// Approach of ball and inner race, m: of dry surfaces, so less than the elastic one by the
    /// film, and negative where they are apart. A law without ball inertia knows only that of both
    /// races together.
    pub approach: f64,
}

/// Normal load of one contact, and its slope.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LoadSlope {
    /// Normal load Q, N.
    pub load: f64,
    /// Its derivatives by A1 and A2, N/m.
    pub by_place: [f64; 2],
}

/// The law of one ball: from the place of the inner groove centre to the force that holds it there.
///
/// `axial` (A1) and `radial` (A2) are measured from the outer groove centre in m, `speed` is the
/// angular speed of the shaft in rad/s. An implementation is a pure function: the same arguments
/// give the same bytes, and every position, contact or none, has an answer.
pub trait BallLaw {
    /// Whether [`BallForce::couple`] can differ from zero; the ring leaves it out otherwise.
    const HAS_COUPLE: bool = false;

    /// Force at a position. Branch-free where speed counts: it runs in the innermost loop.
    fn force(&self, axial: f64, radial: f64, speed: f64) -> BallForce;

    /// Forces on balls side by side: the same numbers as by [`BallLaw::force`].
    #[inline(always)]
    fn forces<S: Simd>(&self, axial: Lanes<S>, radial: Lanes<S>, speed: f64) -> LaneForces<S> {
        one_by_one(self, axial, radial, speed)
    }

    /// Force and its exact derivative by position.
    fn force_and_tangent(&self, axial: f64, radial: f64, speed: f64) -> (BallForce, BallTangent);

    /// Loads at the inner and the outer race and their exact derivatives by position.
    fn load_slopes(&self, axial: f64, radial: f64, speed: f64) -> [LoadSlope; 2];

    /// How far a ball is pressed past where it leaves the inner race, m, negative where they are
    /// apart: there the force is not smooth. Infinite where the law is smooth throughout.
    fn past_lift_off(&self, _axial: f64, _radial: f64, _speed: f64) -> f64 {
        f64::INFINITY
    }

    /// Loads and angles of both contacts.
    fn contact(&self, axial: f64, radial: f64, speed: f64) -> BallContact;
}

/// Forces on balls side by side by a law that knows only single balls.
#[inline(always)]
pub(super) fn one_by_one<L: BallLaw + ?Sized, S: Simd>(
    law: &L,
    axial: Lanes<S>,
    radial: Lanes<S>,
    speed: f64,
) -> LaneForces<S> {
    let simd = axial.witness();
    let balls = single_balls(law, axial.into(), radial.into(), speed);
    let lanes = |of: fn(&BallForce) -> f64| Lanes::from_fn(simd, |i| of(&balls[i]));
    LaneForces {
        axial: lanes(|ball| ball.axial),
        radial: lanes(|ball| ball.radial),
        couple: lanes(|ball| ball.couple),
    }
}

/// Out of line: costly laws gain nothing from the wide registers that the loop over the balls is
/// compiled for.
#[inline(never)]
fn single_balls<L: BallLaw + ?Sized>(
    law: &L,
    axial: [f64; LANES],
    radial: [f64; LANES],
    speed: f64,
) -> [BallForce; LANES] {
    std::array::from_fn(|i| law.force(axial[i], radial[i], speed))
}
