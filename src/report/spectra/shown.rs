//! What figures and pages show of a spectrum: its powers or amplitudes, unit by unit.

use std::ops::Range;

use super::names;
use crate::analysis::{Axis, EstimatedSpectrum, SpectrumColumn, SpectrumKind, SpectrumQuantity};
use crate::report::terminal::MICRO;

/// Columns of one unit.
#[derive(Debug)]
pub(in crate::report) struct ShownColumns<'a> {
    /// Unit that they are shown in.
    pub unit: String,
    /// How many of it make one of the column's.
    pub factor: f64,
    /// Each with its name.
    pub columns: Vec<(String, &'a SpectrumColumn)>,
}

/// The columns but phases and coherences, those of one unit together.
pub(in crate::report) fn shown_columns(spectrum: &EstimatedSpectrum) -> Vec<ShownColumns<'_>> {
    let mut groups = Vec::<ShownColumns<'_>>::new();
    for column in &spectrum.columns {
        let Some(name) = name(column.quantity) else {
            continue;
        };
        let (unit, factor) = shown_unit(names::unit(spectrum, column.quantity));
        match groups.iter_mut().find(|group| group.unit == unit) {
            Some(group) => group.columns.push((name, column)),
            None => groups.push(ShownColumns {
                unit,
                factor,
                columns: vec![(name, column)],
            }),
        }
    }
    groups
}

/// Places that are shown at first: those that lines are found at, `limit` in Hz, if the axis has any.
pub(in crate::report) fn shown_places(spectrum: &EstimatedSpectrum, limit: f64) -> Range<f64> {
    let last = spectrum.place(spectrum.bins().saturating_sub(1));
    let limit = match spectrum.request.axis {
        Axis::Frequency => limit,
        Axis::Order if spectrum.shaft_frequency > 0.0 => limit / spectrum.shaft_frequency,
        Axis::Order => f64::INFINITY,
    };
    let end = limit.min(last);
    match spectrum.request.kind {
        SpectrumKind::Whirl => spectrum.place(0).max(-end)..end,
        _ => 0.0..end,
    }
}

/// What the axis says.
pub(in crate::report) fn axis_text(axis: Axis) -> &'static str {
    match axis {
        Axis::Frequency => "frequency in Hz",
        Axis::Order => "order",
    }
}

fn name(quantity: SpectrumQuantity) -> Option<String> {
    match quantity {
        SpectrumQuantity::Value(channel) => Some(channel.name().to_owned()),
        SpectrumQuantity::Rotary(x, y) => Some(format!("{x} + i {y}")),
        SpectrumQuantity::Cross(reference, other) => Some(format!("{reference} to {other}")),
        SpectrumQuantity::Phase(_)
        | SpectrumQuantity::CrossPhase(..)
        | SpectrumQuantity::Coherence(..) => None,
    }
}

fn shown_unit(unit: String) -> (String, f64) {
    match unit.as_str() {
        "m" => ("µm".to_owned(), MICRO),
        "rad" => ("µrad".to_owned(), MICRO),
        _ => (unit.replace("^2", "²"), 1.0),
    }
}
