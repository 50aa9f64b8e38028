//! `jeffcott study`.

use std::io;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Instant;

use serde_json::{Value, json};

use super::demand::{TooLarge, check_memory};
use super::jobs::folder_of;
use super::progress::Progress;
use super::{Outcome, stop, stream};
use crate::report::many::{
    Digest, JournalError, MakeError, Making, MergeError, StudyRuns, StudyWatch,
    merge as merge_parts,
};
use crate::report::{self, Outputs, ReportError, RunReport};
use crate::scenario::{self, StudyFile};
use crate::simulate::{Monitor, RunSize, SimulateError, simulate};
use crate::study::many::Shard;

/// Makes many runs of one scenario: grids, samples, sweeps.
#[derive(Debug, clap::Args)]
#[command(
    args_conflicts_with_subcommands = true,
    subcommand_negates_reqs = true,
    after_help = "Examples:\n  jeffcott study scenarios/studies/resonance-7205c.toml\n  \
                  jeffcott study scenarios/studies/resonance-7205c.toml --only 3\n  \
                  jeffcott study scenarios/studies/resonance-7205c.toml --shard 1/4 --out parts\n  \
                  jeffcott study merge parts/resonance-7205c\n\n\
                  Writes to DIR/<name of the file>/: runs.csv, a row a run; spectra.csv and poincare.csv\n\
                  where the study keeps them; figures; and, last, runs.json. A study that is killed goes\n\
                  on from its journal when it is started again.\n\n\
                  Exit code: 0 all runs are done, 1 some failed, or the study was interrupted, 2 a file\n\
                  is wrong."
)]
pub struct Arguments {
    #[command(subcommand)]
    then: Option<Then>,
    #[command(flatten)]
    make: Make,
}

#[derive(Debug, clap::Subcommand)]
enum Then {
    Merge(Merge),
}

/// Puts the parts of a study together that --shard has written
#[derive(Debug, clap::Args)]
struct Merge {
    /// Folder that holds all parts
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// Print the digest as JSON
    #[arg(long)]
    json: bool,
}

#[derive(Debug, clap::Args)]
struct Make {
    /// Study file, .toml or .json
    #[arg(required = true, value_name = "FILE")]
    file: Option<PathBuf>,
    /// Folder that the folder of the study is written to
    #[arg(long, value_name = "DIR", default_value = "output")]
    out: PathBuf,
    /// Threads. Default: one for each processor
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// Make one run alone, with all its files, in the folder run-I of the study
    #[arg(long, value_name = "I", conflicts_with_all = ["shard", "restart"])]
    only: Option<u64>,
    /// Make part I of N; `jeffcott study merge` puts them together
    #[arg(long, value_name = "I/N", value_parser = shard)]
    shard: Option<Shard>,
    /// Begin anew, whatever runs an earlier attempt has kept
    #[arg(long)]
    restart: bool,
    /// Print the digest as JSON
    #[arg(long)]
    json: bool,
}

/// `2/8`: part 2 of 8.
fn shard(text: &str) -> Result<Shard, String> {
    let parts = text.split_once('/');
    let numbers = parts.and_then(|(number, count)| {
        let number = number.trim().parse().ok()?;
        Some((number, count.trim().parse().ok()?))
    });
    match numbers {
        Some((number, count)) if 1 <= number && number <= count => Ok(Shard { number, count }),
        Some((number, count)) => Err(format!("there is no part {number} of {count}")),
        None => Err("write part and number of parts, as in 2/8".to_owned()),
    }
}

/// Makes the runs of a study, or puts its parts together.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    if let Some(Then::Merge(merge)) = &arguments.then {
        return merge.run();
    }
    let make = &arguments.make;
    let file = make.file.as_deref().unwrap_or(Path::new(""));
    let study = match scenario::load_study(file) {
        Ok(study) => study,
        Err(error) => {
            stream::tell(&error.render(stream::color()));
            return Ok(Outcome::WrongInput);
        }
    };
    let name = file.display().to_string();
    let Some(folder) = folder_of(file, &make.out) else {
        return Ok(Outcome::WrongInput);
    };
    let told = match Task::new(&study, make, folder) {
        Ok(task) => task.run(),
        Err(failure) => Err(failure),
    };
    match told {
        Ok(outcome) => Ok(outcome),
        Err(Failure::Output(error)) => Err(error),
        Err(failure) => {
            stream::tell(&format!("error: {name}: {failure}\n"));
            Ok(failure.outcome())
        }
    }
}

/// Why a study did not come to its end, in words.
#[derive(Debug, thiserror::Error)]
enum Failure {
    #[error(transparent)]
    Make(#[from] MakeError),
    #[error(transparent)]
    Report(#[from] ReportError),
    #[error(transparent)]
    Simulate(#[from] SimulateError),
    #[error(transparent)]
    TooLarge(#[from] TooLarge),
    #[error("there is no run {number}: they count from 0 to {last}")]
    NoRun { number: u64, last: u64 },
    #[error("run {number}: {message}")]
    Run { number: u64, message: String },
    #[error(transparent)]
    Output(#[from] io::Error),
}

impl Failure {
    fn outcome(&self) -> Outcome {
        match self {
            Self::TooLarge(_)
            | Self::NoRun { .. }
            | Self::Make(
                MakeError::First(_)
                | MakeError::NoPart { .. }
                | MakeError::Journal(JournalError::Other { .. } | JournalError::Unreadable { .. }),
            ) => Outcome::WrongInput,
            _ => Outcome::Failed,
        }
    }
}

/// A checked study and what is asked of it.
struct Task<'a> {
    study: &'a StudyFile,
    make: &'a Make,
    folder: PathBuf,
    runs: StudyRuns<'a>,
}

impl<'a> Task<'a> {
    fn new(study: &'a StudyFile, make: &'a Make, folder: PathBuf) -> Result<Self, Failure> {
        Ok(Self {
            study,
            make,
            folder,
            runs: StudyRuns::new(study)?,
        })
    }

    fn run(&self) -> Result<Outcome, Failure> {
        match self.make.only {
            Some(number) => self.only(number),
            None => self.all(),
        }
    }

    fn all(&self) -> Result<Outcome, Failure> {
        let started = Instant::now();
        // what keeps the first run from beginning it tells itself
        if let Ok(size) = RunSize::of(&self.runs.first) {
            check_memory(&size, self.threads())?;
        }
        let title = &self.study.title;
        let mut progress = Progress::new(title);
        let making = Making {
            folder: &self.folder,
            shard: self.make.shard.unwrap_or(Shard::WHOLE),
            threads: self.threads(),
            anew: self.make.restart,
        };
        let mut watch = StudyWatch {
            stop: stop::flag(),
            resumed: &mut |runs| {
                stream::tell(&format!("going on behind {runs} runs that are done\n"));
            },
            progress: &mut |part| progress.show(part),
        };
        let (files, digest) = self.runs.make(&making, &mut watch)?;
        drop(progress);
        let schedule = &self.runs.schedule;
        let runs = schedule.runs_of(making.shard.chains(schedule));
        let runs = runs.end - runs.start;
        let seconds = started.elapsed().as_secs_f64();
        show(title, &files, digest.as_ref(), self.make.json)?;
        let rate = runs as f64 / seconds;
        stream::tell(&format!(
            "{runs} runs in {seconds:.3} s, {rate:.4} a second\n"
        ));
        Ok(outcome(digest.as_ref()))
    }

    /// Threads that make runs: as many as asked for, or as the machine has.
    fn threads(&self) -> usize {
        let available = || thread::available_parallelism().unwrap_or(NonZeroUsize::MIN);
        self.make.threads.unwrap_or_else(available).get()
    }

    /// Makes one run with all its files.
    fn only(&self, number: u64) -> Result<Outcome, Failure> {
        let schedule = self.runs.schedule;
        let last = schedule.runs().saturating_sub(1);
        if number > last {
            return Err(Failure::NoRun { number, last });
        }
        let failed = |message| Failure::Run { number, message };
        let model = |values: &[f64]| self.study.model(values).map_err(|error| error.message);
        let maker = self.study.maker(schedule, &model, stop::flag());
        let alone = maker.alone(number).map_err(MakeError::from)?;
        let model = alone.map_err(failed)?;
        let freedoms = self.runs.first.rotor.shaft.freedoms.count();
        let title = format!("{}, run {number}", self.study.title);
        let turn = schedule.chain(schedule.chain_of(number));
        let point = turn
            .filter(|turn| turn.number == number)
            .map(|turn| turn.point)
            .next();
        let values = self.study.plan.values(point.unwrap_or(0));
        let outputs = Outputs {
            trace: true,
            energy: model.energy || model.rotor.drive.is_some(),
            drive: model.rotor.drive.is_some(),
            events: true,
            spectrum: true,
            figures: true,
            page: true,
            ..Outputs::default()
        };
        let scenario = self.study.scenario(&values);
        let scenario = scenario.map_err(|error| failed(error.message))?;
        let folder = self.folder.join(format!("run-{number}"));
        let mut report = RunReport::open(&folder, outputs, &title, scenario, freedoms)?;
        let mut progress = Progress::new(&title);
        let mut monitor = Monitor {
            stop: stop::flag(),
            progress: &mut |part| progress.show(part),
        };
        let run = simulate(&model, &mut report, &mut monitor)?;
        drop(progress);
        let files = report.finish(&model, &run)?;
        stream::print(&report::text(&title, &model, &run, &files))?;
        Ok(Outcome::Done)
    }
}

impl Merge {
    fn run(&self) -> io::Result<Outcome> {
        match merge_parts(&self.folder) {
            Ok((files, digest)) => {
                show("merged", &files, Some(&digest), self.json)?;
                Ok(outcome(Some(&digest)))
            }
            Err(error) => {
                stream::tell(&format!("error: {}: {error}\n", self.folder.display()));
                Ok(match error {
                    MergeError::Report(_) => Outcome::Failed,
                    _ => Outcome::WrongInput,
                })
            }
        }
    }
}

fn outcome(digest: Option<&Digest>) -> Outcome {
    match digest {
        Some(digest) if digest.failed > 0 => Outcome::Failed,
        _ => Outcome::Done,
    }
}

/// Shows what came of a study.
fn show(title: &str, files: &[PathBuf], digest: Option<&Digest>, as_json: bool) -> io::Result<()> {
    for warning in digest.iter().flat_map(|digest| &digest.warnings) {
        stream::tell(&format!("warning: {title}: {warning}\n"));
    }
    let paths = files.iter().map(|file| file.display().to_string());
    if as_json {
        let digest = digest.map(Digest::summary);
        let paths: Value = paths.collect();
        let document = json!({ "title": title, "digest": digest, "files": paths });
        return stream::print(&format!("{document:#}\n"));
    }
    let mut text = format!("{title}\n");
    if let Some(digest) = digest {
        text += &digest.text();
    }
    paths.for_each(|path| text += &format!("  wrote {path}\n"));
    stream::print(&text)
}
