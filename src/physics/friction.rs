//! Friction moment of a ball or roller bearing after Palmgren.

use std::f64::consts::PI;

use super::{PER_MINUTE, at_least};

/// Density of mineral oil, kg/m³: what turns dynamic into kinematic viscosity where no density is
/// given. Mineral oils lie between 850 and 900 kg/m³.
pub const MINERAL_OIL_DENSITY: f64 = 870.0;

/// Contact angle from which a bearing counts as an angular contact one, rad: the first of the
/// standards' tables, 5°.
pub const SMALLEST_ANGULAR_CONTACT: f64 = 5.0 * PI / 180.0;

/// Measured coefficients of a type of bearing.
///
/// ```text
/// M_1 = f_1 P_1 d_m             f_1 = z (P_0/C_0)^y
/// P_0 = X_s F_r + Y_s F_a       P_1 = k F_a − k_r F_r      neither less than F_r
/// M_0 = 1e-7 f_0 max(160, (ν n)^(2/3)) d_m³
/// ```
///
/// | symbol | meaning | unit |
/// |---|---|---|
/// | M_1, M_0 | moment that grows with the load, viscous moment | N m; N mm in the formula of M_0 |
/// | F_r, F_a | radial and axial load of the bearing | N |
/// | P_0, P_1 | static equivalent load, load that decides the friction | N |
/// | C_0 | basic static load rating | N |
/// | d_m | pitch diameter | m; mm in the formula of M_0 |
/// | ν, n | kinematic viscosity, speed | mm²/s, 1/min |
///
/// Holds for bearings of normal make without seals, at moderate speed and load and away from
/// starvation: an estimate. A pure tilting moment is not part of it.
///
/// Source: A. Palmgren, *Grundlagen der Wälzlagertechnik* (1959); Harris & Kotzalas, *Rolling
/// Bearing Analysis*, 5th ed. (2007), vol. 1, ch. 10 (z, y, f_0, P_1); ISO 76:2006 (X_s, Y_s).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionFactors {
    /// z, dimensionless.
    pub load_factor: f64,
    /// y, dimensionless.
    pub load_exponent: f64,
    /// X_s, dimensionless.
    pub static_radial: f64,
    /// Y_s, dimensionless.
    pub static_axial: f64,
    /// k of `P_1 = k F_a − k_r F_r`, dimensionless.
    pub axial_factor: f64,
    /// k_r, dimensionless.
    pub radial_relief: f64,
    /// f_0, dimensionless: bearing type and way of lubrication.
    pub viscous_factor: f64,
}

/// Y_s of ISO 76 for single-row angular contact ball bearings at 5°, 10°, … 45°.
const STATIC_AXIAL: [f64; 9] = [0.52, 0.50, 0.46, 0.42, 0.38, 0.33, 0.29, 0.26, 0.22];

impl FrictionFactors {
    /// Deep-groove bearing in an oil bath: z = 0.0005 (0.0004 light to 0.0006 heavy series),
    /// y = 0.55, X_s = 0.6, Y_s = 0.5, k = 3, f_0 = 2 (oil mist 1, oil jet 4).
    pub const DEEP_GROOVE: Self = Self {
        load_factor: 5e-4,
        load_exponent: 0.55,
        static_radial: 0.6,
        static_axial: 0.5,
        axial_factor: 3.0,
        radial_relief: 0.1,
        viscous_factor: 2.0,
    };

    /// Bearing of a nominal contact angle in rad in an oil bath: from 5° on an angular contact
    /// bearing with z = 0.001, y = 0.33, X_s = 0.5, Y_s of ISO 76 (straight lines between its
    /// angles), k = 0.9 cot α, f_0 = 3.3 (oil mist 1.7, oil jet 6.6); below a deep-groove one.
    ///
    /// ```
    /// use jeffcott::physics::FrictionFactors;
    /// // ISO 76: Y_s = 0.26 at 40°.
    /// let factors = FrictionFactors::from_contact_angle(40f64.to_radians());
    /// assert!((factors.static_axial - 0.26).abs() < 1e-12);
    /// assert_eq!(FrictionFactors::from_contact_angle(0.0), FrictionFactors::DEEP_GROOVE);
    /// ```
    pub fn from_contact_angle(angle: f64) -> Self {
        if angle < SMALLEST_ANGULAR_CONTACT {
            return Self::DEEP_GROOVE;
        }
        let last = STATIC_AXIAL.len() - 1;
        let place = (angle.to_degrees() / 5.0 - 1.0).clamp(0.0, last as f64);
        let below = (place as usize).min(last - 1);
        let part = place - below as f64;
        Self {
            load_factor: 1e-3,
            load_exponent: 0.33,
            static_radial: 0.5,
            static_axial: STATIC_AXIAL[below] * (1.0 - part) + STATIC_AXIAL[below + 1] * part,
            // 0.9 cot α
            axial_factor: 0.9 / angle.tan(),
            radial_relief: 0.1,
            viscous_factor: 3.3,
        }
    }

    /// Rollers with coefficients f_1 and f_0 at a contact angle in rad: y = 0, k = 0.8 cot α, k_r = 0.
    ///
    /// Source: Harris & Kotzalas (as above), tables 10.2 and 10.3 (f_1, f_0), eq. 10.26.
    pub fn of_rollers(load_factor: f64, viscous_factor: f64, angle: f64) -> Self {
        Self {
            load_factor,
            load_exponent: 0.0,
            static_radial: 1.0,
            static_axial: 0.0,
            axial_factor: if angle <= 0.0 { 0.0 } else { 0.8 / angle.tan() },
            radial_relief: 0.0,
            viscous_factor,
        }
    }

    /// Part of the moment that grows with the load, M_1, N m: loads and `static_rating` in N,
    /// `pitch_diameter` in m. The loads' signs do not matter.
    ///
    /// ```
    /// use jeffcott::physics::FrictionFactors;
    /// // by hand, deep groove, F_r = C_0/32 = 1000 N: 32^0.55 = 4 √2 ⁴√2 = 6.7272, f_1 = 0.0005/6.7272 = 7.4325e-5, P_1 = F_r;
    /// // F_a alone presses 3 times as hard as P_1, and P_0 = F_a/2: M_1 is 3/2^0.55 = 2.0491 times that
    /// let moment = FrictionFactors::DEEP_GROOVE.load_moment(1e3, 0.0, 32e3, 0.05);
    /// assert!((moment - 3.7163e-3).abs() < 1e-7);
    /// let axial = FrictionFactors::DEEP_GROOVE.load_moment(0.0, 1e3, 32e3, 0.05);
    /// assert!((axial / moment - 2.0491).abs() < 1e-4);
    /// ```
    pub fn load_moment(
        &self,
        radial: f64,
        axial: f64,
        static_rating: f64,
        pitch_diameter: f64,
    ) -> f64 {
        let (radial, axial) = (radial.abs(), axial.abs());
        // P_0 = X_s F_r + Y_s F_a, P_1 = k F_a − k_r F_r
        let static_load = self.static_radial * radial + self.static_axial * axial;
        let static_load = at_least(static_load, radial);
        let load = self.axial_factor * axial - self.radial_relief * radial;
        let load = at_least(load, radial);
        // f_1 = z (P_0/C_0)^y
        let factor = self.load_factor * (static_load / static_rating).powf(self.load_exponent);
        // M_1 = f_1 P_1 d_m
        factor * load * pitch_diameter
    }

    /// Viscous part of the moment, M_0, N m: `viscosity` kinematic in m²/s, `speed` in rad/s,
    /// `pitch_diameter` in m. Zero at rest.
    ///
    /// ```
    /// use jeffcott::physics::FrictionFactors;
    /// use std::f64::consts::PI;
    /// // by hand: f_0 = 2, ν = 27 mm²/s, n = 1000/min, d_m = 50 mm:
    /// // 2e-7 × 27000^(2/3) × 50³ = 2e-7 × 900 × 125 000 = 22.5 N mm
    /// let speed = 1000.0 * PI / 30.0;
    /// let moment = FrictionFactors::DEEP_GROOVE.viscous_moment(27e-6, speed, 0.05);
    /// assert!((moment - 22.5e-3).abs() < 1e-15);
    /// ```
    pub fn viscous_moment(&self, viscosity: f64, speed: f64, pitch_diameter: f64) -> f64 {
        if speed == 0.0 {
            return 0.0;
        }
        // ν n in mm²/s per minute, d_m in mm
        let product = viscosity * 1e6 * (speed.abs() * PER_MINUTE);
        let diameter = pitch_diameter * 1e3;
        // the books change over at ν n = 2000 by a jump of 0.8 %; the larger one has none
        let growth = at_least(product.cbrt().powi(2), 160.0);
        // M_0 = 1e-7 f_0 (ν n)^(2/3) d_m³, N mm
        1e-3 * (1e-7 * self.viscous_factor * growth * diameter.powi(3))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_viscous_moment_has_no_jump() {
        let moment = |product: f64| {
            FrictionFactors::DEEP_GROOVE.viscous_moment(1e-6, product * PI / 30.0, 0.05)
        };
        for edge in [2000.0, 160f64.powf(1.5)] {
            assert!((moment(1.000_01 * edge) / moment(0.999_99 * edge) - 1.0).abs() < 2e-5);
        }
    }

    #[test]
    fn pure_thrust_at_45_degrees_counts_nine_tenths() {
        let factors = FrictionFactors::from_contact_angle(PI / 4.0);
        assert!((factors.axial_factor - 0.9).abs() < 1e-15);
        assert!((factors.static_axial - 0.22).abs() < 1e-15);
        // P_0 = 0.22 C_0, P_1 = 0.9 C_0
        let moment = factors.load_moment(0.0, -1e4, 1e4, 0.1);
        assert!((moment - 1e-3 * 0.22f64.powf(0.33) * 9e3 * 0.1).abs() < 1e-14);
    }
}
