//! Reads a restart file, after looking whether it is whole and of this run.

use std::fs::File;
use std::io::{self, BufReader, ErrorKind, Read, Seek, SeekFrom};
use std::path::Path;

use serde_json::Value;

use super::identity::{difference, of_the_motion};
use super::{MAGIC, RestartError, RunIdentity, Tail, VERSION};
use crate::report::bytes::{Checksum, Take};
use crate::simulate::{Standing, StateSource};

/// Bytes read at a time.
const PIECE: usize = 1 << 16;
/// Bytes of magic, length of the tail and checksum.
const FRAME: u64 = 24;

/// A restart file that fits its run, ready to give back what it keeps.
#[derive(Debug)]
pub struct RestartReader {
    standing: Standing,
    states: BufReader<File>,
    bytes: Vec<u8>,
}

impl RestartReader {
    /// Opens a file and checks that it is whole and belongs to the run.
    ///
    /// # Errors
    /// [`RestartError`] says what is wrong with it and what to do.
    pub fn open(path: &Path, identity: &RunIdentity<'_>) -> Result<Self, RestartError> {
        let refused = |source: io::Error| {
            let path = path.to_owned();
            match source.kind() {
                ErrorKind::NotFound => RestartError::Missing { path },
                _ => RestartError::Unreadable { path, source },
            }
        };
        let damaged = |what: &str| RestartError::Damaged {
            path: path.to_owned(),
            what: what.to_owned(),
        };
        let file = File::open(path).map_err(refused)?;
        let mut file = BufReader::with_capacity(PIECE, file);
        let mut magic = Vec::new();
        let mut start = file.by_ref().take(MAGIC.len() as u64);
        start.read_to_end(&mut magic).map_err(refused)?;
        if magic != MAGIC {
            return Err(RestartError::Foreign {
                path: path.to_owned(),
            });
        }
        let length = file.seek(SeekFrom::End(0)).map_err(refused)?;
        let Some(inside) = length.checked_sub(FRAME) else {
            return Err(damaged("it ends too early"));
        };
        if !is_whole(&mut file, length - 8).map_err(refused)? {
            return Err(damaged("it is cut, or its checksum does not fit"));
        }
        let tail_length = number_at(&mut file, length - 16).map_err(refused)?;
        let unfitting = || damaged("its parts do not fit together");
        let states = inside.checked_sub(tail_length).ok_or_else(unfitting)?;
        let tail = bytes_at(&mut file, MAGIC.len() as u64 + states, tail_length);
        let tail: Value =
            serde_json::from_slice(&tail.map_err(refused)?).map_err(|_| unfitting())?;
        let standing = owned(tail, path, identity)?.ok_or_else(unfitting)?;
        let sample = (standing.main.scaled.len() * size_of::<f64>()) as u64;
        if standing.main.next.checked_mul(sample) != Some(states) {
            return Err(unfitting());
        }
        file.seek(SeekFrom::Start(MAGIC.len() as u64))
            .map_err(refused)?;
        Ok(Self {
            standing,
            states: file,
            bytes: Vec::new(),
        })
    }

    /// Where the run stood.
    pub fn standing(&self) -> &Standing {
        &self.standing
    }
}

impl StateSource for RestartReader {
    fn fill(&mut self, states: &mut [f64]) -> io::Result<()> {
        self.bytes.resize(size_of_val(states), 0);
        self.states.read_exact(&mut self.bytes)?;
        let mut take = Take(&self.bytes);
        for state in states {
            *state = take.f64().ok_or(ErrorKind::UnexpectedEof)?;
        }
        Ok(())
    }
}

/// Whether the checksum that stands after so many bytes is theirs.
fn is_whole(file: &mut BufReader<File>, mut left: u64) -> io::Result<bool> {
    let (mut checksum, mut piece) = (Checksum::START, [0; PIECE]);
    file.rewind()?;
    while left > 0 {
        let count = left.min(PIECE as u64) as usize;
        file.read_exact(&mut piece[..count])?;
        checksum.add(&piece[..count]);
        left -= count as u64;
    }
    let end = file.stream_position()?;
    Ok(number_at(file, end)? == checksum.value())
}

fn number_at(file: &mut BufReader<File>, position: u64) -> io::Result<u64> {
    let mut bytes = [0; 8];
    file.seek(SeekFrom::Start(position))?;
    file.read_exact(&mut bytes)?;
    Ok(u64::from_le_bytes(bytes))
}

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
fn owned(
    tail: Value,
    path: &Path,
    identity: &RunIdentity<'_>,
) -> Result<Option<Standing>, RestartError> {
    let path = path.to_owned();
    // another version may have written a tail of another form
    let there = tail["version"].as_str().unwrap_or_default().to_owned();
    if there != VERSION {
        let here = VERSION;
        return Err(RestartError::Version { path, there, here });
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
