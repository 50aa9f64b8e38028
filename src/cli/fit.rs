//! `jeffcott fit`.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

use super::jobs::{Answer, Common, Failure, name_of, wrong};
use super::study::{answered, show};
use super::terminal::Progress;
use super::{Outcome, terminal};
use crate::ask::FitQuestion;
use crate::scenario;

/// Finds the values of quantities that explain what was measured, and how well they are known.
///
/// A fit file names a scenario, quantities of it with the ranges that they are sought in, and what was measured: stiffnesses,
/// displacements, natural frequencies, lines of vibration, RMS velocities, or lines of a record that `jeffcott analyze` has
/// read. Least squares by Levenberg and Marquardt, from several starts.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  jeffcott fit scenarios/studies/clearance-fit-6205.toml\n  \
                  jeffcott fit scenarios/studies/clearance-fit-6205.toml --set starts=1 --open\n\n\
                  Writes to DIR/<name of the file>/: fit_unknowns.csv, fit_observations.csv, fit_minima.csv,\n\
                  fit_profiles.csv, figures, fit.html, the scenario with the fitted values, fitted.toml, and, last,\n\
                  fit.json. Ctrl-C ends the search with the best so far.\n\n\
                  Exit code: 0 done, 1 the scene has no answer, or the search was interrupted, 2 a file is wrong."
)]
pub struct Arguments {
    /// Fit file, .toml or .json; "-" is standard input
    #[arg(required = true, value_name = "FILE")]
    file: PathBuf,
    /// Threads. Default: one for each processor
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    #[command(flatten)]
    common: Common,
}

/// Fits the unknowns of a file.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let file = &arguments.file;
    show(file, arguments.common.json, arguments.answer(file))
}

impl Arguments {
    fn answer(&self, path: &Path) -> Result<Answer, Failure> {
        let started = Instant::now();
        let file = scenario::load_fit(path, &self.common.settings.all)?;
        let folder = self.common.folder_of(path).map_err(wrong)?;
        let question = FitQuestion::new(&file, self.threads.map(usize::from));
        let answers = AtomicU64::new(0);
        let mut progress = Progress::new(&name_of(path));
        let look = || {
            progress.show_with(0.0, || {
                format!("{} answers", answers.load(Ordering::Relaxed))
            })
        };
        let found = terminal::watched(look, || question.answer(terminal::stop(), &answers))?;
        let written = found.write(&folder)?;
        Ok(answered(written, self.common.open).timed(started))
    }
}
