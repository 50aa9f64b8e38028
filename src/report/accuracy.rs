//! Speed against error: table for people, CSV, JSON and two figures.
//!
//! These files hold times, and so are the only ones that differ from one measurement to the next.

use super::figure::{Axis, COLOURS, Curve, Figure, GREY, Mark, Name, Panel, distinct};
use super::table::{Named, Table};
use super::terminal::{Lines, MICRO, MILLI, or_dash, wrapped};
use super::{Destination, FileSet, Findings};
use crate::study::accuracy::{Accuracy, Agreement, Cost, Errors, FidelityRow, Measured, Row};

/// Reference, methods and ladder of a measurement.
pub fn accuracy_findings(destination: &Destination<'_>, accuracy: &Accuracy) -> Findings {
    let title = destination.title;
    let mut text = Lines::titled(title);
    put_reference(&mut text, &accuracy.agreement);
    put_methods(&mut text, accuracy);
    put_ladder(&mut text, accuracy);
    Findings {
        set: FileSet::ACCURACY,
        tables: vec![
            ("accuracy", methods_table(accuracy)),
            ("ladder", ladder_table(accuracy)),
        ],
        figures: vec![
            methods_figure(title, accuracy),
            ladder_figure(title, accuracy),
        ],
        document: destination.document(accuracy),
        text,
    }
}

const ERRORS: [Named<Errors>; 11] = [
    ("displacement_m", |errors| errors.displacement),
    ("displacement_relative", |errors| {
        errors.displacement_relative
    }),
    ("force_N", |errors| errors.force),
    ("force_relative", |errors| errors.force_relative),
    ("lines_relative", |errors| errors.lines.unwrap_or(f64::NAN)),
    ("displacement_mean_relative", |errors| {
        errors.statistics.mean
    }),
    ("displacement_rms_relative", |errors| errors.statistics.rms),
    ("displacement_peak_relative", |errors| {
        errors.statistics.peak
    }),
    ("force_mean_relative", |errors| errors.force_statistics.mean),
    ("force_rms_relative", |errors| errors.force_statistics.rms),
    ("force_peak_relative", |errors| errors.force_statistics.peak),
];

/// Whole numbers of a cost.
const COUNTS: [Named<Cost>; 4] = [
    ("repeats", |cost| cost.repeats.into()),
    ("steps", |cost| cost.counters.steps as f64),
    ("rejected", |cost| cost.counters.rejected as f64),
    ("evaluations", |cost| cost.counters.evaluations as f64),
];

/// Methods × tolerances.
fn methods_table(accuracy: &Accuracy) -> Table<'static> {
    let rows = || accuracy.rows.iter();
    let measured = |row: &Row| row.result.as_ref().ok().copied();
    let costs: Vec<_> = rows().map(|row| Some(measured(row)?.cost)).collect();
    let errors: Vec<_> = rows().map(|row| Some(measured(row)?.errors)).collect();
    let within = rows().map(|row| measured(row).map(|measured| measured.within_uncertainty));
    let mut table = Table::default();
    table.words("method", rows().map(|row| &row.method));
    table.numbers("tolerance", rows().map(|row| row.tolerance));
    add_costs(&mut table, &costs);
    table.named("error_", &ERRORS, errors.iter().map(Option::as_ref));
    table.words("within_uncertainty", within.map(or_blank));
    table.words(
        "note",
        rows().map(|row| or_blank(row.result.as_ref().err())),
    );
    table
}

/// The fidelity levels.
fn ladder_table(accuracy: &Accuracy) -> Table<'static> {
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
    table.named("difference_", &ERRORS, errors.iter().map(Option::as_ref));
    table.words(
        "note",
        rows().map(|row| or_blank(row.result.as_ref().err())),
    );
    table
}

fn add_costs(table: &mut Table<'_>, costs: &[Option<Cost>]) {
    let seconds = costs.iter().map(|cost| Some(cost.as_ref()?.seconds));
    table.numbers("wall_time_s", seconds);
    for (name, count) in COUNTS {
        table.counts(name, costs.iter().map(|cost| cost.as_ref().map(count)));
    }
}

fn or_blank(value: Option<impl ToString>) -> String {
    value.map(|value| value.to_string()).unwrap_or_default()
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
    let header = first.into_iter().chain(titles(method_errors(irregular)));
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

/// A column of errors for people: its title and its cells.
type ErrorColumn = (&'static str, fn(&Errors) -> String);

const TRACES: [ErrorColumn; 3] = [
    ("error\ndisplacement", |errors| {
        short(errors.displacement_relative)
    }),
    ("\nforce", |errors| short(errors.force_relative)),
    ("\nlines", |errors| or_dash(errors.lines.map(short))),
];
const STATISTICS: [ErrorColumn; 3] = [
    ("error\nin mean", |errors| short(errors.statistics.mean)),
    ("\nin rms", |errors| short(errors.statistics.rms)),
    ("\nin peak", |errors| short(errors.statistics.peak)),
];

/// Columns of a method: of traces, or of statistics where traces mean nothing.
fn method_errors(irregular: bool) -> &'static [ErrorColumn] {
    if irregular { &STATISTICS } else { &TRACES }
}

const VIBRATION: [ErrorColumn; 4] = [
    ("from the top\nposition", |errors| {
        short(errors.statistics.mean)
    }),
    ("\nvibration", |errors| short(errors.displacement_relative)),
    ("\nforce", |errors| short(errors.force_relative)),
    ("\nlines", |errors| or_dash(errors.lines.map(short))),
];
const SPREAD: [ErrorColumn; 4] = [
    ("from the top\nposition", |errors| {
        short(errors.statistics.mean)
    }),
    ("\nrms", |errors| short(errors.statistics.rms)),
    ("\npeak", |errors| short(errors.statistics.peak)),
    ("force\nrms", |errors| short(errors.force_statistics.rms)),
];

/// Columns of a fidelity level, as those of a method.
fn rung_errors(irregular: bool) -> &'static [ErrorColumn] {
    if irregular { &SPREAD } else { &VIBRATION }
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
    let mark = std::iter::once(mark).chain(std::iter::repeat(""));
    let errors = method_errors(irregular).iter().zip(mark);
    cells.extend(errors.map(|((_, cell), mark)| format!("{mark}{}", cell(&measured.errors))));
    cells
}

fn put_ladder(out: &mut Lines, accuracy: &Accuracy) {
    let errors = rung_errors(accuracy.agreement.irregular);
    let header = ["model, cage, freedoms\n", "\n", "ms per\nsimulated s"];
    let rows = &accuracy.ladder.rows;
    let cells = rows.iter().filter_map(|row| ladder_cells(row, accuracy));
    out.table(header.into_iter().chain(titles(errors)), cells);
    out.put(
        "relative to the RMS vibration of the highest level after the settle time; position: of its mean",
    );
    for row in rows {
        if let Err(reason) = &row.result {
            put_note(out, row.configuration.to_string(), reason);
        }
    }
    out.put("");
}

fn ladder_cells(row: &FidelityRow, accuracy: &Accuracy) -> Option<Vec<String>> {
    let (cost, errors) = row.result.as_ref().ok()?;
    let is_top = accuracy.ladder.top == Some(row.configuration);
    let mark = match (is_top, row.as_written) {
        (true, true) => "top, written",
        (true, false) => "top",
        (false, true) => "written",
        (false, false) => "",
    };
    let cells = [
        row.configuration.to_string(),
        mark.to_owned(),
        time(MILLI * cost.seconds / accuracy.duration),
    ];
    let columns = rung_errors(accuracy.agreement.irregular).iter();
    let apart = columns.map(|(_, cell)| cell(errors));
    Some(cells.into_iter().chain(apart).collect())
}

fn titles(columns: &[ErrorColumn]) -> impl Iterator<Item = &'static str> {
    columns.iter().map(|(title, _)| *title)
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

/// Height of a plot, px.
const HEIGHT: u32 = 320;
/// Height of a row, px.
const RUNG_HEIGHT: u32 = 30;

/// Quantity on an axis and its name.
type Quantity = (&'static str, fn(&Measured) -> Option<f64>);

const TIME: Quantity = ("time of the integration in ms", |measured| {
    Some(MILLI * measured.cost.seconds)
});
const EVALUATIONS: Quantity = ("evaluations of the right-hand side", |measured| {
    Some(measured.cost.counters.evaluations as f64)
});
const STEPS: Quantity = ("steps, accepted and rejected", |measured| {
    let counters = &measured.cost.counters;
    Some((counters.steps + counters.rejected) as f64)
});
const DISPLACEMENT: Quantity = ("error in displacement", |measured| {
    Some(measured.errors.displacement_relative)
});
const FORCE: Quantity = ("error in force", |measured| {
    Some(measured.errors.force_relative)
});
const RMS: Quantity = ("error in rms of displacement", |measured| {
    Some(measured.errors.statistics.rms)
});
const FORCE_RMS: Quantity = ("error in rms of force", |measured| {
    Some(measured.errors.force_statistics.rms)
});
/// What is plotted below and upwards, and the uncertainty of it.
type Plotted = (Quantity, Quantity, f64);

/// What is plotted over what, and the uncertainty of it: of traces, or of their rms where they mean
/// nothing.
fn panels(agreement: &Agreement) -> [Plotted; 4] {
    let (scatter, uncertainty) = (&agreement.scatter, &agreement.uncertainty);
    let [displacement, force] = if agreement.irregular {
        [
            (RMS, scatter.statistics.rms),
            (FORCE_RMS, scatter.force_statistics.rms),
        ]
    } else {
        [
            (DISPLACEMENT, uncertainty.displacement_relative),
            (FORCE, uncertainty.force_relative),
        ]
    };
    [
        (TIME, displacement.0, displacement.1),
        (EVALUATIONS, displacement.0, displacement.1),
        (STEPS, displacement.0, displacement.1),
        (TIME, force.0, force.1),
    ]
}

/// Points of a method from the loosest tolerance to the tightest.
fn measured<'a>(accuracy: &'a Accuracy, method: &'a str) -> impl Iterator<Item = &'a Measured> {
    let rows = accuracy.rows.iter().filter(move |row| row.method == method);
    rows.filter_map(|row| row.result.as_ref().ok())
}

/// Error over time, evaluations and steps, a curve a method; the uncertainty is a grey line.
fn methods_figure(title: &str, accuracy: &Accuracy) -> Figure {
    let mut methods: Vec<&str> = Vec::new();
    for row in &accuracy.rows {
        if !methods.contains(&row.method.as_str()) {
            methods.push(&row.method);
        }
    }
    let panels = panels(&accuracy.agreement).into_iter();
    let panels = panels.map(|plotted| methods_panel(accuracy, &methods, plotted));
    let names = methods.iter().enumerate().map(|(index, method)| Name {
        mark: Some(mark(index)),
        ..Name::new(*method, distinct(index))
    });
    let grey = if accuracy.agreement.irregular {
        "scatter of exact runs, which part company"
    } else {
        "uncertainty of the reference"
    };
    let figure = Figure::new("accuracy.svg", title, 2, panels.collect());
    figure.with_names(names.chain([Name::new(grey, GREY)]))
}

fn methods_panel(accuracy: &Accuracy, methods: &[&str], plotted: Plotted) -> Panel {
    let ((x_name, x), (y_name, y), uncertainty) = plotted;
    let all = || {
        accuracy
            .rows
            .iter()
            .filter_map(|row| row.result.as_ref().ok())
    };
    let x_axis = Axis::logarithmic(x_name, all().filter_map(x));
    let y_axis = Axis::logarithmic(y_name, all().filter_map(y));
    let ends = [x_axis.least(), x_axis.most()];
    let limit = Curve::line(GREY, ends.map(|end| (end, uncertainty)).to_vec());
    let curves = methods.iter().enumerate().map(|(index, method)| {
        let points = measured(accuracy, method).filter_map(|row| Some((x(row)?, y(row)?)));
        let points: Vec<_> = points.collect();
        Curve {
            mark: mark(index),
            marks: points.clone(),
            ..Curve::line(distinct(index), points)
        }
    });
    Panel {
        curves: std::iter::once(limit).chain(curves).collect(),
        ..Panel::new(x_axis, y_axis, HEIGHT)
    }
}

/// Curves beyond the colours that there are differ by their marks.
fn mark(index: usize) -> Mark {
    if index < COLOURS {
        Mark::Dot
    } else {
        Mark::Triangle
    }
}

/// A row a fidelity level: its cost to the left, its difference from the highest one to the right.
fn ladder_figure(title: &str, accuracy: &Accuracy) -> Figure {
    let rows = accuracy.ladder.rows.iter();
    let rows: Vec<&FidelityRow> = rows.filter(|row| row.result.is_ok()).collect();
    let cost = |row: &FidelityRow| {
        let (cost, _) = row.result.as_ref().ok()?;
        Some(MILLI * cost.seconds / accuracy.duration)
    };
    let difference = |row: &FidelityRow| {
        let (_, errors) = row.result.as_ref().ok()?;
        let difference = if accuracy.agreement.irregular {
            errors.statistics.rms
        } else {
            errors.displacement_relative
        };
        (difference > 0.0).then_some(difference)
    };
    let costs: Vec<_> = rows.iter().map(|row| cost(row)).collect();
    let differences: Vec<_> = rows.iter().map(|row| difference(row)).collect();
    let name = if accuracy.agreement.irregular {
        "difference of the rms from the top"
    } else {
        "vibration: rms difference from the top"
    };
    let levels = || rows.iter().map(|row| row.configuration.to_string());
    // the names stand once, to the left
    let blank = rows.iter().map(|_| String::new());
    let panels = vec![
        levels_panel("ms per simulated second", Axis::names(levels()), &costs, 0),
        levels_panel(name, Axis::names(blank), &differences, 1),
    ];
    Figure::new("ladder.svg", title, 2, panels)
}

/// A disc a level over one logarithmic axis; a level without a value has none.
fn levels_panel(name: &str, levels: Axis, values: &[Option<f64>], colour: usize) -> Panel {
    let axis = Axis::logarithmic(name, values.iter().flatten().copied());
    let height = RUNG_HEIGHT * values.len().max(1) as u32;
    let places = values.iter().enumerate();
    let places = places.filter_map(|(index, value)| Some(((*value)?, index as f64 + 0.5)));
    let discs = Curve {
        mark: Mark::Disc,
        ..Curve::dots(distinct(colour), places.collect())
    };
    Panel {
        curves: vec![discs],
        ..Panel::new(axis, levels, height)
    }
}
