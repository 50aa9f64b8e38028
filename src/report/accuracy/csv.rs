//! `accuracy.csv`, a row a method and tolerance, and `ladder.csv`, a row a rung.

use std::io;

use super::super::statics::{cell, number};
use crate::study::accuracy::{Accuracy, Cost, Errors, LadderRow, Row};

const COST: [&str; 5] = ["wall_time_s", "repeats", "steps", "rejected", "evaluations"];
const ERRORS: [&str; 11] = [
    "displacement_m",
    "displacement_relative",
    "force_N",
    "force_relative",
    "lines_relative",
    "displacement_mean_relative",
    "displacement_rms_relative",
    "displacement_peak_relative",
    "force_mean_relative",
    "force_rms_relative",
    "force_peak_relative",
];

/// Methods × tolerances.
pub(super) fn methods(accuracy: &Accuracy) -> io::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let names = ["method", "tolerance"].into_iter().chain(COST);
    let names = names.map(str::to_owned);
    let errors = ERRORS.iter().map(|name| format!("error_{name}"));
    let end = ["within_uncertainty", "note"].map(str::to_owned);
    writer.write_record(names.chain(errors).chain(end))?;
    for row in &accuracy.rows {
        writer.write_record(method_cells(row))?;
    }
    bytes(writer)
}

fn method_cells(row: &Row) -> Vec<String> {
    let measured = row.result.as_ref().ok();
    let mut cells = vec![row.method.clone(), number(row.tolerance)];
    cells.extend(cost_cells(measured.map(|measured| &measured.cost)));
    cells.extend(error_cells(measured.map(|measured| &measured.errors)));
    let within = measured.map(|measured| measured.within_uncertainty.to_string());
    cells.push(within.unwrap_or_default());
    cells.push(row.result.as_ref().err().cloned().unwrap_or_default());
    cells
}

/// The rungs.
pub(super) fn ladder(accuracy: &Accuracy) -> io::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let names = ["model", "as_written", "wall_time_per_simulated_s"];
    let names = names.into_iter().chain(COST).map(str::to_owned);
    let errors = ERRORS.iter().map(|name| format!("difference_{name}"));
    writer.write_record(names.chain(errors).chain(["note".to_owned()]))?;
    for row in &accuracy.ladder.rows {
        writer.write_record(ladder_cells(row, accuracy.duration))?;
    }
    bytes(writer)
}

fn ladder_cells(row: &LadderRow, duration: f64) -> Vec<String> {
    let measured = row.result.as_ref().ok();
    let cost = measured.map(|(cost, _)| cost);
    let mut cells = vec![row.configuration.to_string(), row.as_written.to_string()];
    cells.push(cell(cost.map(|cost| cost.seconds / duration)));
    cells.extend(cost_cells(cost));
    cells.extend(error_cells(measured.map(|(_, errors)| errors)));
    cells.push(row.result.as_ref().err().cloned().unwrap_or_default());
    cells
}

fn cost_cells(cost: Option<&Cost>) -> Vec<String> {
    let Some(cost) = cost else {
        return vec![String::new(); COST.len()];
    };
    let counters = &cost.counters;
    vec![
        number(cost.seconds),
        cost.repeats.to_string(),
        counters.steps.to_string(),
        counters.rejected.to_string(),
        counters.evaluations.to_string(),
    ]
}

fn error_cells(errors: Option<&Errors>) -> Vec<String> {
    let Some(errors) = errors else {
        return vec![String::new(); ERRORS.len()];
    };
    let (own, force) = (&errors.statistics, &errors.force_statistics);
    [
        Some(errors.displacement),
        Some(errors.displacement_relative),
        Some(errors.force),
        Some(errors.force_relative),
        errors.lines,
        Some(own.mean),
        Some(own.rms),
        Some(own.peak),
        Some(force.mean),
        Some(force.rms),
        Some(force.peak),
    ]
    .map(cell)
    .to_vec()
}

fn bytes(writer: csv::Writer<Vec<u8>>) -> io::Result<Vec<u8>> {
    writer.into_inner().map_err(|error| error.into_error())
}
