//! Motion of a ball between two races: Jones's kinematics under race control.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Which race the ball rolls on without spinning, and which race supplies the friction that holds
/// the gyroscopic moment.
///
/// The friction force at a race is `T = λ M_g/D` with λ_i + λ_o = 2: λ_o = 2 under outer control, λ_i = 2
/// under inner control. Even control, λ_i = λ_o = 1, by itself says nothing about the pitch angle: the ball
/// moves as under outer control.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RaceControl {
    /// The outer race, which then holds the gyroscopic moment alone: what holds at speed.
    #[default]
    Outer,
    /// The inner race, which then holds the gyroscopic moment alone.
    Inner,
    /// Rolling as under outer control, both races holding the gyroscopic moment evenly.
    Even,
}

/// Motion of a ball relative to the shaft's speed.
///
/// ```text
/// outer control:  tan β = sin α_o/(cos α_o + γ')
/// inner control:  tan β = sin α_i/(cos α_i − γ')
/// ω_m/ω   = 1/[1 + (1 + γ' cos α_o) cos(α_i − β)/((1 − γ' cos α_i) cos(α_o − β))]
/// |ω_R|/ω = 1/{[cos(α_o − β)/(1 + γ' cos α_o) + cos(α_i − β)/(1 − γ' cos α_i)] γ'}
/// ```
///
/// `α` contact angles in rad, `γ' = D/d_m`, `β` pitch angle of the ball's own axis. Outer ring
/// fixed, no sliding in the rolling direction. Holds for contact angles less than a right angle
/// apart.
///
/// Source: A. B. Jones, *J. Basic Engineering* 82 (1960) 309–320; Harris & Kotzalas, *Rolling
/// Bearing Analysis*, 5th ed. (2007), vol. 2, ch. 2.
///
/// ```
/// use jeffcott::physics::{BallMotion, RaceControl};
/// // 7205C at its free angle of 15°: the nominal cage ratio (1 − γ)/2 = 0.40042.
/// let angle = 15f64.to_radians();
/// let motion = BallMotion::new(RaceControl::Outer, 7.938 / 38.5, angle, angle);
/// assert!((motion.orbital_ratio - 0.40042).abs() < 5e-6);
/// assert!(motion.spin_to_roll_outer.abs() < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallMotion {
    /// Pitch angle β of the ball's own axis, rad.
    pub pitch_angle: f64,
    /// Orbital speed over shaft speed, ω_m/ω.
    pub orbital_ratio: f64,
    /// Speed about the ball's own axis over shaft speed, |ω_R|/ω.
    pub rolling_ratio: f64,
    /// Spin over rolling speed at the inner race; zero under inner control.
    pub spin_to_roll_inner: f64,
    /// Spin over rolling speed at the outer race; zero under outer control.
    pub spin_to_roll_outer: f64,
}

impl BallMotion {
    /// Motion at given contact angles in rad; `diameter_ratio` is γ' = D/d_m.
    pub fn new(
        control: RaceControl,
        diameter_ratio: f64,
        angle_inner: f64,
        angle_outer: f64,
    ) -> Self {
        let gamma = diameter_ratio;
        let (sin_i, cos_i) = angle_inner.sin_cos();
        let (sin_o, cos_o) = angle_outer.sin_cos();
        let beta = match control {
            // tan β = sin α_i/(cos α_i − γ')
            RaceControl::Inner => sin_i.atan2(cos_i - gamma),
            // tan β = sin α_o/(cos α_o + γ')
            RaceControl::Outer | RaceControl::Even => sin_o.atan2(cos_o + gamma),
        };
        // surface speeds of the ball over its radius per unit of orbit radius
        let inner = (angle_inner - beta).cos() / (1.0 - gamma * cos_i);
        let outer = (angle_outer - beta).cos() / (1.0 + gamma * cos_o);
        Self {
            pitch_angle: beta,
            orbital_ratio: outer / (outer + inner),
            rolling_ratio: 1.0 / ((outer + inner) * gamma),
            // (1 − γ' cos α_i) tan(α_i − β) + γ' sin α_i
            spin_to_roll_inner: (1.0 - gamma * cos_i) * (angle_inner - beta).tan() + gamma * sin_i,
            // (1 + γ' cos α_o) tan(α_o − β) − γ' sin α_o
            spin_to_roll_outer: (1.0 + gamma * cos_o) * (angle_outer - beta).tan() - gamma * sin_o,
        }
    }
}

/// A race of the bearing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Race {
    /// The race on the shaft.
    #[default]
    Inner,
    /// The race in the housing.
    Outer,
}

/// The race that controls by Jones's criterion: the one that resists spinning more.
///
/// `Q_o a_o E_o cos(α_i − α_o) > Q_i a_i E_i` → outer race
///
/// `resistance = Q a E` of a race in N m: load, semi-major axis of its ellipse and complete
/// elliptic integral of the second kind; `angle_difference = α_i − α_o` in rad.
///
/// Source: A. B. Jones (1960); Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007),
/// vol. 2, ch. 2.
///
/// ```
/// use jeffcott::physics::{Race, controlling_race};
/// assert_eq!(controlling_race(1.0, 2.1, 60f64.to_radians()), Race::Outer);
/// assert_eq!(controlling_race(1.0, 1.9, 60f64.to_radians()), Race::Inner);
/// ```
pub fn controlling_race(
    resistance_inner: f64,
    resistance_outer: f64,
    angle_difference: f64,
) -> Race {
    if resistance_outer * angle_difference.cos() > resistance_inner {
        Race::Outer
    } else {
        Race::Inner
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_controlling_race_does_not_spin() {
        for (control, inner) in [(RaceControl::Outer, false), (RaceControl::Inner, true)] {
            let motion = BallMotion::new(control, 0.2, 0.7, 0.4);
            let (free, held) = if inner {
                (motion.spin_to_roll_outer, motion.spin_to_roll_inner)
            } else {
                (motion.spin_to_roll_inner, motion.spin_to_roll_outer)
            };
            assert!(held.abs() < 1e-15 && free.abs() > 0.1);
        }
    }

    #[test]
    fn mirrored_angles_mirror_the_motion() {
        let motion = BallMotion::new(RaceControl::Outer, 0.2, 0.7, 0.4);
        let mirrored = BallMotion::new(RaceControl::Outer, 0.2, -0.7, -0.4);
        assert_eq!(mirrored.pitch_angle, -motion.pitch_angle);
        assert_eq!(mirrored.orbital_ratio, motion.orbital_ratio);
    }
}
