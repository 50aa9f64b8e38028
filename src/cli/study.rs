//! `jeffcott study`.

use std::io;
use std::num::{NonZeroU64, NonZeroUsize};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Instant;

use serde_json::json;

use super::demand::check_memory;
use super::jobs::{folder_of, name_of};
use super::terminal::Progress;
use super::{Outcome, terminal};
use crate::ask::BearingQuestion;
use crate::report::many::{
    Asked, Digest, Making, StudyError, StudyRuns, StudyWatch, merge as merge_parts,
};
use crate::report::{self, RunReport};
use crate::scenario::{self, Output, StudyFile};
use crate::simulate::{Monitor, RunSize, simulate};
use crate::study::many::{Ask, Shard};

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
                  where the study keeps them; around.csv of ask = \"bearing\"; figures; and, last, runs.json. A study that is killed goes\n\
                  on from its rows, runs.jsonl, when it is started again.\n\n\
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
    /// Print the document of the study, runs.json
    #[arg(long)]
    json: bool,
}

#[derive(Debug, clap::Args)]
struct Make {
    /// Study file, .toml or .json; "-" is standard input
    #[arg(required = true, value_name = "FILE")]
    file: Option<PathBuf>,
    /// Folder that the folder of the study is written to
    #[arg(long, value_name = "DIR", default_value = "output")]
    out: PathBuf,
    /// Threads. Default: one for each processor
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Make one run alone, with all its files, in the folder run-I of the study
    #[arg(long, value_name = "I", conflicts_with_all = ["shard", "restart"])]
    only: Option<u64>,
    /// Make part I of N; `jeffcott study merge` puts them together
    #[arg(long, value_name = "I/N", value_parser = shard)]
    shard: Option<Shard>,
    /// Open the page in a browser when it is written
    #[arg(long, conflicts_with_all = ["shard", "only"])]
    open: bool,
    /// Begin anew, whatever runs an earlier attempt has kept
    #[arg(long)]
    restart: bool,
    /// Print the document of the study, runs.json
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
            terminal::tell_problems(&error);
            return Ok(Outcome::WrongInput);
        }
    };
    let folder = match folder_of(file, &make.out) {
        Ok(folder) => folder,
        Err(message) => return Ok(terminal::refuse(message)),
    };
    let runs = StudyRuns::new(&study).map_err(unmade);
    let made = runs.and_then(|runs| match make.only {
        Some(number) => only(&study, &runs, &folder, number),
        None => all(&study, &runs, &folder, make),
    });
    made.unwrap_or_else(|(outcome, message)| {
        terminal::tell(&format!("error: {}: {message}\n", name_of(file)));
        Ok(outcome)
    })
}

/// How a study ended that did not come to its end, and why.
type Failure = (Outcome, String);

/// What failed on the way.
fn failed(reason: impl ToString) -> Failure {
    (Outcome::Failed, reason.to_string())
}

/// What kept the runs from being made: the study as it is asked for, or something on the way.
fn unmade(error: StudyError) -> Failure {
    let outcome = match error.is_wrong_input() {
        true => Outcome::WrongInput,
        false => Outcome::Failed,
    };
    (outcome, error.to_string())
}

/// Makes all runs, or those of a part.
fn all(
    study: &StudyFile,
    runs: &StudyRuns<'_>,
    folder: &Path,
    make: &Make,
) -> Result<io::Result<Outcome>, Failure> {
    let started = Instant::now();
    let available = || thread::available_parallelism().unwrap_or(NonZeroUsize::MIN);
    let threads = make.threads.map(usize::from);
    let threads = threads.unwrap_or_else(|| available().get());
    // what keeps the first run from beginning it tells itself
    if let Asked::Motion(first) = &runs.first
        && let Ok(size) = RunSize::of(first)
    {
        check_memory(&size, threads).map_err(|message| (Outcome::WrongInput, message))?;
    }
    let making = Making {
        folder,
        shard: make.shard.unwrap_or(Shard::WHOLE),
        threads,
        anew: make.restart,
    };
    let mut progress = Progress::new(&study.title);
    let mut watch = StudyWatch {
        stop: terminal::stop(),
        resumed: &mut |runs| {
            terminal::remark(&format!("going on behind {runs} runs that are done\n"));
        },
        progress: &mut |part| progress.show(part),
    };
    let (files, digest) = runs.make(&making, &mut watch).map_err(unmade)?;
    drop(progress);
    let count = runs.runs_of(making.shard.chains(&runs.schedule));
    let seconds = started.elapsed().as_secs_f64();
    if make.open {
        terminal::open_page(&files);
    }
    let shown = show(&study.title, &files, digest.as_ref(), make.json);
    let rate = count as f64 / seconds;
    let remark = format!("{count} runs in {seconds:.3} s, {rate:.4} a second\n");
    Ok(shown.inspect(|_| terminal::remark(&remark)))
}

/// Makes one run with all its files.
fn only(
    study: &StudyFile,
    runs: &StudyRuns<'_>,
    folder: &Path,
    number: u64,
) -> Result<io::Result<Outcome>, Failure> {
    let last = runs.schedule.runs().saturating_sub(1);
    if number > last {
        let message = format!("there is no run {number}: they count from 0 to {last}");
        return Err((Outcome::WrongInput, message));
    }
    let values = study.plan.values(runs.schedule.turn(number).point);
    let title = format!("{}, run {number}", study.title);
    let folder = folder.join(format!("run-{number}"));
    let no_run = |message| failed(format!("run {number}: {message}"));
    let (text, warnings, files) = match study.ask {
        Ask::Run => {
            let model = |values: &[f64]| study.model(values).map_err(|error| error.message);
            let maker = study.maker(runs.schedule, &model, terminal::stop());
            let alone = maker.alone(number).map_err(|error| unmade(error.into()))?;
            let model = alone.map_err(no_run)?;
            let scenario = study.scenario(&values);
            let scenario = scenario.map_err(|error| no_run(error.message))?;
            let mut output = Output::default();
            output.every = Some(NonZeroU64::MIN);
            let report = RunReport::open(&folder, output, &model, &title, scenario);
            let mut report = report.map_err(failed)?;
            let mut progress = Progress::new(&title);
            let mut monitor = Monitor {
                stop: terminal::stop(),
                progress: &mut |part| progress.show(part),
            };
            let run = simulate(&model, &mut report, &mut monitor).map_err(failed)?;
            drop(progress);
            let written = report.finish(&model, run).map_err(failed)?;
            let warnings = report::warnings(&written.document).map(str::to_owned);
            let warnings: Vec<_> = warnings.collect();
            (written.text(terminal::details()), warnings, written.files)
        }
        Ask::Bearing => {
            let scenario = study.alone(&values, &title);
            let scenario = scenario.map_err(|error| no_run(error.to_string()))?;
            let findings = BearingQuestion::new(&scenario, None, None).answer();
            let findings = findings.map_err(|error| no_run(error.to_string()))?;
            let (files, _) = findings.write(&folder).map_err(failed)?;
            let warnings = findings.warnings().map(str::to_owned).collect();
            (findings.text(terminal::details()), warnings, files)
        }
    };
    for warning in warnings {
        terminal::tell(&format!("warning: {title}: {warning}\n"));
    }
    let text = text + &report::wrote(&files);
    Ok(terminal::summarise(&text).map(|()| Outcome::Done))
}

impl Merge {
    fn run(&self) -> io::Result<Outcome> {
        match merge_parts(&self.folder) {
            Ok((files, digest)) => show("merged", &files, Some(&digest), self.json),
            Err(error) => {
                let (outcome, message) = unmade(error);
                terminal::refuse(format!("{}: {message}", self.folder.display()));
                Ok(outcome)
            }
        }
    }
}

/// Shows what came of a study, some of whose runs may have failed, or of a part, which has no digest.
fn show(
    title: &str,
    files: &[PathBuf],
    digest: Option<&Digest>,
    as_json: bool,
) -> io::Result<Outcome> {
    for warning in digest.iter().flat_map(|digest| &digest.warnings) {
        terminal::tell(&format!("warning: {title}: {warning}\n"));
    }
    if as_json {
        let part = || json!({ "title": title });
        let mut document = digest.map_or_else(part, Digest::document);
        document["files"] = json!(files);
        terminal::print(&format!("{document:#}\n"))?;
    } else {
        let digest = digest.map(Digest::text).unwrap_or_default();
        let wrote = report::wrote(files);
        terminal::summarise(&format!("{title}\n{digest}{wrote}"))?;
    }
    Ok(match digest {
        Some(digest) if digest.failed > 0 => Outcome::Failed,
        _ => Outcome::Done,
    })
}
