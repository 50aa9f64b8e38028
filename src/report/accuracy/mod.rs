//! Speed against error: table for people, CSV, JSON and two figures.
//!
//! These files hold times, and so are the only ones that differ from one measurement to the next.

mod figures;

use crate::report::terminal::{Lines, MICRO, or_dash, wrapped};
use crate::report::{FileSet, Findings};
use crate::scenario::Scenario;
use crate::study::accuracy::{Accuracy, Agreement, Cost, Errors, FidelityRow, Row};
use crate::table::{Named, Table, TableOf};
use figures::{ladder_figure, methods_figure};

/// Reference, methods and ladder of a measurement.
pub fn accuracy_findings(scenario: &Scenario, accuracy: &Accuracy) -> Findings {
    let (title, agreement) = (&scenario.title, &accuracy.agreement);
    let (methods, ladder) = (methods_table(accuracy), ladder_table(accuracy));
    let mut text = Lines::titled(title);
    add_reference(&mut text, agreement);
    add_methods(&mut text, accuracy, &methods);
    add_ladder(&mut text, accuracy, &ladder);
    Findings {
        figures: vec![
            methods_figure(title, agreement, &methods),
            ladder_figure(title, agreement, &ladder),
        ],
        tables: vec![("accuracy", methods), ("ladder", ladder)],
        ..Findings::new(FileSet::sealed("accuracy.json"), scenario, accuracy, text)
    }
}

const ERRORS: [Named<Errors>; 11] = [
    ("displacement", "m", |own| own.displacement),
    ("displacement_relative", "", |own| own.displacement_relative),
    ("force", "N", |own| own.force),
    ("force_relative", "", |own| own.force_relative),
    ("lines_relative", "", |own| own.lines.unwrap_or(f64::NAN)),
    ("displacement_mean_relative", "", |own| own.statistics.mean),
    ("displacement_rms_relative", "", |own| own.statistics.rms),
    ("displacement_peak_relative", "", |own| own.statistics.peak),
    ("force_mean_relative", "", |own| own.force_statistics.mean),
    ("force_rms_relative", "", |own| own.force_statistics.rms),
    ("force_peak_relative", "", |own| own.force_statistics.peak),
];

/// Methods × tolerances.
fn methods_table(accuracy: &Accuracy) -> Table<'static> {
    let measured = |row: &Row| row.result.as_ref().ok().map(|own| own.within_uncertainty);
    let table = Table::from_items(&accuracy.rows)
        .word("method", |row| &row.method)
        .number("tolerance", "", |row| row.tolerance);
    with_costs(table, |row| Some(&row.result.as_ref().ok()?.cost))
        .named("error_", &ERRORS, |row| {
            Some(&row.result.as_ref().ok()?.errors)
        })
        .word("within_uncertainty", |row| or_blank(measured(row)))
        .word("note", |row| or_blank(row.result.as_ref().err()))
        .end()
}

/// The fidelity levels.
fn ladder_table(accuracy: &Accuracy) -> Table<'static> {
    let cost = |row: &'_ FidelityRow| row.result.as_ref().ok().map(|(cost, _)| cost.seconds);
    let table = Table::from_items(&accuracy.ladder.rows)
        .word("model", |row| row.configuration)
        .word("as_written", |row| row.as_written)
        .number("wall_time_per_simulated_s", "", |row| {
            Some(cost(row)? / accuracy.duration)
        });
    with_costs(table, |row| Some(&row.result.as_ref().ok()?.0))
        .named("difference_", &ERRORS, |row| {
            Some(&row.result.as_ref().ok()?.1)
        })
        .word("note", |row| or_blank(row.result.as_ref().err()))
        .end()
}

fn with_costs<'r, R>(table: TableOf<'r, R>, cost: fn(&'r R) -> Option<&'r Cost>) -> TableOf<'r, R> {
    table
        .number("wall_time", "s", |row| Some(cost(row)?.seconds))
        .count("repeats", |row| Some(f64::from(cost(row)?.repeats)))
        .count("steps", |row| Some(cost(row)?.counters.steps as f64))
        .count("rejected", |row| Some(cost(row)?.counters.rejected as f64))
        .count("evaluations", |row| {
            Some(cost(row)?.counters.evaluations as f64)
        })
}

fn or_blank(value: Option<impl ToString>) -> String {
    value.map(|value| value.to_string()).unwrap_or_default()
}

fn add_reference(out: &mut Lines, agreement: &Agreement) {
    let uncertainty = &agreement.uncertainty;
    let text = format!(
        "{}; {} is {} of the motion off: the uncertainty ({} µm, force {} N, lines {})",
        agreement.reference,
        agreement.other,
        short(uncertainty.displacement_relative),
        short(MICRO * uncertainty.displacement),
        short(uncertainty.force),
        or_dash(uncertainty.lines.map(short))
    );
    out.line("reference", text);
    let (motion, force) = (MICRO * agreement.scale.displacement, agreement.scale.force);
    let text = format!("{motion:.4} µm of motion, {force:.4} N of change in the bearings' force");
    out.line("relative to", text);
    if agreement.irregular {
        let scatter = &agreement.scatter.statistics;
        let text = format!(
            "two exact runs part company (small differences grow {}-fold): single traces mean nothing, \
             their statistics do; {} exact runs scatter by mean {}, rms {}, peak {}",
            short(agreement.growth),
            agreement.runs,
            short(scatter.mean),
            short(scatter.rms),
            short(scatter.peak)
        );
        out.line("irregular", text);
    }
}

/// Every method, with errors of traces, or of statistics where traces mean nothing.
fn add_methods(out: &mut Lines, accuracy: &Accuracy, table: &Table<'_>) {
    let errors = match accuracy.agreement.irregular {
        true => [
            ("error\nin mean", "error_displacement_mean_relative"),
            ("\nin rms", "error_displacement_rms_relative"),
            ("\nin peak", "error_displacement_peak_relative"),
        ],
        false => [
            ("error\nmotion", "error_displacement_relative"),
            ("\nforce", "error_force_relative"),
            ("\nlines", "error_lines_relative"),
        ],
    };
    let costs = [
        ("method", "method"),
        ("tolerance", "tolerance"),
        ("time", "wall_time"),
        ("evaluations", "evaluations"),
        ("steps", "steps"),
        ("rejected", "rejected"),
    ];
    let within = [("within\nuncertainty", "within_uncertainty")];
    out.show(table, &[&costs[..], &errors, &within].concat(), 2);
    let alike = |a: &Row, b: &Row| {
        a.method == b.method && a.result.as_ref().err() == b.result.as_ref().err()
    };
    for rows in accuracy.rows.chunk_by(alike) {
        if let Err(reason) = &rows[0].result {
            let tolerances: Vec<_> = rows
                .iter()
                .map(|row| format!("{:e}", row.tolerance))
                .collect();
            let what = format!("{} at {}", rows[0].method, tolerances.join(", "));
            add_note(out, what, reason);
        }
    }
}

/// Every model, with its difference from the highest.
fn add_ladder(out: &mut Lines, accuracy: &Accuracy, table: &Table<'_>) {
    let errors = match accuracy.agreement.irregular {
        true => [
            ("rms", "difference_displacement_rms_relative"),
            ("peak", "difference_displacement_peak_relative"),
            ("force rms", "difference_force_rms_relative"),
        ],
        false => [
            ("vibration", "difference_displacement_relative"),
            ("force", "difference_force_relative"),
            ("lines", "difference_lines_relative"),
        ],
    };
    let costs = [
        ("model, cage, freedoms", "model"),
        ("written", "as_written"),
        ("time per\nsecond", "wall_time_per_simulated_s"),
        ("position", "difference_displacement_mean_relative"),
    ];
    out.show(table, &[&costs[..], &errors].concat(), 2);
    out.put(
        "relative to the RMS vibration of the highest level after the settle time; position: of its mean",
    );
    for row in &accuracy.ladder.rows {
        if let Err(reason) = &row.result {
            add_note(out, row.configuration.to_string(), reason);
        }
    }
    out.put("");
}

/// What could not be measured, and why.
fn add_note(out: &mut Lines, what: String, reason: &str) {
    out.put(format_args!("  not available: {what}"));
    out.put(wrapped(&format!("    {reason}"), 4));
}

/// Two significant digits.
fn short(value: f64) -> String {
    if value == 0.0 {
        "0".to_owned()
    } else {
        format!("{value:.1e}")
    }
}
