//! `[[measured]]`: records that are laid over the spectra of a run.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::scenario::Issue;
use crate::scenario::problems::Problems;

/// A measured record whose spectra are laid over those of the run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeasuredInput {
    /// A folder that `jeffcott analyze` has written, a record, or a file that describes one, looked for from the folder of the scenario.
    #[schemars(extend("examples" = ["output/112", "drive-end.toml"]))]
    pub file: String,
}

impl MeasuredInput {
    /// Its path; `None` where nothing is there.
    pub fn build(&self, problems: &mut Problems<'_>) -> Option<PathBuf> {
        let path = problems.folder.join(&self.file);
        if path.exists() {
            return Some(path);
        }
        let message = format!("there is no {}", path.display());
        let help = "give a folder that `jeffcott analyze` has written, or a record";
        problems.refuse(Issue::new(".file", message).help(help));
        None
    }
}
