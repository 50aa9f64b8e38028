//! Modification of the rating life by lubrication, contamination and fatigue limit.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::equivalent_load::between;
use super::{PER_MINUTE, at_most};

/// Largest viscosity ratio that counts.
const HIGHEST_RATIO: f64 = 4.0;

/// Largest factor that counts.
const HIGHEST_FACTOR: f64 = 50.0;

/// Reference kinematic viscosity ν1 in m²/s that separates the surfaces of a bearing with a pitch diameter in m at a speed
/// in rad/s; infinite at rest.
///
/// `ν1 = 45 000 n^−0.83 d_m^−0.5` below 1000 rpm, `4500 n^−0.5 d_m^−0.5` from there on; mm²/s, 1/min, mm. The standard
/// itself jumps by 2.3 % there.
///
/// Source: ISO 281:2007, 9.3.3.2.
///
/// ```
/// use jeffcott::physics::reference_viscosity;
/// use std::f64::consts::PI;
/// // by hand: 45 000/(500^0.83 √38.5) = 41.72, 4500/√(3000 · 38.5) = 13.24
/// let at = |rpm: f64| 1e6 * reference_viscosity(rpm * PI / 30.0, 38.5e-3);
/// assert!((at(500.0) - 41.72).abs() < 5e-3);
/// assert!((at(3000.0) - 13.24).abs() < 5e-3);
/// ```
pub fn reference_viscosity(speed: f64, pitch_diameter: f64) -> f64 {
    let rpm = speed.abs() * PER_MINUTE;
    let diameter = 1e3 * pitch_diameter;
    // a speed in rad/s that is 1000 rpm but for round-off belongs above
    let growth = if rpm < 1000.0 * (1.0 - 1e-12) {
        45_000.0 * rpm.powf(-0.83)
    } else {
        4500.0 / rpm.sqrt()
    };
    1e-6 * growth / diameter.sqrt()
}

/// Life modification factor a_ISO of radial bearings by the viscosity ratio κ = ν/ν1 and e_C C_u/P.
///
/// ```text
/// a_ISO   = 0.1 [1 − (a − b/κ^p)^c (e_C C_u/P)^d]^(−m) ≤ 50
/// balls     a 2.5671   b 2.2649, 1.9987, 1.9987   c 0.83   d 1/3   m 9.3
/// rollers   a 1.5859   b 1.3993, 1.2348, 1.2348   c 1      d 0.4   m 9.185
/// p         0.054381 (0.1 ≤ κ < 0.4)   0.19087 (< 1)   0.071739 (≤ 4)
/// ```
///
/// A κ above 4 counts as 4; below 0.1 the factor is that of severe wear, 0.1.
///
/// Source: ISO 281:2007, eqs. 31–36.
///
/// ```
/// use jeffcott::physics::LifeModification;
/// // by hand from the equations, e_C C_u/P = 0.05 and 0.2
/// let [balls, rollers] = [LifeModification::BALLS, LifeModification::ROLLERS];
/// assert!((balls.factor(1.0, 0.05) - 1.1437).abs() < 5e-5);
/// assert!((balls.factor(2.0, 0.2) - 15.11).abs() < 5e-3);
/// assert_eq!(balls.factor(4.0, 5.0), 50.0);
/// assert!((rollers.factor(1.0, 0.2) - 0.6505).abs() < 5e-5);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LifeModification {
    /// a.
    start: f64,
    /// b below κ = 0.4 and above.
    slopes: [f64; 2],
    /// c, d and m.
    exponents: [f64; 3],
}

impl LifeModification {
    /// Of radial ball bearings.
    pub const BALLS: Self = Self {
        start: 2.5671,
        slopes: [2.2649, 1.9987],
        exponents: [0.83, 1.0 / 3.0, 9.3],
    };
    /// Of radial roller bearings.
    pub const ROLLERS: Self = Self {
        start: 1.5859,
        slopes: [1.3993, 1.2348],
        exponents: [1.0, 0.4, 9.185],
    };

    /// a_ISO by κ and e_C C_u/P.
    pub fn factor(&self, viscosity_ratio: f64, contamination: f64) -> f64 {
        let ratio = at_most(viscosity_ratio, HIGHEST_RATIO);
        if ratio < 0.1 || contamination <= 0.0 {
            return 0.1;
        }
        let (b, p) = match ratio {
            low if low < 0.4 => (self.slopes[0], 0.054381),
            middle if middle < 1.0 => (self.slopes[1], 0.19087),
            _ => (self.slopes[1], 0.071739),
        };
        let [c, d, m] = self.exponents;
        let rest = 1.0 - (self.start - b / ratio.powf(p)).powf(c) * contamination.powf(d);
        if rest <= 0.0 {
            return HIGHEST_FACTOR;
        }
        at_most(0.1 * rest.powf(-m), HIGHEST_FACTOR)
    }
}

/// Life modification factor a_1 for a reliability in per cent: 1 at 90, straight lines between the values of the
/// standard; NaN outside its 90 … 99.95.
///
/// Source: ISO 281:2007, amended values of table 12.
///
/// ```
/// use jeffcott::physics::reliability_factor;
/// assert_eq!([90.0, 95.0, 99.95].map(reliability_factor), [1.0, 0.64, 0.077]);
/// assert!(reliability_factor(99.99).is_nan());
/// ```
pub fn reliability_factor(per_cent: f64) -> f64 {
    #[rustfmt::skip]
    const FACTORS: [(f64, [f64; 1]); 14] = [
        (90.0, [1.0]), (95.0, [0.64]), (96.0, [0.55]), (97.0, [0.47]), (98.0, [0.37]), (99.0, [0.25]), (99.2, [0.22]),
        (99.4, [0.19]), (99.6, [0.16]), (99.8, [0.12]), (99.9, [0.093]), (99.92, [0.087]), (99.94, [0.080]), (99.95, [0.077]),
    ];
    if !(FACTORS[0].0..=FACTORS[13].0).contains(&per_cent) {
        return f64::NAN;
    }
    let [factor] = between(&FACTORS, per_cent);
    factor
}

/// How clean the lubricant is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Contamination {
    /// Particles of the size of the film: laboratory conditions.
    Extreme,
    /// Very fine filtration, bearings sealed and greased for life.
    High,
    /// Fine filtration, bearings shielded and greased for life.
    Normal,
    /// Slight contamination.
    Slight,
    /// Typical contamination: no seals, wear of the machine, ingress from outside.
    Typical,
    /// Severe contamination.
    Severe,
}

impl Contamination {
    /// Contamination factor e_C: the middle of the range of the class for a pitch diameter in m.
    ///
    /// Source: ISO 281:2007, table 13.
    ///
    /// ```
    /// use jeffcott::physics::Contamination;
    /// assert_eq!(Contamination::Normal.factor(38.5e-3), 0.55);
    /// assert_eq!(Contamination::Extreme.factor(38.5e-3), 1.0);
    /// ```
    pub fn factor(self, pitch_diameter: f64) -> f64 {
        let (small, large) = match self {
            Self::Extreme => (1.0, 1.0),
            Self::High => (0.7, 0.85),
            Self::Normal => (0.55, 0.7),
            Self::Slight => (0.4, 0.5),
            Self::Typical => (0.2, 0.3),
            Self::Severe => (0.05, 0.05),
        };
        if pitch_diameter < 0.1 { small } else { large }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_of_the_equations() {
        let rows = [
            (0.2, 0.1647, 0.2237),
            (0.5, 0.366, 0.8617),
            (1.0, 1.1437, 6.9181),
            (2.0, 1.7018, 15.11),
        ];
        for (ratio, dirty, clean) in rows {
            for (contamination, expected) in [(0.05, dirty), (0.2, clean)] {
                let factor = LifeModification::BALLS.factor(ratio, contamination);
                assert!((factor / expected - 1.0).abs() < 4e-4, "{ratio} {factor}");
            }
        }
    }

    /// The branches of the standard meet at κ = 0.4 and 1 to the rounding of its constants.
    #[test]
    fn branches_meet() {
        for kind in [LifeModification::BALLS, LifeModification::ROLLERS] {
            for ratio in [0.4, 1.0] {
                let [below, above] = [-1e-12, 1e-12].map(|step| kind.factor(ratio + step, 0.2));
                assert!((below / above - 1.0).abs() < 1e-3, "{ratio}");
            }
        }
    }
}
