//! The scenario files of a command line: checked all, before the first one runs.

use std::collections::HashMap;
use std::fmt::Display;
use std::io;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::{Outcome, stream};
use crate::scenario::{self, Scenario};

/// A checked scenario and where its results go.
pub struct Job {
    /// Name of the file as given.
    pub name: String,
    /// What it says.
    pub scenario: Scenario,
    /// Folder of its results.
    pub folder: PathBuf,
}

/// One job a file; `None` where a file is wrong, after telling all that is wrong with all of them.
pub fn jobs(files: &[PathBuf], out: &Path) -> Option<Vec<Job>> {
    let mut jobs = Vec::new();
    let mut folders: HashMap<PathBuf, &Path> = HashMap::new();
    let mut complete = true;
    for file in files {
        let name = file.display().to_string();
        let scenario = match scenario::load(file) {
            Ok(scenario) => scenario,
            Err(error) => {
                stream::tell(&error.render(stream::color()));
                complete = false;
                continue;
            }
        };
        let folder = out.join(file.file_stem().unwrap_or_default());
        if let Some(other) = folders.insert(folder.clone(), file) {
            stream::tell(&format!(
                "error: {name} and {} would both write to {}; rename one or run them apart\n",
                other.display(),
                folder.display()
            ));
            complete = false;
        }
        for warning in &scenario.warnings {
            stream::tell(&format!("warning: {name}: {warning}\n"));
        }
        jobs.push(Job {
            name,
            scenario,
            folder,
        });
    }
    complete.then_some(jobs)
}

/// An answer whose files are written, as it is shown.
pub enum Shown {
    /// For people.
    Text(String),
    /// For programs.
    Json(Value),
}

/// Shows the answers to jobs, each with the name of its file, as they come, and tells of those that
/// failed; JSON stands in one document at the end.
pub fn show<'a, F: Display>(
    as_json: bool,
    answers: impl ExactSizeIterator<Item = (&'a str, Result<Shown, F>)>,
) -> io::Result<Outcome> {
    let count = answers.len();
    let (mut outcome, mut documents) = (Outcome::Done, Vec::new());
    for (name, answer) in answers {
        match answer {
            Ok(Shown::Json(answer)) => documents.push(answer),
            Ok(Shown::Text(text)) => stream::print(&text)?,
            Err(failure) => {
                stream::tell(&format!("error: {name}: {failure}\n"));
                outcome = Outcome::Failed;
            }
        }
    }
    if as_json {
        stream::print(&document(count, documents))?;
    }
    Ok(outcome)
}

/// The answer with the paths of its files.
pub fn with_files(mut answer: Value, files: &[PathBuf]) -> Value {
    let files = files.iter().map(|file| file.display().to_string());
    answer["files"] = files.collect();
    answer
}

/// The JSON of `count` jobs: an object for one, an array for several.
pub fn document(count: usize, mut results: Vec<Value>) -> String {
    let document = match (count, results.pop()) {
        (1, Some(result)) => result,
        (_, last) => results.into_iter().chain(last).collect(),
    };
    format!("{document:#}\n")
}
