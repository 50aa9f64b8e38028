//! Rigid discs on a shaft.

use crate::bearing::MountedBearing;

/// A rigid disc on the shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disc {
    /// Distance of its centre from the left end of the shaft, m.
    pub position: f64,
    /// Mass, kg.
    pub mass: f64,
    /// Moment of inertia about a diameter, kg m².
    pub inertia_transverse: f64,
    /// Moment of inertia about the axis of the shaft, kg m².
    pub inertia_polar: f64,
    /// Length of the shaft about its centre that it keeps from bending, m; zero of a thin disc.
    pub hub_width: f64,
}

impl Disc {
    /// A ring of a width and of outer and inner diameters in m, of a density in kg/m³.
    pub fn of_size(position: f64, width: f64, diameters: [f64; 2], density: f64) -> Self {
        let [outer, inner] = diameters;
        let mass = density * std::f64::consts::FRAC_PI_4 * width * (outer * outer - inner * inner);
        let squares = outer * outer + inner * inner;
        Self {
            position,
            mass,
            inertia_transverse: mass * (squares / 16.0 + width * width / 12.0),
            inertia_polar: mass * squares / 8.0,
            hub_width: 0.0,
        }
    }

    /// Positions of both ends of its hub, m.
    pub(crate) fn hub_ends(&self) -> [f64; 2] {
        [-0.5, 0.5].map(|part| self.position + part * self.hub_width)
    }

    /// The inner ring of a bearing, of which the geometry of the balls says about as much as is true of common series: bore
    /// d_m − 1.7 D, shoulders d_m − 0.6 D, width 1.9 D. Of a 6204 these are 20.0, 28.7 and 15.1 mm.
    pub fn inner_ring(mounted: &MountedBearing) -> Self {
        let geometry = &mounted.bearing.geometry;
        let (pitch, ball) = (geometry.pitch_diameter(), geometry.ball_diameter());
        let diameters = [pitch - 0.6 * ball, (pitch - 1.7 * ball).max(0.0)];
        let density = mounted.bearing.ring_material.density;
        Self::of_size(mounted.position, 1.9 * ball, diameters, density)
    }
}
