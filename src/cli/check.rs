//! `jeffcott check`.

use std::fmt::Display;
use std::io;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::demand::Demand;
use super::jobs::{Settings, name_of};
use super::{Outcome, terminal};
use crate::ask::{Asked, StudyQuestion};
use crate::quasi_static::quasi_static;
use crate::report::scene::scene_figure;
use crate::report::{versioned, write_whole};
use crate::rotor::RotorDefinition;
use crate::scenario::{self, Issue, Loaded, ScenarioError};
use crate::study::many::Shard;

/// Checks scenario, study, fit and record files without running them; shows all that is wrong, and what a run takes. A scenario whose
/// shaft cannot be built, or has no equilibrium, is wrong as well.
///
/// The memory is somewhat more than a run turns out to take. How long a run takes its progress tells.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  jeffcott check scenarios/steady-7205c.toml\n  \
                        jeffcott check scenarios/steady-7205c.toml --figure shaft.svg\n\n\
                        Exit code: 0 all files are right, 2 a file is wrong."
)]
pub struct Arguments {
    /// Scenario, study, fit or record files, .toml or .json; "-" is standard input
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Draw the shaft of the scenario to scale, with all its parts
    #[arg(long, value_name = "FILE.svg")]
    figure: Option<PathBuf>,
    /// Print the findings as JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    settings: Settings,
}

/// Checks every file.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let mut outcome = Outcome::Done;
    let mut findings = Vec::new();
    for file in &arguments.files {
        let checked = check(file, &arguments.settings.all);
        let is_right = match (&checked, &arguments.figure) {
            (Ok(checked), Some(figure)) => draw(checked, figure),
            (checked, _) => checked.is_ok(),
        };
        if !is_right {
            outcome = Outcome::WrongInput;
        }
        let name = name_of(file);
        if arguments.json {
            findings.push(finding(&name, &checked));
        } else {
            show(&name, &checked)?;
        }
    }
    if arguments.json {
        terminal::print(&format!("{:#}\n", Value::Array(findings)))?;
    }
    Ok(outcome)
}

/// A file that is right.
struct Checked {
    title: String,
    warnings: Vec<String>,
    /// What it takes; none where nothing moves, and of a study whose first run cannot begin.
    demand: Option<Demand>,
    /// The shaft with its parts; none of a study and of a record.
    scene: Option<RotorDefinition>,
}

/// Draws the shaft with its parts; tells why where that cannot be.
fn draw(checked: &Checked, file: &Path) -> bool {
    let Some(scene) = &checked.scene else {
        terminal::refuse("--figure draws the shaft of a scenario, and this file has none");
        return false;
    };
    let drawn = scene_figure(&checked.title, scene).svg();
    let written = write_whole(file, drawn.as_bytes());
    if let Err(error) = &written {
        terminal::refuse(error);
    }
    written.is_ok()
}

/// The error of a file that has no answer.
fn refused<E: Display>(file: &Path) -> impl FnOnce(E) -> ScenarioError {
    let name = name_of(file);
    move |error| ScenarioError::new(&name, "", vec![Issue::new("", error.to_string())])
}

/// Checks a file, and whether its motion can begin, or without one its shaft has an equilibrium.
fn check(file: &Path, settings: &[String]) -> Result<Checked, ScenarioError> {
    let mut checked = match scenario::load_any(file, settings)? {
        Loaded::Study(study) => {
            let StudyQuestion {
                first, schedule, ..
            } = StudyQuestion::new(&study, Shard::WHOLE).map_err(refused(file))?;
            let failing = |error: &dyn Display| vec![format!("the first run fails: {error}")];
            let (demand, warnings) = match first {
                Asked::Motion(model) => {
                    let warnings = model.first_warnings();
                    let warnings = warnings.unwrap_or_else(|error| failing(&error));
                    (
                        Demand::from_study(&model, &study, schedule.runs()).ok(),
                        warnings,
                    )
                }
                Asked::Static(question) => {
                    let found = quasi_static(&question).map(|answer| answer.warnings);
                    (None, found.unwrap_or_else(|error| failing(&error)))
                }
            };
            Checked {
                demand,
                warnings,
                title: study.title,
                scene: None,
            }
        }
        Loaded::Fit(fit) => Checked {
            title: fit.title,
            warnings: fit.warnings,
            demand: None,
            scene: None,
        },
        Loaded::Record(record) => Checked {
            title: record.about.title,
            warnings: record.about.warnings,
            demand: None,
            scene: None,
        },
        Loaded::Scenario(scenario) => {
            let model = scenario.model.as_ref();
            let demand = model.map(|model| Demand::from_scenario(&scenario, model));
            let warnings = match model {
                Some(model) => model.first_warnings().map_err(refused(file))?,
                None => {
                    let found = quasi_static(&scenario.question);
                    found.map_err(refused(file))?.warnings
                }
            };
            Checked {
                demand: demand.transpose().map_err(refused(file))?,
                scene: Some(scenario.question.rotor.clone()),
                title: scenario.title,
                warnings,
            }
        }
    };
    let refused = checked.demand.as_ref().and_then(Demand::memory_warning);
    checked.warnings.extend(refused);
    Ok(checked)
}

fn finding(name: &str, checked: &Result<Checked, ScenarioError>) -> Value {
    versioned(match checked {
        Ok(scenario) => json!({
            "file": name,
            "ok": true,
            "title": scenario.title,
            "warnings": scenario.warnings,
            "demand": scenario.demand.as_ref().map(Demand::json),
            "issues": [],
        }),
        Err(error) => json!({
            "file": name,
            "ok": false,
            "title": null,
            "warnings": [],
            "issues": error.issues_json(),
        }),
    })
}

fn show(name: &str, checked: &Result<Checked, ScenarioError>) -> io::Result<()> {
    match checked {
        Ok(scenario) => {
            for warning in &scenario.warnings {
                terminal::tell(&format!("warning: {name}: {warning}\n"));
            }
            let takes = scenario.demand.as_ref();
            let takes = takes.map_or_else(String::new, |demand| format!("  {demand}\n"));
            terminal::summarise(&format!("{name}: ok, {}\n{takes}", scenario.title))
        }
        Err(error) => {
            terminal::tell_problems(error);
            Ok(())
        }
    }
}
