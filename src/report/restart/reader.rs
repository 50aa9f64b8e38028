//! Reads a restart file, after looking whether it is whole and of this run.

use std::fs::File;
use std::io::{self, BufReader, ErrorKind, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::identity::{difference, of_the_motion};
use super::{END, FORMAT, MAGIC, RestartError, RunIdentity, TAIL};
use crate::report::bytes::{Checksum, Take};
use crate::simulate::{Standing, StateSource};

/// This version.
const VERSION: &str = env!("CARGO_PKG_VERSION");
/// Bytes read at a time.
const PIECE: usize = 1 << 16;

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
        let file = File::open(path).map_err(|source| match source.kind() {
            ErrorKind::NotFound => RestartError::Missing {
                path: path.to_owned(),
            },
            _ => unreadable(path)(source),
        })?;
        let mut opening = Opening {
            file: BufReader::with_capacity(PIECE, file),
            path: path.to_owned(),
            head: 0,
        };
        opening.check_start()?;
        let tail = opening.check_end()?;
        opening.check_owner(identity)?;
        let standing = opening.standing(tail)?;
        opening.go_to(opening.head)?;
        Ok(Self {
            standing,
            states: opening.file,
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

fn unreadable(path: &Path) -> impl Fn(io::Error) -> RestartError {
    let path = path.to_owned();
    move |source| RestartError::Unreadable {
        path: path.clone(),
        source,
    }
}

/// The last bytes of a file.
struct Tail {
    /// Place after the standing.
    end: u64,
    /// Length of the standing.
    standing: u64,
}

/// A file that is being checked.
struct Opening {
    file: BufReader<File>,
    path: PathBuf,
    /// Place of the first state.
    head: u64,
}

impl Opening {
    fn check_start(&mut self) -> Result<(), RestartError> {
        let mut start = [0; MAGIC.len() + size_of::<u32>()];
        let mut read = 0;
        while read < start.len() {
            match self.file.read(&mut start[read..]) {
                Ok(0) => break,
                Ok(count) => read += count,
                Err(source) => return Err(unreadable(&self.path)(source)),
            }
        }
        let path = self.path.clone();
        if !start[..read].starts_with(&MAGIC) {
            return Err(RestartError::Foreign { path });
        }
        if start[MAGIC.len()..] != FORMAT.to_le_bytes() {
            return Err(self.damaged("its format is not known to this version"));
        }
        Ok(())
    }

    /// Checks that the file ends as it should and that every byte is what was written.
    fn check_end(&mut self) -> Result<Tail, RestartError> {
        let length = self
            .file
            .seek(SeekFrom::End(0))
            .map_err(unreadable(&self.path))?;
        let Some(end) = length.checked_sub(TAIL) else {
            return Err(self.damaged("it ends too early"));
        };
        let mut bytes = [0; TAIL as usize];
        self.go_to(end)?;
        self.read(&mut bytes)?;
        let mut take = Take(&bytes);
        let (standing, checksum) = (take.u64(), take.u64());
        if take.0 != END {
            return Err(self.damaged("it ends too early"));
        }
        if Some(self.checksum(end + size_of::<u64>() as u64)?) != checksum {
            return Err(self.damaged("its checksum does not fit"));
        }
        Ok(Tail {
            end,
            standing: standing.unwrap_or(0),
        })
    }

    /// Checksum of the first bytes.
    fn checksum(&mut self, mut left: u64) -> Result<u64, RestartError> {
        let (mut checksum, mut piece) = (Checksum::START, [0; PIECE]);
        self.go_to(0)?;
        while left > 0 {
            let count = left.min(PIECE as u64) as usize;
            self.read(&mut piece[..count])?;
            checksum.add(&piece[..count]);
            left -= count as u64;
        }
        Ok(checksum.value())
    }

    /// Checks version, scenario and model, and finds the first state.
    fn check_owner(&mut self, identity: &RunIdentity<'_>) -> Result<(), RestartError> {
        self.go_to((MAGIC.len() + size_of::<u32>()) as u64)?;
        let there = self.text()?;
        let path = self.path.clone();
        if there != VERSION {
            let here = VERSION;
            return Err(RestartError::Version { path, there, here });
        }
        let Ok(scenario) = self.text()?.parse::<Value>() else {
            return Err(self.damaged("its scenario cannot be read"));
        };
        if let Some([key, there, here]) =
            difference(&of_the_motion(&scenario), &of_the_motion(identity.scenario))
        {
            return Err(RestartError::Scenario {
                path,
                key,
                there,
                here,
            });
        }
        if self.number()? != identity.fingerprint() {
            return Err(RestartError::Model { path });
        }
        self.head = self
            .file
            .stream_position()
            .map_err(unreadable(&self.path))?;
        Ok(())
    }

    /// Reads where the run stood, and checks that there are as many states as that needs.
    fn standing(&mut self, tail: Tail) -> Result<Standing, RestartError> {
        let room = tail.end.checked_sub(self.head);
        let Some(states) = room.and_then(|room| room.checked_sub(tail.standing)) else {
            return Err(self.damaged("its parts do not fit together"));
        };
        self.go_to(self.head + states)?;
        let mut bytes = vec![0; tail.standing as usize];
        self.read(&mut bytes)?;
        let standing = serde_json::from_slice(&bytes).ok();
        let fits = |standing: &Standing| {
            let sample = (standing.main.scaled.len() * size_of::<f64>()) as u64;
            standing.main.next.checked_mul(sample) == Some(states)
        };
        standing
            .filter(fits)
            .ok_or_else(|| self.damaged("its parts do not fit together"))
    }

    fn text(&mut self) -> Result<String, RestartError> {
        let length = self.number()?;
        let mut bytes = Vec::new();
        let read = self.file.by_ref().take(length).read_to_end(&mut bytes);
        read.map_err(unreadable(&self.path))?;
        String::from_utf8(bytes).map_err(|_| self.damaged("a text in it is not UTF-8"))
    }

    fn number(&mut self) -> Result<u64, RestartError> {
        let mut bytes = [0; size_of::<u64>()];
        self.read(&mut bytes)?;
        Ok(u64::from_le_bytes(bytes))
    }

    fn read(&mut self, bytes: &mut [u8]) -> Result<(), RestartError> {
        self.file
            .read_exact(bytes)
            .map_err(|source| match source.kind() {
                ErrorKind::UnexpectedEof => self.damaged("it ends too early"),
                _ => unreadable(&self.path)(source),
            })
    }

    fn go_to(&mut self, place: u64) -> Result<(), RestartError> {
        let found = self.file.seek(SeekFrom::Start(place));
        found.map(|_| ()).map_err(unreadable(&self.path))
    }

    fn damaged(&self, what: &str) -> RestartError {
        RestartError::Damaged {
            path: self.path.clone(),
            what: what.to_owned(),
        }
    }
}
