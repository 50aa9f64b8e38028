//! Line contact of a roller and a race: stiffness of a slice, half-width and pressure.

use std::f64::consts::PI;

/// Exponent n of a line contact, `Q = C δ^n`.
pub const LINE_EXPONENT: f64 = 10.0 / 9.0;
/// c of `Q = c L^(8/9) δ^(10/9)` for a steel roller between both races in series, Pa (35 948 N/mm²).
const BOTH_RACES: f64 = 35_948e6;
/// Young's modulus of that steel, Pa.
const YOUNGS_MODULUS: f64 = 206e9;
/// Poisson's ratio of that steel.
const POISSON_RATIO: f64 = 0.3;

/// Constant C of `Q = C δ^(10/9)`, N/m^(10/9), of a roller between both races in series.
///
/// `C = 35 948 L^(8/9)` in N and mm for steel, in proportion to the modulus of the contact
///
/// | symbol | meaning | unit |
/// |---|---|---|
/// | L | effective length of the roller | m |
/// | E* | contact modulus, [`super::contact_modulus`] | Pa |
///
/// Holds for rollers and races of bearings' proportions, whose radii hardly matter; the contact with one race alone is
/// 2^(10/9) times as stiff.
///
/// Source: ISO/TS 16281:2008, 4.2.2, after G. Lundberg and H. Sjövall (1958).
///
/// ```
/// use jeffcott::physics::{Material, contact_modulus, line_stiffness};
/// // L = 13.6 mm of steel with E = 206 GPa: 1000 N press a roller in by 4.932 µm.
/// let steel = Material { youngs_modulus: 206e9, ..Material::BEARING_STEEL };
/// let stiffness = line_stiffness(13.6e-3, contact_modulus(&steel, &steel));
/// assert!(((1000.0 / stiffness).powf(0.9) - 4.932438e-6).abs() < 1e-12);
/// ```
pub fn line_stiffness(length: f64, modulus: f64) -> f64 {
    let steel = 0.5 * YOUNGS_MODULUS / (1.0 - POISSON_RATIO * POISSON_RATIO);
    // C in N/m^(10/9): N/mm^(10/9) are 1000^(10/9) of them, and L^(8/9) in mm 1000^(8/9) of that in m
    BOTH_RACES * length.powf(8.0 / 9.0) * (modulus / steel)
}

/// Contact of a roller and a race, both straight: a strip under an elliptic pressure.
///
/// ```text
/// b = √(4 w/(π E* Σρ))        p_max = 2w/(π b)
/// ```
///
/// w is the load per length. Each slice of a roller is taken for itself, so that its ends have no stress
/// concentration but that of its profile and tilt.
///
/// Source: H. Hertz (1881); K. L. Johnson, *Contact Mechanics* (1985), eqs. 4.43–4.46.
///
/// ```
/// use jeffcott::physics::LineContact;
/// // Hamrock's case: 1600 N on a roller 8 × 8 mm in a race of 69.5 mm, E = 210 GPa: 1431.0 MPa over 88.97 µm.
/// let contact = LineContact { curvature: 2.0 / 8e-3 + 2.0 / 69.5e-3, modulus: 210e9 / 1.82 };
/// let half_width = contact.half_width(1600.0 / 8e-3);
/// let pressure = contact.peak_pressure(1600.0 / 8e-3);
/// assert!((half_width - 88.97e-6).abs() < 1e-8 && (pressure - 1431.0e6).abs() < 1e5);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineContact {
    /// Sum of the curvatures along the rolling direction Σρ, 1/m.
    pub curvature: f64,
    /// Contact modulus E*, Pa.
    pub modulus: f64,
}

impl LineContact {
    /// Half-width b in m under a load per length in N/m.
    pub fn half_width(&self, load: f64) -> f64 {
        // b = √(4 w/(π E* Σρ))
        (4.0 * load / (PI * self.modulus * self.curvature)).sqrt()
    }

    /// Largest pressure in Pa under a load per length in N/m.
    pub fn peak_pressure(&self, load: f64) -> f64 {
        // 2w/(π b)
        (load * self.modulus * self.curvature / PI).sqrt()
    }

    /// Load per length in N/m whose largest pressure is this one in Pa.
    pub fn load_under(&self, pressure: f64) -> f64 {
        PI * pressure * pressure / (self.modulus * self.curvature)
    }
}
