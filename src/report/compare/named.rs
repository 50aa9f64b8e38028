//! The lines that the documents of runs and records hold, with their names, amplitudes in one unit.

use std::collections::HashSet;
use std::path::Path;

use serde_json::Value;

use super::lines::{Line, Lines};
use super::{CompareError, LinesBy};
use crate::analysis::velocity_rate;
use crate::table::Column;

/// Frequency of the shaft of a result, Hz.
///
/// # Errors
/// [`CompareError::NoNames`] where its speed is not known, or changes.
pub(super) fn shaft(path: &Path, document: &Value) -> Result<f64, CompareError> {
    let frequency = number(&document["spectrum"]["shaft_frequency_Hz"]);
    match frequency > 0.0 {
        true => Ok(frequency),
        false => Err(CompareError::NoNames {
            path: path.to_owned(),
            what: "frequency of the shaft",
        }),
    }
}

/// The peaks of a result and the lines of its envelopes, those of one unit together: displacements, velocities and accelerations as
/// velocities; by name the strongest of every name.
///
/// # Errors
/// As [`shaft`], by order.
pub(super) fn quantities<'a>(
    path: &'a Path,
    document: &Value,
    by: LinesBy,
) -> Result<Vec<Lines<'a>>, CompareError> {
    let hertz = match by {
        LinesBy::Order => shaft(path, document)?,
        _ => 1.0,
    };
    let bin = number(&document["spectrum"]["resolution_Hz"]) / hertz;
    let peaks = entries(&document["peaks"]).map(|peak| {
        let (at, unit) = (number(&peak["f_Hz"]), text(&peak["unit"]));
        let rate = velocity_rate(unit).map(|rate| rate(at));
        let rate = rate.or((unit == "m/s").then_some(1.0));
        let (of, unit) = match rate {
            Some(_) => ("velocity", "m/s"),
            None => ("spectrum", unit),
        };
        let amplitude = rate.unwrap_or(1.0) * number(&peak["amplitude"]);
        let column = Column::measure(of, "amplitude", unit.to_owned());
        (column, bin, line(peak, at / hertz, amplitude))
    });
    let envelopes = entries(&document["spectra"]).flat_map(|spectrum| {
        let is_over_orders = spectrum["over"] == "order";
        let (hertz, resolution) = match is_over_orders {
            true => (1.0, "resolution_orders"),
            false => (hertz, "resolution_Hz"),
        };
        let bin = number(&spectrum[resolution]) / hertz;
        let lines = entries(&spectrum["lines"]);
        let lines = lines.filter(move |_| by != LinesBy::Frequency || !is_over_orders);
        lines.map(move |found| {
            let own = Column::from_name(text(&found["column"]));
            let column = Column {
                quantity: "envelope".into(),
                ..own
            };
            let at = number(&found["at"]) / hertz;
            (column, bin, line(found, at, number(&found["value"])))
        })
    });
    let mut groups: Vec<(Column, f64, Vec<Line>)> = Vec::new();
    for (column, bin, line) in peaks.chain(envelopes) {
        match groups.iter_mut().find(|(known, ..)| *known == column) {
            Some((_, _, lines)) => lines.push(line),
            None => groups.push((column, bin, vec![line])),
        }
    }
    let lines = groups.into_iter().map(|(column, bin, lines)| {
        let mut found = Lines::new(column, path, lines, bin);
        if by == LinesBy::Name {
            let mut seen = HashSet::new();
            found
                .lines
                .retain(|line| line.name.is_some() && seen.insert(line.name.clone()));
        }
        found
    });
    Ok(lines.filter(|found| !found.lines.is_empty()).collect())
}

/// The line of an entry of a document.
fn line(entry: &Value, at: f64, amplitude: f64) -> Line {
    let name = Some(text(&entry["name"])).filter(|name| !name.is_empty());
    Line {
        at,
        amplitude,
        name: name.map(str::to_owned),
    }
}

fn entries(list: &Value) -> impl Iterator<Item = &Value> {
    list.as_array().into_iter().flatten()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or(0.0)
}

fn text(value: &Value) -> &str {
    value.as_str().unwrap_or_default()
}
