//! The eleven lines in front of the values of a function.

use std::str::FromStr;

use super::Lines;
use crate::record::Problem;
use crate::record::unit::per_second;

/// Number of the abscissa that is time.
const TIME: i64 = 17;
/// Type of functions that are responses over time.
const TIME_RESPONSE: i64 = 1;
/// Directions from -6 on.
const DIRECTIONS: [&str; 13] = [
    "-rz", "-ry", "-rx", "-z", "-y", "-x", "", "+x", "+y", "+z", "+rx", "+ry", "+rz",
];

/// What comes before the values of a function.
pub(super) struct Header {
    /// First line.
    description: String,
    function: i64,
    entity: String,
    pub node: i64,
    direction: i64,
    pub is_double: bool,
    pub is_complex: bool,
    /// Number of values, or of pairs.
    pub count: u64,
    pub is_even: bool,
    /// First abscissa, and the step to the next, in the unit of the abscissa.
    pub start: f64,
    pub step: f64,
    /// A time in the unit of the abscissa that is one second.
    pub per_second: f64,
    abscissa: i64,
    ordinate: i64,
    unit: String,
}

impl Header {
    pub fn read(lines: &mut Lines<'_>) -> Result<Self, Problem> {
        let mut line = || {
            let line = lines.next().ok_or_else(|| lines.cut())?;
            // bytes beyond ASCII are Latin-1
            let text = line.iter().map(|byte| char::from(*byte)).collect();
            let number = lines.number;
            Ok::<_, Problem>(Line { text, number })
        };
        let [description, _, _, _, _] = [line()?, line()?, line()?, line()?, line()?];
        let [place, form, abscissa, ordinate] = [line()?, line()?, line()?, line()?];
        // denominator of the ordinate, and z axis
        let [_, _] = [line()?, line()?];
        let kind: i64 = form.number(0, 10)?;
        if ![2, 4, 5, 6].contains(&kind) {
            let what = format!("values of type {kind}, of which 2, 4, 5 and 6 are known");
            return Err(Problem::line(form.number, what));
        }
        Ok(Self {
            description: description.field(0, 80),
            function: place.number(0, 5)?,
            entity: Some(place.field(31, 41))
                .filter(|it| !it.is_empty())
                .unwrap_or("node".into()),
            node: place.number(41, 51)?,
            direction: place.number(51, 55)?,
            is_double: matches!(kind, 4 | 6),
            is_complex: matches!(kind, 5 | 6),
            count: form.number(10, 20)?,
            is_even: form.number::<i64>(20, 30)? != 0,
            start: form.number(30, 43)?,
            step: form.number(43, 56)?,
            per_second: per_second(&abscissa.field(47, 67)).unwrap_or(1.0),
            abscissa: abscissa.number(0, 10)?,
            ordinate: ordinate.number(0, 10)?,
            unit: ordinate.field(47, 67),
        })
    }

    /// Whether its values stand over time.
    pub fn is_over_time(&self) -> bool {
        self.abscissa == TIME || (self.abscissa <= 1 && self.function == TIME_RESPONSE)
    }

    /// Its description, or else entity, node and direction.
    pub fn name(&self) -> String {
        if !self.description.is_empty() {
            return self.description.clone();
        }
        let direction = self.direction().unwrap_or_default();
        format!("{}{}{direction}", self.entity, self.node)
    }

    /// Its unit, as it is written.
    pub fn unit(&self) -> Option<String> {
        (!self.unit.is_empty()).then(|| self.unit.clone())
    }

    /// What is measured.
    pub fn quantity(&self) -> Option<&'static str> {
        Some(match self.ordinate {
            2 => "stress",
            3 => "strain",
            5 => "temperature",
            8 => "displacement",
            9 | 13 => "force",
            11 => "velocity",
            12 => "acceleration",
            15 => "pressure",
            19 => "speed",
            _ => return None,
        })
    }

    /// The direction of the sensor; none of a scalar.
    pub fn direction(&self) -> Option<&'static str> {
        let place = usize::try_from(self.direction.checked_add(6)?).ok()?;
        let direction = DIRECTIONS.get(place)?;
        (!direction.is_empty()).then_some(direction)
    }
}

/// A line of fields that stand in columns.
struct Line {
    text: String,
    number: u64,
}

impl Line {
    /// What is in columns, without blanks around it; nothing for `NONE`.
    fn field(&self, from: usize, to: usize) -> String {
        let signs = self.text.chars().skip(from).take(to - from);
        let field: String = signs.collect();
        let field = field.trim();
        field.strip_prefix("NONE").unwrap_or(field).to_owned()
    }

    /// A number; zero where there is none.
    fn number<T: FromStr + Default>(&self, from: usize, to: usize) -> Result<T, Problem> {
        let field = self.field(from, to);
        if field.is_empty() {
            return Ok(T::default());
        }
        field.parse().map_err(|_| {
            let what = format!("`{field}` in columns {} to {to} cannot be", from + 1);
            Problem::line(self.number, what)
        })
    }
}
