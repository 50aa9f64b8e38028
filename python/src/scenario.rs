//! A checked scenario and its questions.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicU64;

use jeffcott::ask::{
    self, AccuracyQuestion, AskError, BearingQuestion, CampbellQuestion, Followed, LinearRange,
    LinearResponseQuestion, MatricesQuestion, Order, Place, ResponseQuestion, RunQuestion,
    Sensitivity, SteadyQuestion,
};
use jeffcott::bearing::CATALOGUE;
use jeffcott::internals::{frequency, method, position, speed, time, tolerance, written};
use jeffcott::scenario::{self, Format, Scenario};
use jeffcott::simulate::Monitor;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::answer::{Findings, RunFindings};
use crate::errors::{ask_error, issue_error, scenario_error};
use crate::watch::{Watch, watched};

/// Number of the scenario that is followed, and its first and last value.
type Ends = (String, String, String);

/// A checked scenario.
#[pyclass(frozen, module = "jeffcott")]
pub struct CheckedScenario {
    scenario: Scenario,
    text: String,
    name: String,
    folder: PathBuf,
    json: bool,
}

impl CheckedScenario {
    /// What was checked.
    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// The folder that its files are looked for from: the same wherever the process goes later.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    fn format(&self) -> Format {
        format(self.json)
    }

    /// By which keys the answer to a question is differentiated.
    fn sensitivity(&self, py: Python<'_>, keys: &[String]) -> PyResult<Option<Sensitivity>> {
        let asked = Sensitivity::new(&self.scenario, keys, self.folder());
        asked.map_err(|error| ask_error(py, &error))
    }

    /// Answers a question about it with the lock of the interpreter released.
    fn answer(
        py: Python<'_>,
        progress: Option<&Py<PyAny>>,
        answer: impl FnOnce(&mut Watch<'_>) -> Result<ask::Findings, AskError> + Send,
    ) -> PyResult<Findings> {
        let findings = watched(py, None, progress, answer)?;
        Ok(Findings(findings.map_err(|error| ask_error(py, &error))?))
    }
}

/// The folder of a file, from the root.
fn folder_of(path: &Path) -> PyResult<PathBuf> {
    let whole = std::path::absolute(path)?;
    Ok(whole.parent().unwrap_or(&whole).to_owned())
}

/// A speed in rad/s, where one is given.
fn given_speed(py: Python<'_>, text: Option<String>) -> PyResult<Option<f64>> {
    let read = text.map(|text| speed(&text).map_err(|issue| issue_error(py, &issue)));
    read.transpose()
}

/// Places of the shaft.
fn places(texts: &[String]) -> PyResult<Vec<Place>> {
    let places = texts.iter().map(|text| text.parse());
    places
        .collect::<Result<_, _>>()
        .map_err(PyValueError::new_err)
}

pub fn format(json: bool) -> Format {
    if json { Format::Json } else { Format::Toml }
}

#[pymethods]
impl CheckedScenario {
    /// Reads and checks a text; messages call it `name`, and its files are looked for from the folder of that path.
    #[staticmethod]
    fn parse(py: Python<'_>, text: String, name: String, json: bool) -> PyResult<Self> {
        let scenario = py.detach(|| scenario::parse(&text, &name, format(json)));
        Ok(Self {
            scenario: scenario.map_err(|error| scenario_error(py, &error))?,
            folder: folder_of(Path::new(&name))?,
            text,
            name,
            json,
        })
    }

    /// Reads and checks a file.
    #[staticmethod]
    fn load(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let scenario = py.detach(|| scenario::load(&path));
        let scenario = scenario.map_err(|error| scenario_error(py, &error))?;
        let ending = path.extension().unwrap_or_default();
        Ok(Self {
            scenario,
            text: fs::read_to_string(&path)?,
            folder: folder_of(&path)?,
            name: path.display().to_string(),
            json: ending.eq_ignore_ascii_case("json"),
        })
    }

    /// Its tables and values as they are written, JSON.
    fn written(&self, py: Python<'_>) -> PyResult<String> {
        let found = written(&self.text, &self.name, self.format());
        let found = found.map_err(|error| scenario_error(py, &error))?;
        Ok(found.to_string())
    }

    /// Its tables and values with their defaults, JSON.
    fn echo(&self) -> String {
        self.scenario.echo.to_string()
    }

    /// Its title.
    fn title(&self) -> &str {
        &self.scenario.title
    }

    /// The path that messages call it by, below the folder that its files are looked for from.
    fn place(&self) -> PathBuf {
        let name = Path::new(&self.name).file_name();
        self.folder.join(name.unwrap_or_default())
    }

    /// What the user should know although it can be run.
    fn warnings(&self) -> Vec<String> {
        self.scenario.warnings.clone()
    }

    fn __repr__(&self) -> String {
        format!("<CheckedScenario {:?}>", self.scenario.title)
    }

    /// Runs it.
    fn run(
        &self,
        py: Python<'_>,
        progress: Option<Py<PyAny>>,
        sensitivity: Vec<String>,
    ) -> PyResult<RunFindings> {
        let question = RunQuestion::new(&self.scenario);
        let mut question = question.map_err(|error| ask_error(py, &error))?;
        question.sensitivity = self.sensitivity(py, &sensitivity)?;
        let answer = watched(py, None, progress.as_ref(), |watch| {
            question.answer(&mut Monitor {
                stop: watch.stop,
                progress: watch.progress,
            })
        })?;
        let answer = answer.map_err(|error| ask_error(py, &error))?;
        Ok(RunFindings(answer))
    }

    /// Where the shaft stands.
    fn bearing(&self, py: Python<'_>, sensitivity: Vec<String>) -> PyResult<Findings> {
        let mut question = BearingQuestion::new(&self.scenario, None, None);
        question.sensitivity = self.sensitivity(py, &sensitivity)?;
        Self::answer(py, None, |_| question.answer())
    }

    /// The motion that it settles to.
    fn steady(
        &self,
        py: Python<'_>,
        period: Option<u32>,
        sensitivity: Vec<String>,
    ) -> PyResult<Findings> {
        let question = SteadyQuestion::new(&self.scenario, period);
        let mut question = question.map_err(|error| ask_error(py, &error))?;
        question.sensitivity = self.sensitivity(py, &sensitivity)?;
        Self::answer(py, None, |watch| {
            question.answer(watch.stop, &AtomicU64::new(0))
        })
    }

    /// The motion that it settles to, along a number of the scenario.
    fn response(
        &self,
        py: Python<'_>,
        followed: Ends,
        period: u32,
        points: usize,
        doubled: bool,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Findings> {
        let (key, from, to) = &followed;
        let followed = Followed { key, from, to };
        let question = ResponseQuestion::new(&self.scenario, &followed, self.folder());
        let mut question = question.map_err(|error| ask_error(py, &error))?;
        question.multiple = period;
        question.points = points;
        question.doubled = doubled;
        Self::answer(py, progress.as_ref(), |watch| {
            question.answer(watch.stop, &AtomicU64::new(0), watch.progress)
        })
    }

    /// Natural frequencies over the speed.
    fn campbell(
        &self,
        py: Python<'_>,
        ends: (String, Option<String>),
        count: usize,
        orders: Vec<String>,
        highest: Option<String>,
        sensitivity: Vec<String>,
    ) -> PyResult<Findings> {
        let refused = |issue| issue_error(py, &issue);
        let range = (speed(&ends.0).map_err(refused)?, given_speed(py, ends.1)?);
        let highest = highest.map(|text| frequency(&text).map_err(refused));
        let orders = orders.iter().map(|order| order.parse::<Order>());
        let orders = orders.collect::<Result<Vec<_>, _>>();
        let orders = orders.map_err(PyValueError::new_err)?;
        let question =
            CampbellQuestion::new(&self.scenario, range, count, &orders, highest.transpose()?);
        let mut question = question.map_err(|error| ask_error(py, &error))?;
        question.sensitivity = self.sensitivity(py, &sensitivity)?;
        Self::answer(py, None, |watch| question.answer(watch.stop))
    }

    /// The response of the linearised shaft to a force, or to its unbalances.
    fn frequency_response(
        &self,
        py: Python<'_>,
        at: Vec<String>,
        ends: (String, String),
        by: Option<String>,
        at_speed: Option<String>,
        count: usize,
    ) -> PyResult<Findings> {
        let (at, by) = (places(&at)?, places(by.as_slice())?);
        let at_speed = given_speed(py, at_speed)?;
        let range = LinearRange {
            from: &ends.0,
            to: &ends.1,
            count,
        };
        let by = by.first().map(|by| (by, at_speed));
        let question = LinearResponseQuestion::new(&self.scenario, &at, by, &range);
        let question = question.map_err(|error| ask_error(py, &error))?;
        Self::answer(py, None, |watch| question.answer(watch.stop))
    }

    /// The matrices of the linearised shaft.
    fn matrices(
        &self,
        py: Python<'_>,
        at: Vec<String>,
        at_speed: Option<String>,
    ) -> PyResult<Findings> {
        let at = at
            .iter()
            .map(|text| position(text))
            .collect::<Result<Vec<_>, _>>();
        let at = at.map_err(|issue| issue_error(py, &issue))?;
        let question = MatricesQuestion::new(&self.scenario, &at, given_speed(py, at_speed)?);
        let question = question.map_err(|error| ask_error(py, &error))?;
        Self::answer(py, None, |_| question.answer())
    }

    /// Speed against error of methods at tolerances.
    fn accuracy(
        &self,
        py: Python<'_>,
        methods: Vec<String>,
        tolerances: Vec<f64>,
        longest: String,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Findings> {
        let refused = |issue| issue_error(py, &issue);
        let named = methods.iter().map(|name| method(name));
        let named = named.collect::<Result<Vec<_>, _>>().map_err(refused)?;
        let checked = tolerances.iter().map(|one| tolerance(&one.to_string()));
        checked.collect::<Result<Vec<_>, _>>().map_err(refused)?;
        let longest = time(&longest).map_err(refused)?;
        let question = AccuracyQuestion::new(&self.scenario, &named, &tolerances, longest);
        let question = question.map_err(|error| ask_error(py, &error))?;
        Self::answer(py, progress.as_ref(), |watch| {
            question.answer(&mut Monitor {
                stop: watch.stop,
                progress: watch.progress,
            })
        })
    }
}

/// Designations of the bearings of the catalogue, and where their dimensions come from.
#[pyfunction]
pub fn catalogue() -> Vec<(String, String)> {
    let balls = CATALOGUE.balls.iter();
    let balls = balls.map(|entry| (&entry.designation, &entry.source));
    let rollers = CATALOGUE.rollers.iter();
    let rollers = rollers.map(|entry| (&entry.designation, &entry.source));
    let all = balls.chain(rollers);
    all.map(|(designation, source)| (designation.clone(), source.clone()))
        .collect()
}
