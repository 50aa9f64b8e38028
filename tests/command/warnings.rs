//! What is warned of on the terminal stands in JSON, in the sealed document and on the page, in the same order and
//! once: of every verb, and of every run of a study.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;
use tempfile::TempDir;

use crate::support::{done, jeffcott, json, root, told, verb};

fn warned() -> PathBuf {
    root().join("tests/scenarios/hard/warned.toml")
}

/// Beginnings of the warnings of the scene.
const OF_THE_FILE: [&str; 2] = ["no `settle` in `[time]`", "`[machine]` has no effect"];
const OF_THE_SPEED: &str =
    "bearing 1, at the static equilibrium: contact = \"hertz\" leaves out the inertia";

/// The warnings on the terminal, without what they are about; that a search is slow so far is told there alone.
fn on_terminal(stderr: &str, about: &str) -> Vec<String> {
    let start = format!("warning: {about}: ");
    let lines = stderr.lines().filter_map(|line| line.strip_prefix(&start));
    let lasting = lines.filter(|line| !line.starts_with("slow: "));
    lasting.map(str::to_owned).collect()
}

fn texts(list: &Value) -> Vec<String> {
    let list = list.as_array().expect("a list of warnings");
    let texts = list.iter().map(|text| text.as_str().expect("a text"));
    texts.map(str::to_owned).collect()
}

/// Whether a page holds a text among its data.
fn shows(page: &Path, text: &str) -> bool {
    let page = fs::read_to_string(page).expect("a page");
    page.contains(&Value::from(text).to_string().replace('<', "\\u003c"))
}

/// Checks a verb on a file: terminal, JSON, document and page say the same, which begins so.
#[track_caller]
fn says_alike(name: &str, more: &[&str], seal: &str, file: &Path, begins: &[&str]) {
    let out = TempDir::new().expect("a folder");
    let more = [&["--json"], more].concat();
    let output = verb(name, &[file], out.path(), &more).output();
    let output = output.expect("the command starts");
    let found = on_terminal(&told(&output), &file.display().to_string());
    assert_eq!(found.len(), begins.len(), "{name}: {found:?}");
    for (text, begin) in found.iter().zip(begins) {
        assert!(
            text.starts_with(begin),
            "{name}: {text} does not begin with {begin}"
        );
    }
    let answer: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(texts(&answer["warnings"]), found, "{name} --json");
    let folder = out.path().join(file.file_stem().expect("a name"));
    assert_eq!(
        texts(&json(&folder.join(seal))["warnings"]),
        found,
        "{seal}"
    );
    for text in &found {
        let page = match seal {
            "summary.json" => "report.html".to_owned(),
            other => other.replace(".json", ".html"),
        };
        assert!(shows(&folder.join(page), text), "{name}: {text}");
    }
}

#[test]
fn every_verb_says_alike_what_it_warns_of() {
    let [settle, machine] = OF_THE_FILE;
    let all = [settle, machine, OF_THE_SPEED];
    let cases = [
        ("run", "--no-verify", "summary.json"),
        ("steady", "--no-verify", "steady.json"),
        ("campbell", "--to=1500rad/s --count=3", "campbell.json"),
        (
            "accuracy",
            "--methods=verner76 --tolerances=1e-4 --longest=1s",
            "accuracy.json",
        ),
    ];
    for (name, more, seal) in cases {
        let more: Vec<&str> = more.split(' ').collect();
        says_alike(name, &more, seal, &warned(), &all);
    }
    let over = "--no-verify --over=speed.constant --from=1500rad/s --to=1510rad/s --points=2";
    let over: Vec<&str> = over.split(' ').collect();
    let both_ends = [
        settle,
        machine,
        OF_THE_SPEED,
        OF_THE_SPEED,
        "the branch goes on beyond its 2 motions",
    ];
    says_alike("steady", &over, "response.json", &warned(), &both_ends);
    let inertia = "bearing 1: contact = \"hertz\" leaves out the inertia";
    says_alike(
        "bearing",
        &[],
        "bearing.json",
        &warned(),
        &[settle, machine, inertia],
    );
}

#[test]
fn check_and_a_run_that_fails_have_the_warnings() {
    let checked = done(
        jeffcott()
            .args(["check", "--json"])
            .arg(warned())
            .output()
            .unwrap(),
    );
    let checked: Value = serde_json::from_slice(&checked.stdout).expect("JSON");
    assert_eq!(texts(&checked[0]["warnings"]).len(), 3);
    let out = TempDir::new().expect("a folder");
    let heavy = fs::read_to_string(warned())
        .unwrap()
        .replace("1000 N", "500 MN");
    let file = out.path().join("heavy.toml");
    fs::write(&file, heavy).expect("a file");
    let output = verb("run", &[&file], out.path(), &["--json"])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1));
    let failed: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let found = on_terminal(&told(&output), &file.display().to_string());
    assert_eq!(texts(&failed["warnings"]), found);
    assert_eq!(found.len(), 2);
}

/// A scene that every verb refuses is not right: here nothing carries the load.
#[test]
fn check_refuses_what_no_verb_can_answer() {
    let folder = TempDir::new().expect("a folder");
    let [moving, standing] = ["moving.toml", "standing.toml"].map(|name| folder.path().join(name));
    let heavy = fs::read_to_string(warned())
        .unwrap()
        .replace("1000 N", "500 MN");
    fs::write(&moving, &heavy).expect("a file");
    let (before, _) = heavy.split_once("[machine]").expect("a table");
    fs::write(&standing, before).expect("a file");
    for file in [moving, standing] {
        let output = jeffcott()
            .args(["check", "--json"])
            .arg(&file)
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(2));
        let found: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        let message = found[0]["issues"][0]["message"]
            .as_str()
            .expect("a message");
        assert!(message.contains("no static equilibrium"), "{message}");
    }
}

/// A study has the warnings of its runs, those of the file of its base among them; none on a key that it sets.
#[test]
fn the_runs_of_a_study_have_the_warnings_of_the_base() {
    let out = TempDir::new().expect("a folder");
    let base = warned();
    let study = |set: &str| {
        format!(
            "title = \"s\"\nbase = \"{}\"\n{set}[[axis]]\nkey = \"load[1].constant.z\"\nvalues = [\"900 N\", \"1000 N\"]\n",
            base.display()
        )
    };
    let file = out.path().join("s.toml");
    fs::write(&file, study("")).expect("a file");
    let output = verb("study", &[&file], out.path(), &[]).output().unwrap();
    let found = on_terminal(&told(&done(output)), "s");
    let [settle, machine] = OF_THE_FILE;
    for (text, begin) in found.iter().zip([settle, machine, OF_THE_SPEED]) {
        assert!(
            text.starts_with(&format!("run 0 and 1 more: {begin}")),
            "{text}"
        );
    }
    assert!(found.len() >= 3, "{found:?}");
    let folder = out.path().join("s");
    assert_eq!(texts(&json(&folder.join("runs.json"))["warnings"]), found);
    for text in &found {
        assert!(shows(&folder.join("report.html"), text), "{text}");
    }
    let alone = done(
        verb("study", &[&file], out.path(), &["--only", "1"])
            .output()
            .unwrap(),
    );
    let of_run = texts(&json(&folder.join("run-1/summary.json"))["warnings"]);
    assert_eq!(of_run, on_terminal(&told(&alone), "s, run 1"));
    assert!(
        of_run.len() >= 3 && of_run[0].starts_with(settle),
        "{of_run:?}"
    );

    fs::write(
        &file,
        study("[[set]]\nkey = \"time.settle\"\nvalue = \"5 ms\"\n"),
    )
    .expect("a file");
    let checked = done(
        jeffcott()
            .args(["check", "--json"])
            .arg(&file)
            .output()
            .unwrap(),
    );
    let checked: Value = serde_json::from_slice(&checked.stdout).expect("JSON");
    let found = texts(&checked[0]["warnings"]);
    assert!(
        found[0].starts_with(machine) && found[1].starts_with(OF_THE_SPEED),
        "{found:?}"
    );
}
