//! Compares two tables row by row, reading each twice and keeping one row in memory.

use super::rule::{Place, Rule, Scales};
use super::table::Table;
use super::{ColumnComparison, CompareError, Difference, Rules, Tolerances};

/// What the comparison of two tables found.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct TableComparison {
    /// Name of the file in a run folder, or of the first file.
    pub name: String,
    /// Columns that both tables have, in the order of the first.
    pub columns: Vec<ColumnComparison>,
    /// What keeps the tables from being compared value by value.
    pub differences: Vec<Difference>,
    /// What only one of them has and is not asked for.
    pub left_out: Vec<Difference>,
    /// Names of the columns of both tables.
    pub(super) known: Vec<String>,
}

impl TableComparison {
    /// Whether both tables have the same columns and rows, and all values agree.
    pub fn agrees(&self) -> bool {
        self.differences.is_empty() && self.columns.iter().all(ColumnComparison::agrees)
    }
}

/// Compares two tables row by row; `name` is what the result calls them.
pub(super) fn compare_rows(
    name: String,
    mut tables: [Table; 2],
    rules: &Rules,
) -> Result<TableComparison, CompareError> {
    let shared = Shared::of(&tables);
    let known = known_columns(&tables);
    let [left, right] = &mut tables;
    let extents = [extent(left)?, extent(right)?];
    let steps = steps(&known, &extents);
    let mut differences = Vec::new();
    let mut partial = shared.only_in_one(&tables);
    match steps {
        [1, 1] if extents[0].rows != extents[1].rows => differences.push(Difference::Rows {
            first: extents[0].rows,
            second: extents[1].rows,
        }),
        [1, 1] => {}
        [first, second] => partial.push(Difference::Thinned {
            thinned: tables[usize::from(first > 1)].path().to_owned(),
            every: first.max(second),
        }),
    }
    let largest =
        |place: Place| extents[0].scales[place.first].max(extents[1].scales[place.second]);
    let rate = match known.first() {
        Some(axis) if axis == "t_s" => extents[0].rate().max(extents[1].rate()),
        _ => 0.0,
    };
    let columns = shared.rules(
        &Scales::of(shared.named(), largest, rate),
        &rules.tolerances,
    );
    for table in &mut tables {
        table.rewind()?;
    }
    let columns = judge_rows(&shared, &columns, &mut tables, steps, rules.worst)?;
    let axis = columns.first().filter(|column| !column.agrees());
    if let Some(axis) = axis.filter(|axis| known.first() == Some(&axis.name)) {
        differences.push(Difference::Axis {
            name: axis.name.clone(),
        });
    }
    Ok(TableComparison::new(
        name,
        columns,
        known,
        differences,
        partial,
        rules,
    ))
}

impl TableComparison {
    /// What only one table has is a difference, or left out.
    pub(super) fn new(
        name: String,
        columns: Vec<ColumnComparison>,
        known: Vec<String>,
        mut differences: Vec<Difference>,
        mut partial: Vec<Difference>,
        rules: &Rules,
    ) -> Self {
        if !rules.common {
            differences.append(&mut partial);
        }
        Self {
            name,
            columns,
            differences,
            left_out: partial,
            known,
        }
    }
}

/// How many rows of each table stand for one row that is compared: more than one of a trace where the
/// other is one of every so many of its samples.
fn steps(known: &[String], [first, second]: &[Extent; 2]) -> [u64; 2] {
    if known.first().is_none_or(|axis| axis != "t_s") {
        return [1, 1];
    }
    [first.thinned_to(second), second.thinned_to(first)]
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

    fn only_in_one(&self, tables: &[Table; 2]) -> Vec<Difference> {
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

    fn named(&self) -> impl Iterator<Item = (&str, Place)> {
        self.0.iter().map(|(name, place)| (name.as_str(), *place))
    }

    fn rules(&self, scales: &Scales<impl Fn(Place) -> f64>, tolerances: &Tolerances) -> Vec<Rule> {
        self.named()
            .map(|(name, place)| Rule::new(name, self.named(), scales, place, tolerances))
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

/// What a table holds, on the whole.
struct Extent {
    rows: u64,
    /// Largest finite magnitude of every column.
    scales: Vec<f64>,
    /// First column of the first two rows.
    start: [f64; 2],
}

impl Extent {
    /// Rows for one of the first column; zero of a single one.
    fn rate(&self) -> f64 {
        let step = self.start[1] - self.start[0];
        if step > 0.0 { step.recip() } else { 0.0 }
    }

    /// N where `other` can hold the first of every N rows of this, one otherwise.
    fn thinned_to(&self, other: &Self) -> u64 {
        let step = |extent: &Self| extent.start[1] - extent.start[0];
        let ratio = (step(other) / step(self)).round();
        if !(ratio > 1.0 && ratio < self.rows as f64) {
            return 1;
        }
        match ratio as u64 {
            every if self.rows.div_ceil(every) == other.rows => every,
            _ => 1,
        }
    }
}

fn extent(table: &mut Table) -> Result<Extent, CompareError> {
    let mut extent = Extent {
        rows: 0,
        scales: vec![0.0; table.columns().len()],
        start: [0.0; 2],
    };
    let mut row = Vec::new();
    while table.read(&mut row)? {
        if let Some(start) = extent.start.get_mut(extent.rows as usize) {
            *start = row[0];
        }
        extent.rows += 1;
        for (scale, value) in extent.scales.iter_mut().zip(&row) {
            if value.is_finite() {
                *scale = scale.max(value.abs());
            }
        }
    }
    if extent.rows == 0 {
        return Err(CompareError::Empty {
            path: table.path().to_owned(),
        });
    }
    Ok(extent)
}

fn judge_rows(
    shared: &Shared,
    rules: &[Rule],
    tables: &mut [Table; 2],
    steps: [u64; 2],
    room: usize,
) -> Result<Vec<ColumnComparison>, CompareError> {
    let names = shared.0.iter().map(|(name, _)| name);
    let mut columns: Vec<_> = names
        .map(|name| ColumnComparison::new(name, room))
        .collect();
    let mut row = 0;
    each_pair(tables, steps, |first, second| {
        row += 1;
        for ((column, (_, place)), rule) in columns.iter_mut().zip(&shared.0).zip(rules) {
            if let Some(judgement) = rule.judge(*place, first, second) {
                let values = [first[place.first], second[place.second]];
                column.take(row, first[0], values, judgement);
            }
        }
    })?;
    Ok(columns)
}

/// Gives the rows that stand for each other.
fn each_pair(
    [left, right]: &mut [Table; 2],
    [left_step, right_step]: [u64; 2],
    mut take: impl FnMut(&[f64], &[f64]),
) -> Result<(), CompareError> {
    let (mut first, mut second, mut unused) = (Vec::new(), Vec::new(), Vec::new());
    while left.read(&mut first)? && right.read(&mut second)? {
        take(&first, &second);
        for (table, step) in [(&mut *left, left_step), (&mut *right, right_step)] {
            for _ in 1..step {
                table.read(&mut unused)?;
            }
        }
    }
    Ok(())
}
