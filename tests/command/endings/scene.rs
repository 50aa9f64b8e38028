//! The command in a folder of its own, and what it leaves there.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

use tempfile::TempDir;

use crate::support::{self, files, interrupt, jeffcott, shipped_text, wait_for};

/// A shipped scenario with four times the samples.
pub fn finely_sampled(name: &str) -> String {
    let text = shipped_text(name);
    let key = "samples_per_revolution = ";
    let (before, after) = text.split_once(key).expect("samples per revolution");
    let digits = after.find(|c: char| !c.is_ascii_digit());
    let (number, rest) = after.split_at(digits.unwrap_or(after.len()));
    let samples: u32 = number.parse().expect("a whole number");
    format!("{before}{key}{}{rest}", 4 * samples)
}

/// A scene in a folder: its scenario, and its results under `output/scene`.
pub struct Scene {
    folder: TempDir,
}

/// What a command said.
#[derive(Debug)]
pub struct Said {
    pub code: Option<i32>,
    pub stderr: String,
}

impl Said {
    #[track_caller]
    pub fn done(self) -> Self {
        assert_eq!(self.code, Some(0), "{}", self.stderr);
        self
    }

    /// The exit code, and a part of the message.
    #[track_caller]
    pub fn says(&self, code: i32, part: &str) {
        assert_eq!(self.code, Some(code), "{}", self.stderr);
        assert!(self.stderr.contains(part), "`{part}` in\n{}", self.stderr);
    }
}

impl Scene {
    pub fn new(scenario: &str) -> Self {
        let scene = Self {
            folder: tempfile::tempdir().expect("a temporary folder"),
        };
        scene.change(scenario);
        scene
    }

    /// Replaces the scenario.
    pub fn change(&self, scenario: &str) {
        fs::write(self.path("scene.toml"), scenario).expect("a written scenario");
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// A file of the results.
    pub fn result(&self, name: &str) -> PathBuf {
        self.path("output/scene").join(name)
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = jeffcott();
        command
            .args(["run", "scene.toml"])
            .args(arguments)
            .current_dir(self.folder.path());
        command
    }

    pub fn run(&self, arguments: &[&str]) -> Said {
        let output = self.command(arguments).output();
        said(&output.expect("the command starts"))
    }

    /// Starts the run, interrupts it once a file of the results has so many bytes, and waits.
    pub fn interrupt(&self, arguments: &[&str], name: &str, bytes: u64) -> Said {
        let child = self
            .command(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command starts");
        wait_for(&self.result(name), bytes);
        interrupt(&child);
        said(&child.wait_with_output().expect("an output"))
    }

    /// All results by name.
    pub fn results(&self) -> BTreeMap<String, Vec<u8>> {
        let folder = self.path("output/scene");
        if folder.exists() {
            files(&folder).into_iter().collect()
        } else {
            BTreeMap::new()
        }
    }
}

fn said(output: &Output) -> Said {
    Said {
        code: output.status.code(),
        stderr: support::text(&output.stderr),
    }
}
