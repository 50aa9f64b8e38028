//! A comparison as JSON.

use serde_json::{Value, json};

use super::{ColumnComparison, Comparison, Difference, TableComparison, Worst};

impl Comparison {
    /// The comparison as JSON; a difference that is not finite is null.
    pub fn to_json(&self) -> Value {
        json!({
            "agrees": self.agrees(),
            "differences": messages(&self.differences),
            "left_out": messages(&self.left_out),
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
        "left_out": messages(&table.left_out),
        "columns": table.columns.iter().map(column_json).collect::<Value>(),
    })
}

fn column_json(column: &ColumnComparison) -> Value {
    let place = |worst: &Worst| {
        json!({
            "row": worst.row,
            "at": worst.at,
            "first": worst.first,
            "second": worst.second,
            "difference": worst.difference,
            "allowed": worst.allowed,
        })
    };
    json!({
        "name": column.name,
        "agrees": column.agrees(),
        "failures": column.failures,
        "relative_needed": column.needed,
        "worst": column.worst().map(place),
        "further": column.places.iter().skip(1).map(place).collect::<Value>(),
    })
}
