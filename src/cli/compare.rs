//! `jeffcott compare`.

use std::error::Error;
use std::io::{self, ErrorKind};
use std::path::PathBuf;

use super::{Outcome, stream};
use crate::report::compare::{CompareError, Comparison, Tolerance, Tolerances, compare};

/// Compares two traces or spectra, or all tables of two run folders.
///
/// Columns are matched by name, rows by number. Values agree where
/// |a − b| ≤ absolute + relative · max|column|. Phases are compared modulo 2π, and only where the
/// amplitude is beyond its own tolerance.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Example:\n  jeffcott compare output/old output/new --relative 1e-4 --column \
                  force_z_N=1e-3,0.5\n\nExit code: 0 equal within tolerance, 1 different, 2 not \
                  comparable."
)]
pub struct Arguments {
    /// First CSV file or run folder
    #[arg(value_name = "A")]
    first: PathBuf,
    /// Second CSV file or run folder
    #[arg(value_name = "B")]
    second: PathBuf,
    /// Allowed difference as part of the largest magnitude in the column
    #[arg(
        long,
        value_name = "R",
        default_value_t = 1e-6,
        allow_negative_numbers = true
    )]
    relative: f64,
    /// Allowed difference in the unit of the column, added to the relative one
    #[arg(
        long,
        value_name = "A",
        default_value_t = 0.0,
        allow_negative_numbers = true
    )]
    absolute: f64,
    /// Another tolerance for one column; may be given several times
    #[arg(long = "column", value_name = "NAME=R[,A]", value_parser = column)]
    columns: Vec<Column>,
    /// Print the result as JSON
    #[arg(long)]
    json: bool,
}

/// A tolerance for one column.
#[derive(Debug, Clone)]
struct Column {
    name: String,
    tolerance: Tolerance,
}

fn column(text: &str) -> Result<Column, Box<dyn Error + Send + Sync>> {
    let (name, tolerance) = text
        .split_once('=')
        .ok_or("expected NAME=R or NAME=R,A, as in x_m=1e-4,1e-12")?;
    let (relative, absolute) = tolerance.split_once(',').unwrap_or((tolerance, "0"));
    Ok(Column {
        name: name.trim().to_owned(),
        tolerance: Tolerance::new(number(relative)?, number(absolute)?)?,
    })
}

fn number(text: &str) -> Result<f64, String> {
    let text = text.trim();
    text.parse()
        .map_err(|_| format!("{text:?} is not a number"))
}

/// Compares and prints the worst place of every column.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    match comparison(arguments) {
        Err(error) => {
            stream::tell(&message(&error));
            Ok(Outcome::WrongInput)
        }
        Ok(comparison) => {
            show(&comparison, arguments.json)?;
            Ok(if comparison.agrees() {
                Outcome::Done
            } else {
                Outcome::Differs
            })
        }
    }
}

fn comparison(arguments: &Arguments) -> Result<Comparison, CompareError> {
    let default = Tolerance::new(arguments.relative, arguments.absolute)?;
    let columns = arguments.columns.iter();
    let tolerances = columns.fold(Tolerances::uniform(default), |tolerances, column| {
        tolerances.with_column(&column.name, column.tolerance)
    });
    compare(&arguments.first, &arguments.second, &tolerances)
}

/// Prints the result; a reader that goes away early does not change the verdict.
fn show(comparison: &Comparison, json: bool) -> io::Result<()> {
    let text = if json {
        format!("{:#}\n", comparison.to_json())
    } else {
        format!("{comparison}\n")
    };
    match stream::print(&text) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        printed => printed,
    }
}

/// The error and all its causes in one line.
fn message(error: &CompareError) -> String {
    let causes = std::iter::successors(error.source(), |cause| (*cause).source());
    let causes: String = causes.map(|cause| format!(": {cause}")).collect();
    format!("error: {error}{causes}\n")
}
