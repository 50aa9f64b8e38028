//! A table made of rows, column by column.

use std::borrow::Cow;

use super::{Column, Named, Table};

/// A table of rows that are made into columns, one after the other.
#[derive(Debug)]
pub struct TableOf<'r, R> {
    rows: &'r [R],
    table: Table<'static>,
}

impl<'r, R> TableOf<'r, R> {
    /// Adds a column of any kind but words, some of whose values may be missing.
    #[must_use]
    pub fn column<V: Into<Option<f64>>>(
        mut self,
        column: Column,
        value: impl Fn(&'r R) -> V,
    ) -> Self {
        self.table.add(column, self.rows.iter().map(value));
        self
    }

    /// Adds a column of numbers, some of which may be missing.
    #[must_use]
    pub fn number<V: Into<Option<f64>>>(
        self,
        quantity: impl Into<Cow<'static, str>>,
        unit: &'static str,
        value: impl Fn(&'r R) -> V,
    ) -> Self {
        self.column(Column::number(quantity, unit), value)
    }

    /// Adds a column of whole numbers, some of which may be missing.
    #[must_use]
    pub fn count<V: Into<Option<f64>>>(
        self,
        quantity: impl Into<Cow<'static, str>>,
        value: impl Fn(&'r R) -> V,
    ) -> Self {
        self.column(Column::count(quantity), value)
    }

    /// Adds a column of words.
    #[must_use]
    pub fn word<W: ToString>(
        self,
        quantity: impl Into<Cow<'static, str>>,
        word: impl Fn(&'r R) -> W,
    ) -> Self {
        let mut words: Vec<String> = Vec::new();
        let indices = self.rows.iter().map(|row| {
            let word = word(row).to_string();
            let known = words.iter().position(|known| *known == word);
            let index = known.unwrap_or(words.len());
            if known.is_none() {
                words.push(word);
            }
            index as f64
        });
        let indices: Vec<f64> = indices.collect();
        let Self { rows, mut table } = self;
        table.add(Column::words(quantity, words), indices);
        Self { rows, table }
    }

    /// Adds columns of numbers of a thing, whose quantities begin with `before`; a row without it has none of them.
    #[must_use]
    pub fn named<T: 'r>(
        self,
        before: &str,
        columns: &[Named<T>],
        thing: impl Fn(&'r R) -> Option<&'r T>,
    ) -> Self {
        columns.iter().fold(self, |table, (quantity, unit, value)| {
            table.number(format!("{before}{quantity}"), unit, |row| {
                thing(row).map(value)
            })
        })
    }

    /// Puts a heading above it that is not the name of its file.
    #[must_use]
    pub fn headed(mut self, heading: &'static str) -> Self {
        self.table.heading = Some(heading);
        self
    }

    /// The table.
    pub fn end(self) -> Table<'static> {
        self.table
    }
}

impl Table<'static> {
    /// Begins a table of rows.
    pub fn from_items<R>(rows: &[R]) -> TableOf<'_, R> {
        TableOf {
            rows,
            table: Self::default(),
        }
    }
}
