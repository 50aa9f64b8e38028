//! A table that is there as a whole before it is written: the result of a verb, column by column.

use std::io;

use super::Column;

/// A table of named columns, all of the same length.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::report) struct Table {
    columns: Vec<(Column, Vec<f64>)>,
}

impl Table {
    /// Adds a column of numbers, some of which may be missing; the name ends with the unit.
    pub fn numbers<T: Into<Option<f64>>>(
        &mut self,
        name: impl Into<String>,
        values: impl IntoIterator<Item = T>,
    ) {
        self.add(Column::number(name.into()), values);
    }

    /// Adds a column of whole numbers, some of which may be missing.
    pub fn counts<T: Into<Option<f64>>>(
        &mut self,
        name: impl Into<String>,
        values: impl IntoIterator<Item = T>,
    ) {
        self.add(Column::count(name.into()), values);
    }

    /// Adds a column of words.
    pub fn words<T: ToString>(
        &mut self,
        name: impl Into<String>,
        values: impl IntoIterator<Item = T>,
    ) {
        let mut words: Vec<String> = Vec::new();
        let mut index = |word: String| {
            let known = words.iter().position(|known| *known == word);
            known.unwrap_or_else(|| {
                words.push(word);
                words.len() - 1
            })
        };
        let values = values
            .into_iter()
            .map(|value| index(value.to_string()) as f64);
        let values = values.collect();
        self.columns
            .push((Column::words(name.into(), words), values));
    }

    fn add<T: Into<Option<f64>>>(&mut self, column: Column, values: impl IntoIterator<Item = T>) {
        let values = values
            .into_iter()
            .map(|value| value.into().unwrap_or(f64::NAN));
        self.columns.push((column, values.collect()));
    }

    /// The columns.
    pub fn columns(&self) -> Vec<Column> {
        self.columns
            .iter()
            .map(|(column, _)| column.clone())
            .collect()
    }

    /// Gives the rows one by one; NaN where a number is missing.
    ///
    /// # Errors
    /// What `take` answers.
    pub fn rows(&self, take: &mut dyn FnMut(&[f64]) -> io::Result<()>) -> io::Result<()> {
        let rows = self.columns.first().map_or(0, |(_, values)| values.len());
        (0..rows).try_for_each(|row| {
            let row: Vec<f64> = self.columns.iter().map(|(_, values)| values[row]).collect();
            take(&row)
        })
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
    use super::super::CsvTable;
    use super::Table;

    #[test]
    fn what_is_missing_is_an_empty_cell_and_words_may_hold_commas() {
        let mut table = Table::default();
        table.counts("n", [1.0, 2.0]);
        table.numbers("x_m", [Some(0.1), None]);
        table.words("note", ["a, \"b\"", ""]);
        let mut csv = CsvTable::new(Vec::new(), &table.columns()).expect("memory takes everything");
        table
            .rows(&mut |row| csv.row(row))
            .expect("memory takes everything");
        let csv = csv.finish().expect("memory takes everything");
        assert_eq!(csv, b"n,x_m,note\n1,0.1,\"a, \"\"b\"\"\"\n2,,\n");
    }
}
