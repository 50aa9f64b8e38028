//! Findings: their documents, tables and figures.

use std::path::{Path, PathBuf};

use jeffcott::analysis::Channel;
use jeffcott::ask;
use jeffcott::internals::{Column, ColumnKind, Table};
use numpy::{IntoPyArray, PyArray1};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;

use crate::errors::{other, run_error};
use crate::scenario::CheckedScenario;

/// Names and columns of a table: numpy arrays, or lists of words.
pub type Columns<'py> = Vec<(String, Bound<'py, PyAny>)>;

/// The columns of a table. Whole numbers are int64 where none is missing, else float64 with NaN.
pub fn columns<'py>(py: Python<'py>, table: &Table<'_>) -> PyResult<Columns<'py>> {
    let column = |(column, values): (&Column, &[f64])| {
        let array = match &column.kind {
            ColumnKind::Count if values.iter().all(|value| !value.is_nan()) => {
                let counts: Vec<i64> = values.iter().map(|value| *value as i64).collect();
                counts.into_pyarray(py).into_any()
            }
            ColumnKind::Word(_) => {
                let words = values.iter().map(|value| column.kind.word(*value));
                let words: Vec<&str> = words.collect();
                words.into_pyobject(py)?.into_any()
            }
            _ => PyArray1::from_slice(py, values).into_any(),
        };
        Ok((column.name(), array))
    };
    table.iter().map(column).collect()
}

/// An answer to a question that is no run.
#[pyclass(frozen, module = "jeffcott")]
pub struct Findings(pub(crate) ask::Findings);

#[pymethods]
impl Findings {
    /// The document, JSON.
    fn document(&self) -> String {
        self.0.document.to_string()
    }

    /// What a person reads.
    fn text(&self) -> String {
        self.0.text(false)
    }

    /// What the reader should know.
    fn warnings(&self) -> Vec<&str> {
        self.0.warnings().collect()
    }

    /// Names of the tables.
    fn tables(&self) -> Vec<&str> {
        self.0.tables().map(|(name, _)| name).collect()
    }

    /// The columns of a table; None where there is none of this name.
    fn table<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Option<Columns<'py>>> {
        let mut tables = self.0.tables();
        let found = tables.find(|(known, _)| *known == name);
        found.map(|(_, table)| columns(py, table)).transpose()
    }

    /// Names of the figures.
    fn figures(&self) -> Vec<String> {
        self.0.figures().map(str::to_owned).collect()
    }

    /// A figure as SVG; None where there is none of this name.
    fn figure(&self, name: &str) -> PyResult<Option<String>> {
        Ok(self.0.figure(name))
    }

    /// The text of a further file; None where there is none of this name.
    fn file(&self, name: &str) -> Option<&str> {
        self.0.file(name)
    }

    fn __repr__(&self) -> String {
        format!("<Findings {}>", self.0.document["title"])
    }

    /// Writes all files into a folder; returns their paths.
    fn write(&self, py: Python<'_>, folder: PathBuf) -> PyResult<Vec<PathBuf>> {
        let files = py.detach(|| self.0.write(&folder));
        Ok(files.map_err(|error| run_error(py, &error))?.files)
    }
}

/// A run with its samples.
#[pyclass(frozen, module = "jeffcott")]
pub struct RunFindings(pub(crate) ask::RunFindings);

impl RunFindings {
    /// Whether a channel has a value in any sample: bearings, elements and housings that the machine lacks have none.
    fn is_observed(&self, channel: Channel) -> bool {
        let mut samples = self.0.recorded.samples.iter();
        samples.any(|sample| channel.value(sample).is_some())
    }
}

#[pymethods]
impl RunFindings {
    /// What `summary.json` says.
    fn document(&self, py: Python<'_>) -> String {
        py.detach(|| self.0.document().to_string())
    }

    /// What a person reads.
    fn text(&self) -> String {
        self.0.text()
    }

    /// What the reader should know.
    fn warnings(&self) -> Vec<String> {
        self.0.recorded.run.warnings.clone()
    }

    /// Number of samples.
    fn samples(&self) -> usize {
        self.0.recorded.samples.len()
    }

    /// Largest difference from the second pass in m, the same relative to the motion, and the tolerance of that pass;
    /// None where the scenario asks for none or it failed.
    fn error(&self) -> Option<(f64, f64, f64)> {
        let error = self.0.recorded.error()?;
        Some((
            error.displacement,
            error.relative,
            error.reference_tolerance,
        ))
    }

    /// Names of all columns of the samples, also of those that no table has.
    fn columns(&self) -> Vec<String> {
        Channel::all()
            .filter(|channel| self.is_observed(*channel))
            .map(|channel| channel.column().name())
            .collect()
    }

    /// All samples of a column by its name in the files; NaN where a value was not observed.
    fn column<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let mut channels = Channel::all().filter(|channel| channel.column().name() == name);
        let Some(channel) = channels.find(|channel| self.is_observed(*channel)) else {
            return Err(PyKeyError::new_err(format!(
                "the run has no column {name:?}; the columns are {}",
                self.columns().join(", ")
            )));
        };
        let samples = self.0.recorded.samples.iter();
        let values = samples.map(|sample| channel.value(sample).unwrap_or(f64::NAN));
        Ok(values.collect::<Vec<_>>().into_pyarray(py))
    }

    /// Names of the tables.
    fn tables(&self) -> Vec<String> {
        self.0.tables()
    }

    /// The columns of a table; None where the run has none of this name.
    fn table<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Option<Columns<'py>>> {
        let table = py.detach(|| self.0.table(name));
        table.map(|table| columns(py, &table)).transpose()
    }

    /// Names of the figures.
    fn figures(&self) -> Vec<String> {
        self.0.figures()
    }

    /// A figure as SVG; None where the run has none of this name.
    fn figure(&self, py: Python<'_>, name: &str) -> PyResult<Option<String>> {
        Ok(py.detach(|| self.0.figure(name)))
    }

    /// The columns of the first spectrum that another version of the scenario asks for, from the samples of this run.
    fn estimated<'py>(&self, py: Python<'py>, asked: &CheckedScenario) -> PyResult<Columns<'py>> {
        let estimated = py.detach(|| self.0.estimated(asked.scenario()));
        let estimated = estimated.map_err(|error| run_error(py, &error))?;
        match estimated.into_iter().next() {
            Some(Ok(table)) => columns(py, &table),
            Some(Err(message)) => Err(other(message)),
            None => Ok(Vec::new()),
        }
    }

    fn __repr__(&self) -> String {
        format!("<RunFindings: {} samples>", self.samples())
    }

    /// Writes all files of the run into a folder; returns their paths.
    fn write(&self, py: Python<'_>, folder: PathBuf) -> PyResult<Vec<PathBuf>> {
        let folder: &Path = &folder;
        let files = py.detach(|| self.0.write(folder));
        files.map_err(|error| run_error(py, &error))
    }
}
