//! What a fit has found: values with their errors, what is computed against what was measured, and what is not known.

mod figures;
mod text;
mod warnings;

use serde_json::{Value, json};

use super::compare::overlay_figures;
use super::findings::document;
use super::terminal::Lines;
use super::variable::variable_column;
use super::{FileSet, Findings};
use crate::fit::{Fit, Minimum, Number, Observation, Unidentified, Unknown};
use crate::scenario::{Balance, FitFile};
use crate::table::Table;
use figures::{observations_figure, predictions, profiles_figure, residuals_figure};
use text::{tell, tell_balance};
use warnings::warnings;

/// A row of the observations, phases in degrees of one turn.
struct Row<'a> {
    name: &'a str,
    unit: &'a str,
    measured: f64,
    computed: f64,
    sigma: f64,
    /// Difference in standard deviations.
    residual: f64,
    /// Error of the computed number.
    error: f64,
}

/// What a fit has found by so many answers of the scene.
pub fn fit_findings(file: &FitFile, fit: &Fit, answers: u64) -> Findings {
    let balance = file.balance(&fit.values);
    let rows = rows(file, fit);
    let warnings = warnings(file, fit, &rows);
    let mut text = Lines::titled(&file.title);
    tell(&mut text, file, fit, &rows);
    text.detail("search", format!("{answers} answers of the scene"));
    tell_balance(&mut text, &balance);
    let mut tables = vec![
        ("fit_unknowns", unknowns_table(file, fit)),
        ("fit_observations", observations_table(&rows)),
        ("fit_minima", minima_table(file, fit)),
    ];
    if !fit.profiles.is_empty() {
        tables.push(("fit_profiles", profiles_table(file, fit)));
    }
    let (records, predicted) = predictions(file, fit);
    let mut figures = vec![
        observations_figure(&file.title, &rows),
        residuals_figure(&file.title, &rows),
    ];
    figures.extend(profiles_figure(file, fit));
    figures.extend(match records.is_empty() {
        true => Vec::new(),
        false => overlay_figures(&[vec![predicted], records].concat()),
    });
    let mut unknowns = tables[0].1.records();
    for (unknown, at_bound) in unknowns
        .as_array_mut()
        .into_iter()
        .flatten()
        .zip(&fit.at_bound)
    {
        unknown["at_bound"] = json!(at_bound);
    }
    let found = json!({
        "unknowns": unknowns,
        "correlations": fit.correlations.row_iter().map(|row| row.iter().copied().collect()).collect::<Vec<Vec<f64>>>(),
        "not_identified": fit.unidentified.iter().map(|one| unidentified_json(file, one)).collect::<Value>(),
        "chi_square": fit.chi_square,
        "degrees_of_freedom": fit.freedoms,
        "probability": fit.probability,
        "estimated_sigma": fit.estimated_sigma,
        "observations": tables[1].1.records(),
        "minima": tables[2].1.records(),
        "corrections": balance.iter().map(balance_json).collect::<Value>(),
        "complete": fit.is_complete,
        "warnings": warnings,
    });
    Findings {
        tables,
        figures,
        files: vec![("fitted.toml", file.fitted_toml(&fit.values).into_bytes())],
        incomplete: !fit.is_complete,
        ..Findings::of_document(
            FileSet::sealed("fit.json"),
            document(&file.title, &file.echo, found),
            text,
        )
    }
}

fn rows<'a>(file: &'a FitFile, fit: &'a Fit) -> Vec<Row<'a>> {
    let pairs = file
        .observations
        .iter()
        .zip(&fit.computed)
        .zip(&fit.residuals);
    let row = |((observation, computed), residual): ((&'a Observation, &'a Number), &f64)| {
        let scale = fit.estimated_sigma.unwrap_or(1.0);
        let sigma = scale * observation.sigma.unwrap_or_else(|| observation.scale());
        let (unit, factor) = match observation.wraps {
            true => ("deg", 1f64.to_degrees()),
            false => (&*observation.unit, 1.0),
        };
        Row {
            name: &observation.name,
            unit,
            measured: factor * observation.in_turn(observation.measured),
            computed: factor * observation.in_turn(computed.value),
            sigma: factor * sigma,
            residual: residual / scale,
            error: factor * computed.error,
        }
    };
    pairs.map(row).collect()
}

/// An unknown with its value, its standard error, and whether it is at a bound.
type Found<'a> = (&'a Unknown, f64, f64, bool);

fn found<'a>(file: &'a FitFile, fit: &'a Fit) -> Vec<Found<'a>> {
    let known = fit.values.iter().zip(&fit.errors).zip(&fit.at_bound);
    let pairs = file.unknowns.iter().zip(known);
    pairs
        .map(|(unknown, ((value, error), bound))| (unknown, *value, *error, *bound))
        .collect()
}

fn unknowns_table(file: &FitFile, fit: &Fit) -> Table<'static> {
    let found = found(file, fit);
    Table::from_items(&found)
        .word("key", |(unknown, ..)| &unknown.variable.key)
        .number("value", "", |(_, value, ..)| *value)
        .number("standard_error", "", |(_, _, error, _)| *error)
        .word("unit", |(unknown, ..)| &unknown.variable.unit)
        .number("from", "", |(unknown, ..)| unknown.range[0])
        .number("to", "", |(unknown, ..)| unknown.range[1])
        .number("start", "", |(unknown, ..)| unknown.start)
        .count("at_bound", |(.., bound)| f64::from(u8::from(*bound)))
        .end()
}

fn observations_table(rows: &[Row<'_>]) -> Table<'static> {
    Table::from_items(rows)
        .word("observation", |row| row.name)
        .number("measured", "", |row| row.measured)
        .number("computed", "", |row| row.computed)
        .word("unit", |row| row.unit)
        .number("sigma", "", |row| row.sigma)
        .number("residual", "", |row| row.residual)
        .number("numerical_error", "", |row| row.error)
        .end()
}

fn minima_table(file: &FitFile, fit: &Fit) -> Table<'static> {
    let table = Table::from_items(&fit.minima)
        .number("chi_square", "", |own| own.chi_square)
        .count("starts", |own| own.starts as f64);
    let keys = file.variables().enumerate();
    keys.fold(table, |table, (place, variable)| {
        let column = variable_column(variable);
        table.column(column, move |own: &Minimum| own.values[place])
    })
    .end()
}

fn profiles_table(file: &FitFile, fit: &Fit) -> Table<'static> {
    let points = fit.profiles.iter().flat_map(|profile| {
        let unknown = &file.unknowns[profile.unknown];
        profile.points.iter().map(move |point| (unknown, point))
    });
    let points: Vec<_> = points.collect();
    Table::from_items(&points)
        .word("key", |(unknown, _)| &unknown.variable.key)
        .number("value", "", |(_, point)| point[0])
        .word("unit", |(unknown, _)| &unknown.variable.unit)
        .number("chi_square_above_least", "", |(_, point)| point[1])
        .end()
}

fn balance_json(own: &Balance) -> Value {
    json!({
        "unbalance": own.plane + 1,
        "position_m": own.position,
        "mass_kg": own.mass,
        "radius_m": own.radius,
        "angle_rad": own.angle,
    })
}

fn unidentified_json(file: &FitFile, one: &Unidentified) -> Value {
    let parts = one.parts.iter().map(|(unknown, change)| {
        let variable = &file.unknowns[*unknown].variable;
        json!({ "key": variable.key, "change": change, "unit": variable.unit })
    });
    parts.collect()
}
