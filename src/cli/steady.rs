//! `jeffcott steady`.

use std::io;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use super::jobs::{Files, Job};
use super::terminal::{Progress, in_words};
use super::{Outcome, terminal};
use crate::ask::{AskError, Followed, ResponseQuestion, SteadyQuestion};
use crate::report::Findings;
use crate::scenario::Scenario;

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
    #[arg(long, requires = "over", allow_hyphen_values = true)]
    from: Option<String>,
    /// Its last value
    #[arg(long, requires = "over", allow_hyphen_values = true)]
    to: Option<String>,
    /// Most motions of a branch
    #[arg(long, value_name = "N", requires = "over", default_value_t = ResponseQuestion::MOST_POINTS as u32,
          value_parser = clap::value_parser!(u32).range(1..))]
    points: u32,
    /// Leave out the motions of doubled period
    #[arg(long, requires = "over")]
    no_doubled: bool,
    /// Keys of the scenario that the numbers of the answer are differentiated by, as "bearing[*].preload,shaft.mass"
    #[arg(
        long,
        value_name = "KEY,KEY",
        value_delimiter = ',',
        conflicts_with = "over"
    )]
    sensitivity: Vec<String>,
}

/// A motion, or a branch of them.
enum Question<'a> {
    Motion(Box<SteadyQuestion<'a>>),
    Branch(Box<ResponseQuestion<'a>>),
}

/// Checks all files, then finds their motions in turn.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let set = |scenario: &mut Scenario| scenario.leave_out_verification(arguments.no_verify);
    arguments.files.answer(set, |job| {
        let question = arguments.question(job)?;
        Ok(Box::new(move || {
            let started = Instant::now();
            let findings = SearchPace::default().watched(job, &question)?;
            Ok(job.write(&findings)?.timed(started))
        }))
    })
}

impl Arguments {
    fn question<'j>(&self, job: &'j Job) -> Result<Question<'j>, AskError> {
        let scenario = &job.scenario;
        let Self { over, from, to, .. } = self;
        let Some(((key, from), to)) = over.as_ref().zip(from.as_ref()).zip(to.as_ref()) else {
            let mut question = SteadyQuestion::new(scenario, self.period)?;
            question.sensitivity = job.sensitivity(&self.sensitivity)?;
            return Ok(Question::Motion(Box::new(question)));
        };
        let followed = Followed { key, from, to };
        let mut question = ResponseQuestion::new(scenario, &followed, job.base())?;
        question.multiple = self.period.unwrap_or(1);
        question.points = self.points as usize;
        question.doubled = !self.no_doubled;
        Ok(Question::Branch(Box::new(question)))
    }
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
    /// Answers a question and watches the search from another thread.
    fn watched(&self, job: &Job, question: &Question<'_>) -> Result<Findings, AskError> {
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
        let (stop, integrated) = (terminal::stop(), &self.periods);
        let mut reached = |part: f64| self.part.store(part.to_bits(), Ordering::Relaxed);
        terminal::watched(look, || match question {
            Question::Motion(question) => question.answer(stop, integrated),
            Question::Branch(question) => question.answer(stop, integrated, &mut reached),
        })
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
