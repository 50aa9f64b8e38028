//! Whose folder it is while files are written there: one process's, or that of all that make parts of one study.

use std::fs::{File, TryLockError};
use std::io;
use std::path::Path;

use super::{FileAction, ReportError};

/// A lock on a folder. The system takes it back when the process ends, however it ends.
#[derive(Debug)]
pub(super) struct Claim {
    _locked: File,
}

impl Claim {
    /// For this process alone.
    ///
    /// # Errors
    /// [`ReportError::Busy`] where another one writes there.
    pub fn alone(folder: &Path) -> Result<Self, ReportError> {
        Self::by(File::try_lock, folder)
    }

    /// Together with others that share it.
    ///
    /// # Errors
    /// [`ReportError::Busy`] where another one has it alone.
    pub fn shared(folder: &Path) -> Result<Self, ReportError> {
        Self::by(File::try_lock_shared, folder)
    }

    fn by(
        lock: impl Fn(&File) -> Result<(), TryLockError>,
        folder: &Path,
    ) -> Result<Self, ReportError> {
        let locked = lockable(folder).map_err(ReportError::file(FileAction::Create, folder))?;
        match lock(&locked) {
            Err(TryLockError::WouldBlock) => Err(ReportError::Busy {
                folder: folder.to_owned(),
            }),
            // a file system that knows no locks has none to respect
            _ => Ok(Self { _locked: locked }),
        }
    }
}

/// What is locked: the folder itself, which leaves nothing behind.
#[cfg(unix)]
fn lockable(folder: &Path) -> io::Result<File> {
    File::open(folder)
}

/// What is locked: a file of its own, as folders cannot be.
#[cfg(not(unix))]
fn lockable(folder: &Path) -> io::Result<File> {
    File::create(folder.join(".lock"))
}
