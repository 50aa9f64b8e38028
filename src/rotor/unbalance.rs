//! The unbalance m e: a centre of mass beside the shaft's axis.

use nalgebra::Complex;

use super::Rotation;
use crate::bearing::Angle;

/// A mass m whose centre lies an eccentricity e off the axis, towards +X at shaft angle 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Unbalance {
    /// m e, kg m.
    moment: f64,
    /// e, m.
    eccentricity: f64,
}

impl Unbalance {
    pub fn new(mass: f64, eccentricity: f64) -> Self {
        Self {
            moment: mass * eccentricity,
            eccentricity,
        }
    }

    /// Whether there is one.
    pub fn is_some(&self) -> bool {
        self.moment > 0.0
    }

    /// Force in x and y at a shaft angle, N: `m e (ω² cos ψ + ω̇ sin ψ)`, `m e (ω² sin ψ − ω̇ cos ψ)`.
    #[inline(always)]
    pub fn force(&self, rotation: &Rotation, Angle { cos, sin }: Angle) -> [f64; 2] {
        let inward = self.moment * rotation.speed * rotation.speed;
        let along = self.moment * rotation.acceleration;
        [inward * cos + along * sin, inward * sin - along * cos]
    }

    /// Its rate of change, N/s, the acceleration staying as it is.
    pub fn force_rate(&self, rotation: &Rotation) -> [f64; 2] {
        let Angle { cos, sin } = Angle::new(rotation.angle);
        let Rotation {
            speed,
            acceleration,
            ..
        } = *rotation;
        let (along, inward) = (3.0 * speed * acceleration, speed * speed * speed);
        [
            self.moment * (along * cos - inward * sin),
            self.moment * (along * sin + inward * cos),
        ]
    }

    /// The same force at a constant speed in rad/s as complex amplitudes of x and y, N.
    pub fn phasor(&self, speed: f64) -> [Complex<f64>; 2] {
        let inward = self.moment * speed * speed;
        [Complex::new(inward, 0.0), Complex::new(0.0, -inward)]
    }

    /// What it adds to the kinetic energy of a shaft that moves at a velocity (ẋ, ẏ) in m/s as it turns, J: its centre
    /// of mass moves by e ω (−sin ψ, cos ψ) besides.
    pub fn kinetic_energy(&self, velocity: [f64; 2], rotation: &Rotation) -> f64 {
        let Angle { cos, sin } = Angle::new(rotation.angle);
        let speed = rotation.speed;
        self.moment * speed * (velocity[1] * cos - velocity[0] * sin)
            + 0.5 * speed * speed * self.moment * self.eccentricity
    }

    /// Power of a force in x and y at the centre of mass through that motion, W.
    pub fn power(&self, force: [f64; 2], rotation: &Rotation) -> f64 {
        let Angle { cos, sin } = Angle::new(rotation.angle);
        self.eccentricity * rotation.speed * (force[1] * cos - force[0] * sin)
    }

    /// Moment about the shaft that a force in x and y on its axis has about the centre of mass, N m:
    /// `e (f_x sin ψ − f_y cos ψ)`.
    pub fn moment_of(&self, force: [f64; 2], rotation: &Rotation) -> f64 {
        let Angle { cos, sin } = Angle::new(rotation.angle);
        self.eccentricity * (force[0] * sin - force[1] * cos)
    }
}
