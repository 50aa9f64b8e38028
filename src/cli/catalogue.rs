//! `jeffcott catalogue`.

use std::io;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::{Outcome, terminal};
use crate::bearing::catalogue::{self, CatalogueEntry, Found};
use crate::bearing::{Bearing, Estimate, EstimateError, RollerEntry, RollerEstimate};
use crate::report::{
    add_roller_table, catalogue_text, entry_json, entry_text, roller_entry_json, roller_entry_text,
    versioned,
};
use crate::scenario::catalogue_file;

/// Lists the bearings that a scenario can name, or shows one of them, with the source of every number.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  jeffcott catalogue 6208\n\n\
                  Exit code: 0 done, 2 there is no such bearing.")]
pub struct Arguments {
    /// Designation of one bearing
    #[arg(value_name = "DESIGNATION")]
    designation: Option<String>,
    /// Print as JSON
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    /// Print the shipped catalogue as the CSV that a file of your own has the shape of
    #[arg(long, conflicts_with = "designation")]
    csv: bool,
}

/// The environment variable that names the user's own catalogue.
const VARIABLE: &str = "JEFFCOTT_CATALOGUE";

/// Reads the user's own catalogue, from the command line or the environment; false where it is wrong, after telling.
pub fn add_own(given: Option<&Path>) -> bool {
    let named = std::env::var_os(VARIABLE).filter(|value| !value.is_empty());
    let Some(path) = given.map(Path::to_owned).or(named.map(PathBuf::from)) else {
        return true;
    };
    match catalogue_file::read(&path) {
        Ok(entries) => {
            catalogue::add_own(entries);
            true
        }
        Err(problems) => {
            for problem in problems {
                terminal::refuse(format!("{}: {problem}", path.display()));
            }
            false
        }
    }
}

/// Prints the catalogue or one bearing.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let text = if arguments.csv {
        catalogue::SHIPPED.to_owned()
    } else if let Some(designation) = &arguments.designation {
        match one(designation, arguments.json) {
            Ok(text) => text,
            Err(message) => return Ok(terminal::refuse(message)),
        }
    } else {
        all(arguments.json)
    };
    terminal::print(&text)?;
    Ok(Outcome::Done)
}

fn one(designation: &str, json: bool) -> Result<String, String> {
    let (found, _) =
        catalogue::look_up(&catalogue::EMPTY, designation).map_err(|error| error.to_string())?;
    let wrong = |name: &str, error: EstimateError| format!("{name}: {error}");
    let (document, lines) = match found {
        Found::Balls(entry) => {
            let estimate = entry.line.estimate();
            let estimate = estimate.map_err(|error| wrong(&entry.designation, error))?;
            let bearing = Bearing::catalogue(designation).map_err(|error| error.to_string())?;
            let lines = entry_text(entry, &bearing, &estimate);
            (entry_json(entry, &bearing, &estimate), lines)
        }
        Found::Rollers(entry) => {
            let estimate = entry.line.estimate();
            let estimate = estimate.map_err(|error| wrong(&entry.designation, error))?;
            let lines = roller_entry_text(entry, &estimate);
            (roller_entry_json(entry, &estimate), lines)
        }
    };
    Ok(match json {
        true => format!("{:#}\n", versioned(document)),
        false => lines.text(terminal::details()),
    })
}

/// Every roller bearing with its estimate.
fn rollers() -> impl Iterator<Item = (&'static RollerEntry, RollerEstimate)> {
    let entries = catalogue::all(&catalogue::EMPTY).flat_map(|known| &known.rollers);
    entries.filter_map(|entry| Some((entry, entry.line.estimate().ok()?)))
}

/// Every bearing that its designation finds, with its estimate.
fn found() -> Vec<(&'static CatalogueEntry, Bearing, Estimate)> {
    let entries = catalogue::all(&catalogue::EMPTY).flat_map(|known| &known.balls);
    let found = entries.filter_map(|entry| {
        let (first, _) = catalogue::look_up(&catalogue::EMPTY, &entry.designation).ok()?;
        let bearing = entry.bearing().ok()?;
        let estimate = entry.line.estimate().ok()?;
        let is_found = matches!(first, Found::Balls(first) if std::ptr::eq(first, entry));
        is_found.then_some((entry, bearing, estimate))
    });
    let mut found: Vec<_> = found.collect();
    found.sort_by(|(a, ..), (b, ..)| a.designation.cmp(&b.designation));
    found
}

fn all(json: bool) -> String {
    let found = found();
    if json {
        let entries = found.iter();
        let entries =
            entries.map(|(entry, bearing, estimate)| entry_json(entry, bearing, estimate));
        let rollers = rollers().map(|(entry, estimate)| roller_entry_json(entry, &estimate));
        let all = json!({
            "bearings": entries.collect::<Value>(),
            "roller_bearings": rollers.collect::<Value>(),
        });
        return format!("{:#}\n", versioned(all));
    }
    let bearings = found.iter().map(|(entry, _, estimate)| (*entry, estimate));
    let mut out = catalogue_text(bearings);
    add_roller_table(&mut out, rollers());
    out.text(terminal::details())
}
