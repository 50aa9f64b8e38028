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

mod error;
mod identity;
mod reader;
mod writer;

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use serde_json::Value;

pub use error::RestartError;
pub use identity::RunIdentity;
pub(super) use identity::difference;
pub use reader::RestartReader;
pub use writer::RestartWriter;

use crate::simulate::Standing;

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
