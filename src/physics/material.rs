//! Elastic constants and density of a ball or a ring.

/// Isotropic elastic material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Young's modulus E, Pa.
    pub youngs_modulus: f64,
    /// Poisson's ratio ν, dimensionless, in −1 … 0.5.
    pub poisson_ratio: f64,
    /// Density ρ, kg/m³.
    pub density: f64,
}

impl Material {
    /// Through-hardened bearing steel: E = 207 GPa, ν = 0.3, ρ = 7800 kg/m³.
    ///
    /// Source: Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), ch. 6 (moduli);
    /// density of 52100 steel as commonly tabulated.
    pub const BEARING_STEEL: Self = Self {
        youngs_modulus: 207e9,
        poisson_ratio: 0.3,
        density: 7800.0,
    };

    /// Plane-strain compliance (1 − ν²)/E, 1/Pa.
    fn plane_strain_compliance(&self) -> f64 {
        (1.0 - self.poisson_ratio * self.poisson_ratio) / self.youngs_modulus
    }
}

/// Contact modulus E* of two bodies, Pa.
///
/// `1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂`
///
/// Holds for linear elastic half-spaces; the two bodies may differ (hybrid bearings with
/// ceramic balls).
///
/// Source: K. L. Johnson, *Contact Mechanics* (1985), eq. 4.18.
///
/// ```
/// use jeffcott::physics::{Material, contact_modulus};
/// // Steel on steel, E = 207 GPa, ν = 0.3: E* = E/(2 (1 − ν²)) = 113.736 GPa.
/// let steel = Material::BEARING_STEEL;
/// assert!((contact_modulus(&steel, &steel) - 113.736e9).abs() < 1e6);
/// ```
pub fn contact_modulus(first: &Material, second: &Material) -> f64 {
    1.0 / (first.plane_strain_compliance() + second.plane_strain_compliance())
}
