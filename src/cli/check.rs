//! `jeffcott check`.

use std::io;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::{Outcome, stream};
use crate::scenario::{self, ScenarioError};

/// Checks scenario and study files without running them; shows all that is wrong.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Example:\n  jeffcott check scenarios/steady-7205c.toml\n\n\
                        Exit code: 0 all files are right, 2 a file is wrong."
)]
pub struct Arguments {
    /// Scenario or study files, .toml or .json
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Print the findings as JSON
    #[arg(long)]
    json: bool,
}

/// Checks every file.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let mut outcome = Outcome::Done;
    let mut findings = Vec::new();
    for file in &arguments.files {
        let checked = check(file);
        if checked.is_err() {
            outcome = Outcome::WrongInput;
        }
        let name = file.display().to_string();
        if arguments.json {
            findings.push(finding(&name, &checked));
        } else {
            show(&name, &checked)?;
        }
    }
    if arguments.json {
        stream::print(&format!("{:#}\n", Value::Array(findings)))?;
    }
    Ok(outcome)
}

/// A file that is right.
struct Checked {
    title: String,
    warnings: Vec<String>,
}

fn check(file: &Path) -> Result<Checked, ScenarioError> {
    if scenario::is_study(file) {
        return scenario::load_study(file).map(|study| Checked {
            title: study.title,
            warnings: Vec::new(),
        });
    }
    scenario::load(file).map(|scenario| Checked {
        title: scenario.title,
        warnings: scenario.warnings,
    })
}

fn finding(name: &str, checked: &Result<Checked, ScenarioError>) -> Value {
    match checked {
        Ok(scenario) => json!({
            "file": name,
            "ok": true,
            "title": scenario.title,
            "warnings": scenario.warnings,
            "issues": [],
        }),
        Err(error) => json!({
            "file": name,
            "ok": false,
            "title": null,
            "warnings": [],
            "issues": error.issues_json(),
        }),
    }
}

fn show(name: &str, checked: &Result<Checked, ScenarioError>) -> io::Result<()> {
    match checked {
        Ok(scenario) => {
            for warning in &scenario.warnings {
                stream::tell(&format!("warning: {name}: {warning}\n"));
            }
            stream::print(&format!("{name}: ok, {}\n", scenario.title))
        }
        Err(error) => {
            stream::tell(&error.render(stream::color()));
            Ok(())
        }
    }
}
