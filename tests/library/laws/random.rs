//! Seeded random bearings, positions and speeds.

use std::f64::consts::TAU;

use crate::bearing::{Bearing, FreePosition, Geometry};
use crate::physics::Material;

const SILICON_NITRIDE: Material = Material {
    youngs_modulus: 310e9,
    poisson_ratio: 0.26,
    density: 3200.0,
};

/// A ball in its bearing at a position and a speed.
pub struct Case {
    pub bearing: Bearing,
    pub axial: f64,
    pub radial: f64,
    pub speed: f64,
}

/// Small generator of random numbers (xorshift64).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    /// Uniform in 0 … 1.
    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Contact angles 0° … 60°, steel and ceramic balls.
    pub fn bearing(&mut self) -> Bearing {
        let diameter = self.between(3e-3, 20e-3);
        let pitch = diameter * self.between(3.5, 8.0);
        let angle = FreePosition::ContactAngle(self.between(0.0, 60f64.to_radians()));
        let (inner, outer) = (self.between(0.505, 0.54), self.between(0.505, 0.54));
        let ball_material = if self.unit() < 0.3 {
            SILICON_NITRIDE
        } else {
            Material::BEARING_STEEL
        };
        Bearing {
            ball_material,
            ..Bearing::of_steel(Geometry::new(5, diameter, pitch, angle, inner, outer).unwrap())
        }
    }

    /// Approaches from deep separation through the edge of contact to deep contact, angles of the
    /// line of groove centres from −17° to 75°, speeds from (almost) rest to 3e6 d_m n.
    pub fn case(&mut self) -> Case {
        loop {
            let bearing = self.bearing();
            let geometry = &bearing.geometry;
            let diameter = geometry.ball_diameter();
            let approach = if self.unit() < 0.5 {
                diameter * self.between(-8e-3, 8e-3)
            } else {
                let sign = (self.unit() - 0.5).signum();
                sign * diameter * 10f64.powf(self.between(-7.0, -2.0))
            };
            let speed_factor = if self.unit() < 0.5 {
                self.between(0.0, 3e6)
            } else {
                10f64.powf(self.between(-3.0, 6.477))
            };
            let distance = geometry.groove_centre_distance() + approach;
            let angle = self.between(-0.3, 1.3);
            let case = Case {
                bearing,
                axial: distance * angle.sin(),
                radial: distance * angle.cos(),
                speed: speed_factor / (geometry.pitch_diameter() * 1e3) * TAU / 60.0,
            };
            // the contact angle stays below 90°: the inner groove centre beyond the ball's
            if case.radial > 1.3 * (geometry.groove_factors()[1] - 0.5) * diameter {
                return case;
            }
        }
    }
}
