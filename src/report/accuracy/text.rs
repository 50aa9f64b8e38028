//! Speed against error for people.

use std::fmt::{self, Write};
use std::path::PathBuf;

use super::super::statics::table;
use crate::report::units::{MICRO, MILLI};
use crate::study::accuracy::{Accuracy, Agreement, Errors, LadderRow, Measured, Row};

/// Longest note beside a table.
const NOTE: usize = 76;

/// Reference, methods, ladder, and the files written; at most 100 columns.
pub fn accuracy_text(title: &str, accuracy: &Accuracy, files: &[PathBuf]) -> String {
    let mut out = String::new();
    write_text(&mut out, title, accuracy, files)
        .expect("a String takes everything that is written to it");
    out
}

fn write_text(
    out: &mut String,
    title: &str,
    accuracy: &Accuracy,
    files: &[PathBuf],
) -> fmt::Result {
    writeln!(out, "{title}")?;
    write_reference(out, &accuracy.agreement)?;
    writeln!(out, "\n{}", methods(accuracy))?;
    let left_out = accuracy.rows.iter().filter_map(|row| {
        let reason = row.result.as_ref().err()?;
        Some((format!("{} at {:e}", row.method, row.tolerance), reason))
    });
    write_notes(out, left_out)?;
    write_least_time(out, accuracy)?;
    writeln!(out, "\n{}", ladder(accuracy))?;
    let missing = accuracy.ladder.rows.iter().filter_map(|row| {
        let reason = row.result.as_ref().err()?;
        Some((row.configuration.to_string(), reason))
    });
    write_notes(out, missing)?;
    writeln!(out)?;
    for file in files {
        writeln!(out, "  wrote         {}", file.display())?;
    }
    Ok(())
}

fn write_reference(out: &mut String, agreement: &Agreement) -> fmt::Result {
    let run = |(method, tolerance): &(String, f64)| format!("{method} at {tolerance:e}");
    let uncertainty = &agreement.uncertainty;
    writeln!(
        out,
        "  reference     {}; {} is\n                {} of the motion off: the uncertainty",
        run(&agreement.reference),
        run(&agreement.other),
        short(uncertainty.displacement_relative)
    )?;
    writeln!(
        out,
        "                ({} µm, force {} N, lines {})",
        short(MICRO * uncertainty.displacement),
        short(uncertainty.force),
        uncertainty.lines.map_or_else(dash, short)
    )?;
    writeln!(
        out,
        "  relative to   {:.4} µm of motion, {:.4} N of change in the bearings' force",
        MICRO * agreement.scale.displacement,
        agreement.scale.force
    )?;
    if agreement.irregular {
        let scatter = &agreement.scatter.statistics;
        writeln!(
            out,
            "  irregular     two exact runs part company (small differences grow {}-fold): single\n\
             \x20               traces mean nothing, their statistics do; {} exact runs scatter by\n\
             \x20               mean {}, rms {}, peak {}",
            short(agreement.growth),
            agreement.runs,
            short(scatter.mean),
            short(scatter.rms),
            short(scatter.peak)
        )?;
    }
    Ok(())
}

fn methods(accuracy: &Accuracy) -> String {
    let irregular = accuracy.agreement.irregular;
    let first = [
        "method\n",
        "tolerance\n",
        "time\nms",
        "evaluations\n",
        "steps\n",
        "rejected\n",
    ];
    let errors = error_header(irregular);
    let measured = |row: &Row| {
        let measured = row.result.as_ref().ok()?;
        Some(method_cells(row, measured, irregular))
    };
    let header = first.into_iter().chain(errors);
    let rows = accuracy.rows.iter().filter_map(measured);
    let mut text = table(header, rows).trim_fmt();
    if accuracy.rows.iter().any(is_within) {
        text += if irregular {
            "\n≈ within the scatter of exact runs"
        } else {
            "\n≤ not above the uncertainty of the reference"
        };
    }
    text
}

fn is_within(row: &Row) -> bool {
    row.result
        .as_ref()
        .is_ok_and(|measured| measured.within_uncertainty)
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
        errors.lines.map_or_else(dash, short),
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
fn write_least_time(out: &mut String, accuracy: &Accuracy) -> fmt::Result {
    if accuracy.agreement.irregular {
        return Ok(());
    }
    for decade in (2..=12).step_by(2) {
        let bound = 10f64.powi(-decade);
        let fast = accuracy.rows.iter().filter_map(|row| {
            let measured = row.result.as_ref().ok()?;
            (measured.errors.displacement_relative <= bound).then_some((row, measured))
        });
        let best = fast.min_by(|a, b| a.1.cost.seconds.total_cmp(&b.1.cost.seconds));
        let Some((row, measured)) = best else { break };
        writeln!(
            out,
            "  error ≤ {bound:<5e} soonest by {} at {:e}: {} ms",
            row.method,
            row.tolerance,
            time(MILLI * measured.cost.seconds)
        )?;
    }
    Ok(())
}

fn ladder(accuracy: &Accuracy) -> String {
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
    let cells = |row: &LadderRow| ladder_cells(row, accuracy);
    let rows = accuracy.ladder.rows.iter().filter_map(cells);
    let mut text = table(header.into_iter().chain(vibration), rows).trim_fmt();
    text += "\nrelative to the rms of the top rung's vibration after the settle time; place: of its middle";
    text
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
        let lines = errors.lines.map_or_else(dash, short);
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

fn write_notes<'a>(
    out: &mut String,
    notes: impl Iterator<Item = (String, &'a String)>,
) -> fmt::Result {
    for (what, reason) in notes {
        writeln!(out, "  not available: {what}")?;
        for line in wrapped(reason) {
            writeln!(out, "    {line}")?;
        }
    }
    Ok(())
}

/// The words in lines of at most [`NOTE`] characters, where no word is longer.
fn wrapped(text: &str) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let last = lines.len() - 1;
        if lines[last].is_empty() {
            lines[last] = word.to_owned();
        } else if lines[last].chars().count() + 1 + word.chars().count() <= NOTE {
            lines[last] += " ";
            lines[last] += word;
        } else {
            lines.push(word.to_owned());
        }
    }
    lines
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

fn dash() -> String {
    "–".to_owned()
}
