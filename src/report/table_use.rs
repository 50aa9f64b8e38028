//! What the tables of a run's ball laws are good for, and how often it left them.

use super::wrapped;
use crate::simulate::TableUse;

/// Characters before the text of a line.
const INDENT: usize = 16;

/// A line or more for every bearing that was to have a table.
pub(super) fn table_use_text(tables: &[Option<TableUse>]) -> String {
    let told = tables.iter().enumerate();
    told.filter_map(|(index, table)| Some(line(index + 1, table.as_ref()?)))
        .collect()
}

fn line(bearing: usize, used: &TableUse) -> String {
    let says = match &used.table {
        Ok(report) => format!(
            "{} cells, off by {:.1e} N, {:.1e} of the largest ball load; {} samples outside it, by the exact law",
            report.cells, report.error, report.relative_error, used.samples_outside
        ),
        Err(error) => format!("none, the exact law instead: {error}"),
    };
    let line = wrapped(
        &format!("  table         bearing {bearing}: {says}"),
        INDENT,
    );
    format!("{line}\n")
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
        let lines = table_use_text(&[of(Ok(report)), None, of(Err(TableError::NoRegion))]);
        let told = lines.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            told.contains("bearing 1: 1234 cells, off by 2.0e-8 N, 1.7e-10 of"),
            "{told}"
        );
        assert!(told.contains("5 samples outside it"), "{told}");
        assert!(told.contains("bearing 3: none"), "{told}");
        assert!(!told.contains("bearing 2"), "{told}");
    }
}
