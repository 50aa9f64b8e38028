//! Records of sensors.

use std::path::{Path, PathBuf};

use jeffcott::ask::{AnalyzeQuestion, record_setting};
use jeffcott::record::Record;
use numpy::PyReadonlyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::answer::Findings;
use crate::errors::scenario_error;

/// Finds out what is in a record: a file, one that describes a record, or arrays with their names; options are those of the
/// command, `description` is JSON.
#[pyfunction]
pub fn analyze(
    py: Python<'_>,
    file: Option<PathBuf>,
    arrays: Vec<(String, PyReadonlyArray1<'_, f64>)>,
    options: Vec<(String, Vec<String>)>,
    description: &str,
) -> PyResult<Findings> {
    let settings = options.iter();
    let settings = settings.filter_map(|(name, values)| record_setting(name, values));
    let settings: Vec<String> = settings.collect();
    let wrong = |error: &dyn std::fmt::Display| PyValueError::new_err(error.to_string());
    let columns = arrays
        .into_iter()
        .map(|(name, values)| (name, values.as_array().to_vec()));
    let columns: Vec<_> = columns.collect();
    let is_description = |path: &Path| {
        let ending = path.extension().and_then(|ending| ending.to_str());
        matches!(ending, Some("toml" | "json"))
    };
    let asked = py.detach(|| match file.as_deref() {
        Some(path) if is_description(path) => Ok(AnalyzeQuestion::load(path, &settings)),
        Some(path) => {
            let name = path.display().to_string();
            let record = Record::open(path)?;
            Ok(AnalyzeQuestion::describe(
                record,
                &name,
                description,
                &settings,
            ))
        }
        None => {
            let record = Record::from_columns(columns, "arrays")?;
            Ok(AnalyzeQuestion::describe(
                record,
                "arrays",
                description,
                &settings,
            ))
        }
    });
    let asked = asked.map_err(|error: jeffcott::record::RecordError| wrong(&error))?;
    let question = asked.map_err(|error| scenario_error(py, &error))?;
    Ok(Findings(py.detach(|| question.answer())))
}
