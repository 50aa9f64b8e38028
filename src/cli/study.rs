//! `jeffcott study`.

use std::io;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Instant;

use super::demand::check_memory;
use super::jobs::{Answer, Answers, Common, Failure, Job, name_of, wrong};
use super::run::run_motion;
use super::terminal::Progress;
use super::{Outcome, terminal};
use crate::ask::{
    Asked, BearingQuestion, Making, RunQuestion, StudyQuestion, StudyWatch, WrittenFindings, merge,
};
use crate::scenario::{self, StudyFile};
use crate::simulate::RunSize;
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
    /// Threads. Default: one for each processor
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Make one run alone, with the files of `jeffcott run` or `bearing`, in the folder run-I of the study
    #[arg(long, value_name = "I", conflicts_with_all = ["shard", "restart", "open"])]
    only: Option<u64>,
    /// Make part I of N; `jeffcott study merge` puts them together
    #[arg(long, value_name = "I/N", value_parser = shard, conflicts_with = "open")]
    shard: Option<Shard>,
    /// Begin anew, whatever runs an earlier attempt has kept
    #[arg(long)]
    restart: bool,
    #[command(flatten)]
    common: Common,
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
    if let Some(Then::Merge(parts)) = &arguments.then {
        let merged = merge(&parts.folder).map_err(Failure::from);
        return show(
            &parts.folder,
            parts.json,
            merged.map(|found| answered(found, false)),
        );
    }
    let make = &arguments.make;
    let file = make.file.as_deref().unwrap_or(Path::new(""));
    let study = scenario::load_study(file, &make.common.settings.all).map_err(Failure::from);
    let answer = study.and_then(|study| make.answer(&study, file));
    show(file, make.common.json, answer)
}

/// What was found, with its files, after telling its warnings; a browser shows its page where it `opens`.
pub(super) fn answered(found: WrittenFindings, opens: bool) -> Answer {
    let title = found.document["title"].as_str().unwrap_or_default();
    for warning in found.warnings() {
        terminal::tell(&format!("warning: {title}: {warning}\n"));
    }
    Answer::new(found, opens)
}

/// Shows the answer, or tells why there is none.
pub(super) fn show(
    path: &Path,
    json: bool,
    answer: Result<Answer, Failure>,
) -> io::Result<Outcome> {
    let mut answers = Answers::new(json, 1);
    answers.take_of(&name_of(path), answer)?;
    answers.end()
}

impl Make {
    fn answer(&self, study: &StudyFile, file: &Path) -> Result<Answer, Failure> {
        let folder = self.common.folder_of(file).map_err(wrong)?;
        let question = StudyQuestion::new(study, self.shard.unwrap_or(Shard::WHOLE))?;
        match self.only {
            None => self.all(&study.title, &question, &folder),
            Some(number) => {
                let scenario = question.alone(number, terminal::stop())?;
                alone(&Job {
                    file: file.to_owned(),
                    name: scenario.title.clone(),
                    folder: folder.join(format!("run-{number}")),
                    scenario,
                    opens: false,
                })
            }
        }
    }

    /// Makes all runs, or those of a part.
    fn all(
        &self,
        title: &str,
        question: &StudyQuestion<'_>,
        folder: &Path,
    ) -> Result<Answer, Failure> {
        let started = Instant::now();
        let available = || thread::available_parallelism().unwrap_or(NonZeroUsize::MIN);
        let threads = self.threads.map(usize::from);
        let threads = threads.unwrap_or_else(|| available().get());
        // what keeps the first run from beginning it tells itself
        if let Asked::Motion(first) = &question.first
            && let Ok(size) = RunSize::from_model(first)
        {
            check_memory(&size, threads).map_err(wrong)?;
        }
        let making = Making {
            folder,
            threads,
            anew: self.restart,
        };
        let mut progress = Progress::new(title);
        let mut watch = StudyWatch {
            stop: terminal::stop(),
            resumed: &mut |runs| {
                terminal::remark(&format!("going on behind {runs} runs that are done\n"));
            },
            progress: &mut |part| progress.show(part),
        };
        let findings = question.answer(&making, &mut watch)?;
        drop(progress);
        let (count, seconds) = (question.runs(), started.elapsed().as_secs_f64());
        let rate = count as f64 / seconds;
        Ok(Answer {
            remark: format!("{count} runs in {seconds:.3} s, {rate:.4} a second\n"),
            ..answered(findings, self.common.open)
        })
    }
}

/// Answers what one run is asked, with all its files.
fn alone(job: &Job) -> Result<Answer, Failure> {
    job.warn(&job.scenario.warnings);
    match job.scenario.model {
        Some(_) => run_motion(job, RunQuestion::new(&job.scenario)?),
        None => job.write(&BearingQuestion::new(&job.scenario, None, None).answer()?),
    }
}
