//! `jeffcott response`.

use std::io;

use super::jobs::Files;
use super::{Outcome, terminal};
use crate::ask::{COUNTS, LinearRange, LinearResponseQuestion, Place};
use crate::scenario;

/// Response of the linearised shaft to its unbalances over the speed, or to a force over its frequency.
///
/// The shaft is linearised about its static equilibrium, of its unbalances at every speed anew. Each resonance is reported
/// with its amplification factor and, of unbalances, its separation margin from the speeds of the scenario, both by API 617.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  jeffcott response scenarios/laval-rotor.toml --at \"300 mm\" --from \"500 rpm\" --to \"9000 rpm\"\n  \
                  jeffcott response shaft.toml --by \"y@100 mm\" --at \"y@250 mm\" --from \"1 Hz\" --to \"500 Hz\"\n\n\
                  Each file writes to DIR/<its name without ending>/: frequency_response.csv, resonances.csv,\n\
                  bode.svg, polar.svg, frequency_response.html and, last, frequency_response.json. A force\n\
                  gives receptance, mobility and accelerance.\n\n\
                  Exit code: 0 all responses are found, 1 a shaft has no equilibrium at a speed or a file\n\
                  cannot be written, 2 a file or the command line is wrong."
)]
pub struct Arguments {
    #[command(flatten)]
    files: Files,
    /// Where it is looked at: a position along the shaft, for x and y, or with a direction as in "y@250 mm" or
    /// "tilt_x@250 mm"; repeatable
    #[arg(
        long,
        required = true,
        value_name = "POINT",
        allow_hyphen_values = true
    )]
    at: Vec<Place>,
    /// Point and direction of a harmonic force, as "y@100 mm", or moment, as "tilt_x@100 mm"; without it the unbalances act
    #[arg(long, value_name = "POINT", allow_hyphen_values = true)]
    by: Option<Place>,
    /// Lowest speed, or with --by lowest frequency
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    from: String,
    /// Highest speed, or with --by highest frequency
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    to: String,
    /// Speed of the shaft under a force. Default: that at the start of the scenario
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true, requires = "by", value_parser = scenario::speed)]
    speed: Option<f64>,
    /// Number of speeds or frequencies
    #[arg(long, value_name = "N", default_value_t = 301, value_parser = clap::value_parser!(u32).range(COUNTS))]
    count: u32,
}

/// Checks all files and the range, then answers them in turn.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let by = arguments.by.as_ref().map(|place| (place, arguments.speed));
    let range = LinearRange {
        from: &arguments.from,
        to: &arguments.to,
        count: arguments.count as usize,
    };
    arguments.files.answer(
        |_| {},
        |job| {
            let question = LinearResponseQuestion::new(&job.scenario, &arguments.at, by, &range)?;
            Ok(Box::new(move || {
                job.write(&question.answer(terminal::stop())?)
            }))
        },
    )
}
