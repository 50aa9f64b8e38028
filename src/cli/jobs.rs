//! The scenario files of a command line: checked all, before the first one runs.

use std::collections::HashMap;
use std::error::Error;
use std::fmt::Display;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Instant;

use serde_json::{Value, json};

use super::{Outcome, terminal};
use crate::ask::{AskError, Sensitivity};
use crate::report::{self, Findings, WrittenFindings};
use crate::scenario::{self, Issue, STDIN, STDIN_NAME, Scenario, ScenarioError};

/// Why a job failed, in words.
pub type Failure = Box<dyn Error>;

/// Scenario files, and where and how the answers to them are given.
#[derive(Debug, clap::Args)]
pub struct Files {
    /// Scenario files, .toml or .json; "-" is standard input
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    #[command(flatten)]
    common: Common,
}

/// What every verb is told that answers questions about files.
#[derive(Debug, clap::Args)]
pub struct Common {
    /// Folder that the folders of the results are written to
    #[arg(long, value_name = "DIR", default_value = "output")]
    pub out: PathBuf,
    /// Open the page of each result in a browser
    #[arg(long)]
    pub open: bool,
    /// Print the results as JSON: an object, or an array for several files
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub settings: Settings,
}

/// Values in place of those of the files.
#[derive(Debug, clap::Args)]
pub struct Settings {
    /// Put a value in place of that of the file, as `--set speed.constant="2000 rpm"` or `--set
    /// "bearing[*].catalogue=6305"`; checked as the file is, and repeatable. An entry one beyond the last of a
    /// list is added to it
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub all: Vec<String>,
}

/// A checked scenario and where its results go.
pub struct Job {
    /// The file as given.
    pub file: PathBuf,
    /// What messages call it.
    pub name: String,
    /// What it says.
    pub scenario: Scenario,
    /// Folder of its results.
    pub folder: PathBuf,
    /// Whether a browser is to show its page.
    pub opens: bool,
}

/// What answers a question that was found right.
pub type Answering<'j> = Box<dyn FnOnce() -> Result<Answer, Failure> + 'j>;

/// An answer whose files are written.
pub struct Answer {
    /// For people.
    pub text: String,
    /// For people, on stderr.
    pub remark: String,
    /// For programs: the document, and the files that were written.
    pub json: Value,
    /// Whether it leaves out a part of what was asked for, of which a warning tells.
    pub incomplete: bool,
}

impl Files {
    /// Checks all files, puts options in place of what the scenarios say, asks a question about each, and where all are
    /// right answers them in turn, as they come; JSON is one document at the end, where a file without an answer has its
    /// `error`.
    ///
    /// # Errors
    /// Whatever keeps stdout from taking the answers.
    pub fn answer(
        &self,
        set: impl Fn(&mut Scenario),
        ask: impl for<'j> Fn(&'j Job) -> Result<Answering<'j>, Failure>,
    ) -> io::Result<Outcome> {
        let mut answers = Answers::new(self.common.json, self.files.len());
        let mut jobs = self.jobs(&mut answers);
        if answers.outcome != Outcome::Done {
            return answers.end();
        }
        jobs.iter_mut().for_each(|job| set(&mut job.scenario));
        let mut questions = Vec::new();
        for job in &jobs {
            match ask(job) {
                Ok(question) => questions.push((job, question)),
                Err(error) => answers.fail(Outcome::WrongInput, job.failed(&error)),
            }
        }
        if answers.outcome == Outcome::Done {
            for (job, question) in questions {
                match question() {
                    Ok(answer) => answers.take(answer)?,
                    Err(failure) => answers.fail(Outcome::Failed, job.failed(&failure)),
                }
            }
        }
        answers.end()
    }

    /// One job a file, and what is wrong with the others, for programs, after telling people.
    fn jobs(&self, answers: &mut Answers) -> Vec<Job> {
        let mut jobs = Vec::new();
        let mut folders = Folders::default();
        for file in &self.files {
            let name = name_of(file);
            let mut refuse = |message: &str| {
                let outcome = terminal::refuse(message);
                answers.fail(outcome, failure(&name, message));
            };
            let scenario = match scenario::load_with(file, &self.common.settings.all) {
                Ok(scenario) => scenario,
                Err(error) => {
                    terminal::tell_problems(&error);
                    answers.fail(Outcome::WrongInput, failure(&name, &error.to_string()));
                    continue;
                }
            };
            let folder = match self.common.folder_of(file) {
                Ok(folder) => folder,
                Err(message) => {
                    refuse(&format!("{name}: {message}"));
                    continue;
                }
            };
            if let Err(message) = folders.take(&folder, file) {
                refuse(&format!("{name}: {message}"));
            }
            let job = Job {
                file: file.clone(),
                name,
                scenario,
                folder,
                opens: self.common.open,
            };
            job.warn(&job.scenario.warnings);
            jobs.push(job);
        }
        jobs
    }
}

/// Folders that results are written to, each with the file that it belongs to.
#[derive(Default)]
pub struct Folders(HashMap<PathBuf, PathBuf>);

impl Folders {
    /// Takes a folder for a file.
    ///
    /// # Errors
    /// Another file has it, whose results would be lost.
    pub fn take(&mut self, folder: &Path, file: &Path) -> Result<(), String> {
        match self.0.insert(folder.to_owned(), file.to_owned()) {
            None => Ok(()),
            Some(other) => Err(format!(
                "{} would be written to {}, too; rename one or run them apart",
                other.display(),
                folder.display()
            )),
        }
    }
}

/// The answers of a verb to its files: people are told each as it comes, programs all at the end.
pub struct Answers {
    as_json: bool,
    /// Number of files.
    files: usize,
    documents: Vec<Value>,
    /// The worst of how they ended.
    outcome: Outcome,
}

impl Answers {
    /// None yet, to so many files.
    pub fn new(as_json: bool, files: usize) -> Self {
        Self {
            as_json,
            files,
            documents: Vec::new(),
            outcome: Outcome::Done,
        }
    }

    /// Takes an answer.
    ///
    /// # Errors
    /// Whatever keeps stdout from taking it.
    pub fn take(&mut self, answer: Answer) -> io::Result<()> {
        if answer.incomplete {
            self.outcome = self.outcome.max(Outcome::Failed);
        }
        if self.as_json {
            self.documents.push(answer.json);
            return Ok(());
        }
        terminal::summarise(&answer.text)?;
        terminal::remark(&answer.remark);
        Ok(())
    }

    /// Takes the answer to a file, or tells why there is none.
    ///
    /// # Errors
    /// Whatever keeps stdout from taking it.
    pub fn take_of(&mut self, name: &str, answer: Result<Answer, Failure>) -> io::Result<()> {
        let error = match answer {
            Ok(answer) => return self.take(answer),
            // what keeps stdout from taking it concerns no file
            Err(error) => match error.downcast::<io::Error>() {
                Ok(error) => return Err(*error),
                Err(error) => error,
            },
        };
        let message = error.to_string();
        let outcome = match error.downcast_ref::<ScenarioError>() {
            Some(problems) => {
                terminal::tell_problems(problems);
                Outcome::WrongInput
            }
            None => {
                terminal::tell(&format!("error: {name}: {message}\n"));
                match error.downcast_ref() {
                    Some(AskError::Asked(_)) => Outcome::WrongInput,
                    _ => Outcome::Failed,
                }
            }
        };
        self.fail(outcome, failure(name, &message));
        Ok(())
    }

    /// Takes what programs are told of a file without an answer.
    fn fail(&mut self, outcome: Outcome, failure: Value) {
        self.outcome = self.outcome.max(outcome);
        self.documents.push(failure);
    }

    /// Ends them: for programs with one document, an object for one file, an array for several.
    ///
    /// # Errors
    /// Whatever keeps stdout from taking it.
    pub fn end(mut self) -> io::Result<Outcome> {
        if self.as_json {
            let document = match (self.files, self.documents.pop()) {
                (1, Some(result)) => result,
                (_, last) => self.documents.into_iter().chain(last).collect(),
            };
            terminal::print(&format!("{document:#}\n"))?;
        }
        Ok(self.outcome)
    }
}

/// Why a file has no answer, for programs.
fn failure(name: &str, message: &str) -> Value {
    json!({ "file": name, "error": message })
}

/// What messages call a file.
pub fn name_of(file: &Path) -> String {
    match file == Path::new(STDIN) {
        true => STDIN_NAME.to_owned(),
        false => file.display().to_string(),
    }
}

impl Common {
    /// The folder of a file's results, called like the file without its ending.
    ///
    /// # Errors
    /// That this is no name, in words.
    pub fn folder_of(&self, file: &Path) -> Result<PathBuf, String> {
        let shown = name_of(file);
        let name = Path::new(&shown).file_stem().unwrap_or_default();
        if name.is_empty() || name == "." || name == ".." {
            return Err(format!(
                "the folder of the results is called like the file without its ending, and {name:?} is no name for a \
                 folder: rename the file"
            ));
        }
        Ok(self.out.join(name))
    }
}

/// What keeps a question from being answered as it is asked.
pub fn wrong(message: impl Display) -> AskError {
    Issue::new("", message.to_string()).into()
}

impl Job {
    /// Folder that the files which its scenario names are looked for from.
    pub fn base(&self) -> &Path {
        self.file.parent().unwrap_or(Path::new(""))
    }

    /// By which keys of its scenario the answer is differentiated.
    ///
    /// # Errors
    /// [`AskError::Asked`] where there is no such number.
    pub fn sensitivity(&self, keys: &[String]) -> Result<Option<Sensitivity>, AskError> {
        Sensitivity::new(&self.scenario, keys, self.base())
    }

    /// Writes the files of what was found, and answers with it.
    pub fn write(&self, findings: &Findings) -> Result<Answer, Failure> {
        Ok(self.answer(findings.write(&self.folder)?))
    }

    /// Answers with what was found after printing those of its warnings that were not printed with the scenario.
    pub fn answer(&self, found: WrittenFindings) -> Answer {
        let known = &self.scenario.warnings;
        let warnings = found.warnings();
        self.warn(warnings.filter(|warning| known.iter().all(|known| known != warning)));
        Answer::new(found, self.opens)
    }

    /// Tells of something about the file.
    pub fn tell(&self, kind: &str, message: &str) {
        terminal::tell(&format!("{kind}: {}: {message}\n", self.name));
    }

    /// Tells why there is no answer, and returns it for programs.
    fn failed(&self, error: &impl Display) -> Value {
        let message = error.to_string();
        self.tell("error", &message);
        let mut failure = failure(&self.name, &message);
        failure["warnings"] = json!(self.scenario.warnings);
        failure
    }

    /// Tells what is good to know, unless quiet is asked for.
    pub fn note(&self, message: &str) {
        terminal::remark(&format!("note: {}: {message}\n", self.name));
    }

    /// Tells warnings.
    pub fn warn(&self, warnings: impl IntoIterator<Item = impl Display>) {
        for warning in warnings {
            self.tell("warning", &warning.to_string());
        }
    }
}

impl Answer {
    /// An answer with the paths of its files, whose page a browser shows where it `opens`.
    pub fn new(found: WrittenFindings, opens: bool) -> Self {
        if opens {
            terminal::open_page(&found.files);
        }
        let text = found.text(terminal::details()) + &report::wrote(&found.files);
        let mut json = found.document;
        let files = found.files.iter();
        json["files"] = files.map(|file| file.display().to_string()).collect();
        Self {
            text,
            incomplete: found.incomplete,
            ..Self::of_json(json)
        }
    }

    /// An answer for programs alone.
    pub fn of_json(json: Value) -> Self {
        Self {
            text: String::new(),
            remark: String::new(),
            json,
            incomplete: false,
        }
    }

    /// Takes note of the time that it took.
    pub fn timed(mut self, started: Instant) -> Self {
        let seconds = started.elapsed().as_secs_f64();
        self.json["wall_time_s"] = seconds.into();
        self.remark = format!("done in {seconds:.3} s\n");
        self
    }
}
