//! What a fit has found: values with their errors, what is computed beside what was measured, and what is not known.

use serde_json::{Value, json};

use super::compare::{Overlay, overlay_figures};
use super::figure::{Axis, Curve, Figure, GREY, Mark, Name, Panel, distinct};
use super::findings::document;
use super::terminal::{Lines, digits, shown_unit, to_digits};
use super::variable::{axis_label, shown};
use super::{FileSet, Findings};
use crate::analysis::Channel;
use crate::fit::{Fit, Minimum, Number, Observation, Unidentified, Unknown, Wanted};
use crate::scenario::{Balance, FitFile, Output};
use crate::steady::SteadyLines;
use crate::study::Variable;
use crate::table::{Column, Table};

/// Height of plots, px.
const HEIGHT: u32 = 250;
/// Part of a standard deviation from which on the error of a computed number is worth a warning.
const NUMERICAL: f64 = 0.1;
/// Minima whose χ² is no further above the lowest explain the data as well, to two standard errors.
const AS_GOOD: f64 = 4.0;
/// A probability of χ² below the first tells against the model, one above the second against the standard deviations.
const DOUBTFUL: [f64; 2] = [0.01, 0.99];
/// Correlations from which on values are told to be known together only.
const CORRELATED: f64 = 0.95;

/// A row of the observations.
struct Row<'a> {
    observation: &'a Observation,
    computed: &'a Number,
    residual: f64,
    sigma: f64,
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
    let mut figures = vec![residuals_figure(&file.title, &rows)];
    figures.extend(profiles_figure(file, fit));
    figures.extend(match records.is_empty() {
        true => Vec::new(),
        false => overlay_figures(&[vec![predicted], records].concat()),
    });
    let found = json!({
        "unknowns": tables[0].1.records(),
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
        set: FileSet::sealed("fit.json"),
        output: Output::default(),
        tables,
        long_tables: Vec::new(),
        figures,
        film: None,
        files: vec![("fitted.toml", file.fitted_toml(&fit.values))],
        document: document(&file.title, &file.echo, found),
        text,
        incomplete: !fit.is_complete,
    }
}

fn rows<'a>(file: &'a FitFile, fit: &'a Fit) -> Vec<Row<'a>> {
    let pairs = file
        .observations
        .iter()
        .zip(&fit.computed)
        .zip(&fit.residuals);
    let row = |((observation, computed), residual): ((&'a Observation, &'a Number), &f64)| {
        // what fits to round-off has no scatter
        let scale = fit.estimated_sigma.unwrap_or(1.0).max(f64::EPSILON);
        Row {
            observation,
            computed,
            residual: residual / scale,
            sigma: scale * observation.sigma.unwrap_or_else(|| observation.scale()),
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
    Table::of(&found)
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
    Table::of(rows)
        .word("observation", |row| &row.observation.name)
        .number("measured", "", |row| row.observation.measured)
        .number("computed", "", |row| row.computed.value)
        .word("unit", |row| &row.observation.unit)
        .number("sigma", "", |row| row.sigma)
        .number("residual", "", |row| row.residual)
        .number("numerical_error", "", |row| row.computed.error)
        .end()
}

fn minima_table(file: &FitFile, fit: &Fit) -> Table<'static> {
    let table = Table::of(&fit.minima)
        .number("chi_square", "", |own| own.chi_square)
        .count("starts", |own| own.starts as f64);
    let keys = file.variables().enumerate();
    keys.fold(table, |table, (place, variable)| {
        let column = super::variable::variable_column(variable);
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
    Table::of(&points)
        .word("key", |(unknown, _)| &unknown.variable.key)
        .number("value", "", |(_, point)| point[0])
        .word("unit", |(unknown, _)| &unknown.variable.unit)
        .number("chi_square_above_least", "", |(_, point)| point[1])
        .end()
}

/// A value with its standard error in the unit that it was written in.
fn with_error(variable: &Variable, value: f64, error: f64) -> [String; 3] {
    let error = variable.shown(error);
    let value = variable.shown(value);
    // as many decimals as the error has with two digits
    let decimals = match error > 0.0 && error.is_finite() {
        true => (1.0 - error.log10().floor()).clamp(0.0, 12.0) as usize,
        false => 6,
    };
    [
        format!("{value:.decimals$}"),
        format!("{error:.decimals$}"),
        variable.shown_unit.clone(),
    ]
}

fn tell(text: &mut Lines, file: &FitFile, fit: &Fit, rows: &[Row<'_>]) {
    let (seen, sought) = (rows.len(), file.unknowns.len());
    text.line(
        "fit",
        format!(
            "{seen} observations, {sought} unknowns, from {} {}",
            file.starts,
            if file.starts == 1 { "start" } else { "starts" }
        ),
    );
    match (fit.estimated_sigma, fit.probability) {
        (Some(sigma), _) => text.line(
            "scatter",
            format!(
                "{} % of what was measured, from the residuals: no sigma is given",
                to_digits(100.0 * sigma, 3)
            ),
        ),
        (None, Some(probability)) => text.line(
            "χ²",
            format!(
                "{} where {} are expected; by chance it is larger in {} % of all cases",
                digits(fit.chi_square),
                fit.freedoms,
                to_digits(100.0 * probability, 2)
            ),
        ),
        (None, None) => text.line("χ²", digits(fit.chi_square)),
    }
    let values = found(file, fit)
        .into_iter()
        .map(|(unknown, value, error, bound)| {
            let variable = &unknown.variable;
            let [value, error, unit] = with_error(variable, value, error);
            let range = unknown.range.map(|end| to_digits(variable.shown(end), 5));
            let note = if bound { ", at its bound" } else { "" };
            vec![
                variable.key.clone(),
                value,
                error,
                unit,
                format!("{} … {}{note}", range[0], range[1]),
            ]
        });
    text.table(
        ["unknown", "value", "± standard\nerror", "unit", "sought in"],
        values,
    );
    let observed = rows.iter().map(|row| {
        let (unit, factor) = match row.observation.wraps {
            true => ("deg".to_owned(), 1f64.to_degrees()),
            false => shown_unit(&row.observation.unit),
        };
        let shown = |value: f64| digits(factor * value);
        vec![
            row.observation.name.clone(),
            shown(row.observation.measured),
            shown(row.computed.value),
            unit.clone(),
            shown(row.sigma),
            format!("{:+.2}", row.residual),
            match row.computed.error.is_finite() {
                true => digits(to_digits(row.computed.error / row.sigma, 2)),
                false => "–".to_owned(),
            },
        ]
    });
    text.table(
        [
            "observation",
            "measured",
            "computed",
            "unit",
            "σ",
            "residual\nin σ",
            "numerical\nerror in σ",
        ],
        observed,
    );
    for one in fit.minima.iter().skip(1) {
        let values = file
            .variables()
            .zip(&one.values)
            .map(|(variable, value)| format!("{} = {}", variable.key, shown(variable, *value)));
        let values: Vec<_> = values.collect();
        text.line(
            "also least",
            format!("χ² {} at {}", digits(one.chi_square), values.join(", ")),
        );
    }
}

fn tell_balance(text: &mut Lines, balance: &[Balance]) {
    if balance.is_empty() {
        return;
    }
    let rows = balance.iter().map(|own| {
        [
            (own.plane + 1).to_string(),
            digits(1e3 * own.position),
            digits(1e3 * own.mass),
            digits(1e3 * own.radius),
            format!("{:.2}", own.angle.to_degrees()),
        ]
        .to_vec()
    });
    text.table(
        [
            "unbalance",
            "plane at\nmm",
            "add mass\ng",
            "at radius\nmm",
            "at angle\ndeg",
        ],
        rows,
    );
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

fn warnings(file: &FitFile, fit: &Fit, rows: &[Row<'_>]) -> Vec<String> {
    let mut warnings = file.warnings.clone();
    if !fit.is_complete {
        warnings
            .push("the search did not come to its end: the values are the best so far".to_owned());
    }
    for one in &fit.unidentified {
        let parts = one.parts.iter().map(|(unknown, change)| {
            let variable = &file.unknowns[*unknown].variable;
            let size = to_digits(variable.shown(change.abs()), 3);
            let way = if *change > 0.0 { "up" } else { "down" };
            format!("{} {way} by {size} {}", variable.key, variable.shown_unit)
        });
        let parts: Vec<_> = parts.collect();
        warnings.push(format!(
            "not identified: {} changes no observation by more than its standard deviation, so that these values are not known \
             within their ranges: measure something else that depends on them",
            parts.join(" with ")
        ));
    }
    let bounds = found(file, fit).into_iter().filter(|(.., bound)| *bound);
    warnings.extend(bounds.map(|(unknown, value, ..)| {
        format!(
            "`{}` is at its bound {}: what was measured asks for more; its standard error is that of a value without bounds",
            unknown.variable.key,
            shown(&unknown.variable, value)
        )
    }));
    let count = file.unknowns.len();
    let pairs = (0..count).flat_map(|row| (0..row).map(move |column| (column, row)));
    warnings.extend(pairs.filter(|_| fit.unidentified.is_empty()).filter_map(|(first, second)| {
        let correlation = *fit.correlations.get((first, second))?;
        let keys = [first, second].map(|place| &file.unknowns[place].variable.key);
        (correlation.abs() > CORRELATED).then(|| {
            format!("`{}` and `{}` are known together rather than each: their correlation is {correlation:.3}", keys[0], keys[1])
        })
    }));
    let scale = fit.estimated_sigma.unwrap_or(1.0).powi(2);
    let as_good = fit.minima.iter().skip(1);
    let as_good = as_good.filter(|own| own.chi_square - fit.chi_square < AS_GOOD * scale);
    let count = as_good.count();
    if count > 0 {
        warnings.push(format!(
            "{count} other values explain what was measured as well: see the minima"
        ));
    }
    if let Some(probability) = fit.probability {
        if probability < DOUBTFUL[0] {
            warnings.push(format!(
                "χ² is {:.3} where {} are expected: the scene does not explain what was measured to its standard deviations, and the \
                 standard errors are too small for that; look at the largest residuals",
                fit.chi_square, fit.freedoms
            ));
        } else if probability > DOUBTFUL[1] {
            warnings.push(format!(
                "χ² is {:.3} where {} are expected: the standard deviations are larger than the scatter; that all fits so well is no \
                 proof of the model",
                fit.chi_square, fit.freedoms
            ));
        }
    }
    let inexact = rows
        .iter()
        .filter(|row| row.computed.error > NUMERICAL * row.sigma);
    warnings.extend(inexact.map(|row| {
        format!(
            "{}: the error of the computed number is {:.1e} of the standard deviation: tighten integrator.tolerance",
            row.observation.name,
            row.computed.error / row.sigma
        )
    }));
    warnings
}

/// Residuals in standard deviations, an observation a line, beside one and two of them.
fn residuals_figure(title: &str, rows: &[Row<'_>]) -> Figure {
    let count = rows.len() as f64;
    let points = rows
        .iter()
        .enumerate()
        .map(|(place, row)| (row.residual, place as f64 + 0.5));
    let points: Vec<_> = points.collect();
    let across = Axis::spanning(
        "(computed − measured)/σ",
        points.iter().map(|point| point.0).chain([-2.5, 2.5]),
    );
    let limits = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|at| Curve {
        fine: at != 0.0,
        ..Curve::line(GREY, vec![(at, 0.0), (at, count)])
    });
    let dots = Curve {
        mark: Mark::Disc,
        ..Curve::dots(distinct(0), points)
    };
    let panel = Panel {
        curves: limits.into_iter().chain([dots]).collect(),
        ..Panel::new(
            across,
            Axis::names(rows.iter().map(|row| row.observation.name.clone())),
            60 + 22 * rows.len() as u32,
        )
    };
    Figure::new("fit_residuals", title, 1, vec![panel])
}

/// χ² above its least over every unknown: where it is 1 lies a standard error.
fn profiles_figure(file: &FitFile, fit: &Fit) -> Option<Figure> {
    let panel = |profile: &crate::fit::Profile| {
        let unknown = &file.unknowns[profile.unknown];
        let (variable, error) = (&unknown.variable, fit.errors[profile.unknown]);
        let at = |value: f64| variable.shown(value);
        let points: Vec<_> = profile
            .points
            .iter()
            .map(|point| (at(point[0]), point[1]))
            .collect();
        let best = fit.values[profile.unknown];
        let parabola = (-30..=30).map(|step| {
            let distance = f64::from(step) / 10.0;
            (at(best + distance * error), distance * distance)
        });
        let [least, most] =
            super::figure::ends(points.iter().map(|point| point.0)).unwrap_or([0.0, 1.0]);
        let parabola = parabola
            .filter(|point| (least..=most).contains(&point.0))
            .collect();
        let curves = vec![
            Curve::line(GREY, parabola),
            Curve::marked(distinct(0), points, 50),
        ];
        Panel {
            ..Panel::holding(
                Axis::over(axis_label(variable), least..most),
                "χ² above its least",
                HEIGHT,
                curves,
            )
        }
    };
    let panels: Vec<_> = fit
        .profiles
        .iter()
        .filter(|own| own.points.len() > 2)
        .map(panel)
        .collect();
    let names = [
        Name::new("with the other unknowns at their best", distinct(0)),
        Name::new("by the standard error", GREY),
    ];
    (!panels.is_empty())
        .then(|| Figure::new("fit_profiles", &file.title, 2, panels).with_names(names))
}

/// The records that lines were taken from, and the lines of the fitted motion over the same axis.
fn predictions(file: &FitFile, fit: &Fit) -> (Vec<Overlay>, Overlay) {
    let records = file
        .records
        .iter()
        .filter_map(|path| Overlay::load(path).ok());
    let lines = fit.orbits.iter().flatten().map(|orbit| &orbit.lines).next();
    let channels = file.readings.iter().filter_map(|(_, wanted)| match wanted {
        Wanted::Amplitude { channel, .. } => Some(*channel),
        _ => None,
    });
    let mut channels: Vec<Channel> = channels.collect();
    channels.dedup();
    let table = lines.map(|lines| line_spectrum(lines, &channels));
    (
        records.collect(),
        Overlay::from_tables("fitted".to_owned(), table, Vec::new()),
    )
}

/// Lines as a spectrum that is nothing beside them.
fn line_spectrum(lines: &SteadyLines, channels: &[Channel]) -> Table<'static> {
    const BESIDE: f64 = 1e-6;
    let moving = lines.lines.iter().filter(|line| line.frequency > 0.0);
    let places = moving.flat_map(|line| {
        [(1.0 - BESIDE, 0.0), (1.0, 1.0), (1.0 + BESIDE, 0.0)].map(|at| (line, at))
    });
    let places: Vec<_> = places.collect();
    let mut table = Table::default();
    table.add(
        Column::frequency(),
        places.iter().map(|(line, (at, _))| at * line.frequency),
    );
    for channel in channels {
        let Some(index) = lines.channels.iter().position(|known| known == channel) else {
            continue;
        };
        let heights = places
            .iter()
            .map(|(line, (_, height))| height * line.amplitude[index]);
        table.add(channel.measure("amplitude"), heights);
    }
    table
}
