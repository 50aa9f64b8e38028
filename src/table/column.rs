//! A column: what it measures, in which unit, and what its numbers stand for.

use std::borrow::Cow;

use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::Value;

/// Units of columns. A unit that results are to be measured in is added here.
const UNITS: [&str; 25] = [
    "s",
    "h",
    "Hz",
    "m",
    "rad",
    "m/s",
    "rad/s",
    "m/s^2",
    "rad/s^2",
    "N",
    "N m",
    "N/m",
    "N m/rad",
    "N s/m",
    "J",
    "Pa",
    "Mrev",
    "m^2",
    "rad^2",
    "N^2",
    "N^2 m^2",
    "m^2/s^2",
    "rad^2/s^2",
    "m^2/s^4",
    "rad^2/s^4",
];

/// Word of the quantities whose names end with `N_m` for N/m; elsewhere that is N m.
const STIFFNESS: &str = "stiffness";

/// What densities are divided by.
const PER: [&str; 2] = ["Hz", "order"];

/// How spectra scale their lines, as names say it: peak, RMS, peak to peak, power and density.
pub const SCALINGS: [&str; 5] = ["peak", "rms", "peak_to_peak", "power", "density"];

/// What else is measured of a motion, as names say it.
const MEASURES: [&str; 6] = [
    "amplitude",
    "mean",
    "equilibrium",
    "order_1",
    "order_2",
    "order_3",
];

/// What the numbers of a column stand for.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ColumnKind {
    /// A real number, or nothing where it is NaN.
    Number,
    /// A measure of how the quantity moves: `amplitude`, `rms`, `density`, `mean`, `order_1` ….
    Measure(&'static str),
    /// The phase that belongs to an amplitude of the same quantity, rad.
    Phase,
    /// A whole number, exact below 2^53, or nothing where it is NaN.
    Count,
    /// The word at this index.
    Word(Vec<String>),
}

impl ColumnKind {
    /// The word that a number stands for; empty where there is none.
    pub fn word(&self, number: f64) -> &str {
        match self {
            Self::Word(words) => words.get(number as usize).map_or("", String::as_str),
            _ => "",
        }
    }

    /// What a number stands for, as JSON; null where there is nothing.
    pub fn json(&self, number: f64) -> Value {
        match self {
            Self::Word(_) => Some(self.word(number))
                .filter(|word| !word.is_empty())
                .into(),
            Self::Count if number.is_finite() => (number as i64).into(),
            _ => number.into(),
        }
    }
}

/// A column of a table.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Column {
    /// What is measured: `x_velocity`.
    pub quantity: Cow<'static, str>,
    /// Its unit: `m/s`; empty where it has none.
    pub unit: Cow<'static, str>,
    /// What its numbers stand for.
    pub kind: ColumnKind,
}

impl Column {
    /// A column of real numbers.
    pub fn number(
        quantity: impl Into<Cow<'static, str>>,
        unit: impl Into<Cow<'static, str>>,
    ) -> Self {
        Self {
            quantity: quantity.into(),
            unit: unit.into(),
            kind: ColumnKind::Number,
        }
    }

    /// A column of whole numbers.
    pub fn count(quantity: impl Into<Cow<'static, str>>) -> Self {
        Self {
            kind: ColumnKind::Count,
            ..Self::number(quantity, "")
        }
    }

    /// A column of words, of which a row holds the index.
    pub fn words(
        quantity: impl Into<Cow<'static, str>>,
        words: impl IntoIterator<Item = impl Into<String>>,
    ) -> Self {
        Self {
            kind: ColumnKind::Word(words.into_iter().map(Into::into).collect()),
            ..Self::number(quantity, "")
        }
    }

    /// A measure of how a quantity moves.
    pub fn measure(
        quantity: impl Into<Cow<'static, str>>,
        what: &'static str,
        unit: impl Into<Cow<'static, str>>,
    ) -> Self {
        Self {
            kind: ColumnKind::Measure(what),
            ..Self::number(quantity, unit)
        }
    }

    /// Frequencies, which spectra stand over.
    pub fn frequency() -> Self {
        Self::number("f", "Hz")
    }

    /// Multiples of the frequency of the shaft.
    pub fn order() -> Self {
        Self::number("order", "")
    }

    /// Phases of a quantity.
    pub fn phase(quantity: impl Into<Cow<'static, str>>) -> Self {
        Self {
            kind: ColumnKind::Phase,
            ..Self::number(quantity, "rad")
        }
    }

    /// Whether its values are heights of the lines of a spectrum, if they stand over frequency.
    pub fn has_lines(&self) -> bool {
        matches!(self.kind, ColumnKind::Measure(what) if what == MEASURES[0] || SCALINGS.contains(&what))
    }

    /// The column of a part of what it is of, which its name begins with: `order_1_x` of `x`.
    #[must_use]
    pub fn of_part(self, part: &str) -> Self {
        Self {
            quantity: format!("{part}_{}", self.quantity).into(),
            ..self
        }
    }

    /// Quantity and unit as one name, valid in MATLAB and pandas: `x_velocity_m_s`, `x_amplitude_m`.
    pub fn name(&self) -> String {
        let what = match self.kind {
            ColumnKind::Measure(what) => what,
            ColumnKind::Phase => "phase",
            _ => "",
        };
        let unit = suffix(&self.unit);
        let parts = [&*self.quantity, what, &unit].into_iter();
        let parts: Vec<_> = parts.filter(|part| !part.is_empty()).collect();
        parts.join("_")
    }

    /// The column of a [name](Self::name); that it counts or holds words does not stand there.
    pub fn from_name(name: &str) -> Self {
        let densities = UNITS
            .iter()
            .flat_map(|unit| PER.map(|per| format!("{unit}/{per}")));
        let units = UNITS.iter().map(|unit| (*unit).to_owned());
        let read = units.chain(densities).filter_map(|unit| {
            let quantity = before(name, &suffix(&unit))?;
            let is_stiffness = quantity.split('_').any(|word| word == STIFFNESS);
            let other = if is_stiffness { "N m" } else { "N/m" };
            (unit != other).then(|| (quantity.to_owned(), unit))
        });
        // what is left is shortest where the unit is the longest
        let read = read.min_by_key(|(quantity, _)| quantity.len());
        let (quantity, unit) = read.unwrap_or_else(|| (name.to_owned(), String::new()));
        if let Some(quantity) = before(&quantity, "phase").filter(|_| unit == "rad") {
            return Self::phase(quantity.to_owned());
        }
        let measures = SCALINGS.into_iter().chain(MEASURES);
        let measured = measures.rev().find_map(|what| {
            let quantity = before(&quantity, what)?;
            Some(Self::measure(quantity.to_owned(), what, unit.clone()))
        });
        measured.unwrap_or_else(|| Self::number(quantity, unit))
    }
}

/// The name.
impl Serialize for Column {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.name())
    }
}

/// By the name.
impl<'de> Deserialize<'de> for Column {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = Cow::<str>::deserialize(deserializer)?;
        Ok(Self::from_name(&name))
    }
}

/// What a name has before its last part.
fn before<'a>(name: &'a str, part: &str) -> Option<&'a str> {
    let rest = name.strip_suffix(part)?.strip_suffix('_')?;
    (!rest.is_empty()).then_some(rest)
}

/// A unit as the end of a name: `rad_s` of `rad/s`, `kg_m2` of `kg m^2`, `N2_per_Hz` of `N^2/Hz`.
fn suffix(unit: &str) -> String {
    let density = PER.iter().find_map(|per| {
        let above = unit.strip_suffix(per)?.strip_suffix('/')?;
        Some(format!("{above}_per_{per}"))
    });
    let unit = density.unwrap_or_else(|| unit.to_owned());
    unit.replace(['^', '(', ')'], "")
        .replace([' ', '/', '.'], "_")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_back() {
        let columns = [
            Column::number("x_velocity", "m/s"),
            Column::number("tilt_x_acceleration", "rad/s^2"),
            Column::number("moment_x", "N m"),
            Column::number("stiffness_x", "N/m"),
            Column::number("stiffness_tilt_x", "N m/rad"),
            Column::number("order", ""),
            Column::measure("x", "amplitude", "m"),
            Column::measure("force_x", "density", "N^2/Hz"),
            Column::measure("x", "peak_to_peak", "m"),
            Column::phase("housing1_x"),
            Column::number("m", ""),
        ];
        for column in columns {
            assert_eq!(Column::from_name(&column.name()), column);
        }
    }

    #[test]
    fn any_name_is_the_name_of_its_column() {
        for name in [
            "",
            "_",
            "_m",
            "m",
            "phase_rad",
            "a_N_m",
            "amplitude_m",
            "x_phase_rad",
        ] {
            assert_eq!(Column::from_name(name).name(), name);
        }
    }
}
