//! `jeffcott campbell`.

use std::io;

use super::jobs::{Answer, Failure, Files, Job};
use super::{Outcome, stream};
use crate::report;
use crate::scenario;
use crate::study::campbell::{self, CampbellQuestion};

/// Follows natural frequencies over the speed, and finds the critical speeds.
///
/// The shaft is linearised about its static equilibrium at every speed, with gyroscopic moments; modes
/// are followed by their shapes. No motion is computed, and of the speeds of the scenarios nothing is used.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  jeffcott campbell scenarios/back-to-back-7205c.toml --to \"60000 rpm\"\n  \
                  jeffcott campbell shaft.toml --from \"1000 rpm\" --to \"9000 rpm\" --orders 1,2,4.8\n\n\
                  Each file writes to DIR/<its name without ending>/: campbell.csv, campbell.svg and,\n\
                  last, campbell.json.\n\n\
                  Exit code: 0 all diagrams are drawn, 1 a shaft has no equilibrium at a speed or a file\n\
                  cannot be written, 2 a file or the command line is wrong."
)]
pub struct Arguments {
    #[command(flatten)]
    files: Files,
    /// Lowest speed
    #[arg(long, value_name = "SPEED", default_value = "0 rpm", value_parser = scenario::speed)]
    from: f64,
    /// Highest speed
    #[arg(long, value_name = "SPEED", value_parser = scenario::speed)]
    to: f64,
    /// Number of speeds
    #[arg(long, value_name = "N", default_value_t = 61, value_parser = clap::value_parser!(u32).range(2..=100_000))]
    count: u32,
    /// Multiples of the shaft's frequency whose crossings are critical speeds
    #[arg(long, value_name = "A,B", value_delimiter = ',', default_value = "1")]
    orders: Vec<f64>,
}

/// Checks the range and all files, then answers them in turn.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    if let Err(error) = campbell::check_range(
        [arguments.from, arguments.to],
        arguments.count as usize,
        &arguments.orders,
    ) {
        stream::tell(&format!("error: {error}\n"));
        return Ok(Outcome::WrongInput);
    }
    arguments
        .files
        .answer(|_| Ok(()), |job, ()| answer(job, arguments))
}

fn answer(job: &Job, arguments: &Arguments) -> Result<Answer, Failure> {
    let destination = job.destination();
    let question = CampbellQuestion {
        rotor: job.scenario.question.rotor.clone(),
        from: arguments.from,
        to: arguments.to,
        count: arguments.count as usize,
        orders: arguments.orders.clone(),
    };
    let campbell = question.solve()?;
    let answer = report::campbell_answer(&destination, &campbell);
    let files = destination.write(&answer)?;
    let text = report::campbell_text(destination.title, &campbell, &files);
    Ok(Answer::new(text, answer.document, &files))
}
