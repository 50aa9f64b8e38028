//! `jeffcott compare`: what agrees, what differs, what cannot be compared.

#![allow(clippy::unwrap_used)] // a test that cannot go on fails

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use jeffcott::report::compare::{Comparison, Tolerance, Tolerances, compare};
use tempfile::TempDir;

const TRACE: &str = "t_s,x_m\n0.0,0.0\n0.1,2e-6\n0.2,-1e-6\n";
const SPECTRUM: &str = "f_Hz,x_amplitude_m,x_phase_rad\n0.0,1e-6,3.14159\n1.0,1e-14,0.3\n";

fn files(first: &str, second: &str) -> (TempDir, PathBuf, PathBuf) {
    let folder = TempDir::new().unwrap();
    let paths = ["a.csv", "b.csv"].map(|name| folder.path().join(name));
    fs::write(&paths[0], first).unwrap();
    fs::write(&paths[1], second).unwrap();
    let [first, second] = paths;
    (folder, first, second)
}

fn compared(first: &str, second: &str, relative: f64) -> Comparison {
    let (_folder, first, second) = files(first, second);
    let tolerances = Tolerances::uniform(Tolerance::new(relative, 0.0).unwrap());
    compare(&first, &second, &tolerances).unwrap()
}

fn command(arguments: &[&Path], options: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_jeffcott"));
    command.arg("compare").args(arguments).args(options);
    command.output().unwrap()
}

/// Exit code and both streams.
fn result(output: &Output) -> (i32, String) {
    let text = [output.stdout.as_slice(), output.stderr.as_slice()].concat();
    (
        output.status.code().unwrap(),
        String::from_utf8(text).unwrap(),
    )
}

#[test]
fn a_table_agrees_with_itself_exactly() {
    for text in [TRACE, SPECTRUM] {
        assert!(compared(text, text, 0.0).agrees());
    }
}

#[test]
fn the_tolerance_is_relative_to_the_largest_magnitude_of_the_column() {
    let moved = TRACE
        .replace("0.1,2e-6", "0.1,2.0002e-6")
        .replace("0.0,0.0", "0.0,1e-10");
    assert!(compared(TRACE, &moved, 1.1e-4).agrees());
    let strict = compared(TRACE, &moved, 9e-5);
    let x = &strict.tables[0].columns[1];
    assert_eq!((x.name.as_str(), x.failures), ("x_m", 1));
    let worst = x.worst.unwrap();
    assert_eq!(
        (worst.row, worst.at, worst.first, worst.second),
        (2, 0.1, 2e-6, 2.0002e-6)
    );
}

#[test]
fn phases_agree_modulo_a_turn_and_where_there_is_nothing() {
    let turned = SPECTRUM
        .replace("3.14159", "-3.141595")
        .replace("0.3\n", "-2.0\n");
    assert!(compared(SPECTRUM, &turned, 1e-5).agrees());
    let other = SPECTRUM.replace("3.14159", "3.13");
    let comparison = compared(SPECTRUM, &other, 1e-5);
    assert_eq!(comparison.tables[0].columns[2].failures, 1);
}

#[test]
fn nan_agrees_with_nan_only_and_infinity_with_itself() {
    let with = |value: &str| TRACE.replace("-1e-6", value);
    assert!(compared(&with("NaN"), &with("NaN"), 0.0).agrees());
    assert!(compared(&with("inf"), &with("inf"), 0.0).agrees());
    for (a, b) in [
        ("NaN", "1"),
        ("inf", "-inf"),
        ("inf", "1e300"),
        ("NaN", "inf"),
    ] {
        assert!(!compared(&with(a), &with(b), 1.0).agrees(), "{a} {b}");
        assert!(!compared(&with(b), &with(a), 1.0).agrees(), "{b} {a}");
    }
}

#[test]
fn rows_columns_and_axes_that_do_not_match_are_named() {
    let message = |second: &str| {
        let comparison = compared(TRACE, second, 1e-6);
        assert!(!comparison.agrees());
        comparison.tables[0].differences[0].to_string()
    };
    let shorter = TRACE.replace("0.2,-1e-6\n", "");
    assert_eq!(
        message(&shorter),
        "3 rows against 2: the first 2 are compared"
    );
    let renamed = message(&TRACE.replace("x_m", "y_m"));
    assert!(renamed.contains("a.csv has the column x_m"), "{renamed}");
    let delayed = message(&TRACE.replace("0.1,", "0.11,"));
    assert!(delayed.starts_with("the axes t_s differ"), "{delayed}");
}

#[test]
fn the_order_of_columns_does_not_matter() {
    let swapped = "x_m,t_s\n0.0,0.0\n2e-6,0.1\n-1e-6,0.2\n";
    assert!(compared(TRACE, swapped, 0.0).agrees());
}

#[test]
fn exit_codes_tell_equal_different_and_unusable() {
    let (folder, a, b) = files(TRACE, &TRACE.replace("2e-6", "3e-6"));
    assert_eq!(result(&command(&[&a, &a], &[])).0, 0);
    let (code, text) = result(&command(&[&a, &b], &[]));
    assert_eq!(code, 1);
    assert!(
        text.contains("x_m") && text.contains("differs in 1 row"),
        "{text}"
    );
    assert_eq!(result(&command(&[&a, &b], &["--column", "x_m=0.5"])).0, 0);
    assert_eq!(result(&command(&[&a, &b], &["--absolute", "1e-6"])).0, 0);
    let missing = folder.path().join("missing.csv");
    let (code, text) = result(&command(&[&a, &missing], &[]));
    assert_eq!(code, 2);
    assert!(
        text.contains("cannot read") && text.contains("missing.csv"),
        "{text}"
    );
}

#[test]
fn what_cannot_be_compared_says_why() {
    let (folder, a, b) = files(TRACE, "t_s,x_m\n0.0,fast\n");
    let unusable = |arguments: &[&Path], options: &[&str], expected: &str| {
        let (code, text) = result(&command(arguments, options));
        assert_eq!(code, 2, "{text}");
        assert!(text.contains(expected), "{text}");
        assert!(!text.contains("panicked"), "{text}");
    };
    unusable(
        &[&a, &b],
        &[],
        "line 2, column \"x_m\": \"fast\" is not a number",
    );
    unusable(
        &[&a, &a],
        &["--relative", "-1"],
        "the relative tolerance is -1",
    );
    unusable(
        &[&a, &a],
        &["--absolute", "NaN"],
        "the absolute tolerance is NaN",
    );
    unusable(
        &[&a, &a],
        &["--column", "y_m=1"],
        "no table has a column \"y_m\"; there are: t_s, x_m",
    );
    unusable(&[&a, &a], &["--column", "x_m"], "expected NAME=R");
    unusable(
        &[&a, &a],
        &["--column", "x_m=1,-2"],
        "the absolute tolerance is -2",
    );
    unusable(&[&a, folder.path()], &[], "is a folder");
    unusable(&[folder.path(), Path::new("gone")], &[], "cannot read gone");
    unusable(
        &[folder.path(), folder.path()],
        &[],
        "holds a trace.csv or spectrum.csv",
    );
    for (content, expected) in [
        ("", "no rows"),
        ("t_s,x_m\n", "no rows"),
        ("t_s,t_s\n1,2\n", "two columns named \"t_s\""),
        ("t_s,x_m\n1\n", "not a table"),
    ] {
        fs::write(&b, content).unwrap();
        unusable(&[&a, &b], &[], expected);
    }
    fs::write(&b, [0x74, 0xff, 0xfe, 0x0a]).unwrap();
    unusable(&[&a, &b], &[], "not a table");
}

#[test]
fn folders_are_compared_table_by_table() {
    let folder = TempDir::new().unwrap();
    let runs = ["old", "new"].map(|name| folder.path().join(name));
    for run in &runs {
        fs::create_dir(run).unwrap();
        fs::write(run.join("trace.csv"), TRACE).unwrap();
    }
    assert_eq!(result(&command(&[&runs[0], &runs[1]], &[])).0, 0);
    fs::write(runs[1].join("spectrum.csv"), SPECTRUM).unwrap();
    let (code, text) = result(&command(&[&runs[0], &runs[1]], &[]));
    assert_eq!(code, 1);
    assert!(text.contains("only one run has"), "{text}");
    assert!(text.contains("spectrum.csv"), "{text}");
}

#[test]
fn json_carries_the_worst_place() {
    let (_folder, a, b) = files(TRACE, &TRACE.replace("2e-6", "3e-6"));
    let output = command(&[&a, &b], &["--json"]);
    let value: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(value["agrees"], false);
    let x = &value["tables"][0]["columns"][1];
    assert_eq!(x["name"], "x_m");
    assert_eq!(x["worst"]["row"], 2);
    assert_eq!(x["worst"]["second"], 3e-6);
}

#[test]
fn a_reader_that_goes_away_does_not_change_the_verdict() {
    let (_folder, a, b) = files(TRACE, &TRACE.replace("2e-6", "3e-6"));
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let mut command = Command::new(env!("CARGO_BIN_EXE_jeffcott"));
    command
        .arg("compare")
        .args([&a, &b])
        .stdout(writer)
        .stderr(Stdio::piped());
    let (code, text) = result(&command.output().unwrap());
    assert_eq!((code, text.as_str()), (1, ""));
}
