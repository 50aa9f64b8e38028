//! Dimensions and their units, converted by one exact constant each.

use std::f64::consts::PI;

use Scale::{Per, Times};

/// What a quantity measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Dimension {
    Mass,
    Length,
    Angle,
    Time,
    Force,
    Moment,
    Inertia,
    AngularSpeed,
    Velocity,
    Acceleration,
    Frequency,
    Pressure,
    Density,
    Damping,
    TiltDamping,
    ContactLoss,
    ContactStiffness,
    Stiffness,
    Viscosity,
    PressureViscosity,
    SecondMoment,
}

/// How a number in some unit becomes one in SI. Dividing by a power of ten is exact where
/// multiplying by its inverse is not: 5 mm is 5/1e3.
#[derive(Debug, Clone, Copy)]
enum Scale {
    Times(f64),
    Per(f64),
}

/// A unit of some dimension.
#[derive(Debug, Clone, Copy)]
pub(super) struct Unit {
    /// Spelling, products with one blank, powers with `^`.
    pub symbol: &'static str,
    scale: Scale,
}

impl Unit {
    /// SI value of a number in this unit.
    pub fn si(&self, number: f64) -> f64 {
        match self.scale {
            Times(factor) => number * factor,
            Per(divisor) => number / divisor,
        }
    }

    /// Number in this unit of an SI value, rounded to the digits that people read.
    pub fn readable(&self, si: f64) -> f64 {
        let exact = match self.scale {
            Times(factor) => si / factor,
            Per(divisor) => si * divisor,
        };
        format!("{exact:.9e}").parse().unwrap_or(exact)
    }
}

const fn times(symbol: &'static str, factor: f64) -> Unit {
    let scale = Times(factor);
    Unit { symbol, scale }
}

const fn per(symbol: &'static str, divisor: f64) -> Unit {
    let scale = Per(divisor);
    Unit { symbol, scale }
}

impl Dimension {
    /// Every dimension with its name in messages and in the schema, and its units, the SI unit first.
    #[rustfmt::skip]
    pub const ALL: [(Self, &'static str, &'static [Unit]); 21] = [
        (Self::Mass, "mass", &[times("kg", 1.0), per("g", 1e3), per("mg", 1e6), times("t", 1e3), times("lb", 0.453_592_37)]),
        (Self::Length, "length", &[times("m", 1.0), per("mm", 1e3), per("um", 1e6), per("nm", 1e9), per("cm", 1e2), times("in", 0.0254)]),
        (Self::Angle, "angle", &[times("rad", 1.0), times("deg", PI / 180.0), per("mrad", 1e3), per("urad", 1e6)]),
        (Self::Time, "time", &[times("s", 1.0), per("ms", 1e3), per("us", 1e6), times("min", 60.0)]),
        (Self::Force, "force", &[times("N", 1.0), times("kN", 1e3), times("MN", 1e6), per("mN", 1e3), times("lbf", 4.448_221_615_260_5)]),
        (Self::Moment, "moment of force", &[times("N m", 1.0), per("N mm", 1e3), times("kN m", 1e3)]),
        (Self::Inertia, "moment of inertia", &[times("kg m^2", 1.0), per("kg mm^2", 1e6), per("kg cm^2", 1e4), per("g m^2", 1e3), per("g cm^2", 1e7), per("g mm^2", 1e9)]),
        (Self::AngularSpeed, "angular speed", &[times("rad/s", 1.0), times("rpm", PI / 30.0), times("1/min", PI / 30.0), times("rev/s", 2.0 * PI), times("deg/s", PI / 180.0), per("mrad/s", 1e3)]),
        (Self::Velocity, "velocity", &[times("m/s", 1.0), per("mm/s", 1e3), per("um/s", 1e6)]),
        (Self::Acceleration, "acceleration", &[times("m/s^2", 1.0), per("mm/s^2", 1e3), times("gn", 9.806_65)]),
        (Self::Frequency, "frequency", &[times("Hz", 1.0), times("kHz", 1e3), times("MHz", 1e6)]),
        (Self::Pressure, "pressure", &[times("Pa", 1.0), times("kPa", 1e3), times("MPa", 1e6), times("GPa", 1e9), times("N/mm^2", 1e6), times("psi", 6_894.757_293_168_361)]),
        (Self::Density, "density", &[times("kg/m^3", 1.0), times("g/cm^3", 1e3)]),
        (Self::Damping, "damping coefficient", &[times("N s/m", 1.0), times("N s/mm", 1e3), times("kN s/m", 1e3)]),
        (Self::TiltDamping, "tilt damping coefficient", &[times("N m s/rad", 1.0), times("N m s", 1.0), per("N mm s/rad", 1e3)]),
        (Self::ContactLoss, "contact damping coefficient", &[times("s/m", 1.0), times("s/mm", 1e3)]),
        (Self::ContactStiffness, "contact stiffness", &[times("N/m^1.5", 1.0), times("N/mm^1.5", 31_622.776_601_683_792)]),
        (Self::Stiffness, "stiffness", &[times("N/m", 1.0), times("N/mm", 1e3), times("N/um", 1e6), times("kN/mm", 1e6)]),
        (Self::Viscosity, "viscosity", &[times("Pa s", 1.0), per("mPa s", 1e3), per("cP", 1e3)]),
        (Self::PressureViscosity, "pressure-viscosity coefficient", &[times("1/Pa", 1.0), per("1/MPa", 1e6), per("1/GPa", 1e9), per("mm^2/N", 1e6)]),
        (Self::SecondMoment, "second moment of area", &[times("m^4", 1.0), per("mm^4", 1e12), per("cm^4", 1e8)]),
    ];

    /// Name in messages and in the schema.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }

    /// Units, the SI unit first.
    pub fn units(self) -> &'static [Unit] {
        Self::ALL[self as usize].2
    }

    /// The name with its article.
    pub fn with_article(self) -> String {
        let name = self.name();
        let article = if name.starts_with('a') { "an" } else { "a" };
        format!("{article} {name}")
    }

    /// The dimension of a name.
    pub fn named(name: &str) -> Option<Self> {
        let mut all = Self::ALL.into_iter();
        all.find(|(_, known, _)| *known == name)
            .map(|(dimension, ..)| dimension)
    }

    /// The unit of a spelling, in this dimension.
    pub fn unit(self, spelling: &str) -> Option<&'static Unit> {
        self.units().iter().find(|unit| unit.symbol == spelling)
    }

    /// The units as they are listed in messages.
    pub fn unit_list(self) -> String {
        let symbols: Vec<_> = self.units().iter().map(|unit| unit.symbol).collect();
        symbols.join(", ")
    }
}

/// A number with the four significant digits that a message needs.
pub(super) fn significant(number: f64) -> f64 {
    format!("{number:.3e}").parse().unwrap_or(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_unit_belongs_to_two_dimensions() {
        for (place, (dimension, ..)) in Dimension::ALL.into_iter().enumerate() {
            assert_eq!(dimension as usize, place);
        }
        let mut symbols: Vec<_> = Dimension::ALL
            .iter()
            .flat_map(|(_, _, units)| *units)
            .map(|unit| unit.symbol)
            .collect();
        let count = symbols.len();
        symbols.sort_unstable();
        symbols.dedup();
        assert_eq!(symbols.len(), count);
    }

    #[test]
    fn limits_read_back_without_stray_digits() {
        let degree = Dimension::Angle.unit("deg").unwrap();
        assert_eq!(degree.readable(std::f64::consts::FRAC_PI_3), 60.0);
    }
}
