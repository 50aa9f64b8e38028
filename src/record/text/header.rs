//! The lines in front of a table: names and units of its columns.

use super::dialect::{Rows, is_passed};
use crate::record::unit::{is_unit, per_second, split};
use crate::table::Column;

/// Name of the first column of this program's traces.
const TRACE_TIME: &str = "t_s";
/// First words of names of columns of times.
const TIMES: [&str; 8] = [
    "t",
    "time",
    "times",
    "timestamp",
    "zeit",
    "temps",
    "tiempo",
    "seconds",
];

/// What a header says of a column.
pub struct Heading {
    /// Empty where there is none.
    pub name: String,
    pub quantity: Option<String>,
    pub unit: Option<String>,
}

impl Heading {
    /// Of a column of times in s.
    pub fn of_times() -> Self {
        Self {
            name: TIMES[1].to_owned(),
            quantity: None,
            unit: Some("s".to_owned()),
        }
    }

    /// What the name of a column says that is next to the times of a trace of this program; that of another one has other signs
    /// than letters, digits and `_`.
    pub fn of_trace(name: &str) -> Self {
        let is_of_name = |sign: char| sign.is_alphanumeric() || sign == '_';
        if !name.chars().all(is_of_name) {
            return Self::from_name(name, "");
        }
        let column = match with_rate(name) {
            Some((quantity, unit)) => Column::number(quantity, unit),
            None => Column::from_name(name),
        };
        Self {
            name: name.to_owned(),
            quantity: Some(column.quantity.into_owned()),
            unit: (!column.unit.is_empty()).then(|| column.unit.into_owned()),
        }
    }

    /// What name and unit say, of which the name may hold the unit.
    fn from_name(name: &str, unit: &str) -> Self {
        let (name, own) = split(name);
        let unit = unit.trim_matches(['[', ']', '(', ')', ' ', '-']);
        let unit = own.or((!unit.is_empty()).then_some(unit));
        let mut heading = Self {
            name: name.to_owned(),
            quantity: None,
            unit: unit.map(str::to_owned),
        };
        if heading.unit.is_none() && heading.is_time() {
            // `time_ms`
            let last = name.rsplit('_').next();
            let unit = last.filter(|last| per_second(last).is_some());
            heading.unit = unit.map(str::to_owned);
        }
        heading
    }

    /// Whether it names times.
    pub fn is_time(&self) -> bool {
        let name = self.name.to_lowercase();
        let first = name.split(|sign: char| !sign.is_alphabetic()).next();
        first.is_some_and(|first| TIMES.contains(&first))
    }
}

/// Name and unit of a column that ends with a unit a second, which no trace of this program has: `v_mm_s`.
fn with_rate(name: &str) -> Option<(String, String)> {
    let (rest, per) = name.rsplit_once('_')?;
    let (quantity, unit) = rest.rsplit_once('_')?;
    let is_rate = ["s", "s2"].contains(&per) && is_unit(unit) && !quantity.is_empty();
    let known = Column::from_name(name).quantity;
    (is_rate && quantity.len() < known.len())
        .then(|| (quantity.to_owned(), format!("{unit}/{per}")))
}

/// What the lines in front of the rows say of each column. Names stand in the last line with as many cells as there are
/// columns, units in the same cells or in a line of their own below; a comment right above the rows may hold either.
pub(super) fn read(lines: &[&[u8]], rows: &Rows) -> Vec<Heading> {
    let above = lines[..rows.start].iter().rev().enumerate();
    let mut above = above.filter_map(|(distance, line)| cells(line, rows, distance));
    let empty = || vec![String::new(); rows.columns];
    let last = above.next().unwrap_or_else(empty);
    let mut filled = last
        .iter()
        .filter(|cell| !["", "-"].contains(&cell.as_str()))
        .peekable();
    let is_units = filled.peek().is_some() && filled.all(|cell| is_unit(cell));
    let (names, units) = match is_units.then(|| above.next()).flatten() {
        Some(names) => (names, last),
        None => (last, empty()),
    };
    of_columns(&names, &units)
}

/// What names and units of all columns say; of a trace of this program the names alone.
pub(super) fn of_columns(names: &[String], units: &[String]) -> Vec<Heading> {
    if names.first().is_some_and(|name| name == TRACE_TIME) {
        return names.iter().map(|name| Heading::of_trace(name)).collect();
    }
    let headings = names.iter().zip(units);
    headings
        .map(|(name, unit)| Heading::from_name(name, unit))
        .collect()
}

/// The cells of a line so far above the rows, if there is one a column and none is a number; one at the end may be more or
/// less, as of comments that no row has.
fn cells(line: &[u8], rows: &Rows, distance: usize) -> Option<Vec<String>> {
    let line = line.trim_ascii_start();
    let text = match is_passed(line) {
        // one column has no name that could be told from other comments
        true if distance > 1 || rows.columns == 1 => return None,
        true => line.get(1..)?.trim_ascii(),
        false => line,
    };
    let mut cells = rows.dialect.header_cells(text);
    let more = usize::from(distance == 0);
    if !(rows.columns - 1..=rows.columns + more).contains(&cells.len()) {
        return None;
    }
    cells.resize(rows.columns, String::new());
    let is_number = |cell: &String| {
        rows.dialect
            .number(cell.as_bytes())
            .is_some_and(f64::is_finite)
    };
    (!cells.iter().any(is_number)).then_some(cells)
}

/// Numbers that lines in front of the rows give by name: `Sample rate: 25600 Hz`.
pub(super) fn numbers(lines: &[&[u8]], rows: &Rows) -> Vec<(String, f64)> {
    let named = |line: &&[u8]| {
        let text = rows.dialect.header_cells(line).join("\t");
        let text = text.trim_matches(['#', '%', '\t', ' ']);
        let (name, value) = text
            .split_once([':', '='])
            .or_else(|| text.split_once('\t'))?;
        let value = value.split([' ', '\t']).find(|word| !word.is_empty())?;
        let value = rows.dialect.number(value.as_bytes())?;
        Some((name.trim().replace('\t', " "), value))
    };
    lines[..rows.start].iter().filter_map(named).collect()
}
