//! Friction moment of a deep-groove ball bearing after SKF.

use super::PER_MINUTE;

/// Constants of a series of deep-groove ball bearings.
///
/// ```text
/// M     = φ_ish φ_rs G_rr (ν n)^0.6 + μ_sl G_sl
/// G_rr  = R1 d_m^1.96 F_r^0.54, with F_a: R1 d_m^1.96 (F_r + R2 F_a/sin α_F)^0.54
/// G_sl  = S1 d_m^−0.26 F_r^(5/3), with F_a: S1 d_m^−0.145 (F_r^5 + S2 d_m^1.5 F_a^4/sin α_F)^(1/3)
/// α_F   = 24.6 (F_a/C_0)^0.24 deg          μ_sl = 0.15 φ_bl + 0.05 (1 − φ_bl)
/// φ_bl  = exp(−2.6e-8 (n ν)^1.4 d_m)       φ_ish = 1/(1 + 1.84e-9 (n d_m)^1.28 ν^0.64)
/// φ_rs  = exp(−K_rs ν n (d + D) √(K_z/(2 (D − d))))     K_z = 3.1
/// ```
///
/// At F_a → 0 the two forms of G_sl differ by d_m^0.115, half as much again of a small bearing: the source's own jump. An axial
/// load below 1e-6 of the radial one, the round-off of an equilibrium, counts as none.
///
/// d_m = (d + D)/2, M in N mm, lengths in mm, ν in mm²/s, n in 1/min, loads in N; K_rs = 3e-8 in an oil bath or jet, 6e-8 with grease.
/// No seals, no drag in an oil bath.
///
/// Source: SKF, *Rolling bearings*, catalogue, section on friction (model of 2004).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkfFriction {
    rolling: [f64; 2],
    sliding: [f64; 2],
}

/// What the friction moment depends on besides the series, SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkfOperation {
    /// Bore and outside diameter, m.
    pub boundary: [f64; 2],
    /// Basic static load rating C_0, N.
    pub static_rating: f64,
    /// Radial and axial load, N; their signs do not matter.
    pub loads: [f64; 2],
    /// Kinematic viscosity, m²/s.
    pub viscosity: f64,
    /// Speed, rad/s.
    pub speed: f64,
    /// Whether grease lubricates.
    pub grease: bool,
}

/// First digits of a designation, then R1, R2, S1, S2.
type Series = (&'static str, [f64; 2], [f64; 2]);

const SERIES: [Series; 6] = [
    ("618", [4.7e-7, 1.7], [6.5e-3, 0.78]),
    ("628", [4.7e-7, 1.7], [6.5e-3, 0.78]),
    ("619", [4.3e-7, 1.7], [4.75e-3, 3.6]),
    ("60", [4.1e-7, 1.7], [3.73e-3, 14.6]),
    ("62", [3.9e-7, 1.7], [3.23e-3, 36.5]),
    ("63", [3.7e-7, 1.7], [2.84e-3, 92.8]),
];

/// Axial load over the radial one below which there is none.
const NO_AXIAL_LOAD: f64 = 1e-6;

impl SkfFriction {
    /// Constants of the series that a designation begins with: four or five digits, `60`, `62`, `63`, `618`, `619`, `628` and two more.
    pub fn from_designation(designation: &str) -> Option<Self> {
        let digits = designation.chars().take_while(char::is_ascii_digit).count();
        let rest = |series: &str| digits.checked_sub(series.len());
        let known = SERIES
            .iter()
            .find(|(series, ..)| designation.starts_with(series) && rest(series) == Some(2));
        known.map(|&(_, rolling, sliding)| Self { rolling, sliding })
    }

    /// Rolling and sliding part of the moment, N m; zero at rest.
    ///
    /// ```
    /// use jeffcott::physics::{SkfFriction, SkfOperation};
    /// use std::f64::consts::PI;
    /// // 6205, 1000 N radial, ν = 20 mm²/s, 3000 rpm, oil bath. By hand: φ_ish = 0.9636, φ_rs = 0.9673, G_rr = 0.020824,
    /// // (ν n)^0.6 = 736.02; φ_bl = 0.0075, μ_sl = 0.05075, G_sl = 125.02
    /// let [rolling, sliding] = SkfFriction::from_designation("6205").unwrap().moment(&SkfOperation {
    ///     boundary: [0.025, 0.052],
    ///     static_rating: 7850.0,
    ///     loads: [1000.0, 0.0],
    ///     viscosity: 20e-6,
    ///     speed: 3000.0 * PI / 30.0,
    ///     grease: false,
    /// });
    /// assert!((1e3 * rolling - 14.286).abs() < 2e-3 && (1e3 * sliding - 6.345).abs() < 2e-3);
    /// ```
    pub fn moment(&self, operation: &SkfOperation) -> [f64; 2] {
        let rpm = operation.speed.abs() * PER_MINUTE;
        if rpm == 0.0 {
            return [0.0; 2];
        }
        let viscosity = 1e6 * operation.viscosity;
        let [bore, outside] = operation.boundary.map(|length| 1e3 * length);
        // d_m = (d + D)/2
        let mean = 0.5 * (bore + outside);
        let starvation = if operation.grease { 6e-8 } else { 3e-8 };
        let inlet = 1.0 / (1.0 + 1.84e-9 * (rpm * mean).powf(1.28) * viscosity.powf(0.64));
        let section = (3.1 / (2.0 * (outside - bore))).sqrt();
        let replenishment = (-starvation * viscosity * rpm * (bore + outside) * section).exp();
        let boundary = (-2.6e-8 * (rpm * viscosity).powf(1.4) * mean).exp();
        let coefficient = 0.15 * boundary + 0.05 * (1.0 - boundary);
        let [rolling, sliding] = self.load_terms(operation, mean);
        [
            1e-3 * inlet * replenishment * rolling * (viscosity * rpm).powf(0.6),
            1e-3 * coefficient * sliding,
        ]
    }

    /// G_rr and G_sl.
    fn load_terms(&self, operation: &SkfOperation, mean: f64) -> [f64; 2] {
        let [radial, axial] = operation.loads.map(f64::abs);
        let ([r1, r2], [s1, s2]) = (self.rolling, self.sliding);
        if axial <= NO_AXIAL_LOAD * radial {
            return [
                r1 * mean.powf(1.96) * radial.powf(0.54),
                s1 * mean.powf(-0.26) * radial.powf(5.0 / 3.0),
            ];
        }
        let degrees = 24.6 * (axial / operation.static_rating).powf(0.24);
        let sine = degrees.to_radians().sin();
        let sliding = radial.powi(5) + s2 * mean.powf(1.5) * axial.powi(4) / sine;
        [
            r1 * mean.powf(1.96) * (radial + r2 * axial / sine).powf(0.54),
            s1 * mean.powf(-0.145) * sliding.cbrt(),
        ]
    }
}
