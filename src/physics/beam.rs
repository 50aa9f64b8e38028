//! A shaft element that bends and shears: stiffness, mass, rotary inertia.

use std::f64::consts::PI;

use super::Material;

/// A matrix of a beam element in one plane: rows and columns w₁, θ₁, w₂, θ₂, with w the deflection and θ = dw/dz
/// the slope of the cross-section at either end.
pub type ElementMatrix = [[f64; 4]; 4];

/// A round bar or tube between two nodes of a shaft (Timoshenko beam).
///
/// ```text
/// φ = 12 E I/(κ G A L²),   κ = 6(1+ν)(1+m²)²/((7+6ν)(1+m²)² + (20+12ν) m²),   m = inner/outer diameter
/// ```
///
/// Holds for small deflections of a straight bar of one cross-section; the mass matrix is consistent with the
/// deflection under end forces.
///
/// Source: J. S. Przemieniecki, *Theory of Matrix Structural Analysis* (1968), ch. 5 and 11; the form of M. I. Friswell
/// et al., *Dynamics of Rotating Machines* (2010), sec. 5.4. Shear coefficient: G. R. Cowper, *J. Appl. Mech.* 33 (1966)
/// 335–340.
///
/// ```
/// use jeffcott::physics::{BeamElement, Material};
/// let bar = BeamElement {
///     length: 1.0,
///     outer_diameter: 0.05,
///     inner_diameter: 0.0,
///     material: Material { youngs_modulus: 211e9, poisson_ratio: 0.3, density: 7810.0 },
/// };
/// // a cantilever under 1 kN at its end yields by F L³/(3 E I) and the shear F L/(κ G A)
/// let [[a, b], [_, d]] = [[2, 2], [3, 3]].map(|[i, j]| [bar.stiffness()[i][2], bar.stiffness()[j][3]]);
/// let yielding = 1e3 * d / (a * d - b * b);
/// assert!((yielding - 5.157e-3).abs() < 2e-6);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamElement {
    /// Length L, m.
    pub length: f64,
    /// Outer diameter, m.
    pub outer_diameter: f64,
    /// Inner diameter, m; zero of a solid bar.
    pub inner_diameter: f64,
    /// Elastic constants and density.
    pub material: Material,
}

impl BeamElement {
    /// Area A of the cross-section, m².
    pub fn area(&self) -> f64 {
        PI / 4.0 * (self.outer_diameter.powi(2) - self.inner_diameter.powi(2))
    }

    /// Second moment of area I about a diameter, m⁴.
    pub fn second_moment(&self) -> f64 {
        PI / 64.0 * (self.outer_diameter.powi(4) - self.inner_diameter.powi(4))
    }

    /// Mass, kg.
    pub fn mass(&self) -> f64 {
        self.material.density * self.area() * self.length
    }

    /// Bending over shear stiffness φ, dimensionless.
    fn shear_ratio(&self) -> f64 {
        let nu = self.material.poisson_ratio;
        let shear_modulus = self.material.youngs_modulus / (2.0 * (1.0 + nu));
        let m2 = (self.inner_diameter / self.outer_diameter).powi(2);
        let ring = (1.0 + m2).powi(2);
        let coefficient =
            6.0 * (1.0 + nu) * ring / ((7.0 + 6.0 * nu) * ring + (20.0 + 12.0 * nu) * m2);
        12.0 * self.material.youngs_modulus * self.second_moment()
            / (coefficient * shear_modulus * self.area() * self.length.powi(2))
    }

    /// Stiffness, N/m, N and N m.
    pub fn stiffness(&self) -> ElementMatrix {
        let (phi, l) = (self.shear_ratio(), self.length);
        let unit = self.material.youngs_modulus * self.second_moment() / ((1.0 + phi) * l.powi(3));
        let (near, far) = ((4.0 + phi) * l * l, (2.0 - phi) * l * l);
        scaled(
            unit,
            [
                [12.0, 6.0 * l, -12.0, 6.0 * l],
                [6.0 * l, near, -6.0 * l, far],
                [-12.0, -6.0 * l, 12.0, -6.0 * l],
                [6.0 * l, far, -6.0 * l, near],
            ],
        )
    }

    /// Inertia of the deflection, kg, kg m and kg m².
    pub fn translational_inertia(&self) -> ElementMatrix {
        let (phi, l) = (self.shear_ratio(), self.length);
        let square = phi * phi;
        let unit = self.mass() / (840.0 * (1.0 + phi).powi(2));
        let near = 312.0 + 588.0 * phi + 280.0 * square;
        let far = 108.0 + 252.0 * phi + 140.0 * square;
        let near_slope = (44.0 + 77.0 * phi + 35.0 * square) * l;
        let far_slope = (26.0 + 63.0 * phi + 35.0 * square) * l;
        let slopes = (8.0 + 14.0 * phi + 7.0 * square) * l * l;
        let opposite = -(6.0 + 14.0 * phi + 7.0 * square) * l * l;
        scaled(
            unit,
            [
                [near, near_slope, far, -far_slope],
                [near_slope, slopes, far_slope, opposite],
                [far, far_slope, near, -near_slope],
                [-far_slope, opposite, -near_slope, slopes],
            ],
        )
    }

    /// Inertia of the cross-sections that tilt about a diameter, kg, kg m and kg m²; twice as large about the axis of the
    /// shaft, which gives the gyroscopic coupling of both planes.
    pub fn rotary_inertia(&self) -> ElementMatrix {
        let (phi, l) = (self.shear_ratio(), self.length);
        let unit = self.material.density * self.second_moment() / (30.0 * (1.0 + phi).powi(2) * l);
        let slope = (3.0 - 15.0 * phi) * l;
        let near = (4.0 + 5.0 * phi + 10.0 * phi * phi) * l * l;
        let far = (-1.0 - 5.0 * phi + 5.0 * phi * phi) * l * l;
        scaled(
            unit,
            [
                [36.0, slope, -36.0, slope],
                [slope, near, -slope, far],
                [-36.0, -slope, 36.0, -slope],
                [slope, far, -slope, near],
            ],
        )
    }
}

fn scaled(factor: f64, matrix: ElementMatrix) -> ElementMatrix {
    matrix.map(|row| row.map(|entry| factor * entry))
}
