//! A comparison for people.

use std::fmt;

use super::{ColumnComparison, Comparison, TableComparison, Worst};
use crate::numerics::digits::to_digits;
use crate::report::terminal::Lines;
use crate::table::Column;

impl fmt::Display for Comparison {
    /// A table of the worst places, what keeps the results from being compared, the verdict and, where
    /// they differ, what to do.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut lines = Lines::default();
        self.tell_places(&mut lines);
        write!(f, "{}{}", lines.text(false), self.verdict())
    }
}

impl Comparison {
    /// Whether the results agree and, where they do not, what to do.
    fn verdict(&self) -> String {
        if self.agrees() {
            return "equal within tolerance".to_owned();
        }
        let mut text = "different".to_owned();
        text.extend(self.furthest().map(|(table, column)| advice(table, column)));
        if self.is_partial() {
            text += "\nwhat only one of them has is left out with --common";
        }
        text
    }

    /// Tells what [`Display`](fmt::Display) does, the verdict first, as a page shows it.
    pub(super) fn tell(&self, lines: &mut Lines) {
        lines.line("result", self.verdict());
        self.tell_places(lines);
    }

    /// The worst places of every table, and what differs or is left out besides.
    fn tell_places(&self, lines: &mut Lines) {
        for table in &self.tables {
            lines.put(&table.name);
            if !table.columns.is_empty() {
                let (header, rows) = worst_places(table);
                lines.table(header.iter().map(String::as_str), rows);
            }
            lines.each("differs", &table.differences);
            lines.each("left out", &table.left_out);
        }
        lines.each("differs", &self.differences);
        lines.each("left out", &self.left_out);
    }

    /// Whether one of the results has files, columns or samples that the other has not.
    fn is_partial(&self) -> bool {
        let of_tables = self.tables.iter().flat_map(|table| &table.differences);
        let mut all = self.differences.iter().chain(of_tables);
        all.any(|difference| difference.only_in_one)
    }

    /// The column that is furthest from agreeing.
    fn furthest(&self) -> Option<(&TableComparison, &ColumnComparison)> {
        let tables = self.tables.iter();
        tables
            .flat_map(|table| table.columns.iter().map(move |column| (table, column)))
            .filter(|(_, column)| !column.agrees())
            .max_by(|a, b| a.1.needed.total_cmp(&b.1.needed))
    }
}

/// Where to look, and what would let the results agree.
fn advice(table: &TableComparison, column: &ColumnComparison) -> String {
    let Some(worst) = column.worst() else {
        return String::new();
    };
    let (name, at) = (column.column.name(), short(worst.at));
    let place = format!(": most of all {name}, at {} = {at}", axis(table));
    let needed = rounded_up(column.needed);
    if column.decibels {
        return format!(
            "{place}\nlook there first; if that is meant, --decibels {needed} allows it"
        );
    }
    if !needed.is_finite() {
        return format!("{place}, where no tolerance would let it agree");
    }
    format!(
        "{place}\nlook there first; if that is meant, a relative tolerance of {needed:e} allows it:\n\
         --column {name}={needed:e}"
    )
}

/// A positive number rounded up to two digits.
fn rounded_up(number: f64) -> f64 {
    if !(number > 0.0 && number.is_finite()) {
        return number;
    }
    let rounded = to_digits(number, 2);
    if rounded >= number {
        return rounded;
    }
    to_digits(rounded + 0.1 * 10f64.powf(number.log10().floor()), 2)
}

/// The worst places of every column, with the heads of their table.
fn worst_places(found: &TableComparison) -> (Vec<String>, Vec<Vec<String>>) {
    let axis = axis(found);
    let places = || found.columns.iter().flat_map(|column| &column.places);
    let has_names = places().any(|place| place.name.is_some());
    let is_of_lines = places().any(|place| place.second_at.is_some());
    let apart = match found.columns.iter().any(|column| column.decibels) {
        true => "dB",
        false => "|a−b|",
    };
    let also = format!("{axis} of b");
    let header = [
        "column",
        "line",
        apart,
        "allowed",
        &axis,
        &also,
        "a",
        "b",
        "differs in",
    ];
    let is_shown = |cell: &usize| match cell {
        1 => has_names,
        5 => is_of_lines,
        _ => true,
    };
    let shown = |row: Vec<String>| {
        let cells = row.into_iter().enumerate();
        cells
            .filter(|(cell, _)| is_shown(cell))
            .map(|(_, text)| text)
            .collect::<Vec<_>>()
    };
    let header = shown(header.map(str::to_owned).to_vec());
    let rows = found.columns.iter().flat_map(|column| {
        let places = column.places.iter().enumerate();
        let mut rows: Vec<_> = places
            .map(|(index, worst)| shown(worst_place(column, worst, index == 0)))
            .collect();
        if rows.is_empty() {
            let mut row = vec![String::new(); 9];
            row[0] = column.column.name();
            row[8] = "not significant".to_owned();
            rows.push(shown(row));
        }
        rows
    });
    (header, rows.collect())
}

fn axis(table: &TableComparison) -> String {
    let first = table.known.first();
    first.map_or_else(|| "row".to_owned(), Column::name)
}

/// The row of a place; the first of a column names it.
fn worst_place(column: &ColumnComparison, worst: &Worst, first: bool) -> Vec<String> {
    let verdict = match column.failures {
        0 => "nowhere".to_owned(),
        1 => "1 row".to_owned(),
        rows => format!("{rows} rows"),
    };
    let apart = |difference: f64| match column.decibels {
        true => format!("{difference:.1}"),
        false => format!("{difference:.1e}"),
    };
    let only_first = |text: String| if first { text } else { String::new() };
    vec![
        only_first(column.column.name()),
        worst.name.clone().unwrap_or_default(),
        apart(worst.difference),
        apart(worst.allowed),
        short(worst.at),
        worst.second_at.map_or_else(String::new, short),
        short(worst.first),
        short(worst.second),
        only_first(verdict),
    ]
}

/// A number as it is where that is short, otherwise six digits of it.
pub(super) fn short(number: f64) -> String {
    let size = number.abs();
    let ordinary = size == 0.0 || (1e-3..1e6).contains(&size);
    let exact = if ordinary {
        format!("{number}")
    } else {
        format!("{number:e}")
    };
    if exact.len() <= 8 {
        return exact;
    }
    if !ordinary {
        return format!("{number:.5e}");
    }
    let decimals = (5.0 - size.log10().floor()).clamp(0.0, 8.0) as usize;
    format!("{number:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::rounded_up;

    #[test]
    fn numbers_are_short_and_as_exact_as_that_allows() {
        let shown = [
            0.0,
            -0.25,
            159.15494309189535,
            1e-6,
            1.00123456e-6,
            1e5 / 3.0,
            1e300 / 3.0,
        ];
        let shown = shown.map(super::short);
        assert_eq!(shown[..4], ["0", "-0.25", "159.155", "1e-6"]);
        assert_eq!(shown[4..], ["1.00123e-6", "33333.3", "3.33333e299"]);
    }

    #[test]
    fn what_is_advised_is_enough_and_hardly_more() {
        for number in [1.0, 0.33333, 9.99e-7, 1.01e3, 1e-300, 5.04e-1] {
            let rounded = rounded_up(number);
            assert!(
                (number..=1.1 * number).contains(&rounded),
                "{number:e} {rounded:e}"
            );
        }
    }
}
