//! The scenario files of a command line: checked all, before the first one runs.

use std::collections::HashMap;
use std::error::Error;
use std::io;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::{Outcome, stream};
use crate::report::{Destination, Written};
use crate::scenario::{self, Scenario};
use crate::simulate::Model;

/// Why a job failed, in words.
pub type Failure = Box<dyn Error>;

/// Scenario files, and where and how the answers to them are given.
#[derive(Debug, clap::Args)]
pub struct Files {
    /// Scenario files, .toml or .json
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Folder that the folders of the results are written to
    #[arg(long, value_name = "DIR", default_value = "output")]
    pub out: PathBuf,
    /// Print the results as JSON: an object, or an array for several files
    #[arg(long)]
    json: bool,
}

/// A checked scenario and where its results go.
pub struct Job {
    /// Name of the file as given.
    pub name: String,
    /// What it says.
    pub scenario: Scenario,
    /// Folder of its results.
    pub folder: PathBuf,
}

/// An answer whose files are written.
pub struct Answer {
    /// For people.
    pub text: String,
    /// For people, on stderr.
    pub told: String,
    /// For programs.
    pub json: Value,
    /// Whether it leaves out a part of what was asked for, of which a warning tells.
    pub incomplete: bool,
}

impl Files {
    /// Checks all files and what `prepare` needs of them, then answers them in turn, as they come; JSON
    /// stands in one document at the end, where a file without an answer has its `error`.
    ///
    /// # Errors
    /// Whatever keeps stdout from taking the answers.
    pub fn answer<T>(
        &self,
        prepare: impl Fn(&mut Job) -> Result<T, Failure>,
        answer: impl Fn(&Job, T) -> Result<Answer, Failure>,
    ) -> io::Result<Outcome> {
        let Some(tasks) = self.jobs().and_then(|jobs| tasks(jobs, prepare)) else {
            return Ok(Outcome::WrongInput);
        };
        let count = tasks.len();
        let (mut outcome, mut documents) = (Outcome::Done, Vec::new());
        for (job, task) in tasks {
            let answer = answer(&job, task);
            if answer.as_ref().is_ok_and(|answer| answer.incomplete) {
                outcome = Outcome::Failed;
            }
            match answer {
                Ok(answer) if self.json => documents.push(answer.json),
                Ok(answer) => {
                    stream::print(&answer.text)?;
                    stream::tell(&answer.told);
                }
                Err(failure) => {
                    let message = failure.to_string();
                    job.tell("error", &message);
                    outcome = Outcome::Failed;
                    documents.push(json!({ "file": job.name, "error": message }));
                }
            }
        }
        if self.json {
            stream::print(&document(count, documents))?;
        }
        Ok(outcome)
    }

    /// One job a file; `None` where a file is wrong, after telling all that is wrong with all of them.
    fn jobs(&self) -> Option<Vec<Job>> {
        let mut jobs = Vec::new();
        let mut folders: HashMap<PathBuf, &Path> = HashMap::new();
        let mut complete = true;
        for file in &self.files {
            let name = file.display().to_string();
            let scenario = match scenario::load(file) {
                Ok(scenario) => scenario,
                Err(error) => {
                    stream::tell(&error.render(stream::color()));
                    complete = false;
                    continue;
                }
            };
            let Some(folder) = folder_of(file, &self.out) else {
                complete = false;
                continue;
            };
            if let Some(other) = folders.insert(folder.clone(), file) {
                stream::tell(&format!(
                    "error: {name} and {} would both write to {}; rename one or run them apart\n",
                    other.display(),
                    folder.display()
                ));
                complete = false;
            }
            let job = Job {
                name,
                scenario,
                folder,
            };
            job.warn(&job.scenario.warnings);
            jobs.push(job);
        }
        complete.then_some(jobs)
    }
}

/// The folder of a file's results in `out`, called like the file without its ending; none, after telling, where that is
/// no name.
pub fn folder_of(file: &Path, out: &Path) -> Option<PathBuf> {
    let name = file.file_stem().unwrap_or_default();
    if name.is_empty() || name == "." || name == ".." {
        stream::tell(&format!(
            "error: {}: the folder of the results is called like the file without its ending, and {name:?} is no name \
             for a folder: rename the file\n",
            file.display()
        ));
        return None;
    }
    Some(out.join(name))
}

/// The jobs with what they need; `None` where one lacks it, after telling of all of them.
fn tasks<T>(
    jobs: Vec<Job>,
    prepare: impl Fn(&mut Job) -> Result<T, Failure>,
) -> Option<Vec<(Job, T)>> {
    let task = |mut job: Job| match prepare(&mut job) {
        Ok(task) => Some((job, task)),
        Err(failure) => {
            job.tell("error", &failure.to_string());
            None
        }
    };
    let tasks: Vec<_> = jobs.into_iter().map(task).collect();
    tasks.into_iter().collect()
}

impl Job {
    /// Where its results go.
    pub fn destination(&self) -> Destination<'_> {
        Destination {
            folder: &self.folder,
            title: &self.scenario.title,
            scenario: &self.scenario.echo,
            formats: &self.scenario.output.formats,
        }
    }

    /// Takes the motion, without the pass that measures its error where `no_verify` says so; `missing` is told
    /// where there is none.
    pub fn motion(&mut self, no_verify: bool, missing: &str) -> Result<Model, Failure> {
        let mut model = self.scenario.model.take().ok_or(missing)?;
        if no_verify {
            model.verify = false;
            // the summary tells what was run
            self.scenario.echo["integrator"]["verify"] = false.into();
        }
        Ok(model)
    }

    /// Tells of something about the file.
    pub fn tell(&self, kind: &str, message: &str) {
        stream::tell(&format!("{kind}: {}: {message}\n", self.name));
    }

    /// Tells warnings.
    pub fn warn(&self, warnings: impl IntoIterator<Item = impl std::fmt::Display>) {
        for warning in warnings {
            self.tell("warning", &warning.to_string());
        }
    }
}

impl Answer {
    /// An answer with the paths of its files.
    pub fn new(text: String, mut json: Value, files: &[PathBuf]) -> Self {
        let files = files.iter().map(|file| file.display().to_string());
        json["files"] = files.collect();
        Self {
            text,
            told: String::new(),
            json,
            incomplete: false,
        }
    }
}

/// An answer that is told as it is written.
impl From<Written> for Answer {
    fn from(written: Written) -> Self {
        Self::new(written.text, written.json, &written.files)
    }
}

/// The JSON of `count` jobs: an object for one, an array for several.
fn document(count: usize, mut results: Vec<Value>) -> String {
    let document = match (count, results.pop()) {
        (1, Some(result)) => result,
        (_, last) => results.into_iter().chain(last).collect(),
    };
    format!("{document:#}\n")
}
