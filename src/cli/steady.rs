//! `jeffcott steady`.

use std::io;
use std::path::Path;
use std::time::Instant;

use super::jobs::{Answer, Failure, Files, Job};
use super::progress::Progress;
use super::{Outcome, stop};
use crate::report;
use crate::scenario::OpenNumber;
use crate::simulate::Model;
use crate::steady::{ResponseQuestion, SteadyQuestion, response, steady};
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
                  steady_spectrum.csv, steady_trace.svg, steady_spectrum.svg and, last, steady.json; with\n\
                  --over response.csv, response_specials.csv, response.svg and, last, response.json.\n\n\
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
    /// Number of the scenario to follow the motion along, as "speed.constant" or "load[0].constant.z"
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
    #[arg(long, value_name = "N", requires = "over", default_value_t = 20_000)]
    points: usize,
    /// Leave out the motions of doubled period
    #[arg(long, requires = "over")]
    no_doubled: bool,
}

/// Checks all files, then finds their motions in turn.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let prepare = |job: &mut Job| {
        let missing = "`steady` needs a table `[time]`, as `run` does";
        let model = job.motion(arguments.no_verify, missing)?;
        Ok((model, stretch(job, arguments)?))
    };
    arguments.files.answer(prepare, |job, (model, stretch)| {
        let started = Instant::now();
        let mut answer = match &stretch {
            Some(stretch) => along(job, &model, stretch, arguments)?,
            None => alone(job, &model, arguments)?,
        };
        let seconds = started.elapsed().as_secs_f64();
        answer.json["wall_time_s"] = seconds.into();
        answer.told = format!("done in {seconds:.3} s\n");
        Ok(answer)
    })
}

/// A number of the scenario and its first and last value.
struct Stretch {
    varied: OpenNumber,
    variable: Variable,
    ends: [f64; 2],
}

fn stretch(job: &Job, arguments: &Arguments) -> Result<Option<Stretch>, Failure> {
    let Arguments { over, from, to, .. } = arguments;
    let Some(((over, from), to)) = over.as_ref().zip(from.as_ref()).zip(to.as_ref()) else {
        return Ok(None);
    };
    let folder = Path::new(&job.name).parent().unwrap_or(Path::new(""));
    let varied = OpenNumber::new(&job.scenario, over, folder)?;
    let ((first, variable), (last, _)) = (varied.value(from)?, varied.value(to)?);
    if first == last {
        return Err("--from and --to are the same value".into());
    }
    // the scenario exists at both ends
    varied.rotor(first)?;
    varied.rotor(last)?;
    Ok(Some(Stretch {
        varied,
        variable,
        ends: [first, last],
    }))
}

fn alone(job: &Job, model: &Model, arguments: &Arguments) -> Result<Answer, Failure> {
    let destination = job.destination();
    let found = steady(&SteadyQuestion {
        model,
        multiple: arguments.period,
        stop: stop::flag(),
    })?;
    job.warn(&found.warnings);
    let answer = report::steady_answer(&destination, model, &found);
    let files = destination.write(&answer)?;
    let text = report::steady_text(destination.title, model, &found, &files);
    Ok(Answer::new(text, answer.document, &files))
}

fn along(
    job: &Job,
    model: &Model,
    stretch: &Stretch,
    arguments: &Arguments,
) -> Result<Answer, Failure> {
    let destination = job.destination();
    let mut progress = Progress::new(destination.title);
    let varied = &stretch.varied;
    let question = ResponseQuestion {
        model,
        family: &|value| varied.rotor(value).map_err(|issue| issue.to_string()),
        range: stretch.ends,
        multiple: arguments.period.unwrap_or(1),
        points: arguments.points,
        doubled: !arguments.no_doubled,
        stop: stop::flag(),
    };
    let branches = response(&question, &mut |part| progress.show(part))?;
    drop(progress);
    let incomplete = || branches.iter().filter(|branch| branch.incomplete);
    job.warn(incomplete().map(|branch| &branch.end));
    let variable = &stretch.variable;
    let answer = report::response_answer(&destination, variable, &branches);
    let files = destination.write(&answer)?;
    let text = report::response_text(destination.title, variable, &branches, &files);
    Ok(Answer {
        incomplete: incomplete().next().is_some(),
        ..Answer::new(text, answer.document, &files)
    })
}
