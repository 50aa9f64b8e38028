//! How a run ended early, and what was kept of it, in words.

use std::path::PathBuf;

use serde_json::json;

use super::jobs::Answer;
use crate::integrate::IntegrateError;
use crate::report::KeptFiles;

/// A restart file that was written.
#[derive(Debug)]
pub struct Kept {
    /// Its path.
    pub path: PathBuf,
    /// Samples up to it.
    pub samples: u64,
    /// Time of the sample after them, s.
    pub time: f64,
}

/// A run that was stopped as asked before a `time` in s; `resume` is the command that goes on.
pub fn stopped(title: &str, time: f64, kept: Option<&Kept>, resume: &str) -> Answer {
    let mut text = format!("{title}\n  stopped       at t = {time:.6e} s\n");
    if let Some(Kept { path, samples, .. }) = kept {
        text += &format!("  samples       {samples}\n  wrote {}\n", path.display());
    }
    let json = json!({
        "title": title,
        "stopped_at_s": time,
        "samples": kept.map(|kept| kept.samples),
    });
    let files: Vec<_> = kept.iter().map(|kept| kept.path.clone()).collect();
    Answer {
        told: format!("it goes on with: {resume}\n"),
        ..Answer::new(text, json, &files)
    }
}

/// A run that cannot go on.
pub fn failed(error: &IntegrateError, kept: &KeptFiles) -> String {
    let files = kept.files.iter().map(|file| file.display().to_string());
    let files = files.collect::<Vec<_>>().join(" and ");
    let beside = match kept.beside_earlier {
        true => "; the other results there are those of an earlier run",
        false => "",
    };
    format!("{error}\n  kept {files}{beside}")
}

/// A run that somebody stopped; `resumed` tells whether it went on from a restart file, which still stands.
pub fn interrupted(
    error: &IntegrateError,
    kept: Option<&Kept>,
    resumed: bool,
    resume: &str,
) -> String {
    match kept {
        Some(Kept {
            path,
            samples,
            time,
        }) => format!(
            "{error}\n  kept {}: {samples} samples, up to t = {time:.6e} s\n  it goes on with: {resume}",
            path.display()
        ),
        None if resumed => {
            format!("{error}; the restart file stands as it was\n  it goes on with: {resume}")
        }
        None => {
            format!("{error}; nothing was written (--restartable keeps what it takes to go on)")
        }
    }
}
