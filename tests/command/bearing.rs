//! `jeffcott bearing` as a user meets it: what it prints, what it writes, how it ends.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use serde_json::Value;
use tempfile::TempDir;

use crate::support::{done, jeffcott, names, shipped, text, verb};

fn bearing(files: &[PathBuf], out: &Path, more: &[&str]) -> Output {
    verb("bearing", files, out, more).output().unwrap()
}

/// A scenario without motion, with more tables at its end.
fn standing(folder: &TempDir, tables: &str) -> PathBuf {
    let file = folder.path().join("standing.toml");
    let head = "[shaft]\nmass = \"5 kg\"\nfreedoms = \"translational\"\n[speed]\n\
                constant = \"500 rad/s\"\n[[bearing]]\ncatalogue = \"7205C\"\n";
    fs::write(&file, format!("{head}{tables}")).unwrap();
    file
}

const THRUST: &str = "[[load]]\nconstant = { z = \"1000 N\" }\n";

#[test]
fn the_answer_fits_the_terminal_and_names_what_is_asked() {
    let out = TempDir::new().unwrap();
    let files = [shipped("bearing-7205c"), shipped("arrangement-7205c")];
    let output = bearing(&files, out.path(), &[]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let shown = text(&output.stdout);
    for word in [
        "equilibrium",
        "K_θy",
        "condition",
        "life L10r",
        "static safety",
        "friction",
        "ball pass",
        "of films",
        "twist",
        "λi",
        "N mm",
        "bearing 2",
    ] {
        assert!(shown.contains(word), "no {word} in\n{shown}");
    }
    for line in shown.lines().filter(|line| !line.contains("wrote")) {
        assert!(line.chars().count() <= 100, "{line}");
    }
    for name in ["bearing-7205c", "arrangement-7205c"] {
        let files = names(&out.path().join(name));
        assert_eq!(
            files,
            ["balls.csv", "balls.svg", "bearing.html", "bearing.json"]
        );
    }
    let balls = fs::read_to_string(out.path().join("arrangement-7205c/balls.csv")).unwrap();
    assert_eq!(balls.lines().count(), 1 + 2 * 12);
}

#[test]
fn the_json_is_the_file_and_balances_the_load() {
    let out = TempDir::new().unwrap();
    let output = bearing(&[shipped("bearing-7205c")], out.path(), &["--json"]);
    let mut printed: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(printed["files"].as_array().unwrap().len(), 4);
    printed.as_object_mut().unwrap().remove("files");
    let file = fs::read(out.path().join("bearing-7205c/bearing.json")).unwrap();
    assert_eq!(printed, serde_json::from_slice::<Value>(&file).unwrap());

    let number = |pointer: &str| printed.pointer(pointer).unwrap().as_f64().unwrap();
    assert!((number("/force/force_z_N") - 1000.0).abs() < 1e-6);
    assert!((number("/force/force_y_N") + 300.0).abs() < 1e-6);
    assert_eq!(
        number("/stiffness/named/stiffness_x_N_m"),
        number("/stiffness/matrix/0/0")
    );
    assert_eq!(printed["free"], serde_json::json!(["x", "y", "z"]));
    let balls = printed["bearings"][0]["balls"].as_array().unwrap();
    let axial = |ball: &Value| {
        let inner = &ball["inner"];
        inner["load_N"].as_f64().unwrap() * inner["angle_rad"].as_f64().unwrap().sin()
    };
    // the share of the gyroscopic moment is at the outer race: the inner contacts carry the thrust
    let carried: f64 = balls.iter().map(axial).sum();
    assert!((carried - 1000.0).abs() < 1e-6, "{carried}");
}

#[test]
fn run_names_the_table_that_a_standing_shaft_lacks() {
    let folder = TempDir::new().unwrap();
    let file = standing(&folder, THRUST);
    let out = folder.path().join("out");
    done(jeffcott().arg("check").arg(&file).output().unwrap());
    let output = verb("run", &[&file], &out, &[]).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("the scenario has no [time]"));
    assert!(!out.exists());
}

#[test]
fn warnings_are_messages_and_an_uncarried_load_is_code_1() {
    let folder = TempDir::new().unwrap();
    let pair = "preload = \"100 N\"\narrangement = \"back-to-back\"\nspacing = \"20 mm\"\n";
    let file = standing(&folder, &format!("{pair}{THRUST}"));
    let output = bearing(&[file], folder.path(), &[]);
    assert!(output.status.success());
    let messages = text(&output.stderr);
    assert!(messages.contains("the preload is lost on"), "{messages}");

    let file = standing(&folder, &THRUST.replace("1000 N", "500 MN"));
    let out = folder.path().join("loose");
    let output = bearing(&[file], &out, &[]);
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("no static equilibrium"));
    assert!(!out.exists());
}

#[test]
fn a_shaft_that_is_held_all_around_has_an_answer() {
    let out = TempDir::new().unwrap();
    let held = "[static]\ndisplacement = { x = \"0 m\", y = \"0 m\", z = \"10 um\" }\n";
    let output = bearing(&[standing(&out, held)], out.path(), &["--json"]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(answer["condition"], 1.0);
    assert!(answer["force"]["force_z_N"].as_f64().unwrap() > 0.0);
}
