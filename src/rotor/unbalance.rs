//! The unbalance: masses beside the shaft's axis, as the mass eccentricity and in planes along the shaft.

use nalgebra::Complex;

use super::{Freedoms, Rotation, Shaft};
use crate::bearing::{Angle, Vector5};

/// Unbalances in planes along a rigid shaft, summed in the frame that turns with it, X at shaft angle 0 first.
///
/// `U = Σ u_i e^(iβ_i)`, `U_c = Σ u_i z_i e^(iβ_i)`: together they are a static unbalance and a couple.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PlaneUnbalance {
    /// Static unbalance U, kg m.
    pub moment: [f64; 2],
    /// Couple unbalance U_c about the centre of mass, kg m².
    pub couple: [f64; 2],
}

impl PlaneUnbalance {
    /// Adds an unbalance in kg m in a plane at a position in m from the centre of mass, at an angle in rad from the mass
    /// eccentricity.
    pub fn add(&mut self, amount: f64, angle: f64, position: f64) {
        let (sin, cos) = angle.sin_cos();
        for (axis, part) in [amount * cos, amount * sin].into_iter().enumerate() {
            self.moment[axis] += part;
            self.couple[axis] += part * position;
        }
    }
}

impl Shaft {
    /// Static unbalance of mass eccentricity and planes, kg m, in the frame that turns with the shaft.
    fn unbalance_moment(&self) -> [f64; 2] {
        let [x, y] = self.unbalance.moment;
        [self.mass * self.eccentricity + x, y]
    }

    /// Distance of the centre of mass from the axis, m.
    pub(crate) fn mass_eccentricity(&self) -> f64 {
        let [x, y] = self.unbalance_moment();
        x.hypot(y) / self.mass
    }

    /// Whether it has a static unbalance or a couple.
    pub(crate) fn is_unbalanced(&self) -> bool {
        self.unbalance_moment() != [0.0; 2] || self.unbalance.couple != [0.0; 2]
    }
}

/// The unbalance of a shaft as it turns: its centre of mass lies off the axis, and its principal axis may be inclined.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Unbalance {
    /// U, kg m.
    moment: [f64; 2],
    /// U/m, m.
    offset: [f64; 2],
    /// U_c, kg m².
    couple: [f64; 2],
    /// U_c/I_t, rad; zero where the tilts are held.
    inclination: [f64; 2],
}

impl Unbalance {
    pub fn new(shaft: &Shaft) -> Self {
        let [x, y] = shaft.unbalance.moment;
        let tilts = shaft.freedoms == Freedoms::All && shaft.inertia_transverse > 0.0;
        let incline = |part: f64| match tilts {
            true => part / shaft.inertia_transverse,
            false => 0.0,
        };
        Self {
            inclination: shaft.unbalance.couple.map(incline),
            moment: shaft.unbalance_moment(),
            offset: [shaft.eccentricity + x / shaft.mass, y / shaft.mass],
            couple: shaft.unbalance.couple,
        }
    }

    /// Whether there is one.
    pub fn is_some(&self) -> bool {
        self.moment != [0.0; 2] || self.is_couple()
    }

    /// Whether it has a couple.
    pub fn is_couple(&self) -> bool {
        self.couple != [0.0; 2]
    }

    /// Force and moment at a shaft angle, N and N m, of U e^(iψ): `F_x + i F_y = U (ω² − i ω̇) e^(iψ)`, and of the couple
    /// `M_y − i M_x = U_c (ω² − i ω̇) e^(iψ)`.
    #[inline(always)]
    pub fn force(&self, rotation: &Rotation, angle: Angle) -> Vector5 {
        let [x, y] = turning(self.moment, rotation, angle);
        if !self.is_couple() {
            return [x, y, 0.0, 0.0, 0.0];
        }
        let [along_y, along_x] = turning(self.couple, rotation, angle);
        [x, y, 0.0, -along_x, along_y]
    }

    /// Its rate of change, N/s and N m/s, the acceleration staying as it is.
    pub fn force_rate(&self, rotation: &Rotation) -> Vector5 {
        let Angle { cos, sin } = Angle::new(rotation.angle);
        let Rotation {
            speed,
            acceleration,
            ..
        } = *rotation;
        let (along, inward) = (3.0 * speed * acceleration, speed * speed * speed);
        let rate = |[u, v]: [f64; 2]| {
            let of = |part: f64| {
                [
                    part * (along * cos - inward * sin),
                    part * (along * sin + inward * cos),
                ]
            };
            let ([x, y], [turned_x, turned_y]) = (of(u), of(v));
            [x - turned_y, y + turned_x]
        };
        let ([x, y], [along_y, along_x]) = (rate(self.moment), rate(self.couple));
        [x, y, 0.0, -along_x, along_y]
    }

    /// The same force at a constant speed in rad/s as complex amplitudes, N and N m.
    pub fn phasor(&self, speed: f64) -> [Complex<f64>; 5] {
        let square = speed * speed;
        let of = |[u, v]: [f64; 2]| {
            [
                Complex::new(square * u, square * v),
                Complex::new(square * v, -square * u),
            ]
        };
        let ([x, y], [along_y, along_x]) = (of(self.moment), of(self.couple));
        [x, y, Complex::ZERO, -along_x, along_y]
    }

    /// What the unbalance adds to the kinetic energy of a shaft that moves at a velocity (ẋ, ẏ, ż, θ̇x, θ̇y) in m/s and rad/s
    /// as it turns, J: its centre of mass moves by e ω (−sin ψ, cos ψ) besides, and its principal axis tilts by
    /// −ω U_c (cos ψ, sin ψ)/I_t.
    pub fn kinetic_energy(&self, velocity: &Vector5, rotation: &Rotation) -> f64 {
        let speed = rotation.speed;
        let [x, y, _, tilt_x, tilt_y] = velocity;
        let [cos, sin] = turned(self.moment, rotation);
        let [along_x, along_y] = turned(self.couple, rotation);
        let dot = |[a, b]: [f64; 2], [c, d]: [f64; 2]| a * c + b * d;
        let square = dot(self.moment, self.offset) + dot(self.couple, self.inclination);
        let mixed = (y * cos - x * sin) - (tilt_x * along_x + tilt_y * along_y);
        speed * mixed + 0.5 * speed * speed * square
    }

    /// Power of a force in x and y at the centre of mass through that motion, W.
    pub fn power(&self, force: [f64; 2], rotation: &Rotation) -> f64 {
        let [cos, sin] = turned(self.offset, rotation);
        rotation.speed * (force[1] * cos - force[0] * sin)
    }

    /// Moment about the shaft of forces and moments on its axis, N m: `e (f_x sin ψ − f_y cos ψ)` about the centre of mass,
    /// and `U_c (m_x cos ψ + m_y sin ψ)/I_t` about the inclined principal axis.
    pub fn moment_of(&self, [x, y, _, along_x, along_y]: Vector5, rotation: &Rotation) -> f64 {
        let [cos, sin] = turned(self.offset, rotation);
        let [inclined_x, inclined_y] = turned(self.inclination, rotation);
        (x * sin - y * cos) + (along_x * inclined_x + along_y * inclined_y)
    }
}

/// A vector that turns with the shaft, seen from the housing.
fn turned([u, v]: [f64; 2], rotation: &Rotation) -> [f64; 2] {
    let Angle { cos, sin } = Angle::new(rotation.angle);
    [u * cos - v * sin, u * sin + v * cos]
}

/// `(u + i v)(ω² − i ω̇) e^(iψ)`.
#[inline(always)]
fn turning([u, v]: [f64; 2], rotation: &Rotation, Angle { cos, sin }: Angle) -> [f64; 2] {
    let of = |part: f64| {
        let inward = part * rotation.speed * rotation.speed;
        let along = part * rotation.acceleration;
        [inward * cos + along * sin, inward * sin - along * cos]
    };
    let [x, y] = of(u);
    if v == 0.0 {
        return [x, y];
    }
    let [turned_x, turned_y] = of(v);
    [x - turned_y, y + turned_x]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two unbalances in planes are the forces that they exert, each at its place.
    #[test]
    fn planes_exert_their_forces_at_their_places() {
        let planes = [(2e-5, 0.4, -0.06), (3e-5, 2.0, 0.08)];
        let mut unbalance = PlaneUnbalance::default();
        for (amount, angle, position) in planes {
            unbalance.add(amount, angle, position);
        }
        let shaft = Shaft {
            mass: 5.0,
            inertia_transverse: 0.02,
            inertia_polar: 0.01,
            eccentricity: 0.0,
            unbalance,
            freedoms: Freedoms::All,
            gravity: false,
            held_tilt: [0.0; 2],
        };
        let rotation = Rotation {
            angle: 0.7,
            speed: 300.0,
            acceleration: 5e4,
        };
        let whole = Unbalance::new(&shaft);
        let force = whole.force(&rotation, Angle::new(rotation.angle));
        let mut sum = [0.0; 5];
        for (amount, angle, position) in planes {
            let (sin, cos) = (rotation.angle + angle).sin_cos();
            let (inward, along) = (amount * 9e4, amount * 5e4);
            let [x, y] = [inward * cos + along * sin, inward * sin - along * cos];
            for (sum, part) in sum.iter_mut().zip([x, y, 0.0, -position * y, position * x]) {
                *sum += part;
            }
        }
        for (found, expected) in force.iter().zip(sum) {
            assert!((found - expected).abs() < 1e-12, "{force:?} {sum:?}");
        }
        let steady = Rotation {
            acceleration: 0.0,
            ..rotation
        };
        let at_zero = Rotation {
            angle: 0.0,
            ..steady
        };
        let turned = whole.force(&at_zero, Angle::new(0.0));
        for (phasor, force) in whole.phasor(300.0).iter().zip(turned) {
            assert!((phasor.re - force).abs() < 1e-12);
        }
        let (before, after) = (0.7 - 1e-6, 0.7 + 1e-6);
        let rate = whole.force_rate(&steady);
        for (axis, rate) in rate.into_iter().enumerate() {
            let at = |angle: f64| {
                let rotation = Rotation { angle, ..steady };
                whole.force(&rotation, Angle::new(angle))[axis]
            };
            let slope = 300.0 * (at(after) - at(before)) / 2e-6;
            assert!((rate - slope).abs() < 1e-6 * (1.0 + slope.abs()));
        }
    }
}
