//! What a ball law is: the seam between the contacts of one ball and the ring.

use serde::Serialize;

use super::{BallState, RaceFilms};
use crate::bearing::number::{Dual, Function, Number, Plain};
use crate::physics::FilmContact;

/// A ball between its races, seen in its own plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball<T = f64> {
    /// A1: axial distance of the inner groove centre from the outer one, m.
    pub axial: T,
    /// A2: their radial distance, m.
    pub radial: T,
    /// How much lower the surfaces of the inner and the outer race lie under the ball, m: zero on perfect races.
    pub drop: [T; 2],
}

impl Ball {
    /// On perfect races.
    pub fn at(axial: f64, radial: f64) -> Self {
        Self {
            axial,
            radial,
            drop: [0.0; 2],
        }
    }
}

impl<T: Plain> Ball<T> {
    /// The same with slopes by the first D, 2 or 4, of A1, A2 and both drops.
    #[inline(always)]
    pub fn with_slopes<const D: usize>(&self) -> Ball<Dual<T, D>> {
        let [inner, outer] = self.drop;
        Ball {
            axial: Dual::variable(self.axial, 0),
            radial: Dual::variable(self.radial, 1),
            drop: if D == 4 {
                [Dual::variable(inner, 2), Dual::variable(outer, 3)]
            } else {
                [Dual::fixed(inner), Dual::fixed(outer)]
            },
        }
    }
}

/// What the inner ring presses onto one ball, in the ball's own plane.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BallForce<T = f64> {
    /// Axial force F_a, N.
    pub axial: T,
    /// Radial force F_r, N.
    pub radial: T,
    /// Moment about the inner groove centre, N m; zero without gyroscopic friction. The moment of
    /// the ball about the shaft axis' normal is `N = R_i F_a + couple`.
    pub couple: T,
}

impl<T> From<[T; 3]> for BallForce<T> {
    #[inline(always)]
    fn from([axial, radial, couple]: [T; 3]) -> Self {
        Self {
            axial,
            radial,
            couple,
        }
    }
}

impl<T: Plain, const D: usize> BallForce<Dual<T, D>> {
    /// The force without its slopes.
    #[inline(always)]
    pub fn value(&self) -> BallForce<T> {
        BallForce {
            axial: self.axial.value,
            radial: self.radial.value,
            couple: self.couple.value,
        }
    }
}

/// Exact derivative of a [`BallForce`]: rows axial, radial, couple; columns A1, A2.
pub type BallTangent = [[f64; 2]; 3];

/// How a ball answers to the position of the inner ring.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BallResponse<T = f64> {
    /// What the inner ring presses onto it.
    pub force: BallForce<T>,
    /// Normal loads at the inner and the outer race, N.
    pub load: [T; 2],
    /// Approach of ball and inner race, m, as [`BallContact::approach`].
    pub approach: T,
}

/// State of one ball's two contacts, for people to read.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct BallContact {
    /// Normal load at the inner race, N.
    #[serde(rename = "load_inner_N")]
    pub load_inner: f64,
    /// Normal load at the outer race, N.
    #[serde(rename = "load_outer_N")]
    pub load_outer: f64,
    /// Contact angle at the inner race, rad.
    #[serde(rename = "angle_inner_rad")]
    pub angle_inner: f64,
    /// Contact angle at the outer race, rad.
    #[serde(rename = "angle_outer_rad")]
    pub angle_outer: f64,
    /// Approach of ball and inner race, m: of dry surfaces, so less than the elastic one by the
    /// film, and negative where they are apart. A law without ball inertia knows only that of both
    /// races together.
    #[serde(rename = "approach_m")]
    pub approach: f64,
}

/// What holds the inner groove centre of one ball: a law or the table of one.
///
/// An implementation is a pure function: the same arguments give the same bytes, and every position, contact or
/// none, has an answer.
pub trait ForceLaw {
    /// Whether `BallForce::couple` can differ from zero; the ring leaves it out otherwise.
    const HAS_COUPLE: bool;

    /// Force at a shaft speed in rad/s. Free of branches where its speed counts: it runs in the innermost loop.
    fn force<T: Number>(&self, ball: &Ball<T>, speed: f64) -> BallForce<T>;

    /// How far a ball is pressed past where it leaves the inner race, m, negative where they are
    /// apart: there the force is not smooth. Infinite where the law is smooth throughout.
    fn distance_past_lift_off<T: Plain>(&self, ball: &Ball<T>, _speed: f64) -> T {
        ball.axial.constant(f64::INFINITY)
    }

    /// Force on a single ball of perfect races and its exact derivative by position.
    fn force_and_tangent(&self, axial: f64, radial: f64, speed: f64) -> (BallForce, BallTangent) {
        let force = self.force(&Ball::at(axial, radial).with_slopes(), speed);
        let parts = [force.axial, force.radial, force.couple];
        (force.value(), parts.map(|part| part.slopes))
    }
}

/// The law of one ball, written once for every `Number`.
pub trait BallLaw {
    /// Whether the ball has inertia: then its force has a couple, and where it lifts off depends on the speed.
    const HAS_INERTIA: bool = false;

    /// Force, loads and approach of a ball at a shaft speed in rad/s. Free of branches where its speed counts.
    fn response<T: Number>(&self, ball: &Ball<T>, speed: f64) -> BallResponse<T>;

    /// How far a ball is pressed past its lift-off on dry races, m; not asked of a law with films.
    fn past_lift_off<T: Plain>(&self, ball: &Ball<T>, _speed: f64) -> T {
        ball.axial.constant(f64::INFINITY)
    }

    /// Loads and angles of both contacts; without inertia both races press along one line.
    fn contact(&self, ball: &Ball, speed: f64) -> BallContact {
        let response = self.response(ball, speed);
        let angle = ball.axial.atan2(ball.radial);
        BallContact {
            load_inner: response.load[0],
            load_outer: response.load[1],
            angle_inner: angle,
            angle_outer: angle,
            approach: response.approach,
        }
    }

    /// Elastic approaches of a ball and both races under its loads, m, inner first.
    fn elastic_approaches<T: Number>(&self, response: &BallResponse<T>) -> [T; 2];

    /// Approach as in [`BallContact::approach`] under a load in N at the inner race, m.
    fn approach_under(&self, load: f64, speed: f64) -> f64;

    /// Largest load, N, of a ball so far past its lift-off in m; zero where the law is smooth there.
    fn load_past_lift_off(&self, _distance: f64, _speed: f64) -> f64 {
        0.0
    }

    /// Oil films of both races, where the law has them: its force is then smooth where a ball leaves the inner race.
    fn films(&self) -> Option<&RaceFilms> {
        None
    }

    /// Inertia and motion of a ball, where the law does not neglect its inertia.
    fn state(&self, _ball: &Ball, _speed: f64) -> Option<BallState> {
        None
    }

    /// Derivative of the force with rigid films; asked of a law with films only.
    fn contact_tangent(&self, _ball: &Ball, _speed: f64) -> BallTangent {
        BallTangent::default()
    }

    /// Energy, J, that the contacts of a ball store behind their films.
    ///
    /// ```text
    /// U = Σ_races ∫ Q ds = 2/5 Q δ + (0.067/0.933) Q h   δ = (Q/K)^(2/3),  s(Q) = δ(Q) − h(Q)
    /// ```
    ///
    /// The second part is the film's: its thickness falls with the load as Q^(−0.067).
    fn stored_energy(&self, ball: &Ball, speed: f64) -> f64 {
        const SHARE: f64 = FilmContact::LOAD_EXPONENT / (1.0 - FilmContact::LOAD_EXPONENT);
        let response = self.response(ball, speed);
        let approaches = self.elastic_approaches(&response);
        let films = self.films();
        let thickness = films.map(|films| films.thickness(response.load, speed));
        let energy = |race: usize| {
            let load = response.load[race];
            let film = thickness.map_or(0.0, |thickness| thickness[race].central);
            if load > 0.0 {
                0.4 * load * approaches[race] + SHARE * load * film
            } else {
                0.0
            }
        };
        energy(0) + energy(1)
    }

    /// Q_i³ and Q_o^(10/3) of the loads: what the rating life of both races is made of.
    #[inline(always)]
    fn life_powers<T: Plain>(&self, response: &BallResponse<T>) -> [T; 2] {
        let [inner, outer] = response.load;
        let [power] = T::apply(&TenThirds, [outer]);
        [inner * inner * inner, power]
    }
}

impl<L: BallLaw> ForceLaw for L {
    const HAS_COUPLE: bool = L::HAS_INERTIA;

    #[inline(always)]
    fn force<T: Number>(&self, ball: &Ball<T>, speed: f64) -> BallForce<T> {
        self.response(ball, speed).force
    }

    #[inline(always)]
    fn distance_past_lift_off<T: Plain>(&self, ball: &Ball<T>, speed: f64) -> T {
        match self.films() {
            None => self.past_lift_off(ball, speed),
            Some(_) => ball.axial.constant(f64::INFINITY),
        }
    }
}

/// x^(10/3).
struct TenThirds;

impl Function<1, 1> for TenThirds {
    fn with_slopes(&self, [x]: [f64; 1]) -> ([f64; 1], [[f64; 1]; 1]) {
        let power = x * x * x.cbrt();
        ([power * x], [[10.0 / 3.0 * power]])
    }
}
