//! Damping of the contacts of balls and races.

use super::BearingError;

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

    /// Coefficients c of both races, inner first, s/m; none without damping.
    ///
    /// # Errors
    /// [`BearingError::ContactDamping`] where a coefficient is negative or not finite.
    pub(super) fn coefficients(&self) -> Result<Option<[f64; 2]>, BearingError> {
        for value in [self.inner, self.outer] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(BearingError::ContactDamping { value });
            }
        }
        // c = 3/2 α
        let coefficients = [1.5 * self.inner, 1.5 * self.outer];
        Ok((!self.is_none()).then_some(coefficients))
    }
}
