//! `jeffcott campbell`.

use std::f64::consts::TAU;
use std::io;

use super::jobs::{Answer, Failure, Files, Job};
use super::{Outcome, terminal, without_repeats};
use crate::physics::BallPass;
use crate::report;
use crate::rotor::CageMotion;
use crate::scenario;
use crate::study::campbell::{self, CampbellQuestion, MOST_SPEEDS};

/// Follows natural frequencies over the speed, and finds the critical speeds.
///
/// The shaft is linearised about its static equilibrium at every speed, with gyroscopic moments; modes
/// are followed by their shapes. No motion is computed, and of the speeds of the scenarios nothing is used.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  jeffcott campbell scenarios/back-to-back-7205c.toml --to \"60000 rpm\"\n  \
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
    #[arg(long, value_name = "SPEED", default_value = "0 rpm", value_parser = scenario::speed)]
    from: f64,
    /// Highest speed
    #[arg(long, value_name = "SPEED", value_parser = scenario::speed)]
    to: f64,
    /// Number of speeds
    #[arg(long, value_name = "N", default_value_t = 61, value_parser = clap::value_parser!(u32).range(2..=MOST_SPEEDS as i64))]
    count: u32,
    /// Frequency up to which branches are shown, as "20 kHz"; without it one and a half times the highest order at the highest
    /// speed
    #[arg(long, value_name = "FREQUENCY", value_parser = scenario::frequency)]
    highest_frequency: Option<f64>,
    /// Multiples of the shaft's frequency whose crossings are critical speeds: numbers, and "bpfo", "bpfi", "ftf"
    /// and "bsf" for those of the bearings with their cages as in a run that starts at the lowest speed
    #[arg(long, value_name = "A,B", value_delimiter = ',', default_value = "1", value_parser = order)]
    orders: Vec<Order>,
}

/// A multiple of the shaft's frequency, or what is one of every bearing.
#[derive(Debug, Clone, Copy)]
enum Order {
    Number(f64),
    OfBearings(&'static str, OfBearing),
}

/// The frequency of one kind, Hz.
type OfBearing = fn(&BallPass) -> f64;

/// Orders of bearings by their names.
const OF_BEARINGS: [(&str, OfBearing); 4] = [
    ("bpfo", |pass| pass.outer),
    ("bpfi", |pass| pass.inner),
    ("ftf", |pass| pass.cage),
    ("bsf", |pass| pass.spin),
];

fn order(text: &str) -> Result<Order, String> {
    let text = text.trim();
    let named = OF_BEARINGS
        .iter()
        .find(|(name, _)| text.eq_ignore_ascii_case(name));
    if let Some((name, of)) = named {
        return Ok(Order::OfBearings(name, *of));
    }
    let refused = |_| "give a number, \"bpfo\", \"bpfi\", \"ftf\" or \"bsf\"".to_owned();
    text.parse().map(Order::Number).map_err(refused)
}

/// Checks the range and all files, then answers them in turn.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let numbers = arguments.orders.iter().filter_map(|order| match order {
        Order::Number(number) => Some(*number),
        Order::OfBearings(..) => None,
    });
    let numbers: Vec<_> = numbers.collect();
    let range = [arguments.from, arguments.to];
    if let Err(error) = campbell::check_range(range, arguments.count as usize, &numbers) {
        return Ok(terminal::refuse(error));
    }
    arguments
        .files
        .answer(|_| Ok(()), |job, ()| answer(job, arguments))
}

fn answer(job: &Job, arguments: &Arguments) -> Result<Answer, Failure> {
    let question = CampbellQuestion {
        rotor: job.scenario.question.rotor.clone(),
        from: arguments.from,
        to: arguments.to,
        count: arguments.count as usize,
        orders: orders(job, arguments),
    };
    let campbell = question.solve()?.up_to(arguments.highest_frequency);
    job.write(report::campbell_findings(
        &job.destination(),
        &question.rotor,
        &campbell,
    ))
}

/// The orders as numbers, each once; says which number an order of the bearings is.
fn orders(job: &Job, arguments: &Arguments) -> Vec<f64> {
    let mut orders: Vec<f64> = Vec::new();
    for order in &arguments.orders {
        match order {
            Order::Number(number) => orders.push(*number),
            Order::OfBearings(name, of) => {
                for (number, pass) in (1..).zip(ball_passes(job, arguments.from)) {
                    let order = of(&pass);
                    if !orders.contains(&order) {
                        orders.push(order);
                        job.note(&format!("{name} of bearing {number} is order {order:.4}"));
                    }
                }
            }
        }
    }
    without_repeats(orders)
}

/// Ball passes a revolution of the shaft, with the cages as in a motion that starts at a speed in rad/s; also of cages that
/// the scene holds.
fn ball_passes(job: &Job, speed: f64) -> Vec<BallPass> {
    let mut rotor = job.scenario.question.rotor.at_constant_speed(speed);
    if !rotor.cage.turns() {
        rotor.cage = CageMotion::default();
    }
    // what cannot be built is refused by the answer
    let supports = rotor.rolling_supports().unwrap_or_default();
    let passes = supports.iter().map(|support| support.ball_pass(TAU));
    passes.collect()
}
