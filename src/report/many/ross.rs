//! Stiffness over speed as the rotor dynamics program ROSS reads it: a `BearingElement` a file.

use std::fmt::Write as _;
use std::path::Path;

use serde_json::Value;

use super::digest::{Digest, Row};
use super::{each_row, number_in};
use crate::report::ReportError;
use crate::study::many::BearingStiffness;

/// Most files.
const MOST_FILES: usize = 1000;
/// Where the entries of K and C begin in a row of the table, behind run, bearing and speed.
const START: usize = 3;
/// Entries of K and of C.
const ENTRIES: usize = BearingStiffness::ENTRIES.len();

/// What one file holds: a bearing at one place of all axes but the speed.
#[derive(Debug, PartialEq)]
struct Table {
    bearing: usize,
    /// Values of the axes but the speed, with their names.
    at: Vec<(String, f64)>,
    /// Speed, and the entries of K and C there.
    rows: Vec<(f64, [f64; 2 * ENTRIES])>,
}

/// Names and contents of the files of a grid, by the table `stiffness.csv`: a file a bearing and a place of
/// all axes but the speed, numbered where there is more than one.
///
/// Read by `BearingElement.load` of ROSS 3: TOML, speeds of the rotor in rad/s, SI units. ROSS 2 calls them `frequency`, which in
/// ROSS 3 is the frequency of whirl.
pub(super) fn ross_files(
    title: &str,
    identity: &Value,
    digest: &Digest,
    stiffness: &Path,
) -> Result<Vec<(String, String)>, ReportError> {
    if digest.drawn || !digest.is_complete() {
        return Ok(Vec::new());
    }
    let tables = tables(identity, digest, stiffness)?;
    let bearings = tables.iter().map(|table| table.bearing).max().unwrap_or(0);
    let mut places = vec![0; bearings];
    let alone = tables.len() <= bearings;
    let files = tables.into_iter().map(|mut table| {
        table.rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        table.rows.dedup_by(|a, b| a.0 == b.0);
        places[table.bearing - 1] += 1;
        let name = match places[table.bearing - 1] {
            _ if alone => format!("ross_bearing_{}.toml", table.bearing),
            place => format!("ross_bearing_{}_{place}.toml", table.bearing),
        };
        (name, table.text(title))
    });
    Ok(files.collect())
}

fn tables(identity: &Value, digest: &Digest, path: &Path) -> Result<Vec<Table>, ReportError> {
    let mut tables: Vec<Table> = Vec::new();
    each_row(path, |_, record| {
        let number = |place: usize| number_in(&record, place);
        let (run, bearing) = (number(0) as u64, number(1) as usize);
        let Some(row) = digest.row(run).filter(|row| !row.down) else {
            return;
        };
        let at = places(identity, digest, row);
        let entries = std::array::from_fn(|k| number(START + k));
        let entry = (number(2), entries);
        let known = tables
            .iter()
            .rposition(|table| table.bearing == bearing && table.at == at);
        match known {
            Some(table) => tables[table].rows.push(entry),
            None if bearing > 0 && tables.len() < MOST_FILES => tables.push(Table {
                bearing,
                at,
                rows: vec![entry],
            }),
            None => {}
        }
    })?;
    Ok(tables)
}

/// Values of a run's axes but the speed.
fn places(identity: &Value, digest: &Digest, row: &Row) -> Vec<(String, f64)> {
    let speed = |axis: usize| {
        let key = identity["study"]["axis"][axis]["key"].as_str();
        key.is_some_and(|key| key.starts_with("speed."))
    };
    let axes = digest.axes.iter().zip(&row.values).enumerate();
    let others = axes.filter(|(axis, _)| !speed(*axis));
    others
        .map(|(_, (name, value))| (name.clone(), *value))
        .collect()
}

impl Table {
    fn text(&self, title: &str) -> String {
        let bearing = self.bearing;
        let title: String = title.chars().filter(|c| !c.is_control()).collect();
        let mut text = format!(
            "# jeffcott {}: {title}\n\
             # For ROSS: ross.BearingElement.load(FILE); n is the node, to be set to that of the rotor.\n\
             # For ROSS 3; ROSS 2 reads it with `frequency` in place of `speed`.\n\
             # Units: speed in rad/s, k in N/m, c in N s/m. x and y across the shaft, z along it.\n\
             # k: bearing {bearing} at the static equilibrium, tilts left out. c: what damps the shaft, in\n\
             # proportion to the stiffness of its bearings.\n",
            env!("CARGO_PKG_VERSION")
        );
        for (name, value) in &self.at {
            // to a string nothing is refused
            let _ = writeln!(text, "# {name} = {value:?}");
        }
        let _ = writeln!(
            text,
            "[BearingElement_bearing_{bearing}]\nn = 0\ntag = \"bearing_{bearing}\""
        );
        let speeds: Vec<f64> = self.rows.iter().map(|row| row.0).collect();
        let _ = writeln!(text, "speed = {speeds:?}");
        for (offset, letter) in [(0, 'k'), (ENTRIES, 'c')] {
            for (place, (entry, _)) in BearingStiffness::ENTRIES.iter().enumerate() {
                let column = self.rows.iter().map(|row| row.1[offset + place]);
                let column: Vec<f64> = column.collect();
                let _ = writeln!(text, "{letter}{entry} = {column:?}");
            }
        }
        text
    }
}
