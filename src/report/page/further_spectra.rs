//! The spectra that the scenario asks for besides.

use serde_json::Value;

use super::curve::{Panel, curve, prominent};
use crate::analysis::{Axis, EstimatedSpectrum, SpectrumKind};
use crate::report::spectra::{ShownColumns, shown_columns, shown_places};

/// A panel for every unit of a spectrum, shown up to `limit` in Hz.
pub(super) fn panels(spectrum: &EstimatedSpectrum, limit: f64) -> Vec<Value> {
    let groups = shown_columns(spectrum);
    let panels = groups.iter().map(|group| panel(spectrum, group, limit));
    panels.collect()
}

fn panel(spectrum: &EstimatedSpectrum, group: &ShownColumns<'_>, limit: f64) -> Value {
    let rows = prominent_rows(spectrum, group);
    let curves = group.columns.iter().map(|(name, column)| {
        let point = |row: &usize| (spectrum.place(*row), group.factor * column.values[*row]);
        curve(name, rows.iter().map(point))
    });
    let request = &spectrum.request;
    let unit = match request.axis {
        Axis::Frequency => request.axis.unit(),
        Axis::Order => "",
    };
    // a whirl has lines on both sides of zero
    let is_whirl = request.kind == SpectrumKind::Whirl;
    let panel = Panel {
        name: &request.name,
        unit: &group.unit,
        over: [request.axis.name(), unit],
        shown: (!is_whirl).then(|| shown_places(spectrum, limit).end),
        logarithmic: true,
    };
    panel.json(curves.collect(), Vec::new())
}

/// Rows to draw, the mean left out.
fn prominent_rows(spectrum: &EstimatedSpectrum, group: &ShownColumns<'_>) -> Vec<usize> {
    let rows = (0..spectrum.bins()).filter(|row| spectrum.place(*row) != 0.0);
    prominent(rows.collect(), |row| {
        let values = group.columns.iter().map(|(_, column)| column.values[row]);
        values.fold(0.0, f64::max)
    })
}
