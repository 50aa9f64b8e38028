//! A fit as people read it on the terminal.

use super::{Row, found};
use crate::fit::Fit;
use crate::numerics::digits::to_digits;
use crate::report::terminal::{Lines, digits, in_digits, shown_unit};
use crate::report::variable::shown;
use crate::scenario::{Balance, FitFile};
use crate::study::Variable;

/// A value with its standard error in the unit that it was written in.
fn with_error(variable: &Variable, value: f64, error: f64) -> [String; 3] {
    let error = variable.shown(error);
    let value = variable.shown(value);
    // as many decimals as the error has with two digits
    let decimals = match error > 0.0 && error.is_finite() {
        true => (1.0 - error.log10().floor()).clamp(0.0, 12.0) as usize,
        false => 6,
    };
    let shown_error = match error.is_nan() {
        true => "–".to_owned(),
        false => format!("{error:.decimals$}"),
    };
    [
        format!("{value:.decimals$}"),
        shown_error,
        variable.shown_unit.clone(),
    ]
}

/// Values with their errors, and what is computed against what was measured.
pub(super) fn tell(text: &mut Lines, file: &FitFile, fit: &Fit, rows: &[Row<'_>]) {
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
                in_digits(100.0 * sigma, 3)
            ),
        ),
        (None, Some(probability)) => text.line(
            "χ²",
            format!(
                "{} where {} are expected; by chance it is larger in {} % of all cases",
                digits(fit.chi_square),
                fit.freedoms,
                in_digits(100.0 * probability, 2)
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
        let (unit, factor) = shown_unit(row.unit);
        let shown = |value: f64| digits(factor * value);
        vec![
            row.name.to_owned(),
            shown(row.measured),
            shown(row.computed),
            unit,
            shown(row.sigma),
            format!("{:+.2}", row.residual),
            match row.error.is_finite() {
                true => digits(to_digits(row.error / row.sigma, 2)),
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

/// Correction masses.
pub(super) fn tell_balance(text: &mut Lines, balance: &[Balance]) {
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
