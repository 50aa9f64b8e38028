//! The seam of the design: the law of one ball.

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

/// A few balls side by side.
pub type Lanes = wide::f64x4;

/// Number of balls side by side.
pub const LANES: usize = 4;

/// Forces on balls side by side, as [`BallForce`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LaneForces {
    /// Axial forces F_a, N.
    pub axial: Lanes,
    /// Radial forces F_r, N.
    pub radial: Lanes,
    /// Moments about the inner groove centres, N m.
    pub couple: Lanes,
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
    fn forces(&self, axial: Lanes, radial: Lanes, speed: f64) -> LaneForces {
        one_by_one(self, axial, radial, speed)
    }

    /// Force and its exact derivative by position.
    fn force_and_tangent(&self, axial: f64, radial: f64, speed: f64) -> (BallForce, BallTangent);

    /// Loads at the inner and the outer race and their exact derivatives by position.
    fn load_slopes(&self, axial: f64, radial: f64, speed: f64) -> [LoadSlope; 2];

    /// How far balls are pressed past where they leave the inner race, m, negative where they are
    /// apart: there the force is not smooth. Infinite where the law is smooth throughout.
    #[inline(always)]
    fn past_lift_offs(&self, _axial: Lanes, _radial: Lanes, _speed: f64) -> Lanes {
        Lanes::splat(f64::INFINITY)
    }

    /// Loads and angles of both contacts.
    fn contact(&self, axial: f64, radial: f64, speed: f64) -> BallContact;
}

/// Forces on balls side by side by a law that knows only single balls. Out of line: costly laws gain
/// nothing from the wide registers that the loop over the balls is compiled for.
#[inline(never)]
pub(super) fn one_by_one<L: BallLaw + ?Sized>(
    law: &L,
    axial: Lanes,
    radial: Lanes,
    speed: f64,
) -> LaneForces {
    let (axial, radial) = (axial.to_array(), radial.to_array());
    let balls: [BallForce; LANES] = std::array::from_fn(|i| law.force(axial[i], radial[i], speed));
    LaneForces {
        axial: balls.map(|ball| ball.axial).into(),
        radial: balls.map(|ball| ball.radial).into(),
        couple: balls.map(|ball| ball.couple).into(),
    }
}
