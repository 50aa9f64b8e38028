//! What can go wrong between a result and its file.

use std::path::{Path, PathBuf};
use std::{fmt, io};

/// What was being done to a file or folder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum FileAction {
    /// Create a file or folder.
    Create,
    /// Read a file.
    Read,
    /// Write into a file.
    Write,
    /// See that a file or folder outlives a loss of power.
    Sync,
    /// Give a finished file its name.
    Rename,
    /// Remove the file of an earlier run.
    Remove,
}

impl fmt::Display for FileAction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Create => "create",
            Self::Read => "read",
            Self::Write => "write",
            Self::Sync => "sync",
            Self::Rename => "rename",
            Self::Remove => "remove",
        })
    }
}

/// Why a result did not get into its file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReportError {
    /// The file system refused.
    #[error("cannot {action} {}: {source}", path.display())]
    File {
        /// What was tried.
        action: FileAction,
        /// On what.
        path: PathBuf,
        /// The answer of the system.
        source: io::Error,
    },
    /// Another process writes there.
    #[error(
        "another process is writing to {}; wait for its end, or write to another folder by --out",
        path.display()
    )]
    Busy {
        /// The folder, or the file of rows.
        path: PathBuf,
    },
    /// What `[[measured]]` names cannot be laid over a run.
    #[error("cannot lay {} of `[[measured]]` over the run: {message}", path.display())]
    Measured {
        /// The folder or file.
        path: PathBuf,
        /// Why.
        message: String,
    },
}

impl ReportError {
    /// Adds action and path to an answer of the file system.
    pub(super) fn file(action: FileAction, path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::File {
            action,
            path,
            source,
        }
    }

    /// Adds the path to an answer of the file system to writing, for those who write whatever they write to.
    pub(super) fn named(path: &Path) -> impl FnOnce(io::Error) -> io::Error {
        |error| io::Error::new(error.kind(), Self::file(FileAction::Write, path)(error))
    }
}
