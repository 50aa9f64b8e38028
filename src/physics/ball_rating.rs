//! Basic dynamic load rating of a ball bearing from its dimensions.

use std::f64::consts::PI;

/// Rating factor b_m of contemporary steel in radial ball bearings, ISO 281.
const MATERIAL_FACTOR: f64 = 1.3;

/// Groove factor of both races that the tables of ISO 281 rest on.
const GROOVE_FACTOR: f64 = 0.52;

/// Factor f_c of ISO 281 for single-row radial ball bearings, N and mm.
///
/// ```text
/// f_c = 98.0665·0.41·0.95 (2f/(2f − 1))^0.41 γ^0.3 (1 − γ)^1.39/(1 + γ)^(1/3) ·
///       {1 + [1.04 ((1 − γ)/(1 + γ))^1.72]^(10/3)}^(−0.3)
/// ```
///
/// `γ = D cos α/d_m`; both grooves have f = 0.52, as in the tables of the standard, which hold for inner grooves up to 0.52 and
/// outer ones up to 0.53. Wider ones: [`open_groove_factor`].
///
/// Source: ISO/TR 1281-1:2008, eq. 15; ISO 281:2007, table 2.
///
/// ```
/// use jeffcott::physics::rating_factor;
/// // ISO 281, table 2: 46.7 at γ = 0.05, 59.9 at 0.2, 48.4 at 0.4
/// for (gamma, printed) in [(0.05, 46.7), (0.2, 59.9), (0.4, 48.4)] {
///     assert!((rating_factor(gamma) / printed - 1.0).abs() < 1.5e-3);
/// }
/// ```
pub fn rating_factor(gamma: f64) -> f64 {
    let groove = 2.0 * GROOVE_FACTOR / (2.0 * GROOVE_FACTOR - 1.0);
    let races = 1.04 * ((1.0 - gamma) / (1.0 + gamma)).powf(1.72);
    98.0665 * 0.41 * 0.95 * groove.powf(0.41) * gamma.powf(0.3) * (1.0 - gamma).powf(1.39)
        / (1.0 + gamma).cbrt()
        * (1.0 + races.powf(10.0 / 3.0)).powf(-0.3)
}

/// Grooves up to which the tables of ISO 281 hold, inner race first.
const TABLE_GROOVES: [f64; 2] = [0.52, 0.53];

/// What grooves that are wider than those of the tables of ISO 281 leave of f_c and C; 1 of all others. `grooves` are f = r/D of
/// the inner and the outer race.
///
/// ```text
/// (2f_i/(2f_i − 1))^0.41 {1 + [1.04 ((1 − γ)/(1 + γ))^1.72 (f_i (2f_o − 1)/(f_o (2f_i − 1)))^0.41]^(10/3)}^(−0.3)
/// ```
///
/// with f_i of at least 0.52 and f_o of at least 0.53, over its value there.
///
/// Source: ISO/TR 1281-1:2008, eq. 15.
///
/// ```
/// use jeffcott::physics::open_groove_factor;
/// assert_eq!(open_groove_factor(0.2, [0.515, 0.52]), 1.0);
/// // by hand at γ = 0.2: of both grooves 14.661^0.41 (1 + 0.5178^(10/3))^−0.3 = 2.9131, of the tables 26^0.41 (1 + 0.6067^(10/3))^−0.3 =
/// // 3.6106
/// let left = open_groove_factor(0.2, [0.5366, 0.5366]);
/// assert!((left - 0.8068).abs() < 1e-4, "{left}");
/// ```
pub fn open_groove_factor(gamma: f64, grooves: [f64; 2]) -> f64 {
    let part = |[inner, outer]: [f64; 2]| {
        let [inner_width, outer_width] = [inner, outer].map(|factor| 2.0 * factor - 1.0);
        let races = 1.04
            * ((1.0 - gamma) / (1.0 + gamma)).powf(1.72)
            * (inner * outer_width / (outer * inner_width)).powf(0.41);
        (2.0 * inner / inner_width).powf(0.41) * (1.0 + races.powf(10.0 / 3.0)).powf(-0.3)
    };
    let open = std::array::from_fn(|race| f64::max(grooves[race], TABLE_GROOVES[race]));
    part(open) / part(TABLE_GROOVES)
}

/// Basic dynamic radial load rating C of a single-row ball bearing, N; lengths in m, `contact_angle` nominal, rad.
///
/// `C = b_m f_c cos^0.7 α Z^(2/3) D^1.8` with b_m = 1.3, D in mm; above 25.4 mm `3.647 D^1.4` for `D^1.8`. Times
/// [`open_groove_factor`] where grooves are wide.
///
/// Source: ISO 281:2007, eqs. 1 and 2.
///
/// ```
/// use jeffcott::physics::dynamic_rating;
/// // 7205C, 12 balls of 7.938 mm: 16.6 kN in the catalogues; 13 balls would have 17.5 kN
/// let rating = |balls| dynamic_rating(balls, 7.938e-3, 38.5e-3, 15f64.to_radians());
/// assert!((rating(12) - 16_589.0).abs() < 20.0, "{}", rating(12));
/// assert!((rating(13) - 17_499.0).abs() < 20.0, "{}", rating(13));
/// ```
pub fn dynamic_rating(
    balls: usize,
    ball_diameter: f64,
    pitch_diameter: f64,
    contact_angle: f64,
) -> f64 {
    let cosine = contact_angle.min(0.5 * PI).cos();
    let diameter = 1e3 * ball_diameter;
    let size = if diameter <= 25.4 {
        diameter.powf(1.8)
    } else {
        3.647 * diameter.powf(1.4)
    };
    let gamma = ball_diameter * cosine / pitch_diameter;
    MATERIAL_FACTOR
        * rating_factor(gamma)
        * cosine.powf(0.7)
        * (balls as f64).powf(2.0 / 3.0)
        * size
}
