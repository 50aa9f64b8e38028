//! `jeffcott campbell`.

use std::io;

use super::jobs::Files;
use super::{Outcome, terminal};
use crate::ask::{CampbellQuestion, Order};
use crate::scenario;
use crate::study::campbell::MOST_SPEEDS;

/// Follows natural frequencies over the speed, and finds the critical speeds.
///
/// The shaft is linearised about its static equilibrium at every speed, with gyroscopic moments; modes
/// are followed by their shapes. No motion is computed.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  jeffcott campbell scenarios/overhung-rotor-6208.toml\n  \
                  jeffcott campbell shaft.toml --from \"1000 rpm\" --to \"9000 rpm\" --orders 1,2,bpfo\n\n\
                  Each file writes to DIR/<its name without ending>/: campbell.csv, campbell.svg,\n\
                  campbell.html and, last, campbell.json.\n\n\
                  Exit code: 0 all diagrams are drawn, 1 a shaft has no equilibrium at a speed or a file\n\
                  cannot be written, 2 a file or the command line is wrong."
)]
pub struct Arguments {
    #[command(flatten)]
    files: Files,
    /// Lowest speed
    #[arg(long, value_name = "SPEED", default_value = "0 rpm", allow_hyphen_values = true, value_parser = scenario::speed)]
    from: f64,
    /// Highest speed. Default: one and a half times the highest of the scenario
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true, value_parser = scenario::speed)]
    to: Option<f64>,
    /// Number of speeds
    #[arg(long, value_name = "N", default_value_t = 61, value_parser = clap::value_parser!(u32).range(2..=MOST_SPEEDS as i64))]
    count: u32,
    /// Frequency up to which branches are shown, as "20 kHz"; without it one and a half times the highest order at the highest
    /// speed
    #[arg(long, value_name = "FREQUENCY", allow_hyphen_values = true, value_parser = scenario::frequency)]
    highest_frequency: Option<f64>,
    /// Multiples of the shaft's frequency whose crossings are critical speeds: numbers, and "bpfo", "bpfi", "ftf"
    /// and "bsf" for those of the bearings with their cages as in a run that starts at the lowest speed
    #[arg(
        long,
        value_name = "A,B",
        allow_hyphen_values = true,
        value_delimiter = ',',
        default_value = "1"
    )]
    orders: Vec<Order>,
    /// Keys of the scenario that the numbers of the answer are differentiated by, as "bearing[*].preload,shaft.mass"
    #[arg(long, value_name = "KEY,KEY", value_delimiter = ',')]
    sensitivity: Vec<String>,
}

/// Checks all files and the range, then answers them in turn.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let (range, count) = ((arguments.from, arguments.to), arguments.count as usize);
    let (orders, highest) = (&arguments.orders, arguments.highest_frequency);
    arguments.files.answer(
        |_| {},
        |job| {
            let mut question = CampbellQuestion::new(&job.scenario, range, count, orders, highest)?;
            question.sensitivity = job.sensitivity(&arguments.sensitivity)?;
            Ok(Box::new(move || {
                job.write(&question.answer(terminal::stop())?)
            }))
        },
    )
}
