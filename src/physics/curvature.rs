//! Curvature sum and difference of a ball in a grooved race.

/// The two numbers of Hertz's theory that the shapes of the bodies enter by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curvature {
    /// Curvature sum Σρ, 1/m.
    pub sum: f64,
    /// Curvature difference F(ρ), dimensionless, 0 (sphere on sphere) … 1 (line contact).
    pub difference: f64,
}

/// Curvature of a ball on the inner race.
///
/// ```text
/// Σρ   = (4 − 1/f + 2γ/(1 − γ))/D
/// F(ρ) = (1/f + 2γ/(1 − γ))/(D Σρ)
/// ```
///
/// `f` groove factor r/D, `D` ball diameter in m, `γ = D cos α/d_m`. Holds for 0 ≤ γ < 1.
///
/// Source: Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), eqs. 2.28 and 2.30.
///
/// ```
/// use jeffcott::physics::inner_race_curvature;
/// // 218 angular contact bearing, Harris example 2.5: D = 22.23 mm, f = 0.5232, γ = 0.1355.
/// let curvature = inner_race_curvature(0.02223, 0.5232, 0.1355);
/// assert!((curvature.sum * 1e-3 - 0.108).abs() < 5e-4); // 1/mm
/// assert!((curvature.difference - 0.9260).abs() < 5e-4);
/// ```
pub fn inner_race_curvature(ball_diameter: f64, groove_factor: f64, gamma: f64) -> Curvature {
    race_curvature(ball_diameter, groove_factor, 2.0 * gamma / (1.0 - gamma))
}

/// Curvature of a ball on the outer race.
///
/// ```text
/// Σρ   = (4 − 1/f − 2γ/(1 + γ))/D
/// F(ρ) = (1/f − 2γ/(1 + γ))/(D Σρ)
/// ```
///
/// `f` groove factor r/D, `D` ball diameter in m, `γ = D cos α/d_m`. Holds for γ ≥ 0.
///
/// Source: Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), eqs. 2.31 and 2.32.
///
/// ```
/// use jeffcott::physics::outer_race_curvature;
/// // 218 angular contact bearing, Harris example 2.5: D = 22.23 mm, f = 0.5232, γ = 0.1355.
/// let curvature = outer_race_curvature(0.02223, 0.5232, 0.1355);
/// assert!((curvature.sum * 1e-3 - 0.0832).abs() < 5e-4); // 1/mm
/// assert!((curvature.difference - 0.9038).abs() < 5e-4);
/// ```
pub fn outer_race_curvature(ball_diameter: f64, groove_factor: f64, gamma: f64) -> Curvature {
    race_curvature(ball_diameter, groove_factor, -2.0 * gamma / (1.0 + gamma))
}

fn race_curvature(ball_diameter: f64, groove_factor: f64, rolling_term: f64) -> Curvature {
    let sum = (4.0 - 1.0 / groove_factor + rolling_term) / ball_diameter;
    let difference = (1.0 / groove_factor + rolling_term) / (ball_diameter * sum);
    Curvature { sum, difference }
}
