//! Inertia of a ball on its orbit: mass and centrifugal force.

use std::f64::consts::PI;

/// Mass of a solid ball, kg.
///
/// `m_b = π ρ D³/6`
///
/// ```
/// use jeffcott::physics::ball_mass;
/// // 7205C, steel of 7800 kg/m³, D = 7.938 mm: 2.0428 g.
/// assert!((ball_mass(7.938e-3, 7800.0) - 2.0428e-3).abs() < 5e-8);
/// ```
pub fn ball_mass(diameter: f64, density: f64) -> f64 {
    PI / 6.0 * density * diameter * diameter * diameter
}

/// Centrifugal force of a ball on its orbit, N.
///
/// `F_c = ½ m_b d_m ω_m²`
///
/// `m_b` mass in kg, `d_m` pitch diameter in m, `ω_m` orbital speed in rad/s.
///
/// Source: Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), vol. 2, ch. 3.
///
/// ```
/// use jeffcott::physics::centrifugal_force;
/// // 7205C at 1000 rad/s, 1000 N thrust: F_c = 6.38608 N at ω_m = 403.0 rad/s.
/// assert!((centrifugal_force(2.0428e-3, 38.5e-3, 403.0) - 6.386).abs() < 1e-3);
/// ```
pub fn centrifugal_force(mass: f64, pitch_diameter: f64, orbital_speed: f64) -> f64 {
    0.5 * mass * pitch_diameter * orbital_speed * orbital_speed
}
