//! Stiffness over speed as the rotor dynamics program ROSS reads it: a `BearingElement` a file.

use std::fmt::Write as _;

use super::digest::{Digest, is_down};
use super::head::StudyHead;
use crate::report::variable::variable_column;
use crate::study::many::{BearingStiffness, RunRecord};

/// Most files.
const MOST_FILES: usize = 1000;

/// What one file holds: a bearing at one place of all axes but the speed.
#[derive(Debug, PartialEq)]
struct Element {
    bearing: usize,
    /// Values of the axes but the speed, with their names.
    at: Vec<(String, f64)>,
    /// Entries of K and C by the speed.
    rows: Vec<BearingStiffness>,
}

/// Names and contents of the files of a grid: a file a bearing and a place of all axes but the speed, numbered where
/// there is more than one.
///
/// Read by `BearingElement.load` of ROSS 3: TOML, speeds of the rotor in rad/s, SI units. ROSS 2 calls them `frequency`, which in
/// ROSS 3 is the frequency of whirl.
pub(super) fn ross_files(digest: &Digest) -> Vec<(String, String)> {
    if digest.head.drawn || !digest.is_complete() {
        return Vec::new();
    }
    let elements = elements(digest);
    let bearings = elements
        .iter()
        .map(|element| element.bearing)
        .max()
        .unwrap_or(0);
    let mut places = vec![0; bearings];
    let alone = elements.len() <= bearings;
    let files = elements.into_iter().map(|mut element| {
        element.rows.sort_by(|a, b| a.speed.total_cmp(&b.speed));
        element.rows.dedup_by(|a, b| a.speed == b.speed);
        places[element.bearing - 1] += 1;
        let name = match places[element.bearing - 1] {
            _ if alone => format!("ross_bearing_{}.toml", element.bearing),
            place => format!("ross_bearing_{}_{place}.toml", element.bearing),
        };
        (name, element.text(&digest.head.title))
    });
    files.collect()
}

fn elements(digest: &Digest) -> Vec<Element> {
    let mut elements: Vec<Element> = Vec::new();
    for row in digest.rows.iter().filter(|row| !is_down(row)) {
        let at = places(&digest.head, row);
        for entry in row.outcome.iter().flat_map(|outcome| &outcome.stiffness) {
            let is_there = |element: &Element| element.bearing == entry.bearing && element.at == at;
            match elements.iter().rposition(is_there) {
                Some(element) => elements[element].rows.push(*entry),
                None if (1..=MOST_FILES).contains(&entry.bearing)
                    && elements.len() < MOST_FILES =>
                {
                    elements.push(Element {
                        bearing: entry.bearing,
                        at: at.clone(),
                        rows: vec![*entry],
                    });
                }
                None => {}
            }
        }
    }
    elements
}

/// Values of a run's axes but the speed.
fn places(head: &StudyHead, row: &RunRecord) -> Vec<(String, f64)> {
    let axes = head.axes.iter().zip(&row.values);
    let others = axes.filter(|(axis, _)| !axis.key.starts_with("speed."));
    others
        .map(|(axis, value)| (variable_column(axis).name(), *value))
        .collect()
}

impl Element {
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
        let speeds: Vec<f64> = self.rows.iter().map(|row| row.speed).collect();
        let _ = writeln!(text, "speed = {speeds:?}");
        let mut write = |letter: char, part: fn(&BearingStiffness) -> &[f64]| {
            for (place, (entry, _)) in BearingStiffness::ENTRIES.iter().enumerate() {
                let column: Vec<f64> = self.rows.iter().map(|row| part(row)[place]).collect();
                let _ = writeln!(text, "{letter}{entry} = {column:?}");
            }
        };
        write('k', |row| &row.stiffness);
        write('c', |row| &row.damping);
        text
    }
}
