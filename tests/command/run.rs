//! The command as a user meets it: exit codes, files, interrupts.

use std::fs;
use std::path::Path;
use std::process::Stdio;

use crate::support::{
    done, interrupt, jeffcott, names, root, scenarios, shipped, shipped_text, text, toml_files,
    verb, wait_for,
};

/// The README's table names some of the scenarios; its errors are those of today, give or take what
/// another processor's last digits make of them.
fn check_against_readme(file: &Path, error: f64) {
    let readme = root().join("README.md");
    let readme = fs::read_to_string(readme).expect("README.md");
    let stem = file.file_stem().expect("a stem").to_string_lossy();
    let start = format!("| `{stem}`");
    let tolerance = |line: &&str| {
        line.split('|')
            .nth(2)
            .is_some_and(|cell| cell.trim().starts_with("1e-"))
    };
    let Some(line) = readme
        .lines()
        .filter(|line| line.starts_with(&start))
        .find(tolerance)
    else {
        return;
    };
    let cell = line.split('|').nth(3).expect("a column of errors").trim();
    let number = cell.split(':').next().unwrap_or(cell);
    let printed: f64 = number.parse().expect("a number");
    assert!(
        (0.5..2.0).contains(&(error / printed)),
        "{stem}: {error:e}, the README says {number}"
    );
}

/// Scenarios of roller bearings.
const ROLLERS: [&str; 4] = [
    "conveyor-head-22212",
    "motor-6206-nu206",
    "spall-outer-nu206",
    "tapered-pair",
];

#[test]
fn every_shipped_scenario_runs_and_states_its_error() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let files = toml_files(&scenarios());
    assert!(files.len() >= 5);
    let output = verb("run", &files, folder.path(), &["--json"]).output();
    let output = output.expect("the command starts");
    assert!(output.status.success(), "{}", text(&output.stderr));
    let summaries: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    for (summary, file) in summaries.as_array().expect("an array").iter().zip(&files) {
        let error = &summary["measured_error"]["relative"];
        assert!(
            error.as_f64().is_some_and(|error| error < 1e-4),
            "{}: {error}",
            file.display()
        );
        check_against_readme(file, error.as_f64().unwrap_or(f64::NAN));
    }
    // what a warning says nobody could have avoided by a default
    let warned = text(&output.stderr);
    let warned = warned.lines().filter(|line| line.starts_with("warning:"));
    let warned: Vec<_> = warned
        .filter(|line| !line.contains("order tracks"))
        // laminae of rollers meet the races all the time, which adds up to more than ten tolerances
        .filter(|line| {
            !(line.contains("measured error") && ROLLERS.iter().any(|name| line.contains(name)))
        })
        .collect();
    assert!(warned.is_empty(), "{warned:#?}");
    for file in files {
        let run = folder.path().join(file.file_stem().expect("a stem"));
        for name in [
            "trace.csv",
            "spectrum.csv",
            "trace.svg",
            "spectrum.svg",
            "summary.json",
        ] {
            // its speed changes to the end: the lines of a plain spectrum would smear
            let changes = ["run-up-spall-6205", "drive-start-7205c"];
            if name.starts_with("spectrum") && changes.iter().any(|own| run.ends_with(own)) {
                continue;
            }
            let size = fs::metadata(run.join(name))
                .map(|data| data.len())
                .unwrap_or(0);
            assert!(size > 500, "{} of {} has {size} bytes", name, run.display());
        }
    }
}

#[test]
fn a_value_of_the_command_line_stands_for_that_of_the_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = shipped("linear-7205c");
    let set = |settings: &[&str]| {
        let settings = settings.iter().flat_map(|set| ["--set", set]);
        let more: Vec<_> = settings.chain(["--json"]).collect();
        verb("bearing", &[&file], folder.path(), &more)
            .output()
            .expect("the command starts")
    };
    let found = done(set(&[
        "speed.constant=2000 rpm",
        "bearing[*].catalogue=7208C",
        "title=\"Set\"",
    ]));
    let found: serde_json::Value = serde_json::from_slice(&found.stdout).expect("JSON");
    assert_eq!(found["title"], "Set");
    assert_eq!(found["scenario"]["speed"]["constant"], "2000 rpm");
    assert_eq!(found["scenario"]["bearing"][0]["catalogue"], "7208C");
    for (setting, words) in [
        ("shaft.mass=5", "`mass` needs a unit"),
        ("shaft.mas=5 kg", "`shaft` has no key `mas`"),
        ("bearing[7].preload=5 N", "they count from 1 to 1"),
        ("shaft.mass", "write KEY=VALUE"),
    ] {
        let refused = set(&[setting]);
        let told = crate::support::told(&refused);
        assert_eq!(refused.status.code(), Some(2), "{told}");
        assert!(
            told.contains(words) && told.contains("--> command line:1:"),
            "{told}"
        );
    }
}

#[test]
fn the_same_scenario_gives_the_same_bytes() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let scenario = shipped("steady-7205c");
    let [first, second] = ["a", "b"].map(|name| folder.path().join(name));
    for out in [&first, &second] {
        let output = verb("run", &[&scenario], out, &[]).output();
        done(output.expect("the command starts"));
    }
    for name in [
        "trace.csv",
        "spectrum.csv",
        "peaks.csv",
        "poincare.csv",
        "orbit.svg",
        "trace.svg",
        "spectrum.svg",
        "summary.json",
    ] {
        let read = |out: &Path| fs::read(out.join("steady-7205c").join(name)).expect("a file");
        assert!(read(&first) == read(&second), "{name} differs");
    }
}

#[test]
fn a_wrong_file_is_code_2_and_nothing_runs() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let bad = folder.path().join("bad.toml");
    fs::write(&bad, "[shaft]\nmass = 5\n").expect("a written file");
    let good = shipped("steady-7205c");
    let out = folder.path().join("out");
    let output = verb("run", &[&good, &bad], &out, &[]).output();
    let output = output.expect("the command starts");
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("`mass` needs a unit"));
    assert!(!out.exists());
}

#[test]
fn two_files_of_one_name_are_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let copy = folder.path().join("steady-7205c.toml");
    fs::copy(shipped("steady-7205c"), &copy).expect("a copy");
    let output = jeffcott()
        .arg("run")
        .arg(&copy)
        .arg(shipped("steady-7205c"))
        .output();
    let output = output.expect("the command starts");
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("would be written to"));
}

#[test]
fn a_load_that_nothing_carries_is_code_1_and_leaves_no_files() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("loose.toml");
    let text_of = shipped_text("linear-7205c");
    fs::write(&file, text_of.replace("1000 N", "500 MN")).expect("a written file");
    let output = verb("run", &[&file], folder.path(), &[]).output();
    let output = output.expect("the command starts");
    assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
    assert!(
        text(&output.stderr).contains("no static equilibrium"),
        "{}",
        text(&output.stderr)
    );
    assert!(names(&folder.path().join("loose")).is_empty());
}

#[test]
fn an_unwritable_folder_is_code_1_before_the_run() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let blocked = folder.path().join("file");
    fs::write(&blocked, "not a folder").expect("a written file");
    let output = verb("run", &[shipped("steady-7205c")], &blocked, &[]).output();
    let output = output.expect("the command starts");
    assert_eq!(output.status.code(), Some(1));
    assert!(
        text(&output.stderr).contains("cannot create"),
        "{}",
        text(&output.stderr)
    );
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_leaves_no_file_that_looks_whole() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("long.toml");
    let text_of = shipped_text("steady-7205c");
    fs::write(&file, text_of.replace("0.5 s", "5000 s")).expect("a written file");
    let mut child = verb("run", &[&file], folder.path(), &[])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the command starts");
    let partial = folder.path().join("long/.trace.csv.partial");
    wait_for(&partial, 1);
    interrupt(&child);
    assert_eq!(child.wait().expect("an exit status").code(), Some(1));
    assert!(names(&folder.path().join("long")).is_empty());
}

#[test]
fn usage_errors_are_code_2_and_help_is_code_0() {
    let run = |arguments: &[&str]| {
        let output = jeffcott().args(arguments).output();
        output.expect("the command starts")
    };
    assert_eq!(run(&["run"]).status.code(), Some(2));
    assert_eq!(run(&["fly"]).status.code(), Some(2));
    assert_eq!(run(&["--help"]).status.code(), Some(0));
    assert!(text(&run(&["run", "--help"]).stdout).contains("Example"));
}
