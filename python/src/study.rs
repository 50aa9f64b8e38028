//! Studies: many runs of one scenario, whole or in parts.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::thread;

use jeffcott::ask::{Making, StudyQuestion, StudyWatch, merge as merge_parts};
use jeffcott::internals::{Shard, StudyFile, load_study, parse_study};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::errors::{ask_error, scenario_error};
use crate::scenario::{CheckedScenario, format};
use crate::watch::{StopSignal, watched};

/// A checked study.
#[pyclass(frozen, module = "jeffcott")]
pub struct StudyPlan(StudyFile);

#[pymethods]
impl StudyPlan {
    /// Reads and checks a study file and its scenario.
    #[staticmethod]
    fn load(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let study = py.detach(|| load_study(&path, &[]));
        study.map(Self).map_err(|error| scenario_error(py, &error))
    }

    /// Checks the text of a study of a scenario, JSON.
    #[staticmethod]
    fn of(py: Python<'_>, scene: &CheckedScenario, text: &str) -> PyResult<Self> {
        let study = parse_study(text, format(true), scene.scenario(), scene.folder());
        study.map(Self).map_err(|error| scenario_error(py, &error))
    }

    /// Its title.
    fn title(&self) -> &str {
        &self.0.title
    }

    fn __repr__(&self) -> String {
        format!("<StudyPlan {:?}>", self.0.title)
    }

    /// Number of runs, and of the parts that they can be made in.
    fn size(&self, py: Python<'_>) -> PyResult<(u64, u64)> {
        let schedule = self.question(py, Shard::WHOLE)?.schedule;
        Ok((schedule.runs(), schedule.chains()))
    }

    /// Makes part `number` of `count`, or all by 1 of 1, and writes its files into `folder`.
    #[allow(clippy::too_many_arguments)]
    fn make(
        &self,
        py: Python<'_>,
        folder: PathBuf,
        part: (u64, u64),
        threads: Option<NonZeroUsize>,
        anew: bool,
        stop: Option<&StopSignal>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Vec<PathBuf>> {
        let (number, count) = part;
        if !(1..=count).contains(&number) {
            let text = format!("there is no part {number} of {count}");
            return Err(PyValueError::new_err(text));
        }
        let question = self.question(py, Shard { number, count })?;
        let available = || thread::available_parallelism().unwrap_or(NonZeroUsize::MIN);
        let making = Making {
            folder: &folder,
            threads: threads.unwrap_or_else(available).get(),
            anew,
        };
        let found = watched(py, stop, progress.as_ref(), |watch| {
            let mut watch = StudyWatch {
                stop: watch.stop,
                resumed: &mut |_| {},
                progress: watch.progress,
            };
            question.answer(&making, &mut watch)
        })?;
        Ok(found.map_err(|error| ask_error(py, &error))?.files)
    }
}

impl StudyPlan {
    fn question(&self, py: Python<'_>, shard: Shard) -> PyResult<StudyQuestion<'_>> {
        StudyQuestion::new(&self.0, shard).map_err(|error| ask_error(py, &error))
    }
}

/// Puts the parts of a study together, in the folder that they stand in; returns the paths of the files.
#[pyfunction]
pub fn merge(py: Python<'_>, folder: PathBuf) -> PyResult<Vec<PathBuf>> {
    let folder: &Path = &folder;
    let merged = py.detach(|| merge_parts(folder));
    Ok(merged.map_err(|error| ask_error(py, &error))?.files)
}
