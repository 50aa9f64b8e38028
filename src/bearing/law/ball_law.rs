//! What a ball law is: the seam between the contacts of one ball and the ring.

use super::{
    Ball, BallContact, BallForce, BallResponse, BallState, BallTangent, ContactSpring, Lamina,
};
use crate::bearing::number::{Number, Plain};

/// What holds the inner groove centre of one ball: a law or the table of one.
///
/// An implementation is a pure function: the same arguments give the same bytes, and every position, contact or
/// none, has an answer.
pub trait ForceLaw {
    /// Whether `BallForce::couple` can differ from zero; the ring leaves it out otherwise.
    const HAS_COUPLE: bool;

    /// Whether the force depends on `Ball::tilt`; the ring leaves its slopes out otherwise.
    const FOLLOWS_TILT: bool = false;

    /// Force at a shaft speed in rad/s. Free of branches where its speed counts: it runs in the innermost loop.
    fn force<T: Number>(&self, ball: &Ball<T>, speed: f64) -> BallForce<T>;

    /// Number of places of a ball that part from the inner race each by itself, as the laminae of a roller.
    fn places(&self) -> usize {
        1
    }

    /// How far a place of a ball is pressed past where it leaves the inner race, m, negative where they are apart: there the
    /// force is not smooth. Infinite where the law is smooth throughout.
    fn distance_past_lift_off<T: Plain>(&self, ball: &Ball<T>, _place: usize, _speed: f64) -> T {
        ball.axial.constant(f64::INFINITY)
    }

    /// Force on a single ball of perfect races and its exact derivative by position.
    fn force_and_tangent(&self, axial: f64, radial: f64, speed: f64) -> (BallForce, BallTangent) {
        let force = self.force(&Ball::at(axial, radial).with_slopes(), speed);
        let parts = [force.axial, force.radial, force.couple];
        (force.value(), parts.map(|part| part.slopes))
    }
}

/// The law of one ball, written once for every `Number`: its force, and what its contacts bear.
pub trait BallLaw: ForceLaw {
    /// Contact with the inner race, behind its film where there is one.
    type Spring: ContactSpring;

    /// Force, loads and approach of a ball at a shaft speed in rad/s. Free of branches where its speed counts.
    fn response<T: Number>(&self, ball: &Ball<T>, speed: f64) -> BallResponse<T>;

    /// Load by the approach of [`BallContact::approach`] at a speed in rad/s: of both races in series under a law
    /// without ball inertia.
    fn spring(&self, speed: f64) -> Self::Spring;

    /// Exponent n of the elastic contacts, `Q = K δ^n`: with it the force sets in where a ball meets the inner race.
    fn exponent(&self) -> f64 {
        1.5
    }

    /// Largest load of a place of a ball so far past its lift-off in m, N, with all others that part together with it.
    fn load_past_lift_off(&self, distance: f64, speed: f64) -> f64 {
        self.spring(speed).load_and_stiffness(distance).0
    }

    /// Elastic approaches of a ball and both races under its loads, m, inner first.
    fn elastic_approaches<T: Number>(&self, response: &BallResponse<T>) -> [T; 2];

    /// Force of a ball at its place, and what resists its rate by the damping of its contacts with coefficients c in s/m,
    /// inner race first: conjugate to A1, A2, the tilt and both drops, of which it follows the first D, without the tilt.
    ///
    /// ```text
    /// δ̇ = ∂δ/∂A1 Ȧ1 + ∂δ/∂A2 Ȧ2 + ∂δ/∂h_i ḣ_i + ∂δ/∂h_o ḣ_o        D_a = Σ_races Q max(c δ̇, −1) ∂δ/∂a
    /// ```
    #[inline(always)]
    fn damped<T: Plain, const D: usize>(
        &self,
        ball: &Ball<T>,
        rate: &Ball<T>,
        coefficients: [f64; 2],
        speed: f64,
    ) -> (BallForce<T>, Ball<T>) {
        // loads, and elastic approaches with their slopes
        let response = self.response(&ball.with_slopes::<D>(), speed);
        let zero = ball.axial.constant(0.0);
        let rates = [rate.axial, rate.radial, rate.drop[0], rate.drop[1]];
        let mut sums = [zero; 4];
        let approaches = self.elastic_approaches(&response);
        for race in 0..2 {
            let slopes = approaches[race].slopes;
            let mut rate = slopes[0] * rates[0] + slopes[1] * rates[1];
            for variable in 2..D {
                rate = rate + slopes[variable] * rates[variable];
            }
            // no contact pulls: c δ̇ ≥ −1
            let limited = (rate * coefficients[race]).at_least(-1.0);
            let damped = response.load[race].value * limited;
            for variable in 0..D {
                sums[variable] = sums[variable] + damped * slopes[variable];
            }
        }
        let [axial, radial, inner, outer] = sums;
        let resisting = Ball {
            axial,
            radial,
            tilt: zero,
            drop: [inner, outer],
        };
        (response.force.value(), resisting)
    }

    /// Angle, rad, of the line along which both races press without inertia.
    fn contact_angle(&self, ball: &Ball) -> f64 {
        ball.axial.atan2(ball.radial)
    }

    /// Loads and angles of both contacts; without inertia both races press along one line.
    fn contact(&self, ball: &Ball, speed: f64) -> BallContact {
        let response = self.response(ball, speed);
        let angle = self.contact_angle(ball);
        BallContact {
            load_inner: response.load[0],
            load_outer: response.load[1],
            angle_inner: angle,
            angle_outer: angle,
            approach: response.approach,
        }
    }

    /// Inertia and motion of a ball, where the law does not neglect its inertia.
    fn state(&self, _ball: &Ball, _speed: f64) -> Option<BallState> {
        None
    }

    /// The laminae of a roller; none of a ball.
    fn laminae(&self, _ball: &Ball) -> Vec<Lamina> {
        Vec::new()
    }

    /// Leaves the loads of the laminae of a roller, N, in `loads`, which has room for them.
    fn slice_loads(&self, _ball: &Ball, _loads: &mut [f64]) {}

    /// Energies, J, that the elastic contacts of a ball with both races store: `∫ Q dδ = Q δ/(1 + n)`.
    fn elastic_energies(&self, _ball: &Ball, response: &BallResponse) -> [f64; 2] {
        let approaches = self.elastic_approaches(response);
        let share = 1.0 / (1.0 + self.exponent());
        [0, 1].map(|race| share * response.load[race] * approaches[race])
    }
}

/// A law whose contacts bear through oil films: its force is smooth where a ball leaves the inner race.
pub trait FilmLaw: BallLaw {
    /// Derivative of the force with rigid films.
    fn contact_tangent(&self, ball: &Ball, speed: f64) -> BallTangent;
}
