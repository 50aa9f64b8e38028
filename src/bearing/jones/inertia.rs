//! What the motion of a ball asks of its contacts: centrifugal force and friction forces.

use super::contact::Contact;
use super::rate::Rate;
use crate::physics::RaceControl;

/// Inertia forces of a ball with their derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct InertiaForces {
    /// Centrifugal force F_c, N.
    pub(super) centrifugal: Rate,
    /// Friction force at the inner race T_i, N.
    pub(super) friction_inner: Rate,
    /// Friction force at the outer race T_o, N.
    pub(super) friction_outer: Rate,
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
    /// Inertia forces of a ball between two contacts; `force_scale` is F_0 in N.
    #[inline(always)]
    pub(super) fn forces(
        &self,
        inner: &Contact,
        outer: &Contact,
        force_scale: f64,
    ) -> InertiaForces {
        let angles = Angles::new(inner, outer);
        let [centrifugal, friction] = self.outer_control(&angles, force_scale);
        let [centrifugal, friction] = if inner.length < NEAR * inner.free_length {
            let carried = self.carried(&angles, force_scale);
            let near = smooth_step(inner.length, NEAR * inner.free_length);
            [
                centrifugal.blend(&carried[0], &near),
                friction.blend(&carried[1], &near),
            ]
        } else {
            [centrifugal, friction]
        };
        match self.control {
            RaceControl::Outer => InertiaForces {
                centrifugal,
                friction_inner: Rate::default(),
                friction_outer: friction,
            },
            RaceControl::Even => {
                let grip = grip(inner, force_scale);
                let friction_inner = friction.scaled(0.5).blend(&Rate::default(), &grip);
                InertiaForces {
                    centrifugal,
                    friction_inner,
                    friction_outer: friction.minus(&friction_inner),
                }
            }
            RaceControl::Inner => {
                let grip = grip(inner, force_scale);
                let held = self.inner_control(&angles, force_scale);
                let nothing = Rate::default();
                InertiaForces {
                    centrifugal: held[0].blend(&centrifugal, &grip),
                    friction_inner: held[1].blend(&nothing, &grip),
                    friction_outer: nothing.blend(&friction, &grip),
                }
            }
        }
    }

    /// F_c and 2 M_g/D under outer race control.
    #[inline(always)]
    fn outer_control(&self, angles: &Angles, force_scale: f64) -> [Rate; 2] {
        let gamma = self.diameter_ratio;
        let Angles {
            sin_i,
            cos_i,
            sin_o,
            cos_o,
            share,
            turn,
        } = *angles;
        // ω_m/ω = (1 − γ' cos α_i)/(1 + c)
        let orbit = (1.0 - gamma * cos_i) * share;
        let orbit_by_outer = -orbit * turn;
        let orbit_by_inner = gamma * sin_i * share - orbit_by_outer;
        // F_c = F_0 (ω_m/ω)²
        let value = force_scale * orbit * orbit;
        let slope = 2.0 * force_scale * orbit;
        let centrifugal = Rate {
            value,
            by_length: 0.0,
            by_inner: slope * orbit_by_inner,
            by_outer: slope * orbit_by_outer,
        };
        // 2 M_g/D = (2/5) F_c sin α_o, for here p = (ω_m/ω) sin α_o
        let mut friction = centrifugal.scaled(0.4 * sin_o);
        friction.by_outer += 0.4 * value * cos_o;
        [centrifugal, friction]
    }

    /// F_c and 2 M_g/D under inner race control.
    #[inline(always)]
    fn inner_control(&self, angles: &Angles, force_scale: f64) -> [Rate; 2] {
        let gamma = self.diameter_ratio;
        let Angles {
            sin_i,
            cos_i,
            sin_o,
            cos_o,
            share,
            turn,
        } = *angles;
        // ω_m/ω = (c − γ' cos α_o)/(1 + c) = 1 − (1 + γ' cos α_o)/(1 + c)
        let rest = (1.0 + gamma * cos_o) * share;
        let rest_by_inner = rest * turn;
        let rest_by_outer = -gamma * sin_o * share - rest_by_inner;
        let orbit = 1.0 - rest;
        // F_c = F_0 (ω_m/ω)²
        let slope = -2.0 * force_scale * orbit;
        let centrifugal = Rate {
            value: force_scale * orbit * orbit,
            by_length: 0.0,
            by_inner: slope * rest_by_inner,
            by_outer: slope * rest_by_outer,
        };
        // 2 M_g/D = (2/5) F_0 (ω_m/ω) p,  p = sin α_i (1 + γ' cos α_o)/(1 + c)
        let scale = 0.4 * force_scale;
        let by_rest = scale * sin_i * (orbit - rest);
        let friction = Rate {
            value: scale * sin_i * orbit * rest,
            by_length: 0.0,
            by_inner: by_rest * rest_by_inner + scale * cos_i * orbit * rest,
            by_outer: by_rest * rest_by_outer,
        };
        [centrifugal, friction]
    }

    /// F_c and 2 M_g/D of a ball that the cage carries round: outer control with α_i = α_o.
    fn carried(&self, angles: &Angles, force_scale: f64) -> [Rate; 2] {
        let Angles { sin_o, cos_o, .. } = *angles;
        // ω_m/ω = (1 − γ' cos α_o)/2
        let orbit = 0.5 * (1.0 - self.diameter_ratio * cos_o);
        let value = force_scale * orbit * orbit;
        let centrifugal = Rate {
            value,
            by_outer: force_scale * orbit * self.diameter_ratio * sin_o,
            ..Rate::default()
        };
        let mut friction = centrifugal.scaled(0.4 * sin_o);
        friction.by_outer += 0.4 * value * cos_o;
        [centrifugal, friction]
    }
}

/// Sines and cosines of the contact angles, and what they have in common.
#[derive(Debug, Clone, Copy)]
struct Angles {
    sin_i: f64,
    cos_i: f64,
    sin_o: f64,
    cos_o: f64,
    /// 1/(1 + c).
    share: f64,
    /// −∂ ln(1 + c)/∂α_i = ∂ ln(1 + c)/∂α_o.
    turn: f64,
}

impl Angles {
    #[inline(always)]
    fn new(inner: &Contact, outer: &Contact) -> Self {
        let (sin_i, cos_i) = (inner.normal.x, inner.normal.y);
        let (sin_o, cos_o) = (outer.normal.x, outer.normal.y);
        let (c, slope) = bounded_cosine(cos_i * cos_o + sin_i * sin_o);
        let share = 1.0 / (1.0 + c);
        // ∂ cos(α_i − α_o)/∂α_o = sin(α_i − α_o)
        let turn = slope * (sin_i * cos_o - cos_i * sin_o) * share;
        Self {
            sin_i,
            cos_i,
            sin_o,
            cos_o,
            share,
            turn,
        }
    }
}

/// c itself where Jones's kinematics hold; below, a parabola down to c = 0, then constant. With
/// its derivative.
#[inline(always)]
fn bounded_cosine(c: f64) -> (f64, f64) {
    if c >= FARTHEST {
        (c, 1.0)
    } else {
        let c = c.max(0.0);
        (0.5 * (FARTHEST + c * c / FARTHEST), c / FARTHEST)
    }
}

/// Share of the inner race's friction that its load can hold: 1 above a small load, 0 at none.
#[inline(always)]
fn grip(inner: &Contact, force_scale: f64) -> Rate {
    let full = FULL_GRIP * force_scale;
    if inner.load >= full {
        return Rate {
            value: 1.0,
            ..Rate::default()
        };
    }
    let by_load = smooth_step(inner.load, full);
    Rate {
        by_length: by_load.by_length * inner.stiffness,
        ..by_load
    }
}

/// 3x² − 2x³ of x = length/end in 0 … 1: from 0 to 1 without a kink.
#[inline(always)]
fn smooth_step(length: f64, end: f64) -> Rate {
    let x = length / end;
    Rate {
        value: x * x * (3.0 - 2.0 * x),
        by_length: 6.0 * x * (1.0 - x) / end,
        ..Rate::default()
    }
}
