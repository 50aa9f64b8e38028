//! Tables of numbers in columns that know what they measure, and in which unit.
//!
//! A name with its unit, such as `x_velocity_m_s`, is made of a [`Column`] and read back as one, nowhere else. A row is a
//! slice of numbers; the kind of a column says what a number stands for.

mod column;
mod table_of;

use std::borrow::Cow;

use serde_json::{Map, Value};

pub use column::{Column, ColumnKind, SCALINGS};
pub use table_of::TableOf;

/// A column of numbers of things: its quantity, its unit, and its value of one, NaN where there is none.
pub type Named<T> = (&'static str, &'static str, fn(&T) -> f64);

/// A table of named columns, all of the same length.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Table<'a> {
    columns: Vec<(Column, Cow<'a, [f64]>)>,
    /// What people read above it, where that is not the name of its file.
    pub heading: Option<&'static str>,
}

impl<'a> Table<'a> {
    /// A table of rows, each with a number a column.
    pub fn of_rows(
        columns: Vec<Column>,
        rows: impl IntoIterator<Item = impl AsRef<[f64]>>,
    ) -> Self {
        let mut values = vec![Vec::new(); columns.len()];
        for row in rows {
            for (column, value) in values.iter_mut().zip(row.as_ref()) {
                column.push(*value);
            }
        }
        let values = values.into_iter().map(Cow::Owned);
        let columns = columns.into_iter().zip(values).collect();
        Self {
            columns,
            heading: None,
        }
    }

    /// The columns with their values, of which one that is missing is NaN.
    pub fn iter(&self) -> impl Iterator<Item = (&Column, &[f64])> {
        let columns = self.columns.iter();
        columns.map(|(column, values)| (column, &values[..]))
    }

    /// A column by its quantity, with its values.
    pub fn column(&self, quantity: &str) -> Option<(&Column, &[f64])> {
        self.iter().find(|(column, _)| column.quantity == quantity)
    }

    /// Adds a column whose numbers stand elsewhere.
    pub fn borrowed(&mut self, column: Column, values: &'a [f64]) {
        self.columns.push((column, Cow::Borrowed(values)));
    }

    /// The table with numbers of its own.
    pub fn into_owned(self) -> Table<'static> {
        let owned =
            |(column, values): (Column, Cow<'_, [f64]>)| (column, Cow::Owned(values.into_owned()));
        Table {
            columns: self.columns.into_iter().map(owned).collect(),
            heading: self.heading,
        }
    }

    /// Adds a column of any kind, some of whose values may be missing.
    pub fn add<T: Into<Option<f64>>>(
        &mut self,
        column: Column,
        values: impl IntoIterator<Item = T>,
    ) {
        let values = values
            .into_iter()
            .map(|value| value.into().unwrap_or(f64::NAN));
        self.columns.push((column, values.collect()));
    }

    /// The rows as JSON, each an object with a key a column.
    pub fn records(&self) -> Value {
        let columns = &self.columns;
        let record = |row: usize| -> Value {
            let entry = |(column, values): &(Column, Cow<'_, [f64]>)| {
                (column.name(), column.kind.json(values[row]))
            };
            columns.iter().map(entry).collect::<Map<_, _>>().into()
        };
        let length = columns.first().map_or(0, |(_, values)| values.len());
        (0..length).map(record).collect()
    }

    /// The columns.
    pub fn columns(&self) -> Vec<Column> {
        self.columns
            .iter()
            .map(|(column, _)| column.clone())
            .collect()
    }

    /// The rows; NaN where a number is missing.
    pub fn rows(&self) -> impl Iterator<Item = Vec<f64>> {
        let rows = self.columns.first().map_or(0, |(_, values)| values.len());
        let row = |row| {
            self.columns
                .iter()
                .map(move |(_, values)| values[row])
                .collect()
        };
        (0..rows).map(row)
    }
}
