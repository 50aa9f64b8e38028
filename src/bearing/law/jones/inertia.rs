//! What the motion of a ball asks of its contacts: centrifugal force and friction forces.

use super::balance::Contact;
use crate::bearing::dual::Dual;
use crate::bearing::number::Number;
use crate::physics::RaceControl;

/// Inertia forces of a ball, N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct InertiaForces<T> {
    /// Centrifugal force F_c.
    pub(super) centrifugal: T,
    /// Friction forces T at the inner and the outer race.
    pub(super) friction: [T; 2],
}

/// Load at the inner race above which its friction is full, in units of F_0.
const FULL_GRIP: f64 = 0.1;
/// Distance of ball and inner groove centre above which Jones's kinematics hold, in units of the
/// distance at first touch.
const NEAR: f64 = 0.9;
/// Cosine of the angle between the contacts down to which Jones's kinematics hold.
const FARTHEST: f64 = 0.25;

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
/// from the formulas of [`crate::physics::BallMotion`] and J = m_b D²/10.
///
/// Where those say nothing, the law goes on smoothly: an inner race that bears (almost) nothing
/// neither rubs nor controls, the outer race then does both; a ball far from the inner race orbits
/// at the nominal cage speed; contacts more than a right angle apart count as a right angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct InertiaLaw {
    pub(super) control: RaceControl,
    /// γ' = D/d_m.
    pub(super) diameter_ratio: f64,
    /// F_0/ω² = ½ m_b d_m, kg m.
    pub(super) scale: f64,
}

impl InertiaLaw {
    /// Inertia forces of a ball between its contacts with the inner and the outer race; `force_scale` is F_0 in N.
    #[inline(always)]
    pub(super) fn forces<const D: usize>(
        &self,
        contacts: &[Contact<Dual<f64, D>>; 2],
        force_scale: f64,
    ) -> InertiaForces<Dual<f64, D>> {
        let zero = Dual::fixed(0.0);
        let [centrifugal, friction] = self.outer_control(contacts, force_scale);
        let grip = || grip(&contacts[0], force_scale);
        let (centrifugal, friction) = match self.control {
            RaceControl::Outer => (centrifugal, [zero, friction]),
            RaceControl::Even => {
                let held = grip() * friction * 0.5;
                (centrifugal, [held, friction - held])
            }
            RaceControl::Inner => {
                let grip = grip();
                let [held, inner_friction] = self.inner_control(contacts, force_scale);
                let friction = [inner_friction * grip, blend(zero, friction, grip)];
                (blend(held, centrifugal, grip), friction)
            }
        };
        InertiaForces {
            centrifugal,
            friction,
        }
    }

    /// F_c/F_0 of a ball that rests on the outer race alone, at α_o = 0, by cos α_i.
    #[inline(always)]
    pub(super) fn thrown<T: Number>(&self, cosine: T) -> T {
        let one = cosine.constant(1.0);
        let orbit = (cosine * -self.diameter_ratio + 1.0) * (one / (bounded(cosine) + 1.0));
        orbit * orbit
    }

    /// F_c and 2 M_g/D under outer race control; far from the inner race more and more those of a ball that the cage
    /// carries round: outer control with α_i = α_o.
    #[inline(always)]
    fn outer_control<const D: usize>(
        &self,
        contacts: &[Contact<Dual<f64, D>>; 2],
        force_scale: f64,
    ) -> [Dual<f64, D>; 2] {
        let [inner, outer] = contacts;
        // F_c = F_0 (ω_m/ω)², 2 M_g/D = (2/5) F_c sin α_o, for here p = (ω_m/ω) sin α_o
        let forces = |orbit: Dual<f64, D>| {
            let centrifugal = orbit * orbit * force_scale;
            [centrifugal, centrifugal * outer.sin * 0.4]
        };
        // ω_m/ω = (1 − γ' cos α_i)/(1 + c)
        let free = forces((inner.cos * -self.diameter_ratio + 1.0) * share(contacts));
        let near = (inner.length - inner.approach) * NEAR;
        if inner.length.value >= near.value {
            return free;
        }
        // ω_m/ω = (1 − γ' cos α_o)/2
        let carried = forces((outer.cos * -self.diameter_ratio + 1.0) * 0.5);
        let near = smooth_step(inner.length / near);
        [0, 1].map(|part| blend(free[part], carried[part], near))
    }

    /// F_c and 2 M_g/D under inner race control.
    #[inline(always)]
    fn inner_control<const D: usize>(
        &self,
        contacts: &[Contact<Dual<f64, D>>; 2],
        force_scale: f64,
    ) -> [Dual<f64, D>; 2] {
        let [inner, outer] = contacts;
        // ω_m/ω = (c − γ' cos α_o)/(1 + c) = 1 − (1 + γ' cos α_o)/(1 + c)
        let rest = (outer.cos * self.diameter_ratio + 1.0) * share(contacts);
        let orbit = rest * -1.0 + 1.0;
        // 2 M_g/D = (2/5) F_0 (ω_m/ω) p,  p = sin α_i (1 + γ' cos α_o)/(1 + c)
        let friction = inner.sin * orbit * rest * (0.4 * force_scale);
        [orbit * orbit * force_scale, friction]
    }
}

/// 1/(1 + c) with a bounded c = cos(α_i − α_o).
#[inline(always)]
fn share<const D: usize>([inner, outer]: &[Contact<Dual<f64, D>>; 2]) -> Dual<f64, D> {
    let bounded = bounded(inner.cos * outer.cos + inner.sin * outer.sin);
    let share = 1.0 / (1.0 + bounded.value);
    bounded.chained(share, -share * share)
}

/// c itself where Jones's kinematics hold; below, a parabola down to c = 0, then constant.
#[inline(always)]
fn bounded<T: Number>(c: T) -> T {
    let c = c.positive();
    let below = (c * -1.0 + FARTHEST).positive();
    c + below * below * (0.5 / FARTHEST)
}

/// Share of the inner race's friction that its load can hold: 1 above a small load, 0 at none.
#[inline(always)]
fn grip<const D: usize>(inner: &Contact<Dual<f64, D>>, force_scale: f64) -> Dual<f64, D> {
    let full = FULL_GRIP * force_scale;
    if inner.load.value >= full {
        Dual::fixed(1.0)
    } else {
        smooth_step(inner.load * (1.0 / full))
    }
}

/// `weight` × `one` + (1 − `weight`) × `other`.
#[inline(always)]
fn blend<T: Number>(one: T, other: T, weight: T) -> T {
    other + weight * (one - other)
}

/// 3x² − 2x³ of x in 0 … 1: from 0 to 1 without a kink.
#[inline(always)]
fn smooth_step<T: Number>(x: T) -> T {
    x * x * (x * -2.0 + 3.0)
}
