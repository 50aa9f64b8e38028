//! The parts that a study is made in, and what says that one is whole.

use std::fs;
use std::io::BufReader;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::identity::first_difference;
use super::tables::Table;
use crate::report::{FileAction, ReportError};
use crate::scenario::open_regular;
use crate::study::many::Shard;

/// Most bytes of what seals a part.
const LARGEST: u64 = 64 << 20;

/// What a whole part says of itself.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct PartSeal {
    /// Version of the program.
    pub jeffcott: String,
    /// Title of the study.
    pub title: String,
    /// The study and its scenario.
    pub identity: Value,
    /// Which part.
    pub number: u64,
    /// Of how many.
    pub count: u64,
    /// Names of its tables.
    pub tables: Vec<String>,
}

/// Why parts make no whole.
#[derive(Debug, thiserror::Error)]
pub enum MergeError {
    /// There are none.
    #[error(
        "{} holds no part of a study; `jeffcott study FILE --shard 1/N` writes the first of N",
        folder.display()
    )]
    None {
        /// The folder.
        folder: PathBuf,
    },
    /// Some are missing.
    #[error("{} of {count} parts are missing: {}", numbers.len(), listed(numbers))]
    Missing {
        /// Their numbers.
        numbers: Vec<u64>,
        /// Of how many.
        count: u64,
    },
    /// Two parts are of different wholes.
    #[error("{} and {} are parts of different studies: {what}", a.display(), b.display())]
    Different {
        /// One.
        a: PathBuf,
        /// The other.
        b: PathBuf,
        /// What differs.
        what: String,
    },
    /// A file is not what it should be.
    #[error("{} is not whole: {reason}; make that part again", path.display())]
    Broken {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// The trace of a run is not what it should be.
    #[error(
        "run {run} has a trace that is not whole, {}: {reason}; copy it again, or make its part again with \
         --restart",
        path.display()
    )]
    Trace {
        /// Number of the run.
        run: String,
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// The file system refused.
    #[error(transparent)]
    Report(#[from] ReportError),
}

fn listed(numbers: &[u64]) -> String {
    let shown: Vec<_> = numbers.iter().take(20).map(u64::to_string).collect();
    let more = if numbers.len() > 20 { ", …" } else { "" };
    shown.join(", ") + more
}

/// File name of a part, with an ending.
pub(super) fn part_name(stem: &str, shard: Shard, ending: &str) -> String {
    format!("{stem}.part-{}-of-{}.{ending}", shard.number, shard.count)
}

/// The seals of all parts in a folder, in order, if they are one whole: at least one.
pub(super) fn seals(folder: &Path) -> Result<Vec<PartSeal>, MergeError> {
    let mut found = Vec::new();
    let entries = fs::read_dir(folder).map_err(ReportError::file(FileAction::Read, folder))?;
    for entry in entries.flatten() {
        let path = entry.path();
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.starts_with("study.part-") && name.ends_with(".json") {
            found.push((read(&path)?, path));
        }
    }
    found.sort_by_key(|(seal, _)| (seal.count, seal.number));
    let Some((first, first_path)) = found.first() else {
        return Err(MergeError::None {
            folder: folder.to_owned(),
        });
    };
    for (seal, path) in &found {
        if let Some(what) = difference(first, seal) {
            return Err(MergeError::Different {
                a: first_path.clone(),
                b: path.clone(),
                what,
            });
        }
    }
    let count = first.count;
    let there = |number: &u64| found.iter().any(|(seal, _)| seal.number == *number);
    let numbers: Vec<u64> = (1..=count).filter(|number| !there(number)).collect();
    if !numbers.is_empty() {
        return Err(MergeError::Missing { numbers, count });
    }
    Ok(found.into_iter().map(|(seal, _)| seal).collect())
}

fn read(path: &Path) -> Result<PartSeal, MergeError> {
    let broken = |reason: String| MergeError::Broken {
        path: path.to_owned(),
        reason,
    };
    let file = open_regular(path, LARGEST).map_err(|error| broken(error.to_string()))?;
    serde_json::from_reader(BufReader::new(file)).map_err(|error| broken(error.to_string()))
}

fn difference(a: &PartSeal, b: &PartSeal) -> Option<String> {
    if a.count != b.count {
        return Some(format!(
            "one is of {} parts, the other of {}",
            a.count, b.count
        ));
    }
    if a.jeffcott != b.jeffcott {
        return Some(format!("versions {} and {}", a.jeffcott, b.jeffcott));
    }
    let [key, there, here] = first_difference(&a.identity, &b.identity)?;
    Some(format!("`{key}` is {there} in one and {here} in the other"))
}

impl PartSeal {
    /// The part that it seals.
    pub fn shard(&self) -> Shard {
        Shard {
            number: self.number,
            count: self.count,
        }
    }

    /// The file of a table of this part.
    pub fn table(&self, folder: &Path, table: Table) -> PathBuf {
        folder.join(part_name(table.stem(), self.shard(), "csv"))
    }
}
