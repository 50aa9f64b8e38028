//! `jeffcott steady`.

use std::io;
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use super::jobs::{Answer, Failure, Files, Job};
use super::terminal::{Progress, in_words};
use super::{Outcome, terminal};
use crate::report;
use crate::scenario::OpenNumber;
use crate::simulate::Model;
use crate::steady::{ResponseQuestion, SteadyQuestion, response, response_warnings, steady};
use crate::study::Variable;

/// Finds the motion that the shaft settles to, without waiting for it, and whether it is stable.
///
/// The motion that repeats with the forcing is found by Newton's method from the state at rest. Where it
/// is not stable, a stable one of several periods is looked for beside it. Unbalance and passing balls
/// that have no common period make a motion of two frequencies. With --over, the motion is followed along
/// a number of the scenario, past turning points and doublings of its period.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  jeffcott steady scenarios/steady-7205c.toml\n  \
                  jeffcott steady scenarios/varying-compliance-6306.toml --over speed.constant \\\n    \
                  --from \"100 rad/s\" --to \"200 rad/s\"\n\n\
                  Each file writes to DIR/<its name without ending>/: steady_trace.csv,\n\
                  steady_spectrum.csv, steady_trace.svg, steady_spectrum.svg, steady.html and, last,\n\
                  steady.json; with --over response.csv, response_specials.csv, response.svg, response.html and,\n\
                  last, response.json.\n\n\
                  Exit code: 0 all motions are found, 1 a scene has none, none was found or the search\n\
                  was interrupted, 2 a file or the command line is wrong."
)]
pub struct Arguments {
    #[command(flatten)]
    files: Files,
    /// Leave out the second search, which measures the error, whatever `[integrator] verify` says
    #[arg(long)]
    no_verify: bool,
    /// How many periods of the forcing the motion takes. Default: one, or those of a stable motion beside
    /// it
    #[arg(long, value_name = "M", value_parser = clap::value_parser!(u32).range(1..=64))]
    period: Option<u32>,
    /// Number of the scenario to follow the motion along, as "speed.constant" or "load[1].constant.z"
    #[arg(long, value_name = "KEY", requires_all = ["from", "to"])]
    over: Option<String>,
    /// Its first value, as it is written in a scenario
    #[arg(
        long,
        value_name = "VALUE",
        requires = "over",
        allow_hyphen_values = true
    )]
    from: Option<String>,
    /// Its last value
    #[arg(
        long,
        value_name = "VALUE",
        requires = "over",
        allow_hyphen_values = true
    )]
    to: Option<String>,
    /// Most motions of a branch
    #[arg(long, value_name = "N", requires = "over", default_value_t = 20_000,
          value_parser = clap::value_parser!(u32).range(1..))]
    points: u32,
    /// Leave out the motions of doubled period
    #[arg(long, requires = "over")]
    no_doubled: bool,
}

/// Checks all files, then finds their motions in turn.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let prepare = |job: &mut Job| {
        let missing = "`steady` needs a table `[time]`, as `run` does";
        let model = job.motion(arguments.no_verify, missing)?;
        Ok((model, varied_number(job, arguments)?))
    };
    arguments.files.answer(prepare, |job, (model, over)| {
        let started = Instant::now();
        let answer = match &over {
            Some(over) => along(job, &model, over, arguments)?,
            None => alone(job, &model, arguments)?,
        };
        Ok(answer.timed(started))
    })
}

/// A number of the scenario and its first and last value.
struct VariedNumber {
    number: OpenNumber,
    variable: Variable,
    ends: [f64; 2],
}

fn varied_number(job: &Job, arguments: &Arguments) -> Result<Option<VariedNumber>, Failure> {
    let Arguments { over, from, to, .. } = arguments;
    let Some(((over, from), to)) = over.as_ref().zip(from.as_ref()).zip(to.as_ref()) else {
        return Ok(None);
    };
    let folder = job.file.parent().unwrap_or(Path::new(""));
    let number = OpenNumber::new(&job.scenario, over, folder)?;
    let ((first, variable), (last, _)) = (number.value(from)?, number.value(to)?);
    if first == last {
        return Err("--from and --to are the same value".into());
    }
    // the scenario exists at both ends
    number.rotor(first)?;
    number.rotor(last)?;
    Ok(Some(VariedNumber {
        number,
        variable,
        ends: [first, last],
    }))
}

fn alone(job: &Job, model: &Model, arguments: &Arguments) -> Result<Answer, Failure> {
    let pace = SearchPace::default();
    let found = pace.watched(job, || {
        steady(&SteadyQuestion {
            model,
            multiple: arguments.period,
            stop: terminal::stop(),
            integrated: &pace.periods,
        })
    })?;
    job.write(report::steady_findings(&job.destination(), model, &found))
}

/// Time that a search goes without a word.
const PATIENCE: Duration = Duration::from_secs(10);

/// How far a search has come, for whoever watches it.
#[derive(Debug, Default)]
struct SearchPace {
    /// Periods integrated.
    periods: AtomicU64,
    /// Bits of the part of the parameter's range that is followed, 0 … 1.
    part: AtomicU64,
}

impl SearchPace {
    /// Does a search and watches it from another thread.
    fn watched<T>(&self, job: &Job, search: impl FnOnce() -> T) -> T {
        let started = Instant::now();
        let mut progress = Progress::new(&job.scenario.title);
        let mut is_told = false;
        let look = move || {
            let part = f64::from_bits(self.part.load(Ordering::Relaxed));
            let elapsed = started.elapsed();
            progress.show_with(part, || self.words(part, elapsed));
            if elapsed > PATIENCE && !is_told {
                let words = self.words(part, elapsed);
                let slow = format!(
                    "slow: {words} in {:.0} s; Ctrl-C ends the search, and `jeffcott run` computes the motion from its \
                     start",
                    elapsed.as_secs_f64()
                );
                progress.hidden(|| job.warn([slow]));
                is_told = true;
            }
        };
        terminal::watched(look, search)
    }

    /// `1234 periods integrated`, and the time left where it is known.
    fn words(&self, part: f64, elapsed: Duration) -> String {
        let periods = self.periods.load(Ordering::Relaxed);
        let left = (1.0 - part) * elapsed.as_secs_f64() / part;
        match part > 0.0 {
            true => format!("{}, {periods} periods integrated", in_words(left)),
            false => format!("{periods} periods integrated"),
        }
    }
}

fn along(
    job: &Job,
    model: &Model,
    over: &VariedNumber,
    arguments: &Arguments,
) -> Result<Answer, Failure> {
    let pace = SearchPace::default();
    let varied = &over.number;
    let question = ResponseQuestion {
        model,
        family: &|value| varied.rotor(value).map_err(|issue| issue.to_string()),
        range: over.ends,
        multiple: arguments.period.unwrap_or(1),
        points: arguments.points as usize,
        doubled: !arguments.no_doubled,
        stop: terminal::stop(),
        integrated: &pace.periods,
    };
    let mut reached = |part: f64| pace.part.store(part.to_bits(), Ordering::Relaxed);
    let branches = pace.watched(job, || response(&question, &mut reached))?;
    let warnings = response_warnings(&question, &branches);
    let (destination, variable) = (job.destination(), &over.variable);
    let findings = report::response_findings(&destination, variable, &branches, &warnings);
    Ok(Answer {
        incomplete: branches.iter().any(|branch| branch.incomplete),
        ..job.write(findings)?
    })
}
