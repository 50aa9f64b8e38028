//! Damping of the contacts of balls and races.

use super::ring::PlacedBall;
use super::{BallLaw, BearingError, CageAngle, HertzSpring, Ring, Vector5};

/// Hunt–Crossley damping of the contacts with both races.
///
/// ```text
/// Q_damped = Q (1 + c δ̇)   c = 3/2 α   never less than zero
/// ```
///
/// Q is the load of the ball law at a race in N, δ the elastic approach there in m, which follows
/// the motion of the ring (and the ball its balance) at once. As the force along a freedom of the
/// ring is
///
/// ```text
/// F_d = Σ_balls Σ_races Q max(c δ̇, −1) ∂δ/∂q
/// ```
///
/// the power that it takes, `Σ Q max(c δ̇, −1) δ̇`, is never negative: the damping dissipates only. A
/// ball that has left its race is not damped, and no race pulls at a ball. A sphere that meets a
/// wall at a small speed v leaves it at (1 − α v) v.
///
/// Source: K. H. Hunt & F. R. E. Crossley, *J. Applied Mechanics* 42 (1975) 440–445, who give
/// α = 0.08 … 0.32 s/m for steel, bronze and ivory.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ContactDamping {
    /// α at the inner race, s/m; zero for none.
    pub inner: f64,
    /// α at the outer race, s/m; zero for none.
    pub outer: f64,
}

impl ContactDamping {
    /// Whether neither contact is damped.
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// The damped contacts, `springs` the elastic ones; none without damping.
    ///
    /// # Errors
    /// [`BearingError::ContactDamping`] where a coefficient is negative or not finite.
    pub(super) fn races(
        &self,
        springs: [HertzSpring; 2],
    ) -> Result<Option<DampedRaces>, BearingError> {
        for value in [self.inner, self.outer] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(BearingError::ContactDamping { value });
            }
        }
        // c = 3/2 α
        let coefficients = [1.5 * self.inner, 1.5 * self.outer];
        Ok((!self.is_none()).then_some(DampedRaces {
            coefficients,
            stiffness: springs.map(|spring| spring.stiffness_under(1.0)),
        }))
    }
}

/// Damped contacts of a ring's balls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct DampedRaces {
    /// c of both races, inner first, s/m.
    pub coefficients: [f64; 2],
    /// 3/2 K^(2/3) of both races: their stiffness over the cube root of the load.
    stiffness: [f64; 2],
}

impl<L: BallLaw> Ring<L> {
    /// Force that the ring must press onto its contacts to move them at `rate`, seen by one who turns
    /// with the cage, in N and N m.
    pub(super) fn damping_force(
        &self,
        displacement: &Vector5,
        rate: &Vector5,
        cage: CageAngle,
        speed: f64,
        races: &DampedRaces,
    ) -> Vector5 {
        let mut force = [0.0; 5];
        for ball in self.placed(*displacement, cage) {
            let (by_axial, by_radial) = self.place_slopes(&ball);
            let [axial_rate, radial_rate] = [dot(&by_axial, rate), dot(&by_radial, rate)];
            let push = races.push(self.law(), &ball, speed, [axial_rate, radial_rate]);
            for axis in 0..5 {
                force[axis] += push[0] * by_axial[axis] + push[1] * by_radial[axis];
            }
        }
        force
    }
}

impl DampedRaces {
    /// Parts of the approach of both contacts in series that the inner and the outer one have.
    pub fn shares(&self) -> [f64; 2] {
        let [inner, outer] = self.stiffness;
        [outer, inner].map(|other| other / (inner + outer))
    }

    /// c_i s_i of both races, inner first, s/m: c over the approach of both contacts in series.
    pub fn losses(&self) -> [f64; 2] {
        let ([inner, outer], [inner_loss, outer_loss]) = (self.shares(), self.coefficients);
        [inner_loss * inner, outer_loss * outer]
    }

    /// Axial and radial force on one ball whose inner groove centre moves at a rate in m/s.
    fn push(&self, law: &impl BallLaw, ball: &PlacedBall, speed: f64, rate: [f64; 2]) -> [f64; 2] {
        let slopes = law.load_slopes(ball.axial, ball.radial, speed);
        let mut push = [0.0; 2];
        let root = slopes[0].load.cbrt();
        // most laws load both races alike
        let roots = if slopes[1].load == slopes[0].load {
            [root; 2]
        } else {
            [root, slopes[1].load.cbrt()]
        };
        for (race, slope) in slopes.iter().enumerate() {
            if slope.load <= 0.0 {
                continue;
            }
            let stiffness = self.stiffness[race] * roots[race];
            // ∂δ/∂A = (∂Q/∂A)/k
            let approach = slope.by_place.map(|by_place| by_place / stiffness);
            let approach_rate = approach[0] * rate[0] + approach[1] * rate[1];
            // Q max(c δ̇, −1)
            let damped = slope.load * (self.coefficients[race] * approach_rate).max(-1.0);
            push[0] += damped * approach[0];
            push[1] += damped * approach[1];
        }
        push
    }
}

fn dot(a: &Vector5, b: &Vector5) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
