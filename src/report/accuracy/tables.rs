//! `accuracy.csv`, a row a method and tolerance, and `ladder.csv`, a row a rung.

use super::super::table::Table;
use crate::study::accuracy::{Accuracy, Cost, Errors, Row};

/// A column and its value.
type Named<T, V> = (&'static str, fn(&T) -> V);

const ERRORS: [Named<Errors, Option<f64>>; 11] = [
    ("displacement_m", |errors| Some(errors.displacement)),
    ("displacement_relative", |errors| {
        Some(errors.displacement_relative)
    }),
    ("force_N", |errors| Some(errors.force)),
    ("force_relative", |errors| Some(errors.force_relative)),
    ("lines_relative", |errors| errors.lines),
    ("displacement_mean_relative", |errors| {
        Some(errors.statistics.mean)
    }),
    ("displacement_rms_relative", |errors| {
        Some(errors.statistics.rms)
    }),
    ("displacement_peak_relative", |errors| {
        Some(errors.statistics.peak)
    }),
    ("force_mean_relative", |errors| {
        Some(errors.force_statistics.mean)
    }),
    ("force_rms_relative", |errors| {
        Some(errors.force_statistics.rms)
    }),
    ("force_peak_relative", |errors| {
        Some(errors.force_statistics.peak)
    }),
];

/// Whole numbers of a cost.
const COUNTS: [Named<Cost, f64>; 4] = [
    ("repeats", |cost| cost.repeats.into()),
    ("steps", |cost| cost.counters.steps as f64),
    ("rejected", |cost| cost.counters.rejected as f64),
    ("evaluations", |cost| cost.counters.evaluations as f64),
];

/// Methods × tolerances.
pub(super) fn methods(accuracy: &Accuracy) -> Table {
    let rows = || accuracy.rows.iter();
    let measured = |row: &Row| row.result.as_ref().ok().copied();
    let costs: Vec<_> = rows().map(|row| Some(measured(row)?.cost)).collect();
    let errors: Vec<_> = rows().map(|row| Some(measured(row)?.errors)).collect();
    let within = rows().map(|row| measured(row).map(|measured| measured.within_uncertainty));
    let mut table = Table::default();
    table.words("method", rows().map(|row| &row.method));
    table.numbers("tolerance", rows().map(|row| row.tolerance));
    add_costs(&mut table, &costs);
    add_errors(&mut table, "error", &errors);
    table.words("within_uncertainty", within.map(or_blank));
    table.words(
        "note",
        rows().map(|row| or_blank(row.result.as_ref().err())),
    );
    table
}

/// The rungs.
pub(super) fn ladder(accuracy: &Accuracy) -> Table {
    let rows = || accuracy.ladder.rows.iter();
    let measured = || rows().map(|row| row.result.as_ref().ok());
    let costs: Vec<_> = measured().map(|measured| Some(measured?.0)).collect();
    let errors: Vec<_> = measured().map(|measured| Some(measured?.1)).collect();
    let per_second = |cost: &Option<Cost>| Some(cost.as_ref()?.seconds / accuracy.duration);
    let mut table = Table::default();
    table.words("model", rows().map(|row| &row.configuration));
    table.words("as_written", rows().map(|row| row.as_written));
    table.numbers("wall_time_per_simulated_s", costs.iter().map(per_second));
    add_costs(&mut table, &costs);
    add_errors(&mut table, "difference", &errors);
    table.words(
        "note",
        rows().map(|row| or_blank(row.result.as_ref().err())),
    );
    table
}

fn add_costs(table: &mut Table, costs: &[Option<Cost>]) {
    let seconds = costs.iter().map(|cost| Some(cost.as_ref()?.seconds));
    table.numbers("wall_time_s", seconds);
    for (name, count) in COUNTS {
        table.counts(name, costs.iter().map(|cost| cost.as_ref().map(count)));
    }
}

fn add_errors(table: &mut Table, before: &str, errors: &[Option<Errors>]) {
    for (name, value) in ERRORS {
        let values = errors.iter().map(|errors| value(errors.as_ref()?));
        table.numbers(format!("{before}_{name}"), values);
    }
}

fn or_blank(value: Option<impl ToString>) -> String {
    value.map(|value| value.to_string()).unwrap_or_default()
}
