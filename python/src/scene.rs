//! A checked scenario and its questions.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicU64;

use jeffcott::bearing::CATALOGUE;
use jeffcott::internals::{
    AccuracyQuestion, CampbellQuestion, Destination, Findings, OpenNumber, ResponseQuestion,
    RunFindings, accuracy_findings, answer_findings, campbell_findings, check_range,
    contact_choice_text, frequency, method, response, response_findings, response_warnings, speed,
    steady_findings, study_findings, time, tolerance, written,
};
use jeffcott::scenario::{self, Format, Scenario};
use jeffcott::simulate::{Model, Monitor};
use jeffcott::steady::{SteadyError, SteadyQuestion, steady};
use jeffcott::study::quasi_static;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::answer::{Answer, RunAnswer};
use crate::errors::{issue_error, no_time, run_error, scenario_error, scenario_run_error};
use crate::watch::watched;

/// Number of the scenario that is followed, and its first and last value.
type Followed = (String, String, String);

/// A checked scenario.
#[pyclass(frozen, module = "jeffcott._jeffcott")]
pub struct Scene {
    scenario: Scenario,
    text: String,
    name: String,
    json: bool,
}

impl Scene {
    /// What was checked.
    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// The folder that its files are looked for from.
    pub fn folder(&self) -> &Path {
        Path::new(&self.name).parent().unwrap_or(Path::new(""))
    }

    fn format(&self) -> Format {
        format(self.json)
    }

    fn model(&self, py: Python<'_>) -> PyResult<&Model> {
        self.scenario.model.as_ref().ok_or_else(|| no_time(py))
    }

    fn destination(&self) -> Destination<'_> {
        Destination {
            folder: Path::new(""),
            title: &self.scenario.title,
            scenario: &self.scenario.echo,
            formats: self.scenario.formats(),
            page: true,
        }
    }

    fn answer(&self, findings: Findings) -> Answer {
        Answer {
            findings,
            remark: String::new(),
            title: self.scenario.title.clone(),
            scenario: self.scenario.echo.clone(),
            formats: self.scenario.formats().to_vec(),
        }
    }
}

pub fn format(json: bool) -> Format {
    if json { Format::Json } else { Format::Toml }
}

#[pymethods]
impl Scene {
    /// Reads and checks a text; messages call it `name`, and its files are looked for from the folder of that path.
    #[staticmethod]
    fn parse(py: Python<'_>, text: String, name: String, json: bool) -> PyResult<Self> {
        let scenario = py.detach(|| scenario::parse(&text, &name, format(json)));
        Ok(Self {
            scenario: scenario.map_err(|error| scenario_error(py, &error))?,
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

    /// The same with its defaults, JSON.
    fn echo(&self) -> String {
        self.scenario.echo.to_string()
    }

    /// Its title.
    fn title(&self) -> &str {
        &self.scenario.title
    }

    /// What messages call it.
    fn name(&self) -> &str {
        &self.name
    }

    /// What the user should know although it can be run.
    fn warnings(&self) -> Vec<String> {
        self.scenario.warnings.clone()
    }

    /// Runs it.
    fn run(&self, py: Python<'_>, progress: Option<Py<PyAny>>) -> PyResult<RunAnswer> {
        let scenario = self.scenario.clone();
        let answer = watched(py, None, progress.as_ref(), |watch| {
            let mut monitor = Monitor {
                stop: watch.stop,
                progress: watch.progress,
            };
            RunFindings::of(scenario, &mut monitor)
        })?;
        let answer = answer.map_err(|error| scenario_run_error(py, &error))?;
        Ok(RunAnswer(answer))
    }

    /// Where the shaft stands; at every value of its `[study]`, where it has one.
    fn bearing(&self, py: Python<'_>) -> PyResult<Answer> {
        let destination = self.destination();
        if let Some(study) = &self.scenario.study {
            let rows = watched(py, None, None, |_| study.run())?;
            let rows = rows.map_err(|error| run_error(py, &error))?;
            return Ok(self.answer(study_findings(&destination, study, &rows)));
        }
        let found = watched(py, None, None, |_| quasi_static(&self.scenario.question))?;
        let found = found.map_err(|error| run_error(py, &error))?;
        let choice = self.scenario.contact_choice.as_ref();
        let findings = answer_findings(&destination, &self.scenario.question, &found);
        Ok(Answer {
            remark: choice.map(contact_choice_text).unwrap_or_default(),
            ..self.answer(findings)
        })
    }

    /// The motion that it settles to.
    fn steady(&self, py: Python<'_>, period: Option<u32>) -> PyResult<Answer> {
        let model = self.model(py)?;
        let found = watched(py, None, None, |watch| {
            steady(&SteadyQuestion {
                model,
                multiple: period,
                stop: watch.stop,
                integrated: &AtomicU64::new(0),
            })
        })?;
        let found = found.map_err(|error| run_error(py, &error))?;
        let findings = steady_findings(&self.destination(), model, &found);
        Ok(self.answer(findings))
    }

    /// The same along a number of the scenario.
    fn response(
        &self,
        py: Python<'_>,
        followed: Followed,
        period: u32,
        points: usize,
        doubled: bool,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Answer> {
        let model = self.model(py)?;
        let refused = |issue| issue_error(py, &issue);
        let (over, start, stop) = followed;
        let varied = OpenNumber::new(&self.scenario, &over, self.folder()).map_err(refused)?;
        let (first, variable) = varied.value(&start).map_err(refused)?;
        let (last, _) = varied.value(&stop).map_err(refused)?;
        if first == last {
            return Err(PyValueError::new_err("start and stop are the same value"));
        }
        // the scenario exists at both ends
        for end in [first, last] {
            varied.rotor(end).map_err(refused)?;
        }
        let (branches, warnings) = watched(py, None, progress.as_ref(), |watch| {
            let question = ResponseQuestion {
                model,
                family: &|value| varied.rotor(value).map_err(|issue| issue.to_string()),
                range: [first, last],
                multiple: period,
                points,
                doubled,
                stop: watch.stop,
                integrated: &AtomicU64::new(0),
            };
            let branches = response(&question, watch.progress)?;
            let warnings = response_warnings(&question, &branches);
            Ok::<_, SteadyError>((branches, warnings))
        })?
        .map_err(|error| run_error(py, &error))?;
        let findings = response_findings(&self.destination(), &variable, &branches, &warnings);
        Ok(self.answer(findings))
    }

    /// Natural frequencies over the speed.
    fn campbell(
        &self,
        py: Python<'_>,
        ends: [String; 2],
        count: usize,
        orders: Vec<f64>,
        highest: Option<String>,
    ) -> PyResult<Answer> {
        let read = |text: &String| speed(text).map_err(|issue| issue_error(py, &issue));
        let (from, to) = (read(&ends[0])?, read(&ends[1])?);
        let highest = highest.map(|text| frequency(&text).map_err(|issue| issue_error(py, &issue)));
        let highest = highest.transpose()?;
        check_range([from, to], count, &orders)
            .map_err(|error| PyValueError::new_err(error.to_string()))?;
        let question = CampbellQuestion {
            rotor: self.scenario.question.rotor.clone(),
            from,
            to,
            count,
            orders,
        };
        let found = watched(py, None, None, |_| question.solve())?;
        let found = found.map_err(|error| run_error(py, &error))?.up_to(highest);
        let findings = campbell_findings(&self.destination(), &question.rotor, &found);
        Ok(self.answer(findings))
    }

    /// Speed against error of methods at tolerances, the loosest first.
    fn accuracy(
        &self,
        py: Python<'_>,
        methods: Vec<String>,
        tolerances: Vec<f64>,
        longest: String,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Answer> {
        let model = self.model(py)?;
        let refused = |issue| issue_error(py, &issue);
        let named = methods.iter().map(|name| method(name));
        let named = named.collect::<Result<Vec<_>, _>>().map_err(refused)?;
        let checked = tolerances.iter().map(|one| tolerance(&one.to_string()));
        checked.collect::<Result<Vec<_>, _>>().map_err(refused)?;
        let longest = time(&longest).map_err(refused)?;
        let known = scenario::methods();
        let question = AccuracyQuestion {
            model,
            oils: &self.scenario.oils,
            methods: if named.is_empty() { known } else { &named },
            tolerances: &tolerances,
            longest,
        };
        let found = watched(py, None, progress.as_ref(), |watch| {
            question.measure(&mut Monitor {
                stop: watch.stop,
                progress: watch.progress,
            })
        })?;
        let found = found.map_err(|error| run_error(py, &error))?;
        let findings = accuracy_findings(&self.destination(), &found);
        Ok(self.answer(findings))
    }
}

/// Designations of the bearings of the catalogue, and where their dimensions come from.
#[pyfunction]
pub fn catalogue() -> Vec<(String, String)> {
    let entries = CATALOGUE.iter();
    entries
        .map(|entry| (entry.designation.clone(), entry.source.clone()))
        .collect()
}
