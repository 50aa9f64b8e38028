//! What a comparison found: of two results, their tables, columns and places.

use std::fmt;

use serde::Serialize;
use serde_json::{Value, json};

use super::rules::Allowance;
use super::{CompareError, LinesBy, Rules};
use crate::report::findings::versioned;
use crate::table::Column;

/// What the comparison of two results found; shown as a table by `Display`.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Comparison {
    /// Tables that both results have.
    pub tables: Vec<TableComparison>,
    /// Files that only one of the results has.
    pub differences: Vec<Difference>,
    /// Files that only one of the results has and that are not asked for.
    pub left_out: Vec<Difference>,
}

impl Comparison {
    /// The comparison of tables, and what only one of the results has: differences, or left out.
    ///
    /// A tolerance for a column that no table has is refused: it is a slip of the pen that would hide a difference.
    pub(super) fn new(
        tables: Vec<TableComparison>,
        partial: Vec<Difference>,
        rules: &Rules,
    ) -> Result<Self, CompareError> {
        let known = tables.iter().flat_map(|table| &table.known);
        let known: Vec<String> = known.map(Column::name).collect();
        for (name, _) in &rules.tolerances.columns {
            if !known.contains(name) {
                let name = name.clone();
                return Err(CompareError::UnknownColumn { name, known });
            }
        }
        let (left_out, differences) = partial.into_iter().partition(|_| rules.common);
        let found = Self {
            tables,
            differences,
            left_out,
        };
        // what has nothing in common would agree
        match found.agrees() && !found.tables.iter().any(TableComparison::has_numbers) {
            true => Err(CompareError::NothingCompared { columns: known }),
            false => Ok(found),
        }
    }

    /// Whether both results have the same tables and all their values agree.
    pub fn agrees(&self) -> bool {
        self.differences.is_empty() && self.tables.iter().all(TableComparison::agrees)
    }

    /// The comparison as JSON; a difference that is not finite is null.
    pub fn to_json(&self) -> Value {
        versioned(json!({
            "agrees": self.agrees(),
            "differences": self.differences,
            "left_out": self.left_out,
            "tables": self.tables.iter().map(TableComparison::to_json).collect::<Value>(),
        }))
    }
}

/// What keeps two results from being compared value by value, in words.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(transparent)]
#[non_exhaustive]
pub struct Difference {
    /// What it is.
    pub message: String,
    /// Whether it is a file, a column or samples that only one of them has.
    #[serde(skip)]
    pub only_in_one: bool,
}

impl Difference {
    pub(super) fn new(message: String) -> Self {
        Self {
            message,
            only_in_one: false,
        }
    }

    /// What only one of them has.
    pub(super) fn partial(message: String) -> Self {
        Self {
            message,
            only_in_one: true,
        }
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

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
    /// The columns of both tables.
    pub(super) known: Vec<Column>,
}

impl TableComparison {
    /// What only one table has is a difference, or left out.
    pub(super) fn new(
        name: String,
        columns: Vec<ColumnComparison>,
        known: Vec<Column>,
        mut differences: Vec<Difference>,
        rules: &Rules,
    ) -> Self {
        differences.sort_by_key(|difference| difference.only_in_one);
        let is_left_out = |difference: &Difference| rules.common && difference.only_in_one;
        let (left_out, differences) = differences.into_iter().partition(is_left_out);
        Self {
            name,
            columns,
            differences,
            left_out,
            known,
        }
    }

    /// Whether a column with numbers was compared that is more than the axis.
    fn has_numbers(&self) -> bool {
        let is_axis = |own: &&ColumnComparison| self.known.first() == Some(&own.column);
        let is_alone = self.known.len() == 1;
        let mut columns = self.columns.iter().filter(|own| is_alone || !is_axis(own));
        columns.any(|own| own.has_numbers)
    }

    /// Whether both tables have the same columns and rows, and all values agree.
    pub fn agrees(&self) -> bool {
        self.differences.is_empty() && self.columns.iter().all(ColumnComparison::agrees)
    }

    fn to_json(&self) -> Value {
        json!({
            "name": self.name,
            "agrees": self.agrees(),
            "differences": self.differences,
            "left_out": self.left_out,
            "columns": self.columns.iter().map(ColumnComparison::to_json).collect::<Value>(),
        })
    }
}

/// What the comparison of a column found.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ColumnComparison {
    /// Its column.
    pub column: Column,
    /// The worst places, the worst first; none where nothing was compared, as with phases of nothing.
    pub places: Vec<Worst>,
    /// Number of rows beyond what is allowed.
    pub failures: u64,
    /// The relative tolerance that, without an absolute one, would let the column agree; infinite where
    /// none would.
    pub needed: f64,
    /// Whether differences are in dB.
    pub decibels: bool,
    /// Whether a number was compared.
    has_numbers: bool,
    /// Most places that are kept.
    room: usize,
}

/// A place of a column, as a rule the one where its values are furthest beyond, or closest to, what is
/// allowed.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Worst {
    /// Row, from 1, the header not counted; of lines, their number.
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
    /// Of lines, where that of the second result is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub second_at: Option<f64>,
    /// Of lines that are matched by it, their name.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
}

impl Worst {
    fn excess(&self) -> f64 {
        self.difference - self.allowed
    }
}

impl ColumnComparison {
    /// Nothing compared so far.
    pub(super) fn new(column: &Column, rules: &Rules) -> Self {
        Self {
            column: column.clone(),
            places: Vec::new(),
            failures: 0,
            needed: 0.0,
            decibels: rules.lines.is_some_and(|lines| lines.decibels.is_some()),
            has_numbers: false,
            room: match rules.lines.map(|lines| lines.by) {
                Some(LinesBy::Name) => usize::MAX,
                _ => rules.worst.max(1),
            },
        }
    }

    /// Whether no row is beyond what is allowed.
    pub fn agrees(&self) -> bool {
        self.failures == 0
    }

    /// The worst place.
    pub fn worst(&self) -> Option<&Worst> {
        self.places.first()
    }

    /// Takes the values of a place, which may be so far apart.
    pub(super) fn take(&mut self, place: Worst, allowance: Allowance) {
        self.has_numbers |= !(place.first.is_nan() && place.second.is_nan());
        let allowed = allowance.total();
        let place = Worst { allowed, ..place };
        let beyond = place.difference - allowance.more;
        if beyond > 0.0 {
            self.needed = self.needed.max(beyond / allowance.scale);
        }
        if place.excess() > 0.0 {
            self.failures += 1;
        }
        let after = |known: &Worst| known.excess() >= place.excess();
        let index = self.places.partition_point(after);
        if index < self.room {
            self.places.truncate(self.room - 1);
            self.places.insert(index, place);
        }
    }

    fn to_json(&self) -> Value {
        json!({
            "name": self.column,
            "agrees": self.agrees(),
            "failures": self.failures,
            (if self.decibels { "decibels_needed" } else { "relative_needed" }): self.needed,
            "worst": self.worst(),
            "further": self.places.get(1..).unwrap_or_default(),
        })
    }
}
