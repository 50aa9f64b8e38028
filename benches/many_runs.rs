//! A thousand runs of the steady scene as a study, on one thread and on two, beside their bare integration.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use jeffcott::internals::BareRun;
use jeffcott::scenario;

const RUNS: usize = 1000;
const STEADY: &str = "steady-7205c";
/// Each time is the shortest of so many.
const TRIALS: usize = 3;

/// Shortest time of some trials, s.
fn shortest(mut work: impl FnMut()) -> f64 {
    let trials = (0..TRIALS).map(|_| {
        let started = Instant::now();
        work();
        started.elapsed().as_secs_f64()
    });
    trials.fold(f64::INFINITY, f64::min)
}

/// What of the motion is kept.
const THREE: &str = "keep.numbers = ['x_rms_m', 'y_rms_m', 'x_peak_to_peak_m']";

/// Time of the study that keeps this, s.
fn study(keep: &str, threads: &str) -> f64 {
    let folder = tempfile::tempdir().expect("a folder");
    let text = format!(
        "base = '{}'\nverify_every = 0\n{keep}\n[[axis]]\nkey = 'speed.constant'\n\
         from = '500 rad/s'\nto = '500.1 rad/s'\ncount = {RUNS}\n\
         [[set]]\nkey = 'time.duration'\nvalue = '0.5 s'\n\
         [[set]]\nkey = 'time.settle'\nvalue = '0.25 s'\n",
        shipped(STEADY).display()
    );
    let file = folder.path().join("many.toml");
    fs::write(&file, text).expect("a writable folder");
    shortest(|| {
        let status = Command::new(env!("CARGO_BIN_EXE_jeffcott"))
            .arg("study")
            .arg(&file)
            .args(["--threads", threads, "--restart", "--out"])
            .arg(folder.path())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .status()
            .expect("the command starts");
        assert!(status.success());
    })
}

fn shipped(scene: &str) -> PathBuf {
    let scenarios = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios");
    scenarios.join(format!("{scene}.toml"))
}

fn main() {
    let scene = scenario::load(&shipped(STEADY)).expect("a shipped scenario");
    let model = scene.model.expect("a motion");
    let bare = BareRun::new(&model).expect("a rotor");
    let stop = AtomicBool::new(false);
    let integration = shortest(|| {
        for _ in 0..RUNS {
            bare.integrate(&stop).expect("a motion");
        }
    });
    let per_run = |seconds: f64| 1e3 * seconds / RUNS as f64;
    println!("bare integration: {:.3} ms a run", per_run(integration));
    for (name, keep) in [("all numbers", ""), ("three numbers", THREE)] {
        let [one, two] = ["1", "2"].map(|threads| study(keep, threads));
        let over = 100.0 * (one / integration - 1.0);
        println!(
            "{name}: {:.3} ms a run, {over:.0} % over it; {:.2} times as fast on two threads",
            per_run(one),
            one / two
        );
    }
}
