//! The unbalance: masses beside the shaft's axis, as the mass eccentricity and in planes along the shaft.

use nalgebra::Complex;

use super::{Rotation, Shaft};
use crate::bearing::{Angle, Vector5};

/// Unbalances in planes along a shaft, summed in the frame that turns with it, X at shaft angle 0 first: the centre of mass
/// lies off the axis, and the principal axis may be inclined.
///
/// `U = Σ u_i e^(iβ_i)`, `U_c = Σ u_i z_i e^(iβ_i)`: together they are a static unbalance and a couple.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PlaneUnbalance {
    /// Static unbalance U, kg m.
    pub moment: [f64; 2],
    /// Couple unbalance U_c about the centre of mass, kg m².
    pub couple: [f64; 2],
}

impl Shaft {
    /// Unbalance of mass eccentricity and planes.
    pub(super) fn whole_unbalance(&self) -> PlaneUnbalance {
        let [x, y] = self.unbalance.moment;
        PlaneUnbalance {
            moment: [self.mass * self.eccentricity + x, y],
            couple: self.unbalance.couple,
        }
    }

    /// Distance of the centre of mass from the axis, m, and its angle from +X at shaft angle 0, rad.
    pub(crate) fn mass_eccentricity(&self) -> [f64; 2] {
        let [x, y] = self.whole_unbalance().moment;
        [x.hypot(y) / self.mass, y.atan2(x)]
    }

    /// Whether it has a static unbalance or a couple.
    pub(crate) fn is_unbalanced(&self) -> bool {
        self.whole_unbalance().is_some()
    }
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

    /// Whether there is one.
    pub(super) fn is_some(&self) -> bool {
        self.moment != [0.0; 2] || self.is_couple()
    }

    /// Whether it has a couple.
    pub(super) fn is_couple(&self) -> bool {
        self.couple != [0.0; 2]
    }

    /// Force and moment at a shaft angle, N and N m, of U e^(iψ): `F_x + i F_y = U (ω² − i ω̇) e^(iψ)`, and of the couple
    /// `M_y − i M_x = U_c (ω² − i ω̇) e^(iψ)`.
    #[inline(always)]
    pub(super) fn force(&self, rotation: &Rotation, angle: Angle) -> Vector5 {
        let [x, y] = turning(self.moment, rotation, angle);
        if !self.is_couple() {
            return [x, y, 0.0, 0.0, 0.0];
        }
        let [along_y, along_x] = turning(self.couple, rotation, angle);
        [x, y, 0.0, -along_x, along_y]
    }

    /// Its rate of change, N/s and N m/s, the acceleration staying as it is.
    pub(super) fn force_rate(&self, rotation: &Rotation) -> Vector5 {
        let Angle { cos, sin } = Angle::new(rotation.angle);
        let speed = rotation.speed;
        let (along, inward) = (3.0 * speed * rotation.acceleration, speed * speed * speed);
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

    /// Force and moment at a constant speed in rad/s as complex amplitudes, N and N m.
    pub(super) fn phasor(&self, speed: f64) -> [Complex<f64>; 5] {
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

    /// Force and moment per angular acceleration, kg m and kg m²: `−i U e^(iψ)` and that of the couple. A motion q̈ of the
    /// point that it acts at resists the rotation by the moment that is its product with q̈.
    pub(super) fn along(&self, angle: Angle) -> Vector5 {
        let rotation = Rotation {
            angle: 0.0,
            speed: 0.0,
            acceleration: 1.0,
        };
        self.force(&rotation, angle)
    }
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
    use crate::rotor::Freedoms;

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
        let whole = shaft.whole_unbalance();
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
