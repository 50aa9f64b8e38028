//! Errors of the crate as exceptions of the package.

use jeffcott::ask::AskError;
use jeffcott::scenario::{Issue, ScenarioError};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

/// An exception of the package by its name.
fn exception(py: Python<'_>, name: &str, arguments: (String, String)) -> PyErr {
    let raised = py
        .import("jeffcott._errors")
        .and_then(|module| module.getattr(name)?.call1(arguments));
    raised.map_or_else(|error| error, PyErr::from_value)
}

/// `ScenarioError` with all problems of a scenario or of a study.
pub fn scenario_error(py: Python<'_>, error: &ScenarioError) -> PyErr {
    let problems = error.issues_json().to_string();
    exception(py, "ScenarioError", (error.render(false), problems))
}

/// `ScenarioError` of a value that was handed over by itself.
pub fn issue_error(py: Python<'_>, issue: &Issue) -> PyErr {
    let problem = serde_json::json!([{
        "key": issue.path,
        "message": issue.message,
        "line": null,
        "column": null,
        "help": issue.help,
    }]);
    exception(
        py,
        "ScenarioError",
        (issue.to_string(), problem.to_string()),
    )
}

/// `RunError`: the question is right, but there is no answer.
pub fn run_error(py: Python<'_>, error: &dyn std::error::Error) -> PyErr {
    let causes = std::iter::successors(error.source(), |cause| cause.source());
    let said = error.to_string();
    let mut text = said.clone();
    for cause in causes.map(ToString::to_string) {
        // a message may tell its cause already
        if !text.contains(&cause) {
            text += &format!(": {cause}");
        }
    }
    exception(py, "RunError", (text, "[]".to_owned()))
}

/// What is asked wrongly is a `ScenarioError`, what has no answer a `RunError`.
pub fn ask_error(py: Python<'_>, error: &AskError) -> PyErr {
    match error {
        AskError::Asked(issue) => issue_error(py, issue),
        other => run_error(py, other),
    }
}

/// What memory or a thread refuses.
pub fn other(error: impl std::fmt::Display) -> PyErr {
    PyRuntimeError::new_err(error.to_string())
}
