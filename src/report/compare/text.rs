//! A comparison for people and as JSON.

use std::fmt;
use std::path::PathBuf;

use comfy_table::{CellAlignment, Table, presets};
use serde_json::{Value, json};

use super::{ColumnComparison, Comparison, TableComparison, Worst};

/// What keeps two results from being compared value by value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Difference {
    /// Only one of two run folders has a file.
    File {
        /// The file that exists.
        only: PathBuf,
    },
    /// Only one of two tables has a column.
    Column {
        /// Its name.
        name: String,
        /// The table that has it.
        only_in: PathBuf,
    },
    /// The tables have different numbers of rows; the common ones are compared.
    Rows {
        /// Rows of the first table.
        first: u64,
        /// Rows of the second table.
        second: u64,
    },
    /// The times or frequencies differ, so that equal rows do not stand for equal places.
    Axis {
        /// Name of the first column.
        name: String,
    },
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File { only } => write!(f, "only one run has {}", only.display()),
            Self::Column { name, only_in } => {
                write!(f, "only {} has the column {name}", only_in.display())
            }
            Self::Rows { first, second } => {
                let common = first.min(second);
                write!(
                    f,
                    "{first} rows against {second}: the first {common} are compared"
                )
            }
            Self::Axis { name } => write!(
                f,
                "the axes {name} differ: rows are matched by number and stand for different places"
            ),
        }
    }
}

impl Comparison {
    /// The comparison as JSON; a difference that is not finite is null.
    pub fn to_json(&self) -> Value {
        json!({
            "agrees": self.agrees(),
            "differences": messages(&self.differences),
            "tables": self.tables.iter().map(table_json).collect::<Value>(),
        })
    }
}

fn messages(differences: &[Difference]) -> Value {
    differences.iter().map(Difference::to_string).collect()
}

fn table_json(table: &TableComparison) -> Value {
    json!({
        "name": table.name,
        "agrees": table.agrees(),
        "differences": messages(&table.differences),
        "columns": table.columns.iter().map(column_json).collect::<Value>(),
    })
}

fn column_json(column: &ColumnComparison) -> Value {
    let worst = column.worst.map(|worst| {
        json!({
            "row": worst.row,
            "at": worst.at,
            "first": worst.first,
            "second": worst.second,
            "difference": worst.difference,
            "allowed": worst.allowed,
        })
    });
    json!({
        "name": column.name,
        "agrees": column.agrees(),
        "failures": column.failures,
        "worst": worst,
    })
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for table in &self.tables {
            writeln!(f, "{}", table.name)?;
            writeln!(f, "{}", worst_places(table))?;
            for difference in &table.differences {
                writeln!(f, "  {difference}")?;
            }
        }
        for difference in &self.differences {
            writeln!(f, "  {difference}")?;
        }
        f.write_str(if self.agrees() {
            "equal within tolerance"
        } else {
            "different"
        })
    }
}

fn worst_places(table: &TableComparison) -> String {
    let axis = table.known.first().map_or("row", String::as_str);
    let mut out = Table::new();
    out.load_style(presets::NOTHING).set_header([
        "column",
        "worst |a−b|",
        "allowed",
        axis,
        "a",
        "b",
        "verdict",
    ]);
    for column in &table.columns {
        out.add_row(worst_place(column));
    }
    for index in 1..=5 {
        if let Some(column) = out.column_mut(index) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    out.trim_fmt()
}

fn worst_place(column: &ColumnComparison) -> [String; 7] {
    let verdict = match column.failures {
        0 => "ok".to_owned(),
        1 => "differs in 1 row".to_owned(),
        rows => format!("differs in {rows} rows"),
    };
    let name = column.name.clone();
    let Some(worst) = &column.worst else {
        let none = String::new;
        return [
            name,
            none(),
            none(),
            none(),
            none(),
            none(),
            "not significant".to_owned(),
        ];
    };
    let Worst {
        difference,
        allowed,
        at,
        first,
        second,
        ..
    } = worst;
    [
        name,
        format!("{difference:.2e}"),
        format!("{allowed:.2e}"),
        format!("{at}"),
        format!("{first:e}"),
        format!("{second:e}"),
        verdict,
    ]
}
