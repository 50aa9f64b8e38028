//! `jeffcott matrices`.

use std::io;

use super::Outcome;
use super::jobs::Files;
use crate::ask::MatricesQuestion;
use crate::scenario;

/// Writes M, C, G, K and the state matrix of the linearised shaft at a speed.
///
/// The shaft is linearised about its static equilibrium at the speed: M q'' + (C + speed G) q' + K q = f, with K and C of all
/// bearings and elements. The state matrix is that of (q, q').
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  jeffcott matrices scenarios/flexible-spindle-7205c.toml\n  \
                  jeffcott matrices shaft.toml --speed \"9000 rpm\"\n\n\
                  Each file writes to DIR/<its name without ending>/: coordinates.csv, mass.csv, damping.csv,\n\
                  gyroscopic.csv, stiffness.csv, state_matrix.csv, all of them as matrices.npz,\n\
                  matrices.html and, last, matrices.json.\n\n\
                  Exit code: 0 all matrices are written, 1 a shaft has no equilibrium at the speed or a file\n\
                  cannot be written, 2 a file or the command line is wrong."
)]
pub struct Arguments {
    #[command(flatten)]
    files: Files,
    /// Position along a shaft that bends that has coordinates besides bearings, elements, loads and unbalances; repeatable
    #[arg(long, value_name = "POSITION", allow_hyphen_values = true, value_parser = scenario::position)]
    at: Vec<f64>,
    /// Speed of the shaft. Default: that at the start of the scenario
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true, value_parser = scenario::speed)]
    speed: Option<f64>,
}

/// Checks all files, then answers them in turn.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    arguments.files.answer(
        |_| {},
        |job| {
            let question = MatricesQuestion::new(&job.scenario, &arguments.at, arguments.speed)?;
            Ok(Box::new(move || job.write(&question.answer()?)))
        },
    )
}
