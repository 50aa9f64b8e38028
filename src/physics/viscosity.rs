//! Viscosity of oils over the temperature.

use super::at_least;
use crate::numerics::root::bisection;

/// Kinematic viscosity over the temperature.
///
/// `log10 log10 Z = A − B log10 T` with `Z = ν + 0.7 + exp(−1.47 − 1.84 ν − 0.51 ν²)`, ν in mm²/s, T in K. Holds for mineral
/// oils and most synthetic ones from 0.21 mm²/s on; above 2 mm²/s Z is ν + 0.7.
///
/// Source: C. Walther (1931); ASTM D341.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViscosityLaw {
    intercept: f64,
    slope: f64,
}

/// Least viscosity of ASTM D341, mm²/s.
const THINNEST: f64 = 0.21;

/// Zero of the Celsius scale, K.
const ZERO_CELSIUS: f64 = 273.15;

impl ViscosityLaw {
    /// Viscosity index of a common mineral oil.
    pub const USUAL_INDEX: f64 = 95.0;

    /// Through two points, each a temperature in °C and a kinematic viscosity in m²/s; of one temperature there is no law, and
    /// its viscosities are NaN.
    ///
    /// ```
    /// use jeffcott::physics::ViscosityLaw;
    /// let law = ViscosityLaw::through([(40.0, 68e-6), (100.0, 8.6e-6)]);
    /// assert!((law.at(40.0) - 68e-6).abs() < 1e-15);
    /// assert!((law.at(100.0) - 8.6e-6).abs() < 1e-15);
    /// assert!((law.at(70.0) - 19.97e-6).abs() < 0.01e-6, "{}", law.at(70.0));
    /// // a thin oil: Z = 2.70075 and 1.62904, at 70 °C halfway in log10 T 1.98486, of which the standard's inverse is 1.2753
    /// let law = ViscosityLaw::through([(40.0, 2e-6), (100.0, 0.9e-6)]);
    /// assert!((law.at(70.0) - 1.2753e-6).abs() < 0.0003e-6, "{}", law.at(70.0));
    /// ```
    pub fn through(points: [(f64, f64); 2]) -> Self {
        let [(x0, y0), (x1, y1)] = points.map(|(temperature, viscosity)| {
            let outer = shifted(1e6 * viscosity).log10().log10();
            ((temperature + ZERO_CELSIUS).log10(), outer)
        });
        let slope = (y0 - y1) / (x1 - x0);
        Self {
            intercept: y0 + slope * x0,
            slope,
        }
    }

    /// Law of an oil by its kinematic viscosity at 40 °C in m²/s, the number of its ISO VG class in mm²/s (ISO 3448), and its
    /// viscosity index (ASTM D2270, ISO 2909): the viscosity at 100 °C is the one with that index. The standard knows no index
    /// of oils thinner than 2 mm²/s at 100 °C: there it is extended. Where no viscosity at 100 °C has the index, the law is NaN.
    ///
    /// ```
    /// use jeffcott::physics::ViscosityLaw;
    /// // ASTM D2270: 73.30 mm²/s at 40 °C and 8.86 at 100 °C have the index 92, which is rounded to a whole number
    /// let law = ViscosityLaw::from_grade(73.30e-6, 92.0);
    /// assert!((law.at(100.0) - 8.86e-6).abs() < 0.02e-6, "{}", law.at(100.0));
    /// // 22.83 and 5.05 mm²/s have the index 156
    /// let law = ViscosityLaw::from_grade(22.83e-6, 156.0);
    /// assert!((law.at(100.0) - 5.05e-6).abs() < 0.02e-6, "{}", law.at(100.0));
    /// // extended: of VG 2 `100 (L − 2)/(L − H)` is 95 at 0.893 mm²/s
    /// let law = ViscosityLaw::from_grade(2e-6, 95.0);
    /// assert!((law.at(100.0) - 0.893e-6).abs() < 0.001e-6, "{}", law.at(100.0));
    /// ```
    pub fn from_grade(at_40: f64, index: f64) -> Self {
        let grade = 1e6 * at_40;
        // thicker at 100 °C: a higher index
        let reaches = |at_100| viscosity_index(grade, at_100) >= index;
        let at_100 = match reaches(grade) {
            true => bisection(reaches, [THINNEST, grade], 0.0),
            false => f64::NAN,
        };
        Self::through([(40.0, at_40), (100.0, 1e-6 * at_100)])
    }

    /// Kinematic viscosity at a temperature in °C, m²/s, not below 0.21 mm²/s, where the law ends.
    pub fn at(&self, temperature: f64) -> f64 {
        let outer = self.intercept - self.slope * (temperature + ZERO_CELSIUS).log10();
        1e-6 * unshifted(10f64.powf(10f64.powf(outer)))
    }
}

/// exp(−1.47 − 1.84 ν − 0.51 ν²), ν in mm²/s.
fn decay(viscosity: f64) -> f64 {
    (-1.47 - viscosity * (1.84 + 0.51 * viscosity)).exp()
}

/// Z of a viscosity in mm²/s.
fn shifted(viscosity: f64) -> f64 {
    viscosity + 0.7 + decay(viscosity)
}

/// Newton steps to round-off, at the thinnest oil.
const NEWTON_STEPS: usize = 8;

/// Viscosity in mm²/s of a Z, by Newton's method from above: Z rises ever steeper with it. The inverse in the standard is
/// a fit of that, to 0.03 %.
fn unshifted(value: f64) -> f64 {
    let value = at_least(value, shifted(THINNEST));
    (0..NEWTON_STEPS).fold(value - 0.7, |viscosity, _| {
        let slope = 1.0 - decay(viscosity) * (1.84 + 1.02 * viscosity);
        viscosity - (shifted(viscosity) - value) / slope
    })
}

/// From this viscosity at 100 °C on in mm²/s, `L = a Y² + b Y + c` and `H = d Y² + e Y + f`.
type Reference = (f64, [f64; 3], [f64; 3]);

/// ASTM D2270, table X2.1. The first line serves below its 2 mm²/s, too.
#[rustfmt::skip]
const REFERENCES: [Reference; 15] = [
    (2.0, [1.14673, 1.7576, -0.109], [0.84155, 1.5521, -0.077]),
    (3.8, [3.38095, -15.4952, 33.196], [0.78571, 1.7929, -0.183]),
    (4.4, [2.5, -7.2143, 13.812], [0.82143, 1.5679, 0.119]),
    (5.0, [0.101, 16.635, -45.469], [0.04985, 9.1613, -18.557]),
    (6.4, [3.35714, -23.5643, 78.466], [0.22619, 7.7369, -16.656]),
    (7.0, [0.01191, 21.475, -72.87], [0.79762, -0.7321, 14.61]),
    (7.7, [0.41858, 16.1558, -56.04], [0.05794, 10.5156, -28.24]),
    (9.0, [0.88779, 7.5527, -16.6], [0.26665, 6.7015, -10.81]),
    (12.0, [0.7672, 10.7972, -38.18], [0.20073, 8.4658, -22.49]),
    (15.0, [0.97305, 5.3135, -2.2], [0.28889, 5.9741, -4.93]),
    (18.0, [0.97256, 5.25, -0.98], [0.24504, 7.416, -16.73]),
    (22.0, [0.91413, 7.4759, -21.82], [0.20323, 9.1267, -34.23]),
    (28.0, [0.87031, 9.7157, -50.77], [0.18411, 10.1015, -46.75]),
    (40.0, [0.84703, 12.6752, -133.31], [0.17029, 11.4866, -80.62]),
    (70.0, [0.83531, 14.6731, -216.246], [0.16841, 11.8493, -96.947]),
];

/// Viscosity index of kinematic viscosities U at 40 °C and Y at 100 °C in mm²/s: `100 (L − U)/(L − H)`, above 100
/// `100 + (10^N − 1)/0.00715` with `N = log(H/U)/log Y`; below 2 mm²/s, where the standard ends, with log 2.
fn viscosity_index(at_40: f64, at_100: f64) -> f64 {
    let last = REFERENCES.iter().rev().find(|(from, ..)| at_100 >= *from);
    let (_, l, h) = last.unwrap_or(&REFERENCES[0]);
    let square = |[a, b, c]: &[f64; 3]| (a * at_100 + b) * at_100 + c;
    let (l, h) = (square(l), square(h));
    if at_40 < h {
        let exponent = (h / at_40).ln() / at_100.max(REFERENCES[0].0).ln();
        return 100.0 + (10f64.powf(exponent) - 1.0) / 0.00715;
    }
    100.0 * (l - at_40) / (l - h)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reference_viscosities_join() {
        for pair in REFERENCES.windows(2) {
            let edge = pair[1].0;
            let value = |[a, b, c]: [f64; 3]| (a * edge + b) * edge + c;
            for (below, above) in [(pair[0].1, pair[1].1), (pair[0].2, pair[1].2)] {
                let ratio = value(below) / value(above);
                assert!((ratio - 1.0).abs() < 0.01, "{edge}: {ratio}");
            }
        }
    }

    /// Reference viscosities and indices of the worked examples of ASTM D2270, sections 5 and 6.
    #[test]
    fn the_examples_of_the_standard() {
        for (at_40, at_100, index) in [
            (73.30, 8.86, 92.0),
            (22.83, 5.05, 156.0),
            (53.47, 7.80, 111.0),
        ] {
            assert_eq!(viscosity_index(at_40, at_100).round(), index);
        }
        // indices of oils of other kinds, from Tribology-ABC
        for (at_40, at_100, index) in [
            (30.0, 4.24, -25.0),
            (120.0, 8.0, -49.0),
            (120.0, 50.0, 423.0),
        ] {
            assert_eq!(viscosity_index(at_40, at_100).trunc(), index);
        }
    }

    /// Above 2 mm²/s the exponential of Z is nothing: by `log10 log10(ν + 0.7)` alone, halfway.
    #[test]
    fn oils_that_are_not_thin_have_the_law_of_walther() {
        let law = ViscosityLaw::through([(40.0, 68e-6), (100.0, 8.6e-6)]);
        let [cold, warm] = [68.7f64, 9.3].map(|value| value.log10().log10());
        let [from, at, to] = [40.0, 70.0, 100.0].map(|celsius| (celsius + ZERO_CELSIUS).log10());
        let outer = cold + (warm - cold) * (at - from) / (to - from);
        let expected = 10f64.powf(10f64.powf(outer)) - 0.7;
        assert!((1e6 * law.at(70.0) / expected - 1.0).abs() < 1e-12);
    }

    #[test]
    fn thin_oils_are_told_to_the_end_of_the_law() {
        for viscosity in [THINNEST, 0.5, 1.0, 2.0, 5.0, 1e3] {
            let found = unshifted(shifted(viscosity));
            assert!(
                (found / viscosity - 1.0).abs() < 1e-13,
                "{viscosity} {found}"
            );
        }
        assert_eq!(unshifted(0.5), unshifted(shifted(THINNEST)));
        // the index goes on without a jump
        for at_40 in [4.0, 6.0, 7.5] {
            let [below, above] = [2.0 - 1e-9, 2.0].map(|at_100| viscosity_index(at_40, at_100));
            assert!((below - above).abs() < 1e-5, "{at_40}: {below} {above}");
        }
    }

    #[test]
    fn every_grade_thins_with_the_temperature() {
        for grade in [2.0, 2.5, 10.0, 32.0, 100.0, 460.0, 1500.0] {
            let law = ViscosityLaw::from_grade(1e-6 * grade, ViscosityLaw::USUAL_INDEX);
            assert!((law.at(40.0) / (1e-6 * grade) - 1.0).abs() < 1e-9);
            assert!(law.at(60.0) < law.at(40.0) && law.at(100.0) > 0.0);
        }
    }
}
