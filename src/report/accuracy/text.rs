//! Speed against error for people.

use std::path::PathBuf;

use super::super::terminal::{Lines, or_dash, wrapped};
use crate::report::units::{MICRO, MILLI};
use crate::study::accuracy::{Accuracy, Agreement, Errors, LadderRow, Measured, Row};

/// Reference, methods, ladder, and the files written; at most 100 columns.
pub fn accuracy_text(title: &str, accuracy: &Accuracy, files: &[PathBuf]) -> String {
    let mut out = Lines::titled(title);
    put_reference(&mut out, &accuracy.agreement);
    put_methods(&mut out, accuracy);
    put_least_time(&mut out, accuracy);
    put_ladder(&mut out, accuracy);
    out.wrote(files)
}

fn put_reference(out: &mut Lines, agreement: &Agreement) {
    let run = |(method, tolerance): &(String, f64)| format!("{method} at {tolerance:e}");
    let uncertainty = &agreement.uncertainty;
    let text = format!(
        "{}; {} is {} of the motion off: the uncertainty ({} µm, force {} N, lines {})",
        run(&agreement.reference),
        run(&agreement.other),
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

fn put_methods(out: &mut Lines, accuracy: &Accuracy) {
    let irregular = accuracy.agreement.irregular;
    let first = [
        "method\n",
        "tolerance\n",
        "time\nms",
        "evaluations\n",
        "steps\n",
        "rejected\n",
    ];
    let header = first.into_iter().chain(error_header(irregular));
    let rows = accuracy.rows.iter().filter_map(|row| {
        let measured = row.result.as_ref().ok()?;
        Some(method_cells(row, measured, irregular))
    });
    out.table(header, rows);
    let is_within = |measured: &Measured| measured.within_uncertainty;
    let mut all = accuracy.rows.iter().map(|row| row.result.as_ref());
    if all.any(|result| result.is_ok_and(is_within)) {
        out.put(if irregular {
            "≈ within the scatter of exact runs"
        } else {
            "≤ not above the uncertainty of the reference"
        });
    }
    for row in &accuracy.rows {
        if let Err(reason) = &row.result {
            put_note(
                out,
                format!("{} at {:e}", row.method, row.tolerance),
                reason,
            );
        }
    }
}

/// Titles of three columns: of traces, or of statistics where traces mean nothing.
fn error_header(irregular: bool) -> [&'static str; 3] {
    if irregular {
        ["error\nin mean", "\nin rms", "\nin peak"]
    } else {
        ["error\ndisplacement", "\nforce", "\nlines"]
    }
}

fn error_cells(errors: &Errors, irregular: bool, mark: &str) -> Vec<String> {
    if irregular {
        let statistics = &errors.statistics;
        return vec![
            format!("{mark}{}", short(statistics.mean)),
            short(statistics.rms),
            short(statistics.peak),
        ];
    }
    vec![
        format!("{mark}{}", short(errors.displacement_relative)),
        short(errors.force_relative),
        or_dash(errors.lines.map(short)),
    ]
}

fn method_cells(row: &Row, measured: &Measured, irregular: bool) -> Vec<String> {
    let counters = &measured.cost.counters;
    let mark = match (measured.within_uncertainty, irregular) {
        (false, _) => "",
        (true, false) => "≤ ",
        (true, true) => "≈ ",
    };
    let mut cells = vec![
        row.method.clone(),
        format!("{:e}", row.tolerance),
        time(MILLI * measured.cost.seconds),
        counters.evaluations.to_string(),
        counters.steps.to_string(),
        counters.rejected.to_string(),
    ];
    cells.extend(error_cells(&measured.errors, irregular, mark));
    cells
}

/// Of each decade of error, the row that stays below it in the least time.
fn put_least_time(out: &mut Lines, accuracy: &Accuracy) {
    if accuracy.agreement.irregular {
        return;
    }
    for decade in (2..=12).step_by(2) {
        let bound = 10f64.powi(-decade);
        let fast = accuracy.rows.iter().filter_map(|row| {
            let measured = row.result.as_ref().ok()?;
            (measured.errors.displacement_relative <= bound).then_some((row, measured))
        });
        let best = fast.min_by(|a, b| a.1.cost.seconds.total_cmp(&b.1.cost.seconds));
        let Some((row, measured)) = best else { break };
        let (method, tolerance) = (&row.method, row.tolerance);
        let time = time(MILLI * measured.cost.seconds);
        let text = format!("soonest by {method} at {tolerance:e}: {time} ms");
        out.line(&format!("error ≤ {bound:<5e}"), text);
    }
}

fn put_ladder(out: &mut Lines, accuracy: &Accuracy) {
    let vibration = if accuracy.agreement.irregular {
        ["\nrms", "\npeak", "force\nrms"]
    } else {
        ["\nvibration", "\nforce", "\nlines"]
    };
    let header = [
        "model, cage, freedoms\n",
        "\n",
        "ms per\nsimulated s",
        "from the top\nplace",
    ];
    let rows = &accuracy.ladder.rows;
    let cells = rows.iter().filter_map(|row| ladder_cells(row, accuracy));
    out.table(header.into_iter().chain(vibration), cells);
    out.put(
        "relative to the rms of the top rung's vibration after the settle time; place: of its middle",
    );
    for row in rows {
        if let Err(reason) = &row.result {
            put_note(out, row.configuration.to_string(), reason);
        }
    }
    out.put("");
}

fn ladder_cells(row: &LadderRow, accuracy: &Accuracy) -> Option<Vec<String>> {
    let (cost, errors) = row.result.as_ref().ok()?;
    let is_top = accuracy.ladder.top == Some(row.configuration);
    let mark = match (is_top, row.as_written) {
        (true, true) => "top, written",
        (true, false) => "top",
        (false, true) => "written",
        (false, false) => "",
    };
    let statistics = &errors.statistics;
    let apart = if accuracy.agreement.irregular {
        let force = short(errors.force_statistics.rms);
        [short(statistics.rms), short(statistics.peak), force]
    } else {
        let lines = or_dash(errors.lines.map(short));
        let [vibration, force] = [errors.displacement_relative, errors.force_relative].map(short);
        [vibration, force, lines]
    };
    let cells = [
        row.configuration.to_string(),
        mark.to_owned(),
        time(MILLI * cost.seconds / accuracy.duration),
        short(statistics.mean),
    ];
    Some(cells.into_iter().chain(apart).collect())
}

/// What could not be measured, and why.
fn put_note(out: &mut Lines, what: String, reason: &str) {
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

/// Three significant digits, without a power of ten.
fn time(value: f64) -> String {
    let decimals = (2.0 - value.log10().floor()).clamp(0.0, 6.0) as usize;
    format!("{value:.decimals$}")
}
