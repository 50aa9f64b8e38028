//! A file beside the results that a table is put together from.

use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// A file for writing, then reading; removed when dropped.
#[derive(Debug)]
pub(super) struct Scratch {
    file: File,
    path: PathBuf,
}

impl Scratch {
    /// Creates the file.
    pub fn create(path: &Path) -> io::Result<Self> {
        let mut options = File::options();
        options.read(true).write(true).create(true).truncate(true);
        Ok(Self {
            file: options.open(path)?,
            path: path.to_owned(),
        })
    }

    /// Appends bytes.
    pub fn append(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.file.write_all(bytes)
    }

    /// Fills `bytes` from the place `start`.
    pub fn read(&mut self, start: u64, bytes: &mut [u8]) -> io::Result<()> {
        self.file.seek(SeekFrom::Start(start))?;
        self.file.read_exact(bytes)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // there is nobody left to tell of a failure
        let _ = fs::remove_file(&self.path);
    }
}
