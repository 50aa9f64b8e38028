//! Figures of speed against error: methods over time, evaluations and steps; rungs by cost and difference.

use crate::report::figure::{Axis, COLOURS, Curve, Figure, GREY, Mark, Name, Panel, distinct};
use crate::study::accuracy::{Accuracy, Agreement, LadderRow, Measured};

/// Height of a plot, px.
const HEIGHT: u32 = 320;
/// Height of a rung, px.
const RUNG_HEIGHT: u32 = 30;

/// Quantity on an axis and its name.
type Quantity = (&'static str, fn(&Measured) -> Option<f64>);

const TIME: Quantity = ("time of the integration in ms", |measured| {
    Some(1e3 * measured.cost.seconds)
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
const LINES: Quantity = ("error in labelled lines", |measured| measured.errors.lines);

/// What is plotted below and upwards, and the uncertainty of it.
type Plotted = (Quantity, Quantity, Option<f64>);

/// What is plotted over what, and the uncertainty of it: of traces, or of their rms where they mean
/// nothing.
fn panels(agreement: &Agreement) -> [Plotted; 5] {
    let (scatter, uncertainty) = (&agreement.scatter, &agreement.uncertainty);
    let (displacement, force) = if agreement.irregular {
        let limits = (scatter.statistics.rms, scatter.force_statistics.rms);
        ((RMS, Some(limits.0)), (FORCE_RMS, Some(limits.1)))
    } else {
        let limits = (
            uncertainty.displacement_relative,
            uncertainty.force_relative,
        );
        ((DISPLACEMENT, Some(limits.0)), (FORCE, Some(limits.1)))
    };
    [
        (TIME, displacement.0, displacement.1),
        (EVALUATIONS, displacement.0, displacement.1),
        (STEPS, displacement.0, displacement.1),
        (TIME, force.0, force.1),
        (TIME, LINES, uncertainty.lines),
    ]
}

/// Points of a method from the loosest tolerance to the tightest.
fn measured<'a>(accuracy: &'a Accuracy, method: &'a str) -> impl Iterator<Item = &'a Measured> {
    let rows = accuracy.rows.iter().filter(move |row| row.method == method);
    rows.filter_map(|row| row.result.as_ref().ok())
}

/// Error over time, evaluations and steps, a curve a method; the uncertainty is a grey line.
pub(super) fn methods(title: &str, accuracy: &Accuracy) -> Figure {
    let mut methods: Vec<&str> = Vec::new();
    for row in &accuracy.rows {
        if !methods.contains(&row.method.as_str()) {
            methods.push(&row.method);
        }
    }
    let panels = panels(&accuracy.agreement).into_iter();
    let panels = panels.map(|plotted| methods_panel(accuracy, &methods, plotted));
    let words = Panel {
        words: reading(accuracy),
        ..Panel::default()
    };
    let names = methods.iter().enumerate().map(|(index, method)| Name {
        mark: Some(mark(index)),
        ..Name::new(*method, distinct(index))
    });
    let figure = Figure::new("accuracy.svg", title, 2, panels.chain([words]).collect());
    figure.with_names(names)
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
    let limit = uncertainty.map(|limit| {
        let ends = [x_axis.least(), x_axis.most()];
        Curve::line(GREY, ends.map(|end| (end, limit)).to_vec())
    });
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
        curves: limit.into_iter().chain(curves).collect(),
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

/// What the figure rests on, in words.
fn reading(accuracy: &Accuracy) -> Vec<String> {
    let agreement = &accuracy.agreement;
    let (method, tolerance) = &agreement.reference;
    let (other, tightness) = &agreement.other;
    let grey = if agreement.irregular {
        "Grey line: scatter of exact runs, which part company here."
    } else {
        "Grey line: distance of the two, the uncertainty."
    };
    vec![
        format!("Reference: {method} at {tolerance:e},"),
        format!("compared with {other} at {tightness:e}."),
        grey.to_owned(),
        format!("Motion: {:.4} µm.", 1e6 * agreement.scale.displacement),
        "Errors are relative to it, those of forces to their change,".to_owned(),
        "those of lines to each line.".to_owned(),
        "Along a curve, the tolerance falls.".to_owned(),
    ]
}

/// A row a rung: its cost to the left, its difference from the top rung to the right.
pub(super) fn ladder(title: &str, accuracy: &Accuracy) -> Figure {
    let rows = accuracy.ladder.rows.iter();
    let rows: Vec<&LadderRow> = rows.filter(|row| row.result.is_ok()).collect();
    let cost = |row: &LadderRow| {
        let (cost, _) = row.result.as_ref().ok()?;
        Some(1e3 * cost.seconds / accuracy.duration)
    };
    let difference = |row: &LadderRow| {
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
    let rungs = || rows.iter().map(|row| row.configuration.to_string());
    // the names stand once, to the left
    let blank = rows.iter().map(|_| String::new());
    let panels = vec![
        rungs_panel("ms per simulated second", Axis::names(rungs()), &costs, 0),
        rungs_panel(name, Axis::names(blank), &differences, 1),
    ];
    Figure::new("ladder.svg", title, 2, panels)
}

/// A disc a rung over one logarithmic axis; a rung without a value has none.
fn rungs_panel(name: &str, rungs: Axis, values: &[Option<f64>], colour: usize) -> Panel {
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
        ..Panel::new(axis, rungs, height)
    }
}
