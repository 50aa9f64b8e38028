//! `restart.bin`: what a stopped run leaves, so that it goes on to the same bytes.
//!
//! ```text
//! magic, format          8 bytes, u32
//! version, scenario      texts: u64 length and UTF-8
//! fingerprint            u64, of the model
//! states                 f64 of every sample so far
//! standing               both passes, JSON
//! length of the standing u64
//! checksum               u64, of everything before
//! end                    8 bytes
//! ```
//!
//! All numbers are little endian. States come before the standing, which is known last: a run writes
//! them as it goes, and memory does not grow with it.

mod error;
mod identity;
mod reader;
mod writer;

use std::path::{Path, PathBuf};

pub use error::RestartError;
pub use identity::RunIdentity;
pub(super) use identity::difference;
pub use reader::RestartReader;
pub use writer::RestartWriter;

/// Name of the file in the folder of its run.
pub(super) const RESTART: &str = "restart.bin";

const MAGIC: [u8; 8] = *b"jeffcott";
const END: [u8; 8] = *b"tticffej";
const FORMAT: u32 = 2;
/// Bytes of length, checksum and end.
const TAIL: u64 = 24;

/// Where the restart file of a run folder is.
pub fn restart_path(folder: &Path) -> PathBuf {
    folder.join(RESTART)
}
