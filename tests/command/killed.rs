//! Killed at any instant, or started twice into one folder, a run or a study leaves nothing that looks whole and is
//! not. A few times here; `JEFFCOTT_KILLS=100 cargo test --test command killed` does it so often, and twice as often
//! with two processes.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Output, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use tempfile::TempDir;

use crate::support::{done, loaded_7205c, names, told, verb};

/// How often something is killed.
fn kills() -> u64 {
    let asked = std::env::var("JEFFCOTT_KILLS").ok();
    asked.map_or(8, |text| text.parse().expect("a whole number"))
}

/// The same numbers every time: a linear congruence by Knuth, its upper bits, as a part of one.
struct Chance(u64);

impl Chance {
    fn part(&mut self) -> f64 {
        let (factor, more) = (6_364_136_223_846_793_005, 1_442_695_040_888_963_407);
        self.0 = self.0.wrapping_mul(factor).wrapping_add(more);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Two files of one name, whose results belong in one folder, and what each leaves there when it is let alone.
struct Two {
    folder: TempDir,
    verb: &'static str,
    seal: &'static str,
    files: [PathBuf; 2],
    alone: [Vec<(String, Vec<u8>)>; 2],
    /// How long they take.
    time: Duration,
}

impl Two {
    fn new(verb: &'static str, seal: &'static str, texts: [String; 2]) -> Self {
        let folder = TempDir::new().expect("a folder");
        let files = ["a", "b"].map(|name| {
            fs::create_dir(folder.path().join(name)).expect("a folder");
            folder.path().join(name).join("scene.toml")
        });
        for (file, text) in files.iter().zip(texts) {
            fs::write(file, text).expect("a written file");
        }
        let mut two = Self {
            folder,
            verb,
            seal,
            files,
            alone: [Vec::new(), Vec::new()],
            time: Duration::MAX,
        };
        for which in [0, 1] {
            let started = Instant::now();
            done(two.start(which, &[]).wait_with_output().expect("its end"));
            two.time = two.time.min(started.elapsed());
            two.alone[which] = shown(&two.results());
            fs::remove_dir_all(two.results()).expect("a removed folder");
        }
        assert!(two.alone[0] != two.alone[1]);
        two
    }

    fn results(&self) -> PathBuf {
        self.folder.path().join("out/scene")
    }

    fn start(&self, which: usize, more: &[&str]) -> Child {
        let out = self.folder.path().join("out");
        verb(self.verb, &[&self.files[which]], &out, more)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command starts")
    }

    fn end(&self, which: usize, more: &[&str]) -> Output {
        let child = self.start(which, more);
        child.wait_with_output().expect("its end")
    }

    /// What looks whole is one of the two, whole.
    #[track_caller]
    fn assert_whole_or_unsealed(&self, after: &str) {
        if self.results().join(self.seal).exists() {
            let found = shown(&self.results());
            if !self.alone.contains(&found) {
                let names: Vec<_> = found.iter().map(|(name, _)| name).collect();
                panic!("after {after} what looks whole is not: {names:?}");
            }
        }
    }

    /// One of the two stands there, and nothing else.
    #[track_caller]
    fn assert_stands(&self, which: usize) {
        assert!(shown(&self.results()) == self.alone[which]);
        let left = names(&self.results());
        assert!(!left.iter().any(|name| name.starts_with('.')), "{left:?}");
    }

    /// Starts one of the two again and again and kills it at any instant.
    fn kill_again_and_again(&self, more: &[&str]) {
        let mut chance = Chance(1);
        for kill in 0..kills() {
            let which = usize::from(chance.part() < 0.5);
            // half of the kills at the end, where files get their names
            let part = match kill % 2 {
                0 => chance.part(),
                _ => 0.8 + 0.4 * chance.part(),
            };
            let mut child = self.start(which, more);
            thread::sleep(self.time.mul_f64(part));
            child.kill().expect("it is killed");
            child.wait().expect("its end");
            self.assert_whole_or_unsealed(&format!("kill {kill}"));
        }
        done(self.end(0, more));
        self.assert_stands(0);
    }

    /// Starts both at a time; who comes second is told so.
    fn start_together(&self, more: &[&str]) {
        for pair in 0..2 * kills() {
            let both = [0, 1].map(|which| self.start(which, more));
            let ended = both.map(|child| child.wait_with_output().expect("its end"));
            for output in &ended {
                let refused =
                    output.status.code() == Some(1) && told(output).contains("another process");
                assert!(output.status.success() || refused, "{}", told(output));
            }
            assert!(ended.iter().any(|output| output.status.success()));
            self.assert_whole_or_unsealed(&format!("pair {pair}"));
            assert!(self.results().join(self.seal).exists());
        }
    }
}

/// All that a user sees in a folder, with the folders in it, and with its bytes; rows are no result.
fn shown(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut all = Vec::new();
    for name in names(folder) {
        let path = folder.join(&name);
        if name.starts_with('.') || name == "runs.jsonl" {
            continue;
        }
        if path.is_dir() {
            all.extend(shown(&path));
        } else {
            all.push((name, fs::read(path).expect("a readable file")));
        }
    }
    all
}

fn runs() -> Two {
    let scene = |mass| loaded_7205c("contact = \"hertz\"", "").replace("5 kg", mass);
    Two::new("run", "summary.json", ["5 kg", "6 kg"].map(scene))
}

fn studies() -> Two {
    let base = crate::support::scenarios().join("linear-7205c.toml");
    let study = |last: &str| {
        format!(
            "base = '{}'\n[[axis]]\nkey = 'speed.constant'\nfrom = '100 rad/s'\nto = '{last}'\ncount = 30\n\
             [keep]\ntraces = true\n",
            base.display()
        )
    };
    Two::new("study", "runs.json", ["400 rad/s", "500 rad/s"].map(study))
}

#[test]
fn a_killed_run_leaves_nothing_that_looks_whole_and_is_not() {
    runs().kill_again_and_again(&[]);
}

#[test]
fn a_killed_study_with_traces_leaves_nothing_that_looks_whole() {
    studies().kill_again_and_again(&["--restart"]);
}

#[test]
fn a_study_that_is_killed_and_goes_on_comes_to_the_same() {
    let two = studies();
    let mut chance = Chance(2);
    for kill in 0..kills() {
        let mut child = two.start(0, &[]);
        thread::sleep(two.time.mul_f64(1.2 * chance.part()));
        child.kill().expect("it is killed");
        child.wait().expect("its end");
        two.assert_whole_or_unsealed(&format!("kill {kill}"));
    }
    done(two.end(0, &[]));
    two.assert_stands(0);
}

#[test]
fn two_runs_into_one_folder_lock_each_other_out() {
    runs().start_together(&[]);
}

#[test]
fn two_studies_into_one_folder_lock_each_other_out() {
    studies().start_together(&["--restart"]);
}

/// The command of a finished study given again begins it anew: its seal goes before its traces.
#[test]
fn a_finished_study_that_is_begun_again_is_not_sealed() {
    let two = studies();
    done(two.end(0, &[]));
    two.assert_stands(0);
    let mut child = two.start(0, &[]);
    let traces = two.results().join("traces");
    let first = names(&traces).len();
    while names(&traces).len() == first {
        thread::sleep(Duration::from_micros(200));
    }
    child.kill().expect("it is killed");
    child.wait().expect("its end");
    two.assert_whole_or_unsealed("a kill amid its traces");
    assert!(!two.results().join("runs.json").exists());
}

/// What a killed run leaves under temporary names the next one removes.
#[test]
fn leftovers_of_a_killed_run_are_removed() {
    let two = runs();
    fs::create_dir_all(two.results()).expect("a folder");
    for name in [".trace.csv.partial", ".old.csv.partial"] {
        fs::write(two.results().join(name), "left").expect("a written file");
    }
    done(two.end(0, &[]));
    two.assert_stands(0);
}
