//! A file of the user's own bearings.

use std::path::Path;

use crate::bearing::catalogue::{CatalogueEntry, read as read_text};

/// Most bytes of a file.
const LARGEST: u64 = 16 << 20;

/// The bearings of a CSV file.
///
/// # Errors
/// Everything that is wrong with it.
pub(crate) fn read(path: &Path) -> Result<Vec<CatalogueEntry>, Vec<String>> {
    let unreadable = |error: std::io::Error| vec![format!("it cannot be read: {error}")];
    let known = std::fs::metadata(path).map_err(unreadable)?;
    if !known.is_file() || known.len() > LARGEST {
        let most = LARGEST >> 20;
        return Err(vec![format!("it is not a file of at most {most} MB")]);
    }
    read_text(&std::fs::read_to_string(path).map_err(unreadable)?)
}
