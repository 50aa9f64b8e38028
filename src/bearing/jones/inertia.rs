//! What the motion of a ball asks of its contacts: centrifugal force and friction forces.

use super::direction::Direction;
use super::rate::Rate;
use crate::physics::RaceControl;

/// Inertia forces of a ball with their derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct InertiaForces {
    /// Centrifugal force F_c, N.
    pub(super) centrifugal: Rate,
    /// Friction force at the inner race T_i, N.
    pub(super) friction_inner: Rate,
    /// Friction force at the outer race T_o, N.
    pub(super) friction_outer: Rate,
}

/// Load at the inner race, in units of `F_0/4` (about the centrifugal force), at which inner
/// friction is full.
const FULL_FRICTION: f64 = 0.2;

/// The kinematic law of the inertia forces.
///
/// Jones's kinematics without trigonometric functions: with c = cos(α_i − α_o)
///
/// ```text
/// outer control:  ω_m/ω = (1 − γ' cos α_i)/(1 + c)       p = sin α_o (1 − γ' cos α_i)/(1 + c)
/// inner control:  ω_m/ω = (c − γ' cos α_o)/(1 + c)       p = sin α_i (1 + γ' cos α_o)/(1 + c)
/// F_c = F_0 (ω_m/ω)²,  F_0 = ½ m_b d_m ω²
/// T_i + T_o = 2 M_g/D = (2/5) F_0 (ω_m/ω) p,   p = γ' (|ω_R|/ω) sin β
/// ```
///
/// from the formulas of [`crate::physics::BallMotion`] and J = m_b D²/10. Beyond a right angle
/// between the contacts, where rolling has no sense, 1/(1 + c) goes on along its tangent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct InertiaLaw {
    pub(super) control: RaceControl,
    /// γ' = D/d_m.
    pub(super) diameter_ratio: f64,
    /// F_0/ω² = ½ m_b d_m, kg m.
    pub(super) scale: f64,
}

impl InertiaLaw {
    /// Inertia forces at a load of the inner race in N, contact directions and
    /// F_0 = ½ m_b d_m ω² in N.
    #[inline]
    pub(super) fn forces(
        &self,
        load_inner: f64,
        inner: &Direction,
        outer: &Direction,
        force_scale: f64,
    ) -> InertiaForces {
        let (sin_i, cos_i) = inner.sine_and_cosine(1);
        let (sin_o, cos_o) = outer.sine_and_cosine(2);
        let one = Rate::constant(1.0);
        let gamma = self.diameter_ratio;
        let share = inverse_of_one_plus(cos_i * cos_o + sin_i * sin_o);
        // outer control
        let orbit = (one - gamma * cos_i) * share;
        let centrifugal = force_scale * (orbit * orbit);
        let friction = 0.4 * (centrifugal * sin_o);
        match self.control {
            RaceControl::Outer => InertiaForces {
                centrifugal,
                friction_inner: Rate::constant(0.0),
                friction_outer: friction,
            },
            RaceControl::Even => {
                let grip = grip(load_inner, force_scale);
                let friction_inner = 0.5 * (grip * friction);
                InertiaForces {
                    centrifugal,
                    friction_inner,
                    friction_outer: friction - friction_inner,
                }
            }
            RaceControl::Inner => {
                let grip = grip(load_inner, force_scale);
                let slip = one - grip;
                let orbit = (cos_i * cos_o + sin_i * sin_o - gamma * cos_o) * share;
                let roll = sin_i * (one + gamma * cos_o) * share;
                InertiaForces {
                    centrifugal: grip * (force_scale * (orbit * orbit)) + slip * centrifugal,
                    friction_inner: grip * ((0.4 * force_scale) * (orbit * roll)),
                    friction_outer: slip * friction,
                }
            }
        }
    }
}

/// Share of the inner race's friction that its load can hold: 1 above a small load, 0 at none.
///
/// A race without load has no friction and controls nothing. Between, the smooth step 3x² − 2x³
/// hands both over to the outer race.
fn grip(load_inner: f64, force_scale: f64) -> Rate {
    let full = 0.25 * FULL_FRICTION * force_scale;
    if load_inner >= full {
        return Rate::constant(1.0);
    }
    let x = load_inner / full;
    Rate::new(x * x * (3.0 - 2.0 * x), [6.0 * x * (1.0 - x) / full, 0.0, 0.0])
}

/// 1/(1 + c) for c ≥ 0, its tangent 1 − c below.
fn inverse_of_one_plus(c: Rate) -> Rate {
    let (value, slope) = if c.value >= 0.0 {
        let inverse = 1.0 / (1.0 + c.value);
        (inverse, -inverse * inverse)
    } else {
        (1.0 - c.value, -1.0)
    };
    Rate {
        value,
        by: slope * c.by,
    }
}
