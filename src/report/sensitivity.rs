//! How the numbers of an answer change with quantities of its scenario: a table, a tornado, a few lines.

use super::Findings;
use super::figure::{Axis, Cell, Figure, Name, Panel, distinct};
use super::terminal::digits;
use super::variable::{key_in_words, shown};
use crate::fit::{Number, Slope};
use crate::study::Variable;
use crate::table::Table;

/// Numbers that text and tornado show, the first that change.
const SHOWN: usize = 20;
const DRAWN: usize = 6;
/// A number below this part of the largest of its unit is no more than what round-off or higher orders leave.
const SMALL: f64 = 1e-6;
/// A change below this part of a per cent per per cent is none, and one whose error is more than this part of it is not known.
const LEAST: f64 = 1e-3;
const UNSURE: f64 = 0.1;

/// Numbers of an answer, and how fast each changes with each of some quantities.
#[derive(Debug, Clone)]
pub struct SensitivityTable {
    /// The quantities.
    pub variables: Vec<Variable>,
    /// Their values, SI units.
    pub values: Vec<f64>,
    /// The numbers.
    pub numbers: Vec<Number>,
    /// The slopes: a row a quantity, an entry a number.
    pub slopes: Vec<Vec<Slope>>,
}

/// How a number changes with a quantity.
struct Row<'a> {
    number: &'a Number,
    variable: &'a Variable,
    value: f64,
    slope: Slope,
}

impl Row<'_> {
    /// Per cent of the number for a per cent of the quantity.
    fn relative(&self) -> f64 {
        self.slope.value * self.factor()
    }

    fn relative_error(&self) -> f64 {
        (self.slope.error * self.factor()).abs()
    }

    fn factor(&self) -> f64 {
        self.value / self.number.value
    }

    /// Whether it changes at all, and that is known.
    fn counts(&self) -> bool {
        self.relative().abs() >= LEAST && self.relative_error() <= UNSURE * self.relative().abs()
    }
}

impl SensitivityTable {
    fn row(&self, key: usize, number: usize) -> Row<'_> {
        Row {
            number: &self.numbers[number],
            variable: &self.variables[key],
            value: self.values[key],
            slope: self.slopes[key][number],
        }
    }

    /// A row a number that changes and a quantity; per cent where the change is known.
    pub(super) fn table(&self) -> Table<'static> {
        let numbers = self.changing(usize::MAX).into_iter();
        let rows = numbers.flat_map(|number| {
            let keys = 0..self.variables.len();
            keys.map(move |key| self.row(key, number))
        });
        let rows: Vec<_> = rows.collect();
        Table::from_items(&rows)
            .word("number", |row| &row.number.name)
            .number("value", "", |row| row.number.value)
            .word("unit", |row| &row.number.unit)
            .word("key", |row| &row.variable.key)
            .number("key_value", "", |row| row.value)
            .word("key_unit", |row| &row.variable.unit)
            .number("derivative", "", |row| row.slope.value)
            .number("derivative_error", "", |row| row.slope.error)
            .number("percent_per_percent", "", |row| {
                row.counts().then(|| row.relative())
            })
            .number("percent_per_percent_error", "", |row| {
                row.counts().then(|| row.relative_error())
            })
            .end()
    }

    /// The first numbers that change with a quantity and are not small compared with others of their unit.
    fn changing(&self, count: usize) -> Vec<usize> {
        let changes = |number: &usize| {
            let own = &self.numbers[*number];
            let alike = self.numbers.iter().filter(|other| other.unit == own.unit);
            let largest = alike.map(|other| other.value.abs()).fold(0.0, f64::max);
            let mut keys = 0..self.variables.len();
            own.value.abs() >= SMALL * largest && keys.any(|key| self.row(key, *number).counts())
        };
        (0..self.numbers.len())
            .filter(changes)
            .take(count)
            .collect()
    }

    /// A panel a number, a bar a quantity, the longest above.
    fn figure(&self, name: &str, title: &str) -> Figure {
        let panel = |number: usize| {
            let mut rows: Vec<_> = (0..self.variables.len())
                .map(|key| self.row(key, number))
                .collect();
            rows.sort_by(|a, b| b.relative().abs().total_cmp(&a.relative().abs()));
            let ends = rows.iter().map(Row::relative).chain([0.0]);
            let across = Axis::spanning("per cent per per cent", ends);
            let bars = rows.iter().enumerate().map(|(place, row)| Cell {
                corners: [
                    (0.0, place as f64 + 0.2),
                    (row.relative(), place as f64 + 0.8),
                ],
                colour: distinct(usize::from(row.relative() < 0.0)),
                value: row.relative(),
                run: None,
            });
            Panel {
                title: self.numbers[number].name.clone(),
                cells: bars.collect(),
                ..Panel::new(
                    across,
                    Axis::names(rows.iter().map(|row| key_in_words(row.variable))),
                    60 + 34 * rows.len() as u32,
                )
            }
        };
        let panels = self.changing(DRAWN).into_iter().map(panel).collect();
        Figure::new(name, title, 2, panels)
            .with_names(Name::each(["rises with it", "falls with it"]))
    }
}

impl Findings {
    /// Adds how the numbers of the answer change, under names that begin with that of the verb.
    pub(crate) fn add_sensitivity(&mut self, found: &SensitivityTable) {
        let [table, name] = match self.set.seal {
            "bearing.json" => ["bearing_sensitivity", "bearing"],
            "campbell.json" => ["campbell_sensitivity", "campbell"],
            "summary.json" => ["run_sensitivity", "run"],
            _ => ["steady_sensitivity", "steady"],
        };
        let rows = found.table();
        self.document["sensitivity"] = rows.records();
        self.tables.push((table, rows));
        let title = self.document["title"]
            .as_str()
            .unwrap_or_default()
            .to_owned();
        let shown_numbers = found.changing(SHOWN);
        if !shown_numbers.is_empty() {
            let figure = found.figure(&format!("{name}_tornado"), &title);
            // what was asked for comes first
            self.figures.insert(0, figure);
        }
        let at = found.variables.iter().zip(&found.values);
        let at =
            at.map(|(variable, value)| format!("{} = {}", variable.key, shown(variable, *value)));
        self.text.each("sensitivity", at);
        if shown_numbers.is_empty() {
            self.text
                .more("no number changes with it, or none by more than the error of the change");
            return;
        }
        let keys = found
            .variables
            .iter()
            .map(|variable| format!("% per % of\n{}", variable.key));
        let heads: Vec<String> = ["number", "value", "unit"]
            .map(str::to_owned)
            .into_iter()
            .chain(keys)
            .collect();
        let rows = shown_numbers.into_iter().map(|number| {
            let own = &found.numbers[number];
            let head = [own.name.clone(), digits(own.value), own.unit.clone()];
            let keys = (0..found.variables.len()).map(|key| {
                let row = found.row(key, number);
                match row.counts() {
                    true => format!("{:.4}", row.relative()),
                    false => "–".to_owned(),
                }
            });
            head.into_iter().chain(keys).collect()
        });
        self.text.table(heads.iter().map(String::as_str), rows);
    }
}
