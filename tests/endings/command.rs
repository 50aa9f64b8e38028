//! The command in a folder of its own, and what it leaves there.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use tempfile::TempDir;

/// A scene in a folder: its scenario, and its results under `output/scene`.
pub struct Scene {
    folder: TempDir,
}

/// What a command said.
#[derive(Debug)]
pub struct Said {
    pub code: Option<i32>,
    pub stdout: String,
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
        let mut command = Command::new(env!("CARGO_BIN_EXE_jeffcott"));
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
        let file = self.result(name);
        while fs::metadata(&file).map(|data| data.len()).unwrap_or(0) < bytes {
            std::thread::sleep(std::time::Duration::from_millis(5));
        }
        kill(&child);
        said(&child.wait_with_output().expect("an output"))
    }

    /// All results by name.
    pub fn results(&self) -> BTreeMap<String, Vec<u8>> {
        files(&self.path("output/scene"))
    }
}

fn said(output: &std::process::Output) -> Said {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    Said {
        code: output.status.code(),
        stdout: text(&output.stdout),
        stderr: text(&output.stderr),
    }
}

fn kill(child: &Child) {
    let kill = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(kill.expect("kill starts").success());
}

fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let Ok(entries) = fs::read_dir(folder) else {
        return BTreeMap::new();
    };
    entries
        .map(|entry| {
            let path = entry.expect("a readable entry").path();
            let name = path.file_name().expect("a name").to_string_lossy();
            (name.into_owned(), fs::read(&path).expect("a readable file"))
        })
        .collect()
}

/// A scenario of the crate.
pub fn shipped(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios");
    fs::read_to_string(folder.join(name)).expect("a shipped scenario")
}
