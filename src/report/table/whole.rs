//! A table that is there as a whole before it is written: the result of a verb, column by column.

use std::io::{self, Write};

/// A table of named columns, all of the same length.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::report) struct Table {
    columns: Vec<(String, Values)>,
}

/// Values of a column.
#[derive(Debug, Clone, PartialEq)]
enum Values {
    Numbers(Vec<Option<f64>>),
    Words(Vec<String>),
}

impl Table {
    /// Adds a column of numbers, some of which may be missing; the name ends with the unit.
    pub fn numbers<T: Into<Option<f64>>>(
        &mut self,
        name: impl Into<String>,
        values: impl IntoIterator<Item = T>,
    ) {
        let values = values.into_iter().map(Into::into).collect();
        self.columns.push((name.into(), Values::Numbers(values)));
    }

    /// Adds a column of words or whole numbers.
    pub fn words<T: ToString>(
        &mut self,
        name: impl Into<String>,
        values: impl IntoIterator<Item = T>,
    ) {
        let values = values.into_iter().map(|value| value.to_string());
        self.columns
            .push((name.into(), Values::Words(values.collect())));
    }

    /// Number of rows.
    fn rows(&self) -> usize {
        self.columns.first().map_or(0, |(_, values)| match values {
            Values::Numbers(values) => values.len(),
            Values::Words(values) => values.len(),
        })
    }

    /// Writes the table as CSV; what is missing is an empty cell.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn write_csv(&self, writer: impl Write) -> io::Result<()> {
        let mut csv = csv::Writer::from_writer(writer);
        csv.write_record(self.columns.iter().map(|(name, _)| name))?;
        for row in 0..self.rows() {
            csv.write_record(self.columns.iter().map(|(_, values)| match values {
                Values::Numbers(values) => cell(values[row]),
                Values::Words(values) => values[row].clone(),
            }))?;
        }
        csv.flush()
    }
}

/// A number in the shortest form that reads back to the same value.
pub(in crate::report) fn number(value: f64) -> String {
    format!("{value:?}")
}

/// A number, or an empty cell.
pub(in crate::report) fn cell(value: Option<f64>) -> String {
    value.map(number).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::Table;

    #[test]
    fn what_is_missing_is_an_empty_cell() {
        let mut table = Table::default();
        table.words("n", [1, 2]);
        table.numbers("x_m", [Some(0.1), None]);
        let mut csv = Vec::new();
        table.write_csv(&mut csv).expect("memory takes everything");
        assert_eq!(csv, b"n,x_m\n1,0.1\n2,\n");
    }
}
