//! Compares results by the names of their lines, each at its own frequency: BPFO to BPFO, also of a record and a simulation.

use std::fmt;
use std::path::Path;

use serde_json::{Value, json};

use super::{CompareError, sealed};
use crate::analysis::velocity_rate;
use crate::report::terminal::{Lines, MILLI, digits, or_dash, shown_unit};
use crate::table::Column;

/// A line with a name, the strongest of it.
#[derive(Debug, Clone, PartialEq)]
struct NamedLine {
    /// What it is of: `velocity`, `envelope`, or the unit of what makes no velocity.
    of: String,
    name: String,
    /// Hz, or multiples of the shaft.
    at: f64,
    /// In SI units.
    value: f64,
    unit: String,
}

/// The lines of two results by their names.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct NamedComparison {
    /// Each with those of both results.
    rows: Vec<[Option<NamedLine>; 2]>,
    /// How far lines may be apart, dB.
    within: f64,
    /// Leaves out lines that one of them has alone.
    common: bool,
}

/// Compares the named lines of two folders, of runs or of records; amplitudes of displacements, velocities and accelerations as
/// velocities.
///
/// # Errors
/// [`CompareError::Unsealed`] of a folder without a result.
pub(crate) fn compare_named(
    first: &Path,
    second: &Path,
    within: f64,
    common: bool,
) -> Result<NamedComparison, CompareError> {
    let [first, mut second] = [named_lines(&sealed(first)?), named_lines(&sealed(second)?)];
    let mut rows = Vec::new();
    for line in first {
        let alike = |other: &NamedLine| other.of == line.of && other.name == line.name;
        let partner = second.iter().position(alike);
        let partner = partner.map(|place| second.remove(place));
        rows.push([Some(line), partner]);
    }
    rows.extend(second.into_iter().map(|line| [None, Some(line)]));
    rows.retain(|row| !common || row.iter().all(Option::is_some));
    Ok(NamedComparison {
        rows,
        within,
        common,
    })
}

/// The strongest line of every name, of peaks and then of envelopes, the strongest first.
fn named_lines(document: &Value) -> Vec<NamedLine> {
    let entries = |list: &Value| list.as_array().cloned().unwrap_or_default();
    let number = |value: &Value| value.as_f64().unwrap_or(0.0);
    let peaks = entries(&document["peaks"]).into_iter().filter_map(|peak| {
        let (name, unit) = (peak["name"].as_str()?.to_owned(), peak["unit"].as_str()?);
        let (at, value) = (number(&peak["f_Hz"]), number(&peak["amplitude"]));
        let rate = velocity_rate(unit).map(|rate| rate(at));
        let rate = rate.or((unit == "m/s").then_some(1.0));
        Some(NamedLine {
            of: if rate.is_some() { "velocity" } else { unit }.to_owned(),
            name,
            at,
            value: rate.unwrap_or(1.0) * value,
            unit: if rate.is_some() { "m/s" } else { unit }.to_owned(),
        })
    });
    let envelopes = entries(&document["spectra"]).into_iter();
    let envelopes = envelopes.flat_map(|spectrum| entries(&spectrum["lines"]));
    let envelopes = envelopes.filter_map(|line| {
        let column = Column::from_name(line["column"].as_str()?);
        Some(NamedLine {
            of: format!("envelope {}", column.unit),
            name: line["name"].as_str()?.to_owned(),
            at: number(&line["at"]),
            value: number(&line["value"]),
            unit: column.unit.into_owned(),
        })
    });
    let mut lines: Vec<NamedLine> = peaks.chain(envelopes).collect();
    lines.sort_by(|a, b| {
        let kinds =
            a.of.starts_with("envelope")
                .cmp(&b.of.starts_with("envelope"));
        kinds
            .then(a.of.cmp(&b.of))
            .then(b.value.total_cmp(&a.value))
    });
    let mut seen = Vec::new();
    lines.retain(|line| {
        let key = (line.of.clone(), line.name.clone());
        let is_new = !seen.contains(&key);
        seen.push(key);
        is_new
    });
    lines
}

/// By how much the second of two lines is higher, dB.
fn decibels([first, second]: &[Option<NamedLine>; 2]) -> Option<f64> {
    Some(20.0 * (second.as_ref()?.value / first.as_ref()?.value).log10())
}

impl NamedComparison {
    /// Whether every line of both is as high within the limit, and none is alone.
    pub fn agrees(&self) -> bool {
        let near = |row| decibels(row).is_some_and(|apart| apart.abs() <= self.within);
        !self.rows.is_empty() && self.rows.iter().all(near)
    }

    /// As a document.
    pub fn to_json(&self) -> Value {
        let line = |line: &Option<NamedLine>| {
            line.as_ref()
                .map(|line| json!({ "at": line.at, "value": line.value }))
        };
        let rows = self.rows.iter().map(|row| {
            let known = row.iter().flatten().next();
            json!({
                "name": known.map(|line| &line.name),
                "of": known.map(|line| &line.of),
                "unit": known.map(|line| &line.unit),
                "first": line(&row[0]),
                "second": line(&row[1]),
                "difference_dB": decibels(row),
            })
        });
        json!({
            "agrees": self.agrees(),
            "within_dB": self.within,
            "common": self.common,
            "lines": rows.collect::<Value>(),
        })
    }
}

/// A table of the lines, and whether they agree.
impl fmt::Display for NamedComparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut out = Lines::default();
        let header = [
            "line",
            "of",
            "first at",
            "amplitude",
            "second at",
            "amplitude",
            "dB",
        ];
        let rows = self.rows.iter().filter_map(|row| {
            let known = row.iter().flatten().next()?;
            let (unit, factor) = match &*known.unit {
                "m/s" => ("mm/s".to_owned(), MILLI),
                unit => shown_unit(unit),
            };
            let cells = row.iter().flat_map(|line| {
                let cell = |value: fn(&NamedLine) -> f64, factor: f64, unit: &str| {
                    let text = |line| format!("{} {unit}", digits(factor * value(line)));
                    or_dash(
                        line.as_ref()
                            .map(text)
                            .map(|text| text.trim_end().to_owned()),
                    )
                };
                [
                    cell(|line| line.at, 1.0, ""),
                    cell(|line| line.value, factor, &unit),
                ]
            });
            let of = known.of.split(' ').next().unwrap_or_default().to_owned();
            let apart = or_dash(decibels(row).map(|apart| format!("{apart:+.1}")));
            let names = [known.name.clone(), of];
            Some(names.into_iter().chain(cells).chain([apart]).collect())
        });
        out.table(header, rows);
        write!(f, "{}", out.text(false))?;
        match self.agrees() {
            true => write!(f, "equal within {} dB", self.within),
            false if self.rows.is_empty() => write!(f, "no line of both has a name"),
            false => write!(
                f,
                "different by more than {} dB, or lines of one of them alone",
                self.within
            ),
        }
    }
}
