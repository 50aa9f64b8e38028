//! A file of the user's own bearings.

use std::path::Path;

use super::document::file_text;
use crate::bearing::catalogue::{Catalogue, read as read_text};

/// Most bytes of a file.
const LARGEST: u64 = 16 << 20;

/// The bearings of a CSV file.
///
/// # Errors
/// Everything that is wrong with it.
pub(crate) fn read(path: &Path) -> Result<Catalogue, Vec<String>> {
    let text = file_text(path, LARGEST).map_err(|problem| vec![problem])?;
    read_text(&text)
}
