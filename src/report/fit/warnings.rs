//! What the reader of a fit should know.

use super::{Row, found};
use crate::fit::Fit;
use crate::numerics::digits::to_digits;
use crate::report::variable::shown;
use crate::scenario::FitFile;

/// Part of a standard deviation from which on the error of a computed number is worth a warning.
const NUMERICAL: f64 = 0.1;
/// Minima whose χ² is no further above the lowest explain the data as well, to two standard errors.
const AS_GOOD: f64 = 4.0;
/// A probability of χ² below the first tells against the model, one above the second against the standard deviations.
const DOUBTFUL: [f64; 2] = [0.01, 0.99];
/// Correlations from which on values are reported to be known together only.
const CORRELATED: f64 = 0.95;

/// What the reader of a fit should know.
pub(super) fn warnings(file: &FitFile, fit: &Fit, rows: &[Row<'_>]) -> Vec<String> {
    let mut warnings = file.warnings.clone();
    if !fit.is_complete {
        let errors = match fit.errors.iter().any(|error| error.is_nan()) {
            true => {
                "they have no standard errors, as it is not known yet how what is computed depends on them"
            }
            false => "their standard errors rest on what the search knows of the slopes there",
        };
        warnings.push(format!(
            "the search did not come to its end: the values are the best so far; {errors}"
        ));
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
    let inexact = rows.iter().filter(|row| row.error > NUMERICAL * row.sigma);
    warnings.extend(inexact.map(|row| {
        format!(
            "{}: the error of the computed number is {:.1e} of the standard deviation: tighten integrator.tolerance",
            row.name,
            row.error / row.sigma
        )
    }));
    warnings
}
