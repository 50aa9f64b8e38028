//! `jeffcott compare`.

use std::error::Error;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::PathBuf;

use serde_json::json;

use super::{Outcome, terminal};
use crate::report::compare::{
    CompareError, Comparison, LineRules, LinesBy, Rules, Tolerance, Tolerances, compare, document,
    write_figure, write_page,
};
use crate::scenario::ToleranceFile;

/// Relative tolerance where none is given.
const RELATIVE: f64 = 1e-6;

/// Compares traces or spectra, or all tables of folders of runs or records: each further result with the first.
///
/// Columns are matched by name, rows by number. Values agree where
/// |a − b| ≤ absolute + relative · max|column|. The mean of a spectrum, at 0 Hz, counts for no line.
/// What rows are matched by has to agree to 1e-6, unless --column gives it a tolerance of its own. Phases are compared modulo 2π,
/// and only where the amplitude is beyond its own tolerance. Unless a tolerance is zero, differences below 1e-11 of the largest value
/// among all displacements, velocities, accelerations or forces (tilts and moments through 10 mm) are round-off and
/// count as none.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Example:\n  jeffcott compare output/old output/new --relative 1e-4 --column \
                  force_z_N=1e-3,0.5\n  jeffcott compare old/spectrum.csv new/spectrum.csv --lines \
                  --worst 3 --figure difference.svg\n  jeffcott compare output/a output/b output/c --report \
                  all.html\n\nExit code: 0 equal within tolerance, 1 different, 2 not comparable."
)]
pub struct Arguments {
    /// CSV files or run folders, two and more
    #[arg(required = true, num_args = 2.., value_names = ["A", "B"])]
    results: Vec<PathBuf>,
    /// Allowed difference as part of the largest magnitude in the column [default: 1e-6]
    #[arg(long, value_name = "R", allow_negative_numbers = true)]
    relative: Option<f64>,
    /// Allowed difference in the unit of the column, added to the relative one [default: 0]
    #[arg(long, value_name = "A", allow_negative_numbers = true)]
    absolute: Option<f64>,
    /// Another tolerance for one column; may be given several times
    #[arg(long = "column", value_name = "NAME=R[,A]", value_parser = column)]
    columns: Vec<(String, Tolerance)>,
    /// Tolerances from a file: `relative`, `absolute`, and `[[column]]` with `name`, `relative` and
    /// `absolute`; options on the command line go before it
    #[arg(long, value_name = "FILE.toml")]
    tolerances: Option<PathBuf>,
    /// Show this many of the worst places of every column
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..))]
    worst: u16,
    /// Compare spectra by the N strongest lines of every column instead of row by row. Folders of runs and of records without a
    /// common column are compared by their peaks and lines of envelopes, amplitudes as velocities
    #[arg(long, value_name = "N", num_args = 0..=1, require_equals = true, default_missing_value = "10",
          value_parser = clap::value_parser!(u16).range(1..))]
    lines: Option<u16>,
    /// How lines of folders find their partners: at the frequency, at the multiple of the speed of their own shaft, or by name,
    /// BPFO to BPFO, each at its own frequency
    #[arg(
        long,
        value_name = "WHAT",
        default_value = "frequency",
        requires = "lines"
    )]
    by: LinesBy,
    /// Part of its frequency or order within which a line finds its partner [default: a bin of the coarser axis]
    #[arg(
        long,
        value_name = "PART",
        requires = "lines",
        allow_negative_numbers = true
    )]
    reach: Option<f64>,
    /// Let lines be so many dB apart, in place of the tolerances
    #[arg(long, value_name = "DB", requires = "lines", allow_negative_numbers = true,
          conflicts_with_all = ["columns", "tolerances", "relative", "absolute"])]
    decibels: Option<f64>,
    /// Leave out what only one of them has: files, columns, samples of a trace that was thinned
    #[arg(long)]
    common: bool,
    /// Draw the columns of two results that are furthest apart, both curves and their difference
    #[arg(long, value_name = "FILE.svg")]
    figure: Option<PathBuf>,
    /// Write a page that any browser shows: key numbers of runs side by side, their traces and spectra over each other, and
    /// where they differ
    #[arg(long, value_name = "FILE.html")]
    report: Option<PathBuf>,
    /// Print the result as JSON: an object, or an array for more than two
    #[arg(long)]
    json: bool,
}

/// The tolerance of one column.
fn column(text: &str) -> Result<(String, Tolerance), Box<dyn Error + Send + Sync>> {
    let (name, tolerance) = text
        .split_once('=')
        .ok_or("expected NAME=R or NAME=R,A, as in x_m=1e-4,1e-12")?;
    let (relative, absolute) = tolerance.split_once(',').unwrap_or((tolerance, "0"));
    let number = |text: &str| {
        let text = text.trim();
        let refused = |_| format!("{text:?} is not a number");
        text.parse().map_err(refused)
    };
    let tolerance = Tolerance::new(number(relative)?, number(absolute)?)?;
    Ok((name.trim().to_owned(), tolerance))
}

/// Compares and prints the worst places of every column.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    match comparisons(arguments) {
        Err(message) => failed(&message, arguments),
        Ok(comparisons) => {
            show(&comparisons, arguments)?;
            Ok(match comparisons.iter().all(Comparison::agrees) {
                true => Outcome::Done,
                false => Outcome::Failed,
            })
        }
    }
}

/// Tells why nothing is compared.
fn failed(message: &str, arguments: &Arguments) -> io::Result<Outcome> {
    terminal::tell(message);
    if arguments.json {
        let message = message.trim_end();
        let error = message.strip_prefix("error: ").unwrap_or(message);
        terminal::print(&format!("{:#}\n", json!({ "error": error })))?;
    }
    Ok(Outcome::WrongInput)
}

/// The comparisons with the first result, or why nothing is compared.
fn comparisons(arguments: &Arguments) -> Result<Vec<Comparison>, String> {
    keep_results(arguments)?;
    let file = arguments.tolerances.as_deref().map(ToleranceFile::load);
    let file = file.transpose();
    let file = file.map_err(|error| error.render(false))?;
    let rules = Rules {
        tolerances: tolerances(arguments, file.as_ref()).map_err(|error| message(&error))?,
        worst: arguments.worst.into(),
        common: arguments.common,
        lines: arguments.lines.map(|count| LineRules {
            count: count.into(),
            by: arguments.by,
            reach: arguments.reach,
            decibels: arguments.decibels,
        }),
    };
    let results = &arguments.results;
    let others = results[1..].iter();
    let comparisons = others.map(|other| compare(&results[0], other, &rules));
    let comparisons: Result<Vec<_>, _> = comparisons.collect();
    let comparisons = comparisons.map_err(|error| placed(&error, file.as_ref()))?;
    write_files(arguments, &comparisons)?;
    Ok(comparisons)
}

/// Refuses a figure or a page in place of what is compared.
fn keep_results(arguments: &Arguments) -> Result<(), String> {
    let options = [
        ("--figure", &arguments.figure),
        ("--report", &arguments.report),
    ];
    for (option, file) in options {
        let place = file.as_ref().and_then(|file| fs::canonicalize(file).ok());
        let is_it = |result: &&PathBuf| fs::canonicalize(result).ok() == place;
        let lost = place
            .as_ref()
            .and_then(|_| arguments.results.iter().find(is_it));
        if let Some(lost) = lost {
            return Err(format!(
                "error: {option} would replace {}, which is compared: give it another name\n",
                lost.display()
            ));
        }
    }
    Ok(())
}

/// Writes figure and page, where they are asked for.
fn write_files(arguments: &Arguments, comparisons: &[Comparison]) -> Result<(), String> {
    let results = &arguments.results;
    if let Some(file) = &arguments.figure {
        let ([first, second], [comparison]) = (&results[..], comparisons) else {
            return Err(
                "error: --figure draws two results; --report shows more on a page\n".into(),
            );
        };
        write_figure(comparison, [first, second], file).map_err(|error| message(&error))?;
    }
    if let Some(file) = &arguments.report {
        write_page(results, comparisons, file).map_err(|error| message(&error))?;
    }
    Ok(())
}

/// What the file says, unless the command line says otherwise.
fn tolerances(
    arguments: &Arguments,
    file: Option<&ToleranceFile>,
) -> Result<Tolerances, CompareError> {
    let file = file.map(|file| &file.input);
    let relative = arguments.relative.or(file.and_then(|file| file.relative));
    let absolute = arguments.absolute.or(file.and_then(|file| file.absolute));
    let default = Tolerance::new(relative.unwrap_or(RELATIVE), absolute.unwrap_or(0.0))?;
    let mut tolerances = Tolerances::uniform(default);
    for column in file.iter().flat_map(|file| &file.column) {
        let tolerance = Tolerance::new(column.relative, column.absolute)?;
        tolerances = tolerances.with_column(&column.name, tolerance);
    }
    for (name, tolerance) in &arguments.columns {
        tolerances = tolerances.with_column(name, *tolerance);
    }
    Ok(tolerances)
}

/// A column that no table has is shown where the file names it.
fn placed(error: &CompareError, file: Option<&ToleranceFile>) -> String {
    if let (CompareError::UnknownColumn { name, known }, Some(file)) = (error, file)
        && let Some(placed) = file.unused(name, known)
    {
        return placed.render(false);
    }
    message(error)
}

/// Prints the result; a reader that goes away early does not change the verdict.
fn show(comparisons: &[Comparison], arguments: &Arguments) -> io::Result<()> {
    let printed = match arguments.json {
        true => terminal::print(&format!("{:#}\n", document(comparisons))),
        false => terminal::summarise(&text(comparisons, &arguments.results)),
    };
    match printed {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        printed => printed,
    }
}

/// What is reported of the comparisons, behind the names of what was compared where there are several.
fn text(comparisons: &[Comparison], results: &[PathBuf]) -> String {
    let pairs = comparisons.iter().zip(&results[1..]);
    let texts = pairs.map(|(comparison, other)| match comparisons {
        [_] => format!("{comparison}\n"),
        _ => format!(
            "{} and {}\n{comparison}\n",
            results[0].display(),
            other.display()
        ),
    });
    texts.collect::<Vec<_>>().join("\n")
}

/// The error and all its causes in one line.
fn message(error: &CompareError) -> String {
    format!("error: {}\n", error.with_causes())
}
