//! Two results compared.

use std::collections::BTreeMap;
use std::path::PathBuf;

use jeffcott::report::compare::{
    CompareError, LineRules, Rules, Tolerance, Tolerances, compare as compare_files,
};
use pyo3::exceptions::{PyFileNotFoundError, PyValueError};
use pyo3::prelude::*;

/// Compares two tables or run folders; returns what was found as JSON and as text.
#[pyfunction]
#[allow(clippy::too_many_arguments)]
pub fn compare(
    py: Python<'_>,
    first: PathBuf,
    second: PathBuf,
    relative: f64,
    absolute: f64,
    columns: BTreeMap<String, (f64, f64)>,
    worst: usize,
    lines: Option<usize>,
    by: &str,
    reach: Option<f64>,
    decibels: Option<f64>,
    common: bool,
) -> PyResult<(String, String)> {
    if let Some(missing) = [&first, &second].into_iter().find(|path| !path.exists()) {
        let text = format!("there is no {}", missing.display());
        return Err(PyFileNotFoundError::new_err(text));
    }
    let wrong = |error: &CompareError| PyValueError::new_err(error.with_causes());
    let tolerance =
        |relative, absolute| Tolerance::new(relative, absolute).map_err(|error| wrong(&error));
    let mut tolerances = Tolerances::uniform(tolerance(relative, absolute)?);
    for (name, (relative, absolute)) in columns {
        tolerances = tolerances.with_column(&name, tolerance(relative, absolute)?);
    }
    let by = by.parse().map_err(PyValueError::new_err::<String>)?;
    let rules = Rules {
        tolerances,
        worst,
        common,
        lines: lines.map(|count| LineRules {
            count,
            by,
            reach,
            decibels,
        }),
    };
    let found = py.detach(|| compare_files(&first, &second, &rules));
    let found = found.map_err(|error| wrong(&error))?;
    Ok((found.to_json().to_string(), found.to_string()))
}
