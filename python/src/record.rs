//! Records of sensors.

use std::path::PathBuf;

use jeffcott::ask::{AnalyzeQuestion, record_setting};
use jeffcott::record::{Record, RecordError};
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
    let columns = arrays
        .into_iter()
        .map(|(name, values)| (name, values.as_array().to_vec()));
    let columns: Vec<_> = columns.collect();
    let asked = py.detach(|| match file.as_deref() {
        Some(path) => Ok(AnalyzeQuestion::load(path, description, &settings)),
        None => {
            let record = Record::from_columns(columns, "arrays")?;
            let question = AnalyzeQuestion::describe(record, "arrays", description, &settings);
            Ok(question)
        }
    });
    let asked = asked.map_err(|error: RecordError| PyValueError::new_err(error.to_string()))?;
    let question = asked.map_err(|error| scenario_error(py, &error))?;
    Ok(Findings(py.detach(|| question.answer())))
}
