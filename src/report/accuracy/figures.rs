//! Figures of accuracy: error over time of methods, and of levels of the physics.

use crate::report::figure::{Axis, COLOURS, Curve, Figure, GREY, Mark, Name, Panel, distinct};
use crate::report::terminal::shown_column;
use crate::study::accuracy::Agreement;
use crate::table::{ColumnKind, Table};

/// Height of a plot, px.
const HEIGHT: u32 = 320;

/// Height of a row, px.
const LEVEL_HEIGHT: u32 = 30;

/// A quantity of errors, and the uncertainty of it.
type Uncertain = (&'static str, f64);

/// What is plotted over what: errors of traces, or of their rms where they mean nothing.
fn plotted(agreement: &Agreement) -> [(&'static str, Uncertain); 4] {
    let (scatter, uncertainty) = (&agreement.scatter, &agreement.uncertainty);
    let [displacement, force] = match agreement.irregular {
        true => [
            ("error_displacement_rms_relative", scatter.statistics.rms),
            ("error_force_rms_relative", scatter.force_statistics.rms),
        ],
        false => [
            (
                "error_displacement_relative",
                uncertainty.displacement_relative,
            ),
            ("error_force_relative", uncertainty.force_relative),
        ],
    };
    [
        ("wall_time", displacement),
        ("evaluations", displacement),
        ("steps", displacement),
        ("wall_time", force),
    ]
}

/// Error over time, evaluations and steps, a curve a method; the uncertainty is a grey line.
pub(super) fn methods_figure(title: &str, agreement: &Agreement, table: &Table<'_>) -> Figure {
    let panels = plotted(agreement);
    let panels = panels
        .into_iter()
        .filter_map(|(x, y)| methods_panel(table, x, y));
    let methods = methods(table).iter().enumerate();
    let names = methods.map(|(index, method)| Name {
        mark: Some(mark(index)),
        ..Name::new(method, distinct(index))
    });
    let grey = match agreement.irregular {
        true => "scatter of exact runs, which part company",
        false => "uncertainty of the reference",
    };
    let figure = Figure::new("accuracy", title, 2, panels.collect());
    figure.with_names(names.chain([Name::new(grey, GREY)]))
}

/// Names of the methods, as the table numbers them.
fn methods<'a>(table: &'a Table<'_>) -> &'a [String] {
    match table.column("method").map(|(column, _)| &column.kind) {
        Some(ColumnKind::Word(methods)) => methods,
        _ => &[],
    }
}

fn methods_panel(table: &Table<'_>, x: &str, (y, uncertainty): Uncertain) -> Option<Panel> {
    let (_, methods_of_rows) = table.column("method")?;
    let [(x, xs), (y, ys)] = [table.column(x)?, table.column(y)?];
    let [x_axis, y_axis] = [(x, xs), (y, ys)].map(|(column, values)| {
        let (label, factor) = shown_column(column);
        Axis::logarithmic(label, values.iter().map(|value| factor * value))
    });
    let ends = [x_axis.least(), x_axis.most()];
    let limit = Curve::line(GREY, ends.map(|end| (end, uncertainty)).to_vec());
    let curves = (0..methods(table).len()).map(|index| {
        // from the loosest tolerance to the tightest
        let own = methods_of_rows.iter().zip(xs.iter().zip(ys));
        let own = own.filter(|(method, (x, _))| **method == index as f64 && x.is_finite());
        let points: Vec<_> = own.map(|(_, (x, y))| (*x, *y)).collect();
        Curve {
            mark: mark(index),
            marks: points.clone(),
            ..Curve::line(distinct(index), points)
        }
    });
    Some(Panel {
        curves: std::iter::once(limit).chain(curves).collect(),
        ..Panel::new(x_axis, y_axis, HEIGHT)
    })
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
pub(super) fn ladder_figure(title: &str, agreement: &Agreement, table: &Table<'_>) -> Figure {
    let difference = match agreement.irregular {
        true => "difference_displacement_rms_relative",
        false => "difference_displacement_relative",
    };
    let shown = ["wall_time_per_simulated_s", difference].into_iter();
    let shown = shown.enumerate();
    let panels = shown.filter_map(|(index, quantity)| levels_panel(table, quantity, index));
    Figure::new("ladder", title, 2, panels.collect())
}

/// A disc a level over one logarithmic axis; a level whose value is zero has none.
fn levels_panel(table: &Table<'_>, quantity: &str, colour: usize) -> Option<Panel> {
    let ((models, levels), (column, values)) = (table.column("model")?, table.column(quantity)?);
    let known = levels.iter().zip(values.iter().copied());
    let known: Vec<_> = known.filter(|(_, value)| value.is_finite()).collect();
    let names = known
        .iter()
        .map(|(level, _)| models.kind.word(**level).to_owned());
    let axis = Axis::logarithmic(
        shown_column(column).0,
        known.iter().map(|(_, value)| *value),
    );
    let places = known
        .iter()
        .enumerate()
        .filter(|(_, (_, value))| *value > 0.0);
    let places = places.map(|(index, (_, value))| (*value, index as f64 + 0.5));
    let discs = Curve {
        mark: Mark::Disc,
        ..Curve::dots(distinct(colour), places.collect())
    };
    Some(Panel {
        curves: vec![discs],
        ..Panel::new(
            axis,
            Axis::names(names),
            LEVEL_HEIGHT * known.len().max(1) as u32,
        )
    })
}
