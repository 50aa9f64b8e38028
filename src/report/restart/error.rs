//! Why a restart file is of no use.

use std::io;
use std::path::PathBuf;

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
    #[error("cannot read {}: {source}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The answer of the system.
        source: io::Error,
    },
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
        what: String,
    },
    /// Another version wrote it, whose numbers may differ in the last digit.
    #[error(
        "{} was written by version {there} of jeffcott and this is {here}: go on with that one, or \
         run the scenario from its start", path.display()
    )]
    Version {
        /// The file.
        path: PathBuf,
        /// Version that wrote it.
        there: String,
        /// This version.
        here: &'static str,
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
