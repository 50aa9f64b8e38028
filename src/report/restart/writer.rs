//! Writes the restart file while the run goes on.

use std::io::{self, Write};
use std::path::PathBuf;

use super::{MAGIC, RESTART, RunIdentity, Tail, VERSION};
use crate::report::bytes::{Checksum, Put};
use crate::report::{FileAction, PartialFile, ReportError, RunFolder};
use crate::simulate::{Standing, StateKeeper};

/// A restart file being written under its temporary name; dropping it removes it.
#[derive(Debug)]
pub struct RestartWriter {
    file: PartialFile,
    checksum: Checksum,
    bytes: Vec<u8>,
    scenario: serde_json::Value,
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
            bytes: MAGIC.to_vec(),
            scenario: identity.scenario.clone(),
            fingerprint: identity.fingerprint(),
        };
        let path = writer.file.path().to_owned();
        writer
            .write()
            .map_err(ReportError::file(FileAction::Write, &path))?;
        Ok(writer)
    }

    /// Writes where the run stands and gives the file its name, in place of an earlier one.
    ///
    /// # Errors
    /// [`ReportError::File`]; an earlier restart file then stands as it was.
    pub fn finish(mut self, standing: &Standing) -> Result<PathBuf, ReportError> {
        let path = self.file.path().to_owned();
        self.write_tail(standing)
            .map_err(ReportError::file(FileAction::Write, &path))?;
        self.file.close()?.put()
    }

    fn write_tail(&mut self, standing: &Standing) -> io::Result<()> {
        let tail = serde_json::to_vec(&Tail {
            version: VERSION.to_owned(),
            scenario: std::mem::take(&mut self.scenario),
            fingerprint: self.fingerprint,
            standing: standing.clone(),
        })?;
        self.bytes.extend(&tail);
        self.bytes.put_u64(tail.len() as u64);
        self.write()?;
        self.file.write_all(&self.checksum.value().to_le_bytes())
    }

    /// Writes what has been collected.
    fn write(&mut self) -> io::Result<()> {
        self.checksum.add(&self.bytes);
        self.file.write_all(&self.bytes)?;
        self.bytes.clear();
        Ok(())
    }
}

impl StateKeeper for RestartWriter {
    fn keep(&mut self, states: &[f64]) -> io::Result<()> {
        for value in states {
            self.bytes.put_f64(*value);
        }
        self.write().map_err(|error| {
            let kind = error.kind();
            let named = ReportError::file(FileAction::Write, self.file.path())(error);
            io::Error::new(kind, named)
        })
    }
}
