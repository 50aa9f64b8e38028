//! Fits: which values explain what was measured.

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::atomic::AtomicU64;

use jeffcott::ask::FitQuestion;
use jeffcott::internals::{load_fit, parse_fit};
use pyo3::prelude::*;

use crate::answer::Findings;
use crate::errors::{ask_error, scenario_error};
use crate::scenario::{CheckedScenario, format};
use crate::watch::watched;

/// Fits the unknowns of a file, or of a text, JSON, about a scenario.
#[pyfunction]
pub fn fit(
    py: Python<'_>,
    file: Option<PathBuf>,
    asked: Option<(PyRef<'_, CheckedScenario>, String)>,
    threads: Option<NonZeroUsize>,
) -> PyResult<Findings> {
    let read = match (file, &asked) {
        (Some(path), _) => load_fit(&path, &[]),
        (None, Some((scene, text))) => {
            parse_fit(text, format(true), scene.scenario(), scene.folder())
        }
        (None, None) => return Err(pyo3::exceptions::PyValueError::new_err("nothing to fit")),
    };
    let file = read.map_err(|error| scenario_error(py, &error))?;
    let question = FitQuestion::new(&file, threads.map(NonZeroUsize::get));
    let found = watched(py, None, None, |watch| {
        question.answer(watch.stop, &AtomicU64::new(0))
    })?;
    Ok(Findings(found.map_err(|error| ask_error(py, &error))?))
}
