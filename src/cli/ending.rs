//! How a run ended early, and what was kept of it, in words.

use std::fmt;
use std::io;
use std::path::PathBuf;

use serde_json::{Value, json};

use super::jobs::Job;
use super::stream;
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

/// A run that was stopped as asked.
#[derive(Debug)]
pub struct Stopped {
    /// Time of the next sample, s.
    pub time: f64,
    /// What was kept.
    pub restart: Option<Kept>,
    /// What goes on with it.
    pub resume: String,
}

impl Stopped {
    /// A few lines for a person.
    ///
    /// # Errors
    /// Whatever keeps stdout from taking them.
    pub fn print(&self, job: &Job) -> io::Result<()> {
        let title = &job.scenario.title;
        let mut text = format!("{title}\n  stopped       at t = {:.6e} s\n", self.time);
        if let Some(kept) = &self.restart {
            let path = kept.path.display();
            text += &format!("  samples       {}\n  wrote {path}\n", kept.samples);
        }
        stream::print(&text)?;
        stream::tell(&format!("it goes on with: {}\n", self.resume));
        Ok(())
    }

    /// The same for a program.
    pub fn json(&self, job: &Job) -> Value {
        let files = self
            .restart
            .iter()
            .map(|kept| kept.path.display().to_string());
        json!({
            "title": job.scenario.title,
            "stopped_at_s": self.time,
            "samples": self.restart.as_ref().map(|kept| kept.samples),
            "files": files.collect::<Value>(),
        })
    }
}

/// A run that cannot go on.
#[derive(Debug, thiserror::Error)]
pub struct Failed {
    /// Why.
    pub error: IntegrateError,
    /// What was kept of it.
    pub kept: KeptFiles,
}

impl fmt::Display for Failed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let files: Vec<String> = self
            .kept
            .files
            .iter()
            .map(|file| file.display().to_string())
            .collect();
        write!(f, "{}\n  kept {}", self.error, files.join(" and "))?;
        if self.kept.beside_earlier {
            write!(f, "; the other results there are those of an earlier run")?;
        }
        Ok(())
    }
}

/// A run that somebody stopped.
#[derive(Debug, thiserror::Error)]
pub struct Interrupted {
    error: IntegrateError,
    restart: Option<Kept>,
    /// Whether the run went on from a restart file that still stands.
    resumed: bool,
    resume: String,
}

impl Interrupted {
    /// An interruption, what was kept, and the command that goes on.
    pub fn new(
        error: IntegrateError,
        restart: Option<Kept>,
        resumed: bool,
        resume: String,
    ) -> Self {
        Self {
            error,
            restart,
            resumed,
            resume,
        }
    }
}

impl fmt::Display for Interrupted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.error)?;
        match &self.restart {
            Some(Kept {
                path,
                samples,
                time,
            }) => write!(
                f,
                "\n  kept {}: {samples} samples, up to t = {time:.6e} s\n  it goes on with: {}",
                path.display(),
                self.resume
            ),
            None if self.resumed => write!(
                f,
                "; the restart file stands as it was\n  it goes on with: {}",
                self.resume
            ),
            None => write!(
                f,
                "; nothing was written (--restartable keeps what it takes to go on)"
            ),
        }
    }
}
