//! Inertia of a ball on its orbit: centrifugal force and gyroscopic moment.

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

/// Moment of inertia of a solid ball about its centre, kg m².
///
/// `J = m_b D²/10`
///
/// ```
/// use jeffcott::physics::ball_inertia;
/// // 7205C: 2.0428 g, D = 7.938 mm.
/// assert!((ball_inertia(2.0428e-3, 7.938e-3) - 1.28721e-8).abs() < 5e-14);
/// ```
pub fn ball_inertia(mass: f64, diameter: f64) -> f64 {
    mass * diameter * diameter / 10.0
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

/// Gyroscopic moment of a ball whose spin axis is inclined to its orbit's axis, N m.
///
/// `M_g = J |ω_R| ω_m sin β`
///
/// `J` moment of inertia in kg m², `ω_R` speed of rotation about the ball's own axis and `ω_m`
/// orbital speed in rad/s, `β` pitch angle of the spin axis in rad. Positive with β: the races
/// must supply it by friction along the direction of motion.
///
/// Source: A. B. Jones, *J. Basic Engineering* 82 (1960) 309–320.
///
/// ```
/// use jeffcott::physics::gyroscopic_moment;
/// assert_eq!(gyroscopic_moment(2.0, 3.0, 5.0, std::f64::consts::FRAC_PI_2), 30.0);
/// ```
pub fn gyroscopic_moment(
    inertia: f64,
    rolling_speed: f64,
    orbital_speed: f64,
    pitch_angle: f64,
) -> f64 {
    inertia * rolling_speed.abs() * orbital_speed * pitch_angle.sin()
}
