//! Basic load ratings of a roller bearing from its dimensions.

/// Factor f_c of ISO 281 for radial roller bearings, N and mm.
///
/// ```text
/// f_c = 0.83·207.9 γ^(2/9) (1 − γ)^(29/27)/(1 + γ)^(1/4) ·
///       {1 + [1.04 ((1 − γ)/(1 + γ))^(143/108)]^(9/2)}^(−2/9)
/// ```
///
/// Source: Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), ch. 11, with the reduction factor 0.83 of ISO
/// 281:2007, table 7.
///
/// ```
/// use jeffcott::physics::roller_rating_factor;
/// // ISO 281, table 7: 52.1 at γ = 0.01, 84.2 at 0.1, 88.7 at 0.2
/// for (gamma, printed) in [(0.01, 52.1), (0.1, 84.2), (0.2, 88.7)] {
///     assert!((roller_rating_factor(gamma) / printed - 1.0).abs() < 1.5e-3);
/// }
/// ```
pub fn roller_rating_factor(gamma: f64) -> f64 {
    let races = 1.04 * ((1.0 - gamma) / (1.0 + gamma)).powf(143.0 / 108.0);
    0.83 * 207.9 * gamma.powf(2.0 / 9.0) * (1.0 - gamma).powf(29.0 / 27.0)
        / (1.0 + gamma).powf(0.25)
        * (1.0 + races.powf(4.5)).powf(-2.0 / 9.0)
}

/// Basic dynamic radial load rating C of a radial roller bearing, N.
///
/// `C = b_m f_c (i L cos α)^(7/9) Z^(3/4) D^(29/27)` in N and mm
///
/// | symbol | meaning | unit |
/// |---|---|---|
/// | b_m | rating factor of contemporary steel: 1.1, of spherical rollers 1.15 | – |
/// | i, Z | rows, rollers of a row | – |
/// | L, D | effective length and diameter of a roller | m |
/// | α, d_m | nominal contact angle, pitch diameter | rad, m |
///
/// Source: ISO 281:2007, eq. 20.
///
/// ```
/// use jeffcott::physics::roller_dynamic_rating;
/// // by hand, 13 rollers 7.5 × 8 mm on 46 mm: f_c = 88.6, 8^(7/9) = 5.04, 13^(3/4) = 6.85, 7.5^(29/27) = 8.71
/// let rating = roller_dynamic_rating(1.1, [1, 13], 7.5e-3, 8e-3, 46e-3, 0.0);
/// assert!((rating - 29_300.0).abs() < 100.0, "{rating}");
/// ```
pub fn roller_dynamic_rating(
    material_factor: f64,
    [rows, rollers]: [usize; 2],
    diameter: f64,
    length: f64,
    pitch_diameter: f64,
    contact_angle: f64,
) -> f64 {
    let cosine = contact_angle.cos();
    let gamma = diameter * cosine / pitch_diameter;
    material_factor
        * roller_rating_factor(gamma)
        * (rows as f64 * 1e3 * length * cosine).powf(7.0 / 9.0)
        * (rollers as f64).powf(0.75)
        * (1e3 * diameter).powf(29.0 / 27.0)
}

/// Basic static radial load rating C_0 of a radial roller bearing, N.
///
/// `C_0 = 44 (1 − γ) i Z L D cos α` in N and mm
///
/// | symbol | meaning | unit |
/// |---|---|---|
/// | γ | D cos α/d_m | – |
/// | i Z | rollers in all rows | – |
/// | L, D | effective length and diameter of a roller | m |
/// | α | contact angle | rad |
///
/// Source: ISO 76:2006, eq. 12.
///
/// ```
/// use jeffcott::physics::{LineContact, Material, contact_modulus, roller_static_rating};
/// // 13 rollers 7.5 × 8 mm on 46 mm: the roller that bears most, 5 C_0/Z, presses the inner race with 4000 MPa
/// let rating = roller_static_rating(13, 7.5e-3, 8e-3, 46e-3, 0.0);
/// let steel = contact_modulus(&Material::BEARING_STEEL, &Material::BEARING_STEEL);
/// let inner = LineContact { curvature: 2.0 / 7.5e-3 + 2.0 / (46e-3 - 7.5e-3), modulus: steel };
/// let by_pressure = 13.0 / 5.0 * 8e-3 * inner.load_under(4e9);
/// assert!((rating / by_pressure - 1.0).abs() < 0.02, "{rating} {by_pressure}");
/// ```
pub fn roller_static_rating(
    rollers: usize,
    diameter: f64,
    length: f64,
    pitch_diameter: f64,
    angle: f64,
) -> f64 {
    let gamma = diameter * angle.cos() / pitch_diameter;
    // 44 N/mm²
    44e6 * (1.0 - gamma) * rollers as f64 * length * diameter * angle.cos()
}
