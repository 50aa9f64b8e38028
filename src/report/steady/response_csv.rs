//! `response.csv`: one row a motion of a branch; `response_specials.csv`: one row a place where it turns
//! or changes its kind.

use std::io::{self, Write};

use super::super::study::column_name;
use crate::steady::{Response, ResponsePoint};
use crate::study::Variable;

/// Writes every motion of every branch, in their order along it.
pub(super) fn points(
    variable: &Variable,
    branches: &[Response],
    writer: impl Write,
) -> io::Result<()> {
    let rows = branches.iter().enumerate().flat_map(|(number, branch)| {
        let points = branch.points.iter();
        points.map(move |point| (number, branch.multiple, "", point))
    });
    write(variable, branches, false, rows, writer)
}

/// Writes where branches turn or their motions change their kind.
pub(super) fn specials(
    variable: &Variable,
    branches: &[Response],
    writer: impl Write,
) -> io::Result<()> {
    let kinds: Vec<(usize, u32, String, &ResponsePoint)> = branches
        .iter()
        .enumerate()
        .flat_map(|(number, branch)| {
            let specials = branch.specials.iter();
            specials.map(move |special| {
                (
                    number,
                    branch.multiple,
                    special.kind.to_string(),
                    &special.point,
                )
            })
        })
        .collect();
    let rows = kinds
        .iter()
        .map(|(number, multiple, kind, point)| (*number, *multiple, kind.as_str(), *point));
    write(variable, branches, true, rows, writer)
}

fn write<'a>(
    variable: &Variable,
    branches: &[Response],
    kinds: bool,
    rows: impl Iterator<Item = (usize, u32, &'a str, &'a ResponsePoint)>,
    writer: impl Write,
) -> io::Result<()> {
    let mut csv = csv::WriterBuilder::new()
        .has_headers(false)
        .flexible(true)
        .from_writer(writer);
    csv.write_record(header(variable, branches, kinds))?;
    for (number, multiple, kind, point) in rows {
        let mut row = vec![(number + 1).to_string(), multiple.to_string()];
        if kinds {
            row.push(kind.to_owned());
        }
        row.push(point.value.to_string());
        row.push(point.period.to_string());
        row.push(u8::from(point.stable).to_string());
        for swing in &point.swings {
            row.extend([swing.mean, swing.peak_to_peak, swing.rms].map(|value| value.to_string()));
        }
        for multiplier in &point.multipliers {
            row.extend([multiplier.re, multiplier.im].map(|value| value.to_string()));
        }
        csv.write_record(row)?;
    }
    csv.flush()
}

fn header(variable: &Variable, branches: &[Response], kinds: bool) -> Vec<String> {
    let mut names = vec!["branch".to_owned(), "multiple".to_owned()];
    if kinds {
        names.push("kind".to_owned());
    }
    names.push(column_name(variable));
    names.extend(["period_s", "stable"].map(str::to_owned));
    let Some(point) = branches.first().and_then(|branch| branch.points.first()) else {
        return names;
    };
    for swing in &point.swings {
        let column = swing.channel.column();
        let (name, unit) = column.split_at(swing.channel.name().len());
        names.extend(["mean", "peak_to_peak", "rms"].map(|what| format!("{name}_{what}{unit}")));
    }
    for number in 1..=point.multipliers.len() {
        names.extend(["re", "im"].map(|part| format!("multiplier_{number}_{part}")));
    }
    names
}
