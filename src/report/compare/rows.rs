//! Compares two tables row by row, reading each twice and keeping one row in memory.

use std::path::Path;

use super::rule::{Judgement, Place, Rule};
use super::table::Table;
use super::{CompareError, Difference, Tolerances};

/// The place where the values of a column are furthest beyond, or closest to, what is allowed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Worst {
    /// Row, from 1, the header not counted.
    pub row: u64,
    /// Value of the first table's first column there: time in s or frequency in Hz.
    pub at: f64,
    /// Value in the first table.
    pub first: f64,
    /// Value in the second table.
    pub second: f64,
    /// |first − second|, of phases the shorter way round; infinite where only one is a number.
    pub difference: f64,
    /// Difference allowed there.
    pub allowed: f64,
}

/// What the comparison of a column found.
#[derive(Debug, Clone, PartialEq)]
pub struct ColumnComparison {
    /// Name of the column.
    pub name: String,
    /// The worst place; `None` where nothing was compared, as with phases of nothing.
    pub worst: Option<Worst>,
    /// Number of rows beyond what is allowed.
    pub failures: u64,
}

impl ColumnComparison {
    /// Whether no row is beyond what is allowed.
    pub fn agrees(&self) -> bool {
        self.failures == 0
    }

    fn take(&mut self, worst: Worst) {
        let excess = |worst: &Worst| worst.difference - worst.allowed;
        if excess(&worst) > 0.0 {
            self.failures += 1;
        }
        if self
            .worst
            .is_none_or(|known| excess(&worst) > excess(&known))
        {
            self.worst = Some(worst);
        }
    }
}

/// What the comparison of two tables found.
#[derive(Debug, Clone, PartialEq)]
pub struct TableComparison {
    /// Name of the file in a run folder, or of the first file.
    pub name: String,
    /// Columns that both tables have, in the order of the first.
    pub columns: Vec<ColumnComparison>,
    /// What keeps the tables from being compared value by value.
    pub differences: Vec<Difference>,
    /// Names of the columns of both tables.
    pub(super) known: Vec<String>,
}

impl TableComparison {
    /// Whether both tables have the same columns and rows, and all values agree.
    pub fn agrees(&self) -> bool {
        self.differences.is_empty() && self.columns.iter().all(ColumnComparison::agrees)
    }
}

/// Compares two files; `name` is what the result calls them.
pub(super) fn compare_tables(
    name: String,
    first: &Path,
    second: &Path,
    tolerances: &Tolerances,
) -> Result<TableComparison, CompareError> {
    let mut tables = [Table::open(first)?, Table::open(second)?];
    let shared = Shared::of(&tables);
    let mut differences = shared.differences(&tables);
    let known = known_columns(&tables);
    let [left, right] = &mut tables;
    let (left_rows, left_scales) = scales(left)?;
    let (right_rows, right_scales) = scales(right)?;
    if left_rows != right_rows {
        differences.push(Difference::Rows {
            first: left_rows,
            second: right_rows,
        });
    }
    let scale = |place: Place| left_scales[place.first].max(right_scales[place.second]);
    let rules = shared.rules(scale, tolerances);
    for table in &mut tables {
        table.rewind()?;
    }
    let columns = compare_rows(&shared, &rules, &mut tables)?;
    let axis = columns.first().filter(|column| !column.agrees());
    if let Some(axis) = axis.filter(|axis| known.first() == Some(&axis.name)) {
        differences.push(Difference::Axis {
            name: axis.name.clone(),
        });
    }
    Ok(TableComparison {
        name,
        columns,
        differences,
        known,
    })
}

/// Columns that both tables have.
struct Shared(Vec<(String, Place)>);

impl Shared {
    fn of([first, second]: &[Table; 2]) -> Self {
        let names = first.columns().iter().enumerate();
        let places = names.filter_map(|(index, name)| {
            let other = second.columns().iter().position(|other| other == name)?;
            let place = Place {
                first: index,
                second: other,
            };
            Some((name.clone(), place))
        });
        Self(places.collect())
    }

    fn differences(&self, tables: &[Table; 2]) -> Vec<Difference> {
        let missing = |table: &Table| -> Vec<Difference> {
            let own = table.columns().iter();
            own.filter(|name| !self.0.iter().any(|(shared, _)| shared == *name))
                .map(|name| Difference::Column {
                    name: name.clone(),
                    only_in: table.path().to_owned(),
                })
                .collect()
        };
        tables.iter().flat_map(missing).collect()
    }

    fn rules(&self, scale: impl Fn(Place) -> f64, tolerances: &Tolerances) -> Vec<Rule> {
        let named = || self.0.iter().map(|(name, place)| (name.as_str(), *place));
        named()
            .map(|(name, place)| Rule::new(name, named(), &scale, place, tolerances))
            .collect()
    }
}

fn known_columns([first, second]: &[Table; 2]) -> Vec<String> {
    let mut known = first.columns().to_vec();
    let further = second.columns().iter();
    known.extend(
        further
            .filter(|name| !first.columns().contains(name))
            .cloned(),
    );
    known
}

/// Number of rows, and the largest finite magnitude of every column.
fn scales(table: &mut Table) -> Result<(u64, Vec<f64>), CompareError> {
    let mut scales = vec![0.0f64; table.columns().len()];
    let mut row = Vec::new();
    let mut rows = 0;
    while table.read(&mut row)? {
        rows += 1;
        for (scale, value) in scales.iter_mut().zip(&row) {
            if value.is_finite() {
                *scale = scale.max(value.abs());
            }
        }
    }
    if rows == 0 {
        return Err(CompareError::Empty {
            path: table.path().to_owned(),
        });
    }
    Ok((rows, scales))
}

fn compare_rows(
    shared: &Shared,
    rules: &[Rule],
    [left, right]: &mut [Table; 2],
) -> Result<Vec<ColumnComparison>, CompareError> {
    let names = shared.0.iter().map(|(name, _)| ColumnComparison {
        name: name.clone(),
        worst: None,
        failures: 0,
    });
    let mut columns: Vec<ColumnComparison> = names.collect();
    let (mut first, mut second) = (Vec::new(), Vec::new());
    let mut row = 0;
    while left.read(&mut first)? && right.read(&mut second)? {
        row += 1;
        for ((column, (_, place)), rule) in columns.iter_mut().zip(&shared.0).zip(rules) {
            let judgement = rule.judge(*place, &first, &second);
            if let Some(Judgement {
                difference,
                allowed,
            }) = judgement
            {
                column.take(Worst {
                    row,
                    at: first[0],
                    first: first[place.first],
                    second: second[place.second],
                    difference,
                    allowed,
                });
            }
        }
    }
    Ok(columns)
}
