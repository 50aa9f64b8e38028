//! A number with its unit, as people write it: `"5 kg"`; dimensions and their units, converted by one exact constant each.

use std::borrow::Cow;
use std::f64::consts::PI;
use std::marker::PhantomData;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

use Scale::{Above, Per, Times};
pub(super) use measure::*;

/// Why a text is not a quantity of the dimension asked for.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum QuantityError {
    NoNumber,
    /// The decimal sign is a point.
    DecimalComma,
    NoUnit,
    NotFinite,
    UnknownUnit(String),
    WrongDimension(Dimension),
}

/// A parsed quantity.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parsed {
    /// Value in SI units.
    pub si: f64,
    /// The unit it was written in.
    pub unit: &'static Unit,
}

/// Reads a number and a unit of the given dimension.
pub(super) fn parse(text: &str, dimension: Dimension) -> Result<Parsed, QuantityError> {
    let (number, rest) = split_number(text.trim());
    let Ok(number) = number.parse::<f64>() else {
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
    if rest.starts_with(',') {
        return Err(QuantityError::DecimalComma);
    }
    let spelling = normalise(rest);
    let Some(unit) = dimension.unit(&spelling) else {
        let mut all = Dimension::ALL.iter().map(|(dimension, ..)| *dimension);
        let owner = all.find(|dimension| dimension.unit(&spelling).is_some());
        return Err(match owner {
            Some(owner) => QuantityError::WrongDimension(owner),
            None => QuantityError::UnknownUnit(rest.trim().to_owned()),
        });
    };
    let si = unit.si(number);
    match si.is_finite() {
        true => Ok(Parsed { si, unit }),
        false => Err(QuantityError::NotFinite),
    }
}

/// Splits after the longest prefix of the form `[+-] digits [. digits] [e [+-] digits]`.
fn split_number(text: &str) -> (&str, &str) {
    fn unsigned(text: &str) -> &str {
        text.strip_prefix(['+', '-']).unwrap_or(text)
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

/// One spelling for all ways to write a unit: `N·m²`, `N*m**2` and `N m^2` are the same.
fn normalise(unit: &str) -> String {
    let plain = unit
        .replace(['µ', 'μ'], "u")
        .replace('°', "deg")
        .replace("**", "^")
        .replace("^(3/2)", "^1.5")
        .replace('²', "^2")
        .replace('³', "^3");
    let mut product = String::with_capacity(plain.len());
    let mut previous = ' ';
    for character in plain.chars() {
        let is_dot = character == '.' && !previous.is_ascii_digit();
        let separates = is_dot || matches!(character, '*' | '·' | '⋅') || character.is_whitespace();
        product.push(if separates { ' ' } else { character });
        previous = character;
    }
    let words: Vec<_> = product.split_whitespace().collect();
    words.join(" ").replace(" /", "/").replace("/ ", "/")
}

/// A quantity of dimension `D`, kept as it was written and in SI units.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String", bound = "D: Measure + Clone")]
pub(super) struct Quantity<D> {
    text: String,
    si: f64,
    dimension: PhantomData<D>,
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
            text: format!("0 {}", D::DIMENSION.si_symbol()),
            si: 0.0,
            dimension: PhantomData,
        }
    }
}

impl<D: Measure> TryFrom<String> for Quantity<D> {
    type Error = &'static str;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        let parsed = parse(&text, D::DIMENSION);
        Ok(Self {
            si: parsed.map_err(|_| "it is no quantity")?.si,
            text,
            dimension: PhantomData,
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
        D::DIMENSION.name().into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": "string",
            "pattern": r"^\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\s*\D.*$",
            "examples": [D::EXAMPLE],
            "x-dimension": D::DIMENSION.name(),
            "x-units": D::DIMENSION.symbols(),
            "x-minimum": -D::LARGEST,
            "x-maximum": D::LARGEST,
        })
    }
}

/// How a number in some unit becomes one in SI. Dividing by a power of ten is exact where
/// multiplying by its inverse is not: 5 mm is 5/1e3.
#[derive(Debug, Clone, Copy)]
enum Scale {
    Times(f64),
    Per(f64),
    /// A scale whose zero stands this much below that of the base unit.
    Above(f64),
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
            Above(zero) => number - zero,
        }
    }

    /// Number in this unit of an SI value, rounded to the digits that people read.
    pub fn readable(&self, si: f64) -> f64 {
        let exact = match self.scale {
            Times(factor) => si / factor,
            Per(divisor) => si * divisor,
            Above(zero) => si + zero,
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

/// A type that stands for one dimension.
pub(super) trait Measure {
    /// The dimension.
    const DIMENSION: Dimension;
    /// How a quantity of it is written.
    const EXAMPLE: &'static str;
    /// Largest magnitude in SI units that a scenario may hold, where a key sets no other limit:
    /// far beyond any machine, and small enough that no product of such numbers overflows.
    const LARGEST: f64;
}

/// Every dimension: its name in the code and in messages, an example, its largest magnitude in a scenario, and
/// its units, the SI unit first.
macro_rules! dimensions {
    ($($name:ident $words:literal $example:literal $largest:literal [$($unit:expr),*],)*) => {
        /// What a quantity measures.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub(super) enum Dimension {
            $($name),*
        }

        impl Dimension {
            /// Every dimension with its name in messages and in the schema, and its units.
            pub const ALL: &[(Self, &'static str, &'static [Unit])] =
                &[$((Self::$name, $words, &[$($unit),*])),*];
        }

        /// Types that stand for the dimensions.
        pub(super) mod measure {
            use super::{Dimension, Measure};
            $(
                #[allow(dead_code, reason = "of some dimensions no key is, but their units are known")]
                #[derive(Debug, Clone, Copy, PartialEq)]
                pub(in crate::scenario) enum $name {}

                impl Measure for $name {
                    const DIMENSION: Dimension = Dimension::$name;
                    const EXAMPLE: &'static str = $example;
                    const LARGEST: f64 = $largest;
                }
            )*
        }
    };
}

#[rustfmt::skip]
dimensions! {
    Mass "mass" "5 kg" 1e9 [times("kg", 1.0), per("g", 1e3), per("mg", 1e6), times("t", 1e3), times("lb", 0.453_592_37)],
    Length "length" "10 mm" 1e3 [times("m", 1.0), per("mm", 1e3), per("um", 1e6), per("nm", 1e9), per("cm", 1e2), times("in", 0.0254), per("mil", 1e3 / 0.0254)],
    Angle "angle" "15 deg" 1e3 [times("rad", 1.0), times("deg", PI / 180.0), per("mrad", 1e3), per("urad", 1e6)],
    Time "time" "0.5 s" 1e7 [times("s", 1.0), per("ms", 1e3), per("us", 1e6), times("min", 60.0)],
    Force "force" "1000 N" 1e12 [times("N", 1.0), times("kN", 1e3), times("MN", 1e6), per("mN", 1e3), times("lbf", 4.448_221_615_260_5)],
    Moment "moment of force" "2 N m" 1e12 [times("N m", 1.0), per("N mm", 1e3), times("kN m", 1e3)],
    Inertia "moment of inertia" "0.01 kg m^2" 1e12 [times("kg m^2", 1.0), per("kg mm^2", 1e6), per("kg cm^2", 1e4), per("g m^2", 1e3), per("g cm^2", 1e7), per("g mm^2", 1e9)],
    AngularSpeed "angular speed" "500 rad/s" 1e5 [times("rad/s", 1.0), times("rpm", PI / 30.0), times("1/min", PI / 30.0), times("rev/s", 2.0 * PI), times("deg/s", PI / 180.0), per("mrad/s", 1e3)],
    Velocity "velocity" "1 mm/s" 1e5 [times("m/s", 1.0), per("mm/s", 1e3), per("um/s", 1e6)],
    Acceleration "acceleration" "10 m/s^2" 1e9 [times("m/s^2", 1.0), per("mm/s^2", 1e3), times("gn", 9.806_65)],
    Frequency "frequency" "20 kHz" 1e9 [times("Hz", 1.0), times("kHz", 1e3), times("MHz", 1e6)],
    Pressure "pressure" "207 GPa" 1e13 [times("Pa", 1.0), times("kPa", 1e3), times("MPa", 1e6), times("GPa", 1e9), times("N/mm^2", 1e6), times("psi", 6_894.757_293_168_361)],
    Density "density" "7800 kg/m^3" 1e6 [times("kg/m^3", 1.0), times("g/cm^3", 1e3)],
    Damping "damping coefficient" "200 N s/m" 1e12 [times("N s/m", 1.0), times("N s/mm", 1e3), times("kN s/m", 1e3)],
    TiltDamping "tilt damping coefficient" "0.1 N m s/rad" 1e12 [times("N m s/rad", 1.0), times("N m s", 1.0), per("N mm s/rad", 1e3)],
    ContactLoss "contact damping coefficient" "0.2 s/m" 1e9 [times("s/m", 1.0), times("s/mm", 1e3)],
    ContactStiffness "contact stiffness" "1.334e10 N/m^1.5" 1e16 [times("N/m^1.5", 1.0), times("N/mm^1.5", 31_622.776_601_683_792)],
    Stiffness "stiffness" "100 N/um" 1e12 [times("N/m", 1.0), times("N/mm", 1e3), times("N/um", 1e6), times("kN/mm", 1e6)],
    TiltStiffness "tilt stiffness" "1e4 N m/rad" 1e15 [times("N m/rad", 1.0), times("kN m/rad", 1e3), per("N mm/rad", 1e3)],
    Viscosity "viscosity" "0.04 Pa s" 1e4 [times("Pa s", 1.0), per("mPa s", 1e3), per("cP", 1e3)],
    KinematicViscosity "kinematic viscosity" "68 mm^2/s" 1.0 [times("m^2/s", 1.0), per("mm^2/s", 1e6), per("cSt", 1e6)],
    Unbalance "unbalance" "20 g mm" 1e6 [times("kg m", 1.0), per("g mm", 1e6), per("kg mm", 1e3), per("g cm", 1e5), per("g m", 1e3)],
    Temperature "temperature" "70 degC" 2e3 [times("degC", 1.0), Unit { symbol: "K", scale: Above(273.15) }],
    ThermalExpansion "thermal expansion" "12.5e-6 1/K" 1e-2 [times("1/K", 1.0), per("um/m/K", 1e6)],
    PressureViscosity "pressure-viscosity coefficient" "22 1/GPa" 1e-3 [times("1/Pa", 1.0), per("1/MPa", 1e6), per("1/GPa", 1e9), per("mm^2/N", 1e6)],
    SecondMoment "second moment of area" "2.5e-8 m^4" 1e6 [times("m^4", 1.0), per("mm^4", 1e12), per("cm^4", 1e8)],
}

impl Dimension {
    /// Name in messages and in the schema.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }

    /// Units, the SI unit first.
    pub fn units(self) -> &'static [Unit] {
        Self::ALL[self as usize].2
    }

    /// The SI unit.
    pub fn si_symbol(self) -> &'static str {
        self.units()[0].symbol
    }

    /// The name with its article.
    pub fn with_article(self) -> String {
        let name = self.name();
        let article = if name.starts_with('a') { "an" } else { "a" };
        format!("{article} {name}")
    }

    /// The dimension of a name.
    pub fn named(name: &str) -> Option<Self> {
        let mut all = Self::ALL.iter();
        let found = all.find(|(_, known, _)| *known == name);
        found.map(|(dimension, ..)| *dimension)
    }

    /// The unit of a spelling, in this dimension.
    pub fn unit(self, spelling: &str) -> Option<&'static Unit> {
        self.units().iter().find(|unit| unit.symbol == spelling)
    }

    /// The spellings of its units, that of the SI unit first.
    pub fn symbols(self) -> Vec<&'static str> {
        self.units().iter().map(|unit| unit.symbol).collect()
    }
}

/// The SI unit of every dimension.
pub(crate) fn si_units() -> impl Iterator<Item = &'static str> {
    Dimension::ALL.iter().map(|(_, _, units)| units[0].symbol)
}

/// SI value of one unit by its symbol, of the dimension that has the SI unit `si`.
pub(crate) fn unit_size(si: &str, symbol: &str) -> Option<f64> {
    let mut dimensions = Dimension::ALL.iter().map(|(_, _, units)| units);
    let units = dimensions.find(|units| units[0].symbol == si)?;
    let unit = units.iter().find(|unit| unit.symbol == symbol)?;
    Some(unit.si(1.0))
}

/// A number with the four significant digits that a message needs.
pub(super) fn significant(number: f64) -> f64 {
    format!("{number:.3e}").parse().unwrap_or(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn si(text: &str, dimension: Dimension) -> f64 {
        parse(text, dimension).unwrap().si
    }

    #[test]
    fn powers_of_ten_convert_exactly() {
        assert_eq!(si("5 mm", Dimension::Length), 0.005);
        assert_eq!(si("20 um", Dimension::Length), 20e-6);
        assert_eq!(si("22 1/GPa", Dimension::PressureViscosity), 22e-9);
        assert_eq!(si("207 GPa", Dimension::Pressure), 207e9);
    }

    #[test]
    fn a_mil_is_a_thousandth_of_an_inch() {
        let error = si("1 mil", Dimension::Length) - 25.4e-6;
        assert!(error.abs() < 1e-20, "{error:e}");
    }

    #[test]
    fn spellings_of_one_unit_agree() {
        for text in ["3 um", "3 µm", "3 μm", "3um", " +3.0e0  um "] {
            assert_eq!(si(text, Dimension::Length), 3e-6, "{text}");
        }
        for text in ["2 kg m^2", "2 kg*m²", "2 kg·m**2", "2 kg.m^2", "2 kg  m^2"] {
            assert_eq!(si(text, Dimension::Inertia), 2.0, "{text}");
        }
        for text in ["1 N/m^1.5", "1 N / m^(3/2)"] {
            assert_eq!(si(text, Dimension::ContactStiffness), 1.0, "{text}");
        }
    }

    #[test]
    fn turning_speeds_are_in_radians() {
        let full = 2.0 * std::f64::consts::PI;
        for text in ["60 rpm", "1 rev/s", "360 deg/s", "60 1/min"] {
            let speed = si(text, Dimension::AngularSpeed);
            assert!((speed - full).abs() < 1e-14, "{text}: {speed}");
        }
    }

    #[test]
    fn what_is_no_quantity_says_why() {
        use QuantityError as E;
        let refusal = |text| parse(text, Dimension::Mass).unwrap_err();
        assert!(matches!(refusal("5"), E::NoUnit));
        assert!(matches!(refusal("heavy"), E::NoNumber));
        assert!(matches!(refusal(""), E::NoNumber));
        assert!(matches!(refusal("+"), E::NoNumber));
        assert!(matches!(refusal("-inf kg"), E::NotFinite));
        assert!(matches!(refusal("1e999 kg"), E::NotFinite));
        assert!(matches!(refusal("5,5 kg"), E::DecimalComma));
        assert!(matches!(refusal("5 kgs"), E::UnknownUnit(_)));
        assert!(matches!(refusal("5 mm"), E::WrongDimension(_)));
    }

    #[test]
    fn no_unit_belongs_to_two_dimensions() {
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
