//! What the tables of a run's ball laws are good for, and how often it left them.

use super::terminal::Lines;
use crate::simulate::TableUse;

/// A line or more for every bearing that was to have a table.
pub(super) fn put_table_use(out: &mut Lines, tables: &[Option<TableUse>]) {
    for (index, used) in tables.iter().enumerate() {
        let Some(used) = used else { continue };
        let says = match &used.table {
            Ok(report) => format!(
                "{} cells, off by {:.1e} N, {:.1e} of the largest ball load; {} samples outside it, by the exact law",
                report.cells, report.error, report.relative_error, used.samples_outside
            ),
            Err(error) => format!("none, the exact law instead: {error}"),
        };
        out.line("table", format!("bearing {}: {says}", index + 1));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::{TableError, TableReport};

    #[test]
    fn a_table_tells_its_error_and_one_that_is_missing_why() {
        let report = TableReport {
            error: 2e-8,
            relative_error: 1.7e-10,
            cells: 1234,
            evaluations: 9876,
        };
        let of = |table| {
            Some(TableUse {
                table,
                samples_outside: 5,
            })
        };
        let mut out = Lines::default();
        let tables = [of(Ok(report)), None, of(Err(TableError::NoRegion))];
        put_table_use(&mut out, &tables);
        let text = out.text();
        let told = text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            told.contains("bearing 1: 1234 cells, off by 2.0e-8 N, 1.7e-10 of"),
            "{told}"
        );
        assert!(told.contains("5 samples outside it"), "{told}");
        assert!(told.contains("bearing 3: none"), "{told}");
        assert!(!told.contains("bearing 2"), "{told}");
    }
}
