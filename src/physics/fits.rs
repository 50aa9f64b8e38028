//! Interference fits of the rings and unequal temperatures: what they do to the clearance.

use super::Material;

/// Thermal expansion of bearing steel, 1/K.
pub const STEEL_EXPANSION: f64 = 12.5e-6;

/// What an interference fit does to a ring.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RingFit {
    /// Pressure in the seat, Pa.
    pub pressure: f64,
    /// By how much the raceway diameter takes from the clearance, m: growth of the inner raceway, contraction of the
    /// outer one.
    pub clearance_loss: f64,
}

/// An inner ring on its shaft: thick cylinders (Lamé). Lengths in m, all diameters; `shaft_bore` is zero of a solid
/// shaft. An `interference` of zero or below fits loosely and changes nothing.
///
/// ```text
/// p  = I/{d [((F² + d²)/(F² − d²) + ν)/E + ((d² + d0²)/(d² − d0²) − ν_s)/E_s]}
/// ΔF = 2 p d² F/(E (F² − d²))
/// ```
///
/// `F` raceway, `d` bore, `d0` bore of the shaft. Of one material and a solid shaft: `ΔF = I d/F`. The ring is taken as a
/// smooth cylinder of the raceway diameter.
///
/// Source: Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), vol. 2, ch. 3; G. Lamé (1852).
///
/// ```
/// use jeffcott::physics::{Material, inner_ring_fit};
/// // bore 25 mm, raceway 38.5 − 7.938 mm, 1 µm, steel: 0.8180 µm; on a shaft with a bore of 12.5 mm 0.7368 µm
/// let steel = Material::BEARING_STEEL;
/// let fit = |bore| inner_ring_fit(0.025, 0.030562, bore, 1e-6, &steel, &steel);
/// assert!((fit(0.0).clearance_loss - 0.8180e-6).abs() < 5e-11);
/// assert!((fit(0.0125).clearance_loss - 0.7368e-6).abs() < 5e-11);
/// ```
pub fn inner_ring_fit(
    bore: f64,
    raceway: f64,
    shaft_bore: f64,
    interference: f64,
    ring: &Material,
    shaft: &Material,
) -> RingFit {
    if interference <= 0.0 {
        return RingFit::default();
    }
    let [d, f, hole] = [bore, raceway, shaft_bore].map(|diameter| diameter * diameter);
    let outward = ((f + d) / (f - d) + ring.poisson_ratio) / ring.youngs_modulus;
    let inward = ((d + hole) / (d - hole) - shaft.poisson_ratio) / shaft.youngs_modulus;
    let pressure = interference / (bore * (outward + inward));
    RingFit {
        pressure,
        clearance_loss: 2.0 * pressure * d * raceway / (ring.youngs_modulus * (f - d)),
    }
}

/// An outer ring in its housing, as [`inner_ring_fit`]; `housing_outside` is the outside diameter of the housing,
/// infinite of a thick one.
///
/// ```text
/// p   = I/{D [((D² + F²)/(D² − F²) − ν)/E + ((D_h² + D²)/(D_h² − D²) + ν_h)/E_h]}
/// ΔF = 2 p D² F/(E (D² − F²))
/// ```
///
/// Of one material and a thick housing: `ΔF = I F/D`.
///
/// ```
/// use jeffcott::physics::{Material, outer_ring_fit};
/// // outside diameter 52 mm, raceway 38.5 + 7.938 mm, 1 µm, steel: 0.8930 µm; housing of 1.5 × 52 mm: 0.7685 µm
/// let steel = Material::BEARING_STEEL;
/// let fit = |housing| outer_ring_fit(0.052, 0.046438, housing, 1e-6, &steel, &steel);
/// assert!((fit(f64::INFINITY).clearance_loss - 0.8930e-6).abs() < 5e-11);
/// assert!((fit(0.078).clearance_loss - 0.7685e-6).abs() < 5e-11);
/// ```
pub fn outer_ring_fit(
    outside: f64,
    raceway: f64,
    housing_outside: f64,
    interference: f64,
    ring: &Material,
    housing: &Material,
) -> RingFit {
    if interference <= 0.0 {
        return RingFit::default();
    }
    let [d, f, h] = [outside, raceway, housing_outside].map(|diameter| diameter * diameter);
    let thickness = if h.is_finite() {
        (h + d) / (h - d)
    } else {
        1.0
    };
    let inward = ((d + f) / (d - f) - ring.poisson_ratio) / ring.youngs_modulus;
    let outward = (thickness + housing.poisson_ratio) / housing.youngs_modulus;
    let pressure = interference / (outside * (inward + outward));
    RingFit {
        pressure,
        clearance_loss: 2.0 * pressure * d * raceway / (ring.youngs_modulus * (d - f)),
    }
}

/// Change of the diametral clearance in m by temperatures of inner ring, balls and outer ring in K over the one at which
/// it was measured: rings of bearing steel, and balls of a thermal expansion in 1/K.
///
/// `ΔG = −α_T (T_i F_i − T_o F_o) − 2 α_b T_b D` with the raceways F = d_m ∓ D, lengths in m.
///
/// Source: Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), vol. 2, ch. 3.
///
/// ```
/// use jeffcott::physics::{STEEL_EXPANSION, thermal_clearance_change};
/// // the whole bearing warmer: it stays alike, its clearance grows no more than itself
/// let change = thermal_clearance_change(7.938e-3, 38.5e-3, [10.0; 3], STEEL_EXPANSION);
/// assert!(change.abs() < 1e-18);
/// // by hand: inner ring 10 K warmer, 12.5e-6 × 10 × 30.562 mm = 3.820 µm
/// let change = thermal_clearance_change(7.938e-3, 38.5e-3, [10.0, 0.0, 0.0], STEEL_EXPANSION);
/// assert!((change + 3.82025e-6).abs() < 1e-12);
/// // balls of silicon nitride, the whole bearing 40 K warmer: 2 × 11.906 mm × 40 K × (12.5 − 3.2)e-6 = 8.858 µm wider
/// let change = thermal_clearance_change(11.906e-3, 60e-3, [40.0; 3], 3.2e-6);
/// assert!((change - 8.858064e-6).abs() < 1e-12);
/// ```
pub fn thermal_clearance_change(
    ball_diameter: f64,
    pitch_diameter: f64,
    [inner, balls, outer]: [f64; 3],
    ball_expansion: f64,
) -> f64 {
    -STEEL_EXPANSION
        * (inner * (pitch_diameter - ball_diameter)
            + 2.0 * (ball_expansion / STEEL_EXPANSION) * balls * ball_diameter
            - outer * (pitch_diameter + ball_diameter))
}
