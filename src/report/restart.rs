//! `restart.bin`: what a stopped run leaves, so that it goes on to the same bytes.
//!
//! ```text
//! magic            8 bytes
//! states           f64 of every sample so far
//! tail             JSON: version, scenario, fingerprint of the model, standing of both passes
//! length of tail   u64
//! checksum         u64, of everything before
//! ```
//!
//! All numbers are little endian. States come before the tail, which is known last: a run writes them as it goes, and
//! memory does not grow with it. A file that is not whole has no fitting checksum at its end.

use std::fs::File;
use std::io::{self, BufReader, ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::checksum::Checksum;
use super::{FileAction, PartialFile, ReportError, RunFolder};
use crate::scenario::open_regular;
use crate::simulate::{Model, Standing, StateKeeper, StateSource};

/// Name of the file in the folder of its run.
pub(super) const RESTART: &str = "restart.bin";

const MAGIC: [u8; 8] = *b"jeffcott";
/// This version.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Whose file it is, and where the run stood.
#[derive(Serialize, Deserialize)]
struct Tail {
    /// Version that wrote it.
    version: String,
    /// The scenario with its defaults.
    scenario: Value,
    /// Changes with everything that the integration sees.
    fingerprint: u64,
    standing: Standing,
}

/// Where the restart file of a run folder is.
pub fn restart_path(folder: &Path) -> PathBuf {
    folder.join(RESTART)
}

/// What makes a run this one and no other.
#[derive(Debug, Clone, Copy)]
pub struct RunIdentity<'a> {
    /// The scenario with its defaults.
    pub scenario: &'a Value,
    /// What it asks for, with the content of the files that it names.
    pub model: &'a Model,
}

impl RunIdentity<'_> {
    /// A number that changes with everything that the integration sees.
    fn fingerprint(&self) -> u64 {
        let mut checksum = Checksum::START;
        // writing to a checksum cannot fail
        let _ = write!(checksum, "{:?}", self.model);
        checksum.value()
    }
}

/// Keys of `[output]` that say how samples are written: a restart file holds them all, and a run that
/// goes on writes its files anew from the first sample.
const WRITTEN: [&str; 3] = ["formats", "every", "channels"];

/// The part of a scenario that decides what a restart file holds.
fn of_the_motion(scenario: &Value) -> Value {
    let mut motion = scenario.clone();
    if let Some(Value::Object(output)) = motion.get_mut("output") {
        output.retain(|key, _| !WRITTEN.contains(&key.as_str()));
    }
    motion
}

/// The first key in which two scenarios differ, with the values there and here.
pub(in crate::report) fn difference(there: &Value, here: &Value) -> Option<[String; 3]> {
    let (Value::Object(entries), Value::Object(others)) = (there, here) else {
        return (there != here).then(|| [String::new(), there.to_string(), here.to_string()]);
    };
    let absent =
        |value: Option<&Value>| value.map_or_else(|| "absent".to_owned(), Value::to_string);
    let added = others.keys().filter(|key| !entries.contains_key(*key));
    entries
        .keys()
        .chain(added)
        .find_map(|key| match (entries.get(key), others.get(key)) {
            (Some(there), Some(here)) => {
                let [rest, there, here] = difference(there, here)?;
                let dot = if rest.is_empty() { "" } else { "." };
                Some([format!("{key}{dot}{rest}"), there, here])
            }
            (there, here) => Some([key.clone(), absent(there), absent(here)]),
        })
}

/// Why a run cannot go on from a restart file, which stays as it is.
#[derive(Debug, thiserror::Error)]
pub enum RestartError {
    /// There is none.
    #[error(
        "there is no {} to go on from; a run leaves one that is stopped under --stop-at or \
         --restartable, until it is done", path.display()
    )]
    Missing {
        /// Where it would be.
        path: PathBuf,
    },
    /// The file system refuses.
    #[error(transparent)]
    Unreadable(ReportError),
    /// It is something else.
    #[error("{} is no restart file", path.display())]
    Foreign {
        /// The file.
        path: PathBuf,
    },
    /// It is not what was written.
    #[error("{} is damaged: {what}; run the scenario from its start", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What shows it.
        what: &'static str,
    },
    /// Another version wrote it, whose numbers may differ in the last digit.
    #[error(
        "{} was written by version {there} of jeffcott and this is {VERSION}: go on with that one, or \
         run the scenario from its start", path.display()
    )]
    Version {
        /// The file.
        path: PathBuf,
        /// Version that wrote it.
        there: String,
    },
    /// The scenario is another, or has been changed.
    #[error(
        "{} belongs to another scenario: `{key}` is {there} there and {here} here; take the change \
         back, or run the scenario from its start", path.display()
    )]
    Scenario {
        /// The file.
        path: PathBuf,
        /// First key that differs.
        key: String,
        /// Its value in the file.
        there: String,
        /// Its value in the scenario.
        here: String,
    },
    /// The scenario reads the same, but not what it names.
    #[error(
        "{} belongs to another scenario: a file that this one names, as a load series, has changed; \
         take the change back, or run the scenario from its start", path.display()
    )]
    Model {
        /// The file.
        path: PathBuf,
    },
}

/// A restart file being written under its temporary name; dropping it removes it.
#[derive(Debug)]
pub struct RestartWriter {
    file: PartialFile,
    checksum: Checksum,
    scenario: Value,
    fingerprint: u64,
}

impl RestartWriter {
    /// Starts the file in the folder of a run.
    pub(in crate::report) fn create(
        folder: &RunFolder,
        identity: &RunIdentity<'_>,
    ) -> Result<Self, ReportError> {
        let mut writer = Self {
            file: folder.create(RESTART)?,
            checksum: Checksum::START,
            scenario: identity.scenario.clone(),
            fingerprint: identity.fingerprint(),
        };
        let written = writer.write(&MAGIC);
        written.map_err(ReportError::file(FileAction::Write, writer.file.path()))?;
        Ok(writer)
    }

    /// Writes where the run stands and gives the file its name, in place of an earlier one.
    ///
    /// # Errors
    /// [`ReportError::File`]; an earlier restart file then stands as it was.
    pub fn finish(mut self, standing: &Standing) -> Result<PathBuf, ReportError> {
        let written = self.write_tail(standing);
        written.map_err(ReportError::file(FileAction::Write, self.file.path()))?;
        self.file.close()?.rename_durably()
    }

    fn write_tail(&mut self, standing: &Standing) -> io::Result<()> {
        let tail = serde_json::to_vec(&Tail {
            version: VERSION.to_owned(),
            scenario: std::mem::take(&mut self.scenario),
            fingerprint: self.fingerprint,
            standing: standing.clone(),
        })?;
        self.write(&tail)?;
        self.write(&(tail.len() as u64).to_le_bytes())?;
        self.file.write_all(&self.checksum.value().to_le_bytes())
    }

    /// Writes what goes into the checksum.
    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.checksum.add(bytes);
        self.file.write_all(bytes)
    }
}

impl StateKeeper for RestartWriter {
    fn keep(&mut self, states: &[f64]) -> io::Result<()> {
        let mut states = states.iter();
        let written = states.try_for_each(|value| self.write(&value.to_le_bytes()));
        written.map_err(ReportError::named(self.file.path()))
    }
}

/// Bytes read at a time.
const PIECE: usize = 1 << 16;
/// Where the states begin, behind the magic.
const START: u64 = MAGIC.len() as u64;
/// Bytes of magic, length of the tail and checksum.
const FRAME: u64 = 24;

/// A restart file that fits its run, ready to give back what it keeps.
#[derive(Debug)]
pub struct RestartReader {
    /// Where the run stood.
    pub standing: Standing,
    states: BufReader<File>,
}

impl RestartReader {
    /// Opens a file and checks that it is whole and belongs to the run.
    ///
    /// # Errors
    /// [`RestartError`] says what is wrong with it and what to do.
    pub fn open(path: &Path, identity: &RunIdentity<'_>) -> Result<Self, RestartError> {
        let owned = || path.to_owned();
        let refused = |source: io::Error| match source.kind() {
            ErrorKind::NotFound => RestartError::Missing { path: owned() },
            _ => RestartError::Unreadable(ReportError::file(FileAction::Read, path)(source)),
        };
        let damaged = |what| RestartError::Damaged {
            path: owned(),
            what,
        };
        let mut file =
            BufReader::with_capacity(PIECE, open_regular(path, u64::MAX).map_err(refused)?);
        if bytes_at(&mut file, 0, START).map_err(refused)? != MAGIC {
            return Err(RestartError::Foreign { path: owned() });
        }
        let length = file.seek(SeekFrom::End(0)).map_err(refused)?;
        let Some(inside) = length.checked_sub(FRAME) else {
            return Err(damaged("it ends too early"));
        };
        if !is_whole(&mut file, length - 8).map_err(refused)? {
            return Err(damaged("it is cut, or its checksum does not fit"));
        }
        let unfitting = || damaged("its parts do not fit together");
        let tail = number_at(&mut file, length - 16).map_err(refused)?;
        let states = inside.checked_sub(tail).ok_or_else(unfitting)?;
        let tail = bytes_at(&mut file, START + states, tail).map_err(refused)?;
        let tail = serde_json::from_slice(&tail).map_err(|_| unfitting())?;
        let standing = standing_of(tail, path, identity)?.ok_or_else(unfitting)?;
        let sample = (standing.main.scaled.len() * size_of::<f64>()) as u64;
        if standing.main.next.checked_mul(sample) != Some(states) {
            return Err(unfitting());
        }
        file.seek(SeekFrom::Start(START)).map_err(refused)?;
        Ok(Self {
            standing,
            states: file,
        })
    }
}

impl StateSource for RestartReader {
    fn fill(&mut self, states: &mut [f64]) -> io::Result<()> {
        let mut bytes = [0; size_of::<f64>()];
        states.iter_mut().try_for_each(|state| {
            self.states.read_exact(&mut bytes)?;
            *state = f64::from_le_bytes(bytes);
            Ok(())
        })
    }
}

/// Whether the checksum that stands after so many bytes is theirs.
fn is_whole(file: &mut BufReader<File>, count: u64) -> io::Result<bool> {
    let mut checksum = Checksum::START;
    file.rewind()?;
    io::copy(&mut file.by_ref().take(count), &mut checksum)?;
    Ok(number_at(file, count)? == checksum.value())
}

fn number_at(file: &mut BufReader<File>, position: u64) -> io::Result<u64> {
    let bytes = bytes_at(file, position, 8)?.try_into();
    let bytes = bytes.map_err(|_| ErrorKind::UnexpectedEof)?;
    Ok(u64::from_le_bytes(bytes))
}

/// So many bytes, or as many as there are.
fn bytes_at(file: &mut BufReader<File>, position: u64, count: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    file.seek(SeekFrom::Start(position))?;
    file.by_ref().take(count).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Where the run of this version, scenario and model stood; none where the tail is of another form.
///
/// # Errors
/// [`RestartError`] where the file belongs to another run.
fn standing_of(
    tail: Value,
    path: &Path,
    identity: &RunIdentity<'_>,
) -> Result<Option<Standing>, RestartError> {
    let path = path.to_owned();
    // another version may have written a tail of another form
    let there = tail["version"].as_str().unwrap_or_default().to_owned();
    if there != VERSION {
        return Err(RestartError::Version { path, there });
    }
    let Ok(tail) = serde_json::from_value::<Tail>(tail) else {
        return Ok(None);
    };
    let [there, here] = [&tail.scenario, identity.scenario].map(of_the_motion);
    if let Some([key, there, here]) = difference(&there, &here) {
        return Err(RestartError::Scenario {
            path,
            key,
            there,
            here,
        });
    }
    if tail.fingerprint != identity.fingerprint() {
        return Err(RestartError::Model { path });
    }
    Ok(Some(tail.standing))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn the_first_differing_key_is_named_with_its_path() {
        let there = json!({"shaft": {"mass": "5 kg"}, "load": [1, 2]});
        let here = json!({"shaft": {"mass": "6 kg"}, "load": [1, 2]});
        let named =
            |key: &str, there: &str, here: &str| Some([key, there, here].map(str::to_owned));
        let found = difference(&there, &here);
        assert_eq!(found, named("shaft.mass", "\"5 kg\"", "\"6 kg\""));
        let more = json!({"shaft": {"mass": "5 kg"}, "load": [1, 2], "film": true});
        assert_eq!(difference(&there, &more), named("film", "absent", "true"));
        assert_eq!(difference(&more, &there), named("film", "true", "absent"));
        assert_eq!(difference(&there, &there), None);
    }
}
