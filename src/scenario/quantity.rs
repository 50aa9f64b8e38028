//! A number with its unit, as people write it: `"5 kg"`; dimensions, and the units that are of each.

use std::borrow::Cow;
use std::f64::consts::PI;
use std::marker::PhantomData;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::unit::{Unit, UnitError};
use crate::numerics::digits::to_digits;
pub(super) use measure::*;

/// Why a text is not a quantity of the dimension asked for.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum QuantityError {
    NoNumber,
    /// A comma, or digits in groups.
    NotOneNumber,
    NoUnit,
    NotFinite,
    UnknownUnit(String),
    /// The unit, of which nobody can tell what it means, and what to write.
    Ambiguous(String, &'static str),
    /// A unit of something else, of a known dimension or of none.
    WrongDimension(String, Option<Dimension>),
}

/// A parsed quantity.
#[derive(Debug, Clone)]
pub(super) struct Parsed {
    /// Value in SI units.
    pub si: f64,
    /// What it measures.
    pub dimension: Dimension,
    /// The unit it was written in.
    pub unit: Unit,
}

/// Reads a number and a unit of one of the given dimensions.
pub(super) fn parse(text: &str, dimensions: &[Dimension]) -> Result<Parsed, QuantityError> {
    let (number, rest) = split_number(text.trim());
    let Ok(number) = number.replace('−', "-").parse::<f64>() else {
        let word = text.trim().trim_start_matches(['+', '-']);
        let word = word.get(..3).map(str::to_ascii_lowercase);
        return Err(match word.as_deref() {
            Some("nan" | "inf") => QuantityError::NotFinite,
            _ => QuantityError::NoNumber,
        });
    };
    if rest.is_empty() {
        return Err(QuantityError::NoUnit);
    }
    let grouped = rest.starts_with(|c: char| c.is_ascii_digit() || ",'’_".contains(c));
    if grouped && !rest.starts_with("1/") && !rest.starts_with("1 /") {
        return Err(QuantityError::NotOneNumber);
    }
    let unit = Unit::read(rest).map_err(|error| match error {
        UnitError::Unknown => QuantityError::UnknownUnit(rest.to_owned()),
        UnitError::Ambiguous => {
            let advice =
                "write what it divides in brackets, as in `N/(m s)`, or first, as in `N s/m`";
            QuantityError::Ambiguous(rest.to_owned(), advice)
        }
    })?;
    let mut known = dimensions.iter().copied();
    let Some((dimension, unit)) = known.find_map(|it| Some((it, it.unit(&unit)?))) else {
        let mut all = Dimension::ALL.iter().map(|(dimension, ..)| *dimension);
        let owner = all.find(|it| it.unit(&unit).is_some());
        return Err(match owner {
            Some(Dimension::Frequency) if dimensions.contains(&Dimension::AngularSpeed) => {
                QuantityError::Ambiguous(rest.to_owned(), "write `rev/s`, or `rad/s`")
            }
            owner => QuantityError::WrongDimension(rest.to_owned(), owner),
        });
    };
    let si = unit.si(number);
    match si.is_finite() {
        true => Ok(Parsed {
            si,
            dimension,
            unit,
        }),
        false => Err(QuantityError::NotFinite),
    }
}

/// Splits after the longest prefix of the form `[+-] digits [. digits] [e [+-] digits]`.
fn split_number(text: &str) -> (&str, &str) {
    fn unsigned(text: &str) -> &str {
        text.strip_prefix(['+', '-', '−']).unwrap_or(text)
    }
    fn after_digits(text: &str) -> &str {
        text.trim_start_matches(|c: char| c.is_ascii_digit())
    }
    let whole = after_digits(unsigned(text));
    let mantissa = whole.strip_prefix('.').map_or(whole, after_digits);
    let exponent = mantissa.strip_prefix(['e', 'E']).map(unsigned);
    let exponent = exponent.filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
    let rest = exponent.map_or(mantissa, after_digits);
    let (number, _) = text.split_at(text.len() - rest.len());
    (number, rest.trim_start())
}

/// A quantity of a dimension that `D` stands for, kept as it was written and in SI units.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String", bound = "D: Measure + Clone")]
pub(super) struct Quantity<D> {
    text: String,
    si: f64,
    /// What it measures, where `D` stands for several dimensions.
    pub dimension: Dimension,
    measure: PhantomData<D>,
}

impl<D> Quantity<D> {
    /// Value in SI units.
    pub fn si(&self) -> f64 {
        self.si
    }
}

/// Value in SI units of a quantity that may be given.
pub(super) fn si<D>(quantity: &Option<Quantity<D>>) -> Option<f64> {
    quantity.as_ref().map(Quantity::si)
}

/// Zero, in the SI unit.
impl<D: Measure> Default for Quantity<D> {
    fn default() -> Self {
        Self {
            text: format!("0 {}", D::DIMENSIONS[0].si_symbol()),
            si: 0.0,
            dimension: D::DIMENSIONS[0],
            measure: PhantomData,
        }
    }
}

impl<D: Measure> TryFrom<String> for Quantity<D> {
    type Error = &'static str;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        let parsed = parse(&text, D::DIMENSIONS).map_err(|_| "it is no quantity")?;
        Ok(Self {
            text,
            si: parsed.si,
            dimension: parsed.dimension,
            measure: PhantomData,
        })
    }
}

impl<D> From<Quantity<D>> for String {
    fn from(quantity: Quantity<D>) -> Self {
        quantity.text
    }
}

impl<D: Measure> JsonSchema for Quantity<D> {
    fn schema_name() -> Cow<'static, str> {
        names(D::DIMENSIONS).into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": "string",
            "pattern": r"^\s*[+−-]?(\d+\.?\d*|\.\d+)([eE][+−-]?\d+)?\s*\D.*$",
            "examples": [D::EXAMPLE],
            "x-dimension": names(D::DIMENSIONS),
            "x-units": units(D::DIMENSIONS),
            "x-minimum": -D::LARGEST,
            "x-maximum": D::LARGEST,
        })
    }
}

/// A type that stands for a dimension, or for several of which a key takes any.
pub(super) trait Measure {
    /// The dimensions.
    const DIMENSIONS: &[Dimension];
    /// How a quantity of it is written.
    const EXAMPLE: &'static str;
    /// Largest magnitude in SI units that a scenario may hold, where a key sets no other limit:
    /// far beyond any machine, and small enough that no product of such numbers overflows.
    const LARGEST: f64;
}

/// Every dimension: its name in the code and in messages, an example, its largest magnitude in a scenario, and
/// some of its units, the SI unit first.
macro_rules! dimensions {
    ($($name:ident $words:literal $example:literal $largest:literal $units:literal,)*) => {
        /// What a quantity measures.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub(super) enum Dimension {
            $($name),*
        }

        impl Dimension {
            /// Every dimension with its name in messages and in the schema, and some of its units.
            const ALL: &[(Self, &'static str, &'static str)] = &[$((Self::$name, $words, $units)),*];
        }

        /// Types that stand for the dimensions.
        pub(super) mod measure {
            use super::{Dimension, Measure};
            $(
                #[allow(dead_code, reason = "of some dimensions no key is, but their units are known")]
                #[derive(Debug, Clone, Copy, PartialEq)]
                pub(in crate::scenario) enum $name {}

                impl Measure for $name {
                    const DIMENSIONS: &[Dimension] = &[Dimension::$name];
                    const EXAMPLE: &'static str = $example;
                    const LARGEST: f64 = $largest;
                }
            )*
        }
    };
}

#[rustfmt::skip]
dimensions! {
    Mass "mass" "5 kg" 1e9 "kg, g, mg, t, lb, oz",
    Length "length" "10 mm" 1e3 "m, mm, um, nm, cm, in, mil",
    Angle "angle" "15 deg" 1e3 "rad, deg, mrad, urad, rev",
    Time "time" "0.5 s" 1e7 "s, ms, us, min, h",
    Force "force" "1000 N" 1e12 "N, kN, MN, mN, lbf, kgf",
    Moment "moment of force" "2 N m" 1e12 "N m, N mm, kN m, lbf in, lbf ft",
    Inertia "moment of inertia" "0.01 kg m^2" 1e12 "kg m^2, kg mm^2, kg cm^2, g m^2, g cm^2, g mm^2, lb in^2",
    AngularSpeed "angular speed" "500 rad/s" 1e5 "rad/s, rpm, 1/min, rev/s, Hz, deg/s, mrad/s",
    Velocity "velocity" "1 mm/s" 1e5 "m/s, mm/s, um/s, in/s",
    Acceleration "acceleration" "10 m/s^2" 1e9 "m/s^2, mm/s^2, gn",
    Frequency "frequency" "20 kHz" 1e9 "Hz, kHz, MHz, cpm",
    Pressure "pressure" "207 GPa" 1e13 "Pa, kPa, MPa, GPa, N/mm^2, bar, psi, ksi",
    Density "density" "7800 kg/m^3" 1e6 "kg/m^3, g/cm^3, lb/in^3",
    Damping "damping coefficient" "200 N s/m" 1e12 "N s/m, N s/mm, kN s/m, lbf s/in",
    TiltDamping "tilt damping coefficient" "0.1 N m s/rad" 1e12 "N m s/rad, N m s, N mm s/rad",
    ContactLoss "contact damping coefficient" "0.2 s/m" 1e9 "s/m, s/mm",
    ContactStiffness "contact stiffness" "1.334e10 N/m^1.5" 1e16 "N/m^1.5, N/mm^1.5, lbf/in^1.5",
    Stiffness "stiffness" "100 N/um" 1e12 "N/m, N/mm, N/um, kN/mm, MN/m, lbf/in",
    TiltStiffness "tilt stiffness" "1e4 N m/rad" 1e15 "N m/rad, kN m/rad, N mm/rad, lbf in/rad",
    Viscosity "viscosity" "0.04 Pa s" 1e4 "Pa s, mPa s, cP",
    KinematicViscosity "kinematic viscosity" "68 mm^2/s" 1.0 "m^2/s, mm^2/s, cSt",
    Unbalance "unbalance" "20 g mm" 1e6 "kg m, g mm, kg mm, g cm, g m, oz in",
    Temperature "temperature" "70 degC" 2e3 "degC, K, degF",
    ThermalExpansion "thermal expansion" "12.5e-6 1/K" 1e-2 "1/K, um/m/K, ppm/K, 1/degF",
    PressureViscosity "pressure-viscosity coefficient" "22 1/GPa" 1e-3 "1/Pa, 1/MPa, 1/GPa, mm^2/N",
    SecondMoment "second moment of area" "2.5e-8 m^4" 1e6 "m^4, mm^4, cm^4, in^4",
}

/// The first dimension or the second: a key takes quantities of both.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Or<A, B>(PhantomData<(A, B)>);

impl<A: Measure, B: Measure> Measure for Or<A, B> {
    const DIMENSIONS: &[Dimension] = &[A::DIMENSIONS[0], B::DIMENSIONS[0]];
    const EXAMPLE: &'static str = A::EXAMPLE;
    const LARGEST: f64 = A::LARGEST;
}

impl Dimension {
    /// Name in messages and in the schema.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }

    /// Some of its units, the SI unit first.
    pub fn units(self) -> impl Iterator<Item = &'static str> {
        Self::ALL[self as usize].2.split(", ")
    }

    /// The SI unit.
    pub fn si_symbol(self) -> &'static str {
        self.units().next().unwrap_or_default()
    }

    /// The dimension whose SI unit a symbol is.
    pub fn of_unit(symbol: &str) -> Option<Self> {
        let mut all = Self::ALL.iter().map(|(dimension, ..)| *dimension);
        all.find(|dimension| dimension.si_symbol() == symbol)
    }

    /// The dimension of a name.
    pub fn named(name: &str) -> Option<Self> {
        let mut all = Self::ALL.iter();
        let found = all.find(|(_, known, _)| *known == name);
        found.map(|(dimension, ..)| *dimension)
    }

    /// What the values of a key measure, by its schema: nothing, or one of some dimensions.
    pub fn from_key(schema: &Value) -> Vec<Self> {
        let names = schema["x-dimension"].as_str().into_iter();
        names
            .flat_map(|names| names.split(OR))
            .filter_map(Self::named)
            .collect()
    }

    /// The unit, if it is one of this dimension.
    fn unit(self, unit: &Unit) -> Option<Unit> {
        let measures_as = |symbol| Unit::read(symbol).is_ok_and(|it| it.measures_as(unit));
        let counts_turns = || {
            ["min", "Hz", "cpm", "CPM"]
                .iter()
                .any(|it| unit.symbol.contains(it))
        };
        match self {
            _ if measures_as(self.si_symbol()) => Some(unit.clone()),
            // 1/s may be turns or radians
            Self::AngularSpeed if measures_as("Hz") && counts_turns() => {
                Some(unit.clone().times(2.0 * PI))
            }
            Self::TiltDamping if measures_as("N m s") => Some(unit.clone()),
            _ => None,
        }
    }
}

/// The unit that a sensor measures in, and the SI unit of the same quantity; `g` is the standard gravity there. None of a unit that
/// is not known.
pub(super) fn sensor_unit(text: &str) -> Option<(Unit, &'static str)> {
    let unit = Unit::read(match text.trim() {
        "g" | "G" => "gn",
        "mg" => "mgn",
        other => other,
    });
    let unit = unit.ok()?;
    let mut all = Dimension::ALL.iter().map(|(dimension, ..)| *dimension);
    all.find_map(|dimension| Some((dimension.unit(&unit)?, dimension.si_symbol())))
}

/// Spellings of units of some dimensions that differ from a text by capital letters alone.
pub(super) fn alike(text: &str, dimensions: &[Dimension]) -> Vec<String> {
    let mut alike = Unit::alike(text);
    alike.retain(|unit| dimensions.iter().any(|it| it.unit(unit).is_some()));
    alike.into_iter().map(|unit| unit.symbol).collect()
}

/// What is between the names of dimensions of which a key takes any.
const OR: &str = " or ";

/// Names of some dimensions.
pub(super) fn names(dimensions: &[Dimension]) -> String {
    let names: Vec<_> = dimensions.iter().map(|it| it.name()).collect();
    names.join(OR)
}

/// Some units of some dimensions.
pub(super) fn units(dimensions: &[Dimension]) -> Vec<&'static str> {
    dimensions.iter().flat_map(|it| it.units()).collect()
}

/// A number with the four significant digits that a message needs.
pub(super) fn significant(number: f64) -> f64 {
    to_digits(number, 4)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn si(text: &str, dimension: Dimension) -> f64 {
        let parsed = parse(text, &[dimension]);
        parsed
            .unwrap_or_else(|error| panic!("{text}: {error:?}"))
            .si
    }

    fn refusal(text: &str, dimension: Dimension) -> QuantityError {
        parse(text, &[dimension]).expect_err(text)
    }

    /// Units of a dimension that multiply a number, and units that divide it.
    type Sizes<'a> = (Dimension, &'a [(&'a str, f64)], &'a [(&'a str, f64)]);

    #[test]
    #[rustfmt::skip]
    fn one_rounding_converts_a_number() {
        use Dimension as D;
        let sizes: &[Sizes<'_>] = &[
            (D::Mass, &[("kg", 1.0), ("t", 1e3), ("lb", 0.453_592_37)], &[("g", 1e3), ("mg", 1e6)]),
            (D::Length, &[("m", 1.0), ("in", 0.0254)], &[("mm", 1e3), ("um", 1e6), ("nm", 1e9), ("pm", 1e12), ("cm", 1e2), ("mil", 1e3 / 0.0254)]),
            (D::Angle, &[("rad", 1.0), ("deg", PI / 180.0)], &[("mrad", 1e3), ("urad", 1e6)]),
            (D::Time, &[("s", 1.0), ("min", 60.0)], &[("ms", 1e3), ("us", 1e6)]),
            (D::Force, &[("N", 1.0), ("kN", 1e3), ("MN", 1e6), ("lbf", 4.448_221_615_260_5)], &[("mN", 1e3)]),
            (D::Moment, &[("N m", 1.0), ("kN m", 1e3)], &[("N mm", 1e3)]),
            (D::Inertia, &[("kg m^2", 1.0)], &[("kg mm^2", 1e6), ("kg cm^2", 1e4), ("g m^2", 1e3), ("g cm^2", 1e7), ("g mm^2", 1e9)]),
            (D::AngularSpeed, &[("rad/s", 1.0), ("rpm", PI / 30.0), ("1/min", PI / 30.0), ("rev/s", 2.0 * PI), ("deg/s", PI / 180.0)], &[("mrad/s", 1e3)]),
            (D::Velocity, &[("m/s", 1.0)], &[("mm/s", 1e3), ("um/s", 1e6)]),
            (D::Acceleration, &[("m/s^2", 1.0), ("gn", 9.806_65)], &[("mm/s^2", 1e3)]),
            (D::Frequency, &[("Hz", 1.0), ("kHz", 1e3), ("MHz", 1e6)], &[]),
            (D::Pressure, &[("Pa", 1.0), ("kPa", 1e3), ("MPa", 1e6), ("GPa", 1e9), ("N/mm^2", 1e6), ("psi", 6_894.757_293_168_361)], &[]),
            (D::Density, &[("kg/m^3", 1.0), ("g/cm^3", 1e3)], &[]),
            (D::Damping, &[("N s/m", 1.0), ("N s/mm", 1e3), ("kN s/m", 1e3)], &[]),
            (D::TiltDamping, &[("N m s/rad", 1.0), ("N m s", 1.0)], &[("N mm s/rad", 1e3)]),
            (D::ContactLoss, &[("s/m", 1.0), ("s/mm", 1e3)], &[]),
            (D::ContactStiffness, &[("N/m^1.5", 1.0), ("N/mm^1.5", 31_622.776_601_683_792)], &[]),
            (D::Stiffness, &[("N/m", 1.0), ("N/mm", 1e3), ("N/um", 1e6), ("kN/mm", 1e6)], &[]),
            (D::TiltStiffness, &[("N m/rad", 1.0), ("kN m/rad", 1e3)], &[("N mm/rad", 1e3)]),
            (D::Viscosity, &[("Pa s", 1.0)], &[("mPa s", 1e3), ("cP", 1e3)]),
            (D::KinematicViscosity, &[("m^2/s", 1.0)], &[("mm^2/s", 1e6), ("cSt", 1e6)]),
            (D::Unbalance, &[("kg m", 1.0)], &[("g mm", 1e6), ("kg mm", 1e3), ("g cm", 1e5), ("g m", 1e3)]),
            (D::Temperature, &[("degC", 1.0)], &[]),
            (D::ThermalExpansion, &[("1/K", 1.0)], &[("um/m/K", 1e6)]),
            (D::PressureViscosity, &[("1/Pa", 1.0)], &[("1/MPa", 1e6), ("1/GPa", 1e9), ("mm^2/N", 1e6)]),
            (D::SecondMoment, &[("m^4", 1.0)], &[("mm^4", 1e12), ("cm^4", 1e8)]),
        ];
        for (dimension, times, per) in sizes {
            for number in [1.0, 0.1, 137.3, -2.7, 1e-7 / 3.0, 1.234_567_89e9] {
                for (unit, factor) in *times {
                    assert_eq!(si(&format!("{number} {unit}"), *dimension), number * factor, "{unit}");
                }
                for (unit, divisor) in *per {
                    assert_eq!(si(&format!("{number} {unit}"), *dimension), number / divisor, "{unit}");
                }
            }
        }
        assert_eq!(si("300.1 K", D::Temperature), 300.1 - 273.15);
    }

    #[test]
    fn a_mil_is_a_thousandth_of_an_inch() {
        let error = si("1 mil", Dimension::Length) - 25.4e-6;
        assert!(error.abs() < 1e-20, "{error:e}");
    }

    #[test]
    fn spellings_of_one_unit_agree() {
        for text in ["3 um", "3 µm", "3 μm", "3um", " +3.0e0  um ", "3 micron"] {
            assert_eq!(si(text, Dimension::Length), 3e-6, "{text}");
        }
        for text in [
            "2 kg m^2",
            "2 kg*m²",
            "2 kg·m**2",
            "2 kg.m^2",
            "2 kg  m^2",
            "2 kgm2",
            "2 kg-m2",
            "2 kg (m)^2",
        ] {
            assert_eq!(si(text, Dimension::Inertia), 2.0, "{text}");
        }
        for text in ["1 N/m^1.5", "1 N / m^(3/2)", "1 N m^-1.5", "1 N·m^(-1.5)"] {
            assert_eq!(si(text, Dimension::ContactStiffness), 1.0, "{text}");
        }
        for text in [
            "5 N s/m",
            "5 N·s/m",
            "5 N*s/m",
            "5 Ns/m",
            "5 N s m^-1",
            "5 N s m⁻¹",
            "5 N/(m/s)",
        ] {
            assert_eq!(si(text, Dimension::Damping), 5.0, "{text}");
        }
    }

    #[test]
    fn turning_speeds_are_in_radians() {
        let full = 2.0 * PI;
        for text in [
            "60 rpm",
            "60 RPM",
            "1 rev/s",
            "1 r/s",
            "360 deg/s",
            "360 °/s",
            "60 1/min",
            "60 /min",
            "60 min^-1",
            "60 min-1",
            "60 r/min",
            "60 rev/min",
            "60 U/min",
            "60 tr/min",
            "60 cpm",
            "1 Hz",
            "1 rps",
            "0.06 krpm",
        ] {
            let speed = si(text, Dimension::AngularSpeed);
            assert!((speed - full).abs() < 1e-14, "{text}: {speed}");
        }
        assert_eq!(
            si("29 Hz", Dimension::AngularSpeed),
            si("29 rev/s", Dimension::AngularSpeed)
        );
        assert_eq!(si("60 cpm", Dimension::Frequency), 1.0);
    }

    #[test]
    fn any_product_of_its_dimension_is_a_unit() {
        use Dimension as D;
        for (text, dimension, expected) in [
            ("2 MN/m", D::Stiffness, 2e6),
            ("2 kN/m", D::Stiffness, 2e3),
            ("1000 lbf/in", D::Stiffness, 175_126.835),
            ("1 kgf/mm", D::Stiffness, 9_806.65),
            ("2 kN s/m", D::Damping, 2e3),
            ("1 lbf-s/in", D::Damping, 175.126_835),
            ("1 oz in", D::Unbalance, 720.078e-6),
            ("1 oz-in", D::Unbalance, 720.078e-6),
            ("5 gmm", D::Unbalance, 5e-6),
            ("5 kg mm", D::Unbalance, 5e-3),
            ("3 Nm", D::Moment, 3.0),
            ("3 kNmm", D::Moment, 3.0),
            ("1 lbf in", D::Moment, 0.112_984_829),
            ("2 kp", D::Force, 19.613_3),
            ("2 kgf", D::Force, 19.613_3),
            ("1 bar", D::Pressure, 1e5),
            ("30 Mpsi", D::Pressure, 206.842_719e9),
            ("30e3 ksi", D::Pressure, 206.842_719e9),
            ("2 h", D::Time, 7200.0),
            ("1 day", D::Time, 86_400.0),
            ("1 thou", D::Length, 25.4e-6),
            ("212 degF", D::Temperature, 100.0),
            ("70 °C", D::Temperature, 70.0),
            ("12.5 um/(m K)", D::ThermalExpansion, 12.5e-6),
            ("12.5 ppm/°C", D::ThermalExpansion, 12.5e-6),
            ("32 cSt", D::KinematicViscosity, 32e-6),
            ("32 cP", D::Viscosity, 0.032),
            ("1 gn", D::Acceleration, 9.806_65),
            ("0.284 lb/in^3", D::Density, 7_861.09),
            ("−2 mm", D::Length, -2e-3),
        ] {
            let value = si(text, dimension);
            assert!((value / expected - 1.0).abs() < 1e-6, "{text}: {value}");
        }
    }

    #[test]
    fn what_is_no_quantity_says_why() {
        use QuantityError as E;
        let refusal = |text| refusal(text, Dimension::Mass);
        assert!(matches!(refusal("5"), E::NoUnit));
        for text in ["heavy", "", "+", "kg"] {
            assert_eq!(refusal(text), E::NoNumber, "{text}");
        }
        for text in ["-inf kg", "1e999 kg"] {
            assert_eq!(refusal(text), E::NotFinite, "{text}");
        }
        for text in [
            "5,5 kg",
            "1,480 kg",
            "1 480 kg",
            "1'480 kg",
            "1.480,5 kg",
            "1 10/kg",
        ] {
            assert_eq!(refusal(text), E::NotOneNumber, "{text}");
        }
        for text in [
            "5 kgs",
            "5 Mg",
            "5 kg/",
            "5 kg)",
            "5 (kg",
            "5 ()",
            "5 kg^",
            "5 kg^1.3",
            "5 kg^99",
            "5 %",
            "5 kg^0.5^0.5",
        ] {
            assert!(matches!(refusal(text), E::UnknownUnit(_)), "{text}");
        }
        let nested = format!("5 {}kg{}", "(".repeat(99_999), ")".repeat(99_999));
        assert!(matches!(refusal(&nested), E::UnknownUnit(_)));
        let owner = |text| match refusal(text) {
            E::WrongDimension(_, owner) => owner,
            other => panic!("{text}: {other:?}"),
        };
        assert_eq!(owner("5 mm"), Some(Dimension::Length));
        assert_eq!(owner("5 kN s/m"), Some(Dimension::Damping));
        assert_eq!(owner("5 N/m^2"), Some(Dimension::Pressure));
        assert_eq!(owner("5 kg/s^7"), None);
    }

    #[test]
    fn what_can_mean_two_sizes_is_refused() {
        use QuantityError as E;
        for (text, dimension) in [
            ("5 N/m s", Dimension::Damping),
            ("30 1/s", Dimension::AngularSpeed),
            ("30 s^-1", Dimension::AngularSpeed),
        ] {
            assert!(
                matches!(refusal(text, dimension), E::Ambiguous(..)),
                "{text}"
            );
        }
    }

    #[test]
    fn a_hint_differs_by_capital_letters_alone() {
        let hints = |text, dimension| alike(text, &[dimension]);
        assert_eq!(hints("Kn/MM", Dimension::Stiffness), ["kN/mm"]);
        assert_eq!(hints("mn/m", Dimension::Stiffness), ["MN/m", "mN/m"]);
        assert_eq!(hints("Mpa", Dimension::Pressure), ["MPa", "mPa"]);
        assert_eq!(hints("nm", Dimension::Moment), ["Nm"]);
        assert_eq!(
            hints("KRPM", Dimension::AngularSpeed),
            ["kRPM", "kRpm", "krpm"]
        );
        assert!(hints("kgs", Dimension::Mass).is_empty());
        assert!(hints("rev/mon", Dimension::AngularSpeed).is_empty());
        assert!(hints(&"m ".repeat(99_999), Dimension::Length).is_empty());
    }

    #[test]
    fn every_unit_shown_is_one_of_its_dimension_alone() {
        for (dimension, _, units) in Dimension::ALL {
            for unit in units.split(", ") {
                let text = format!("1 {unit}");
                assert!(si(&text, *dimension).is_finite());
                let owners = Dimension::ALL
                    .iter()
                    .filter(|(other, ..)| parse(&text, &[*other]).is_ok());
                let turns = ["Hz", "kHz", "MHz", "cpm", "1/min"].contains(&unit);
                assert_eq!(owners.count(), 1 + usize::from(turns), "{unit}");
            }
        }
    }

    #[test]
    fn limits_read_back_without_stray_digits() {
        let degree = parse("1 deg", &[Dimension::Angle]).unwrap().unit;
        assert_eq!(degree.readable(std::f64::consts::FRAC_PI_3), 60.0);
        let kelvin = parse("1 K", &[Dimension::Temperature]).unwrap().unit;
        assert_eq!(kelvin.readable(0.0), 273.15);
    }
}
