//! `spectrum_<name>.svg`: a panel for every unit.

use super::shown::{ShownColumns, axis_text, shown_columns, shown_places};
use super::table_name;
use crate::analysis::{EstimatedSpectrum, SpectrumColumn};
use crate::report::figure::{Axis, Curve, Figure, Name, Panel, Point, distinct};

/// Height of a plot, px.
const HEIGHT: u32 = 340;

/// The spectrum up to `limit` in Hz.
pub(in crate::report) fn estimated_figure(
    title: &str,
    spectrum: &EstimatedSpectrum,
    limit: f64,
) -> Figure {
    let groups = shown_columns(spectrum);
    let panels = groups.iter().map(|group| panel(spectrum, group, limit));
    let file = format!("{}.svg", table_name(spectrum));
    let title = format!("{title}: {}", spectrum.request.name);
    Figure::new(&file, &title, 1, panels.collect())
}

fn panel(spectrum: &EstimatedSpectrum, group: &ShownColumns<'_>, limit: f64) -> Panel {
    let places = shown_places(spectrum, limit);
    let all = group.columns.iter();
    let values = all.flat_map(|(_, column)| points(spectrum, group, column));
    let strongest = values.fold(0.0, |most: f64, (_, value)| most.max(value));
    let scaling = spectrum.request.scaling.name().replace('_', " ");
    let columns = group.columns.iter().enumerate();
    let curves = columns.map(|(index, (_, column))| {
        let points = points(spectrum, group, column);
        Curve::envelope(
            distinct(index),
            points.filter(|(place, _)| places.contains(place)),
        )
    });
    Panel {
        names: Name::each(group.columns.iter().map(|(name, _)| name.as_str())),
        curves: curves.collect(),
        ..Panel::new(
            Axis::over(axis_text(spectrum.request.axis), places.clone()),
            Axis::below(format!("{scaling} in {}", group.unit), strongest),
            HEIGHT,
        )
    }
}

/// Places and values of a column but the mean.
fn points(
    spectrum: &EstimatedSpectrum,
    group: &ShownColumns<'_>,
    column: &SpectrumColumn,
) -> impl Iterator<Item = Point> {
    let all = column.values.iter().enumerate();
    let placed = all.map(|(row, value)| (spectrum.place(row), group.factor * value));
    placed.filter(|(place, _)| *place != 0.0)
}
