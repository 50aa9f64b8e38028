//! `spectrum_<name>.svg`: a panel for every unit.

use plotters::prelude::*;

use super::shown::{ShownColumns, axis_text, shown_columns, shown_places};
use crate::analysis::{EstimatedSpectrum, SpectrumColumn};
use crate::report::figure::{Area, CURVE_BUCKETS, DrawError, LINE, PALETTE, svg};
use crate::report::figure_lines::{amplitude_range, draw_legend, legend_stroke, line_chart};
use crate::report::{Bucket, Decimator, ReportError};

/// Height of a panel, px.
const PANEL_HEIGHT: u32 = 420;
/// Height of the title, px.
const HEAD_HEIGHT: u32 = 40;

/// Draws the spectrum, up to `limit` in Hz.
pub(in crate::report) fn estimated_figure(
    title: &str,
    spectrum: &EstimatedSpectrum,
    limit: f64,
) -> Result<String, ReportError> {
    let groups = shown_columns(spectrum);
    let height = HEAD_HEIGHT + PANEL_HEIGHT * groups.len() as u32;
    let title = format!("{title}: {}", spectrum.request.name);
    svg("spectrum_<name>.svg", height, &title, |area| {
        let panels = area.split_evenly((groups.len(), 1));
        groups
            .iter()
            .zip(&panels)
            .try_for_each(|(group, panel)| draw(panel, spectrum, group, limit))
    })
}

fn draw(
    area: &Area,
    spectrum: &EstimatedSpectrum,
    group: &ShownColumns<'_>,
    limit: f64,
) -> Result<(), DrawError> {
    let places = shown_places(spectrum, limit);
    let values = amplitude_range(strongest(spectrum, group));
    let floor = values.start;
    let scaling = spectrum.request.scaling.name().replace('_', " ");
    let upright = format!("{scaling} in {}", group.unit);
    let below = axis_text(spectrum.request.axis);
    let mut chart = line_chart(area, places.clone(), values, [below, &upright])?;
    for ((name, column), colour) in group.columns.iter().zip(PALETTE.iter().cycle()) {
        let mut envelope = Decimator::new(CURVE_BUCKETS);
        for (place, value) in points(spectrum, column) {
            if places.contains(&place) {
                envelope.push(place, (group.factor * value).max(floor));
            }
        }
        let buckets = envelope.buckets();
        let curve = buckets.flat_map(|Bucket { first, last }| [first, last]);
        chart
            .draw_series(LineSeries::new(curve, colour.stroke_width(LINE)))?
            .label(name)
            .legend(|from| legend_stroke(from, *colour));
    }
    draw_legend(&mut chart)
}

/// Places and values of a column but the mean.
fn points(
    spectrum: &EstimatedSpectrum,
    column: &SpectrumColumn,
) -> impl Iterator<Item = (f64, f64)> {
    let all = column.values.iter().enumerate();
    let placed = all.map(|(row, value)| (spectrum.place(row), *value));
    placed.filter(|(place, _)| *place != 0.0)
}

fn strongest(spectrum: &EstimatedSpectrum, group: &ShownColumns<'_>) -> f64 {
    let columns = group.columns.iter();
    let values = columns.flat_map(|(_, column)| points(spectrum, column));
    values.fold(0.0, |largest: f64, (_, value)| {
        largest.max(group.factor * value)
    })
}
