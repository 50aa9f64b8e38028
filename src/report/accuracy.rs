//! Speed against error: table for people, CSV, JSON and two figures.
//!
//! These files hold times, and so are the only ones that differ from one measurement to the next.

use super::figure::{Axis, COLOURS, Curve, Figure, GREY, Mark, Name, Panel, distinct};
use super::terminal::{Lines, MICRO, MILLI, or_dash, wrapped};
use super::{FileSet, Findings};
use crate::scenario::Scenario;
use crate::study::accuracy::{Accuracy, Agreement, Cost, Errors, Measured};
use crate::table::{Named, Table};

/// Reference, methods and ladder of a measurement.
pub fn accuracy_findings(scenario: &Scenario, accuracy: &Accuracy) -> Findings {
    let title = &scenario.title;
    let mut text = Lines::titled(title);
    add_reference(&mut text, &accuracy.agreement);
    add_methods(&mut text, accuracy);
    add_ladder(&mut text, accuracy);
    Findings {
        tables: vec![
            ("accuracy", methods_table(accuracy)),
            ("ladder", ladder_table(accuracy)),
        ],
        figures: vec![
            methods_figure(title, accuracy),
            ladder_figure(title, accuracy),
        ],
        ..Findings::new(FileSet::ACCURACY, scenario, accuracy, text)
    }
}

const ERRORS: [Named<Errors>; 11] = [
    ("displacement", "m", |errors| errors.displacement),
    ("displacement_relative", "", |errors| {
        errors.displacement_relative
    }),
    ("force", "N", |errors| errors.force),
    ("force_relative", "", |errors| errors.force_relative),
    ("lines_relative", "", |errors| {
        errors.lines.unwrap_or(f64::NAN)
    }),
    ("displacement_mean_relative", "", |errors| {
        errors.statistics.mean
    }),
    ("displacement_rms_relative", "", |errors| {
        errors.statistics.rms
    }),
    ("displacement_peak_relative", "", |errors| {
        errors.statistics.peak
    }),
    ("force_mean_relative", "", |errors| {
        errors.force_statistics.mean
    }),
    ("force_rms_relative", "", |errors| {
        errors.force_statistics.rms
    }),
    ("force_peak_relative", "", |errors| {
        errors.force_statistics.peak
    }),
];

/// Whole numbers of a cost.
const COUNTS: [Named<Cost>; 4] = [
    ("repeats", "", |cost| cost.repeats.into()),
    ("steps", "", |cost| cost.counters.steps as f64),
    ("rejected", "", |cost| cost.counters.rejected as f64),
    ("evaluations", "", |cost| cost.counters.evaluations as f64),
];

/// Methods × tolerances.
fn methods_table(accuracy: &Accuracy) -> Table<'static> {
    let rows = || accuracy.rows.iter();
    let measured = || rows().map(|row| row.result.as_ref().ok());
    let errors = measured().map(|measured| Some(&measured?.errors));
    let within = measured().map(|measured| Some(measured?.within_uncertainty));
    let notes = rows().map(|row| row.result.as_ref().err());
    let mut table = Table::default();
    table.words("method", rows().map(|row| &row.method));
    table.numbers("tolerance", "", rows().map(|row| row.tolerance));
    add_costs(&mut table, measured().map(|measured| Some(&measured?.cost)));
    table.named("error_", &ERRORS, errors);
    table.words("within_uncertainty", within.map(or_blank));
    table.words("note", notes.map(or_blank));
    table
}

/// The fidelity levels.
fn ladder_table(accuracy: &Accuracy) -> Table<'static> {
    let rows = || accuracy.ladder.rows.iter();
    let costs = rows().map(|row| Some(&row.result.as_ref().ok()?.0));
    let errors = rows().map(|row| Some(&row.result.as_ref().ok()?.1));
    let per_second = |cost: Option<&Cost>| Some(cost?.seconds / accuracy.duration);
    let notes = rows().map(|row| row.result.as_ref().err());
    let mut table = Table::default();
    table.words("model", rows().map(|row| &row.configuration));
    table.words("as_written", rows().map(|row| row.as_written));
    table.numbers(
        "wall_time_per_simulated_s",
        "",
        costs.clone().map(per_second),
    );
    add_costs(&mut table, costs);
    table.named("difference_", &ERRORS, errors);
    table.words("note", notes.map(or_blank));
    table
}

fn add_costs<'a>(table: &mut Table<'_>, costs: impl Iterator<Item = Option<&'a Cost>> + Clone) {
    table.numbers(
        "wall_time",
        "s",
        costs.clone().map(|cost| Some(cost?.seconds)),
    );
    for (name, _, count) in COUNTS {
        table.counts(name, costs.clone().map(|cost| cost.map(count)));
    }
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

fn add_methods(out: &mut Lines, accuracy: &Accuracy) {
    // of traces, or of statistics where traces mean nothing
    let (errors, mark, meaning) = match accuracy.agreement.irregular {
        true => (&STATISTICS, "≈", "within the scatter of exact runs"),
        false => (&TRACES, "≤", "not above the uncertainty of the reference"),
    };
    let first = [
        "method\n",
        "tolerance\n",
        "time\nms",
        "evaluations\n",
        "steps\n",
        "rejected\n",
    ];
    let rows = accuracy.rows.iter().filter_map(|row| {
        let measured = row.result.as_ref().ok()?;
        let counters = &measured.cost.counters;
        let mut cells = vec![
            row.method.clone(),
            format!("{:e}", row.tolerance),
            time(MILLI * measured.cost.seconds),
            counters.evaluations.to_string(),
            counters.steps.to_string(),
            counters.rejected.to_string(),
        ];
        cells.extend(errors.iter().map(|(_, cell)| cell(&measured.errors)));
        if measured.within_uncertainty {
            let error = &mut cells[first.len()];
            *error = format!("{mark} {error}");
        }
        Some(cells)
    });
    out.table(first.into_iter().chain(titles(errors)), rows);
    let mut measured = accuracy.rows.iter().flat_map(|row| &row.result);
    if measured.any(|measured| measured.within_uncertainty) {
        out.put(format!("{mark} {meaning}"));
    }
    for row in &accuracy.rows {
        if let Err(reason) = &row.result {
            let what = format!("{} at {:e}", row.method, row.tolerance);
            add_note(out, what, reason);
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

fn add_ladder(out: &mut Lines, accuracy: &Accuracy) {
    let errors = if accuracy.agreement.irregular {
        &SPREAD
    } else {
        &VIBRATION
    };
    let header = ["model, cage, freedoms\n", "\n", "ms per\nsimulated s"];
    let rows = &accuracy.ladder.rows;
    let cells = rows.iter().filter_map(|row| {
        let (cost, found) = row.result.as_ref().ok()?;
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
        let errors = errors.iter().map(|(_, cell)| cell(found));
        Some(cells.into_iter().chain(errors).collect())
    });
    out.table(header.into_iter().chain(titles(errors)), cells);
    out.put(
        "relative to the RMS vibration of the highest level after the settle time; position: of its mean",
    );
    for row in rows {
        if let Err(reason) = &row.result {
            add_note(out, row.configuration.to_string(), reason);
        }
    }
    out.put("");
}

fn titles(columns: &[ErrorColumn]) -> impl Iterator<Item = &'static str> {
    columns.iter().map(|(title, _)| *title)
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

/// Three significant digits, without a power of ten.
fn time(value: f64) -> String {
    let decimals = (2.0 - value.log10().floor()).clamp(0.0, 6.0) as usize;
    format!("{value:.decimals$}")
}

/// Height of a plot, px.
const HEIGHT: u32 = 320;
/// Height of a row, px.
const LEVEL_HEIGHT: u32 = 30;

/// Quantity on an axis and its name.
type Quantity = ((&'static str, &'static str), fn(&Measured) -> f64);

const TIME: Quantity = (("time of the integration", "ms"), |measured| {
    MILLI * measured.cost.seconds
});
const EVALUATIONS: Quantity = (("evaluations of the right-hand side", ""), |measured| {
    measured.cost.counters.evaluations as f64
});
const STEPS: Quantity = (("steps, accepted and rejected", ""), |measured| {
    let counters = &measured.cost.counters;
    (counters.steps + counters.rejected) as f64
});
const DISPLACEMENT: Quantity = (("error in displacement", ""), |measured| {
    measured.errors.displacement_relative
});
const FORCE: Quantity = (("error in force", ""), |measured| {
    measured.errors.force_relative
});
const RMS: Quantity = (("error in rms of displacement", ""), |measured| {
    measured.errors.statistics.rms
});
const FORCE_RMS: Quantity = (("error in rms of force", ""), |measured| {
    measured.errors.force_statistics.rms
});
/// What is plotted below and upwards, and the uncertainty of it.
type Plotted = (Quantity, Quantity, f64);

/// What is plotted over what, and the uncertainty of it: of traces, or of their rms where they mean
/// nothing.
fn plotted(agreement: &Agreement) -> [Plotted; 4] {
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

/// Error over time, evaluations and steps, a curve a method; the uncertainty is a grey line.
fn methods_figure(title: &str, accuracy: &Accuracy) -> Figure {
    let mut methods: Vec<&str> = Vec::new();
    for row in &accuracy.rows {
        if !methods.contains(&row.method.as_str()) {
            methods.push(&row.method);
        }
    }
    let panels = plotted(&accuracy.agreement).map(|what| methods_panel(accuracy, &methods, what));
    let names = methods.iter().enumerate().map(|(index, method)| Name {
        mark: Some(mark(index)),
        ..Name::new(*method, distinct(index))
    });
    let grey = if accuracy.agreement.irregular {
        "scatter of exact runs, which part company"
    } else {
        "uncertainty of the reference"
    };
    let figure = Figure::new("accuracy", title, 2, panels.to_vec());
    figure.with_names(names.chain([Name::new(grey, GREY)]))
}

fn methods_panel(accuracy: &Accuracy, methods: &[&str], plotted: Plotted) -> Panel {
    let ((x_name, x), (y_name, y), uncertainty) = plotted;
    let rows = || accuracy.rows.iter();
    let measured = || rows().filter_map(|row| row.result.as_ref().ok());
    let x_axis = Axis::logarithmic(x_name, measured().map(x));
    let y_axis = Axis::logarithmic(y_name, measured().map(y));
    let ends = [x_axis.least(), x_axis.most()];
    let limit = Curve::line(GREY, ends.map(|end| (end, uncertainty)).to_vec());
    let curves = methods.iter().enumerate().map(|(index, method)| {
        // from the loosest tolerance to the tightest
        let points = rows().filter(|row| row.method == *method);
        let points = points.filter_map(|row| row.result.as_ref().ok());
        let points: Vec<_> = points.map(|measured| (x(measured), y(measured))).collect();
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
    let levels = rows.filter_map(|row| Some((row.configuration, row.result.as_ref().ok()?)));
    let levels: Vec<_> = levels.collect();
    let cost = |cost: &Cost| MILLI * cost.seconds / accuracy.duration;
    let costs: Vec<f64> = levels.iter().map(|(_, found)| cost(&found.0)).collect();
    let (name, difference): (_, fn(&Errors) -> f64) = if accuracy.agreement.irregular {
        ("difference of the rms from the top", |errors| {
            errors.statistics.rms
        })
    } else {
        ("vibration: rms difference from the top", |errors| {
            errors.displacement_relative
        })
    };
    let differences: Vec<f64> = levels
        .iter()
        .map(|(_, found)| difference(&found.1))
        .collect();
    let names = levels.iter();
    let names = Axis::names(names.map(|(configuration, _)| configuration.to_string()));
    let panels = vec![
        levels_panel("ms per simulated second", names.clone(), &costs, 0),
        levels_panel(name, names, &differences, 1),
    ];
    Figure::new("ladder", title, 2, panels)
}

/// A disc a level over one logarithmic axis; a level whose value is zero has none.
fn levels_panel(name: &str, levels: Axis, values: &[f64], colour: usize) -> Panel {
    let axis = Axis::logarithmic(name, values.iter().copied());
    let height = LEVEL_HEIGHT * values.len().max(1) as u32;
    let places = values.iter().enumerate().filter(|(_, value)| **value > 0.0);
    let places = places.map(|(index, value)| (*value, index as f64 + 0.5));
    let discs = Curve {
        mark: Mark::Disc,
        ..Curve::dots(distinct(colour), places.collect())
    };
    Panel {
        curves: vec![discs],
        ..Panel::new(axis, levels, height)
    }
}
