//! Files, names and folders of others: what never ends is not read, what commands a terminal is shown, links are not
//! followed, and what is no whole run is not compared.
#![cfg(unix)]

use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::{Value, json};
use tempfile::TempDir;

use crate::support::{PROGRAM, done, loaded_7205c, names, root, text, told};

/// The command in a folder; one that reads without end is stopped, with another exit code.
fn says(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new("timeout");
    command
        .args(["60", PROGRAM])
        .args(arguments)
        .current_dir(folder);
    command.output().expect("timeout starts")
}

#[track_caller]
fn refused(output: &Output, word: &str) {
    assert_eq!(output.status.code(), Some(2), "{}", told(output));
    assert!(told(output).contains(word), "`{word}` in\n{}", told(output));
}

fn folder_with(files: &[(&str, &str)]) -> TempDir {
    let folder = TempDir::new().expect("a folder");
    for (name, text) in files {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, text).expect("a file");
    }
    folder
}

const TRACE: &str = "t_s,x_m\n0,1\n1,2\n";

#[test]
fn folders_of_no_whole_run_are_not_compared() {
    let folder = folder_with(&[
        ("a/trace.csv", TRACE),
        ("b/trace.csv", TRACE),
        ("b/summary.json", "{}"),
    ]);
    for verb in [&["compare", "a", "b"], &["compare", "b", "b"]] {
        refused(&says(folder.path(), verb), "no summary.json of a whole run");
    }
    for run in ["a", "b"] {
        fs::write(
            folder.path().join(run).join("summary.json"),
            "{\"jeffcott\": \"0\"}",
        )
        .expect("a file");
    }
    done(says(folder.path(), &["compare", "a", "b"]));
}

/// A device that never ends, and a pipe that nobody writes to.
#[test]
fn what_never_ends_is_not_read() {
    let scene = loaded_7205c("", "[[load]]\nseries = { file = \"NAME.csv\" }\n");
    let own = loaded_7205c("", "").replace("[shaft]", "catalogue_file = \"NAME.csv\"\n[shaft]");
    for name in ["zero", "pipe"] {
        let [series, own] = [&scene, &own].map(|text| text.replace("NAME", name));
        let folder = folder_with(&[
            ("t.csv", TRACE),
            ("series.toml", &series),
            ("own.toml", &own),
            ("run/summary.json", "{\"jeffcott\": \"0\"}"),
        ]);
        for target in ["zero.csv", "zero.toml", "run/trace.csv"] {
            let path = folder.path().join(target.replace("zero", name));
            match name {
                "zero" => symlink("/dev/zero", path).expect("a link"),
                _ => drop(done(
                    Command::new("mkfifo").arg(path).output().expect("mkfifo"),
                )),
            }
        }
        let [csv, toml] = ["csv", "toml"].map(|end| format!("{name}.{end}"));
        let all: [&[&str]; 7] = [
            &["compare", "t.csv", &csv],
            &["compare", &csv, &csv],
            &["compare", "t.csv", "t.csv", "--tolerances", &toml],
            &["compare", "run", "run"],
            &["check", &toml],
            &["check", "series.toml"],
            &["check", "own.toml"],
        ];
        for arguments in all {
            refused(&says(folder.path(), arguments), "file");
        }
        refused(
            &says(folder.path(), &["catalogue", "--catalogue", &csv]),
            "regular file",
        );
    }
}

#[track_caller]
fn has_no_commands(output: &Output) {
    let all = text(&output.stdout) + &told(output);
    let raw = |c: char| c == '\u{202e}' || (c.is_control() && !matches!(c, '\n' | '\t'));
    assert!(!all.contains(raw), "{all:?}");
}

#[test]
fn what_commands_a_terminal_is_shown() {
    let name = "\u{1b}[31mred\u{202e}\u{9b}2J";
    let files = [".toml", "-wrong.toml"].map(|end| format!("{name}{end}"));
    let wrong = loaded_7205c("", "").replace("duration", "\u{7f}dura\u{1b}[2Jtion");
    let column = format!("t_s,x{name}\n0,1\n1,2\n");
    let own = "designation,\u{1b}[2J\u{202e}\n1,2\n";
    let folder = folder_with(&[
        (&files[0], &loaded_7205c("", "")),
        (&files[1], &wrong),
        ("a.csv", &column),
        ("b.csv", TRACE),
        ("own.csv", own),
    ]);
    let all: [&[&str]; 7] = [
        &["check", &files[0], &files[1]],
        &["check", &files[1], "--json"],
        &["bearing", &files[0]],
        &["run", &files[0], "--no-verify", "--json"],
        &["compare", "a.csv", "b.csv"],
        &["compare", "a.csv", &files[0]],
        &["catalogue", "--catalogue", "own.csv"],
    ];
    for arguments in all {
        has_no_commands(&says(folder.path(), arguments));
    }
    let page = fs::read_to_string(folder.path().join("output").join(name).join("report.html"));
    assert!(
        page.expect("a page")
            .contains("<title>\\u001b[31mred\\u202e\\u009b2J</title>")
    );
    let title = format!("title = \"a\\u202Eb\"\n{}", loaded_7205c("", ""));
    fs::write(folder.path().join("turned.toml"), title).expect("a file");
    refused(
        &says(folder.path(), &["check", "turned.toml"]),
        "marks of direction",
    );
}

fn study(keep: &str) -> String {
    let base = root().join("scenarios/steady-7205c.toml");
    let short = [
        "time.settle\"\nvalue = \"5 ms",
        "time.duration\"\nvalue = \"30 ms",
    ];
    let short = short
        .map(|set| format!("[[set]]\nkey = \"{set}\"\n"))
        .concat();
    format!(
        "base = \"{}\"\n{short}{keep}[[axis]]\nkey = \"shaft.mass\"\nvalues = [\"5 kg\", \"6 kg\"]\n",
        base.display()
    )
}

#[test]
fn links_in_the_folder_of_a_study_are_not_followed() {
    let part = "runs.part-1-of-2.jsonl";
    let folder = folder_with(&[
        ("s.toml", &study("")),
        ("t.toml", &study("[keep]\ntraces = true\n")),
        ("j.toml", &study("")),
        ("precious", "kept"),
        ("home/trace-0.csv", "kept"),
        ("output/s/x", ""),
        ("output/t/x", ""),
        ("output/j/x", ""),
    ]);
    let output = folder.path().join("output");
    for (link, target) in [
        (format!("s/{part}"), "precious"),
        ("t/traces".to_owned(), "home"),
        ("j/runs.jsonl".to_owned(), "precious"),
    ] {
        symlink(folder.path().join(target), output.join(link)).expect("a link");
    }
    for study in [&["s.toml", "--shard", "1/2"][..], &["t.toml"], &["j.toml"]] {
        let asked = [&["study"], study].concat();
        assert!(!says(folder.path(), &asked).status.success());
    }
    assert_eq!(
        fs::read_to_string(folder.path().join("precious")).unwrap(),
        "kept"
    );
    assert_eq!(names(&folder.path().join("home")), ["trace-0.csv"]);
    assert_eq!(
        fs::read_to_string(folder.path().join("home/trace-0.csv")).unwrap(),
        "kept"
    );
}

#[test]
fn a_limit_on_the_size_of_files_leaves_nothing() {
    let folder = folder_with(&[("a.toml", &loaded_7205c("", ""))]);
    let limited = format!("ulimit -f 1; exec {PROGRAM} run a.toml --no-verify");
    let output = Command::new("sh")
        .args(["-c", &limited])
        .current_dir(folder.path())
        .output();
    let output = output.expect("a shell");
    assert_eq!(output.status.code(), Some(1), "{}", told(&output));
    assert!(told(&output).contains("cannot write"), "{}", told(&output));
    assert_eq!(names(&folder.path().join("output/a")), Vec::<String>::new());
}

/// A run and then other verbs into its folder: each has its page, and every seal what it seals.
#[test]
fn verbs_do_not_write_over_each_other() {
    let folder = folder_with(&[("a.toml", &loaded_7205c("", ""))]);
    let read = |name: &str| fs::read(folder.path().join("output/a").join(name)).expect("a file");
    done(says(folder.path(), &["run", "a.toml", "--no-verify"]));
    let [page, seal] = ["report.html", "summary.json"].map(read);
    done(says(
        folder.path(),
        &["campbell", "a.toml", "--to", "900 rad/s", "--count", "3"],
    ));
    done(says(folder.path(), &["bearing", "a.toml"]));
    assert_eq!(["report.html", "summary.json"].map(read), [page, seal]);
    for name in [
        "campbell.html",
        "campbell.json",
        "bearing.html",
        "bearing.json",
    ] {
        assert!(!read(name).is_empty());
    }
    done(says(
        folder.path(),
        &["campbell", "a.toml", "--to", "900 rad/s", "--count", "4"],
    ));
    assert!(!read("summary.json").is_empty());
}

/// The tables of natural frequencies of a run-up and of `campbell` have one name.
#[test]
fn no_seal_stands_over_files_of_another_verb() {
    let scene = loaded_7205c("", "").replace(
        "constant = \"500 rad/s\"",
        "from = \"300 rad/s\"\nto = \"500 rad/s\"\nover = \"0.02 s\"",
    );
    let folder = folder_with(&[("a.toml", &scene)]);
    let there = |name: &str| -> PathBuf { folder.path().join("output/a").join(name) };
    done(says(folder.path(), &["run", "a.toml", "--no-verify"]));
    assert!(there("campbell.csv").exists());
    done(says(
        folder.path(),
        &["campbell", "a.toml", "--to", "900 rad/s", "--count", "3"],
    ));
    assert!(there("campbell.json").exists() && !there("summary.json").exists());
    assert!(there("trace.csv").exists());
}

/// A seal that lists files which are not its own, and what else stands in the folder.
#[test]
fn a_seal_removes_nothing_but_results_beside_it() {
    let folder = folder_with(&[("a.toml", &loaded_7205c("", "")), ("kept.csv", "x\n1\n")]);
    let out = folder.path().join("output/a");
    done(says(folder.path(), &["bearing", "a.toml"]));
    let sealed = fs::read_to_string(out.join("bearing.json")).expect("a seal");
    let sealed: Value = serde_json::from_str(&sealed).expect("JSON");
    let listed = sealed["sealed"].as_array().expect("a list").clone();
    assert!(listed.contains(&"balls.csv".into()), "{listed:?}");
    let foreign = json!({ "sealed": ["../../kept.csv", "notes.txt", "old.csv", "balls.csv"] });
    for (name, text) in [("notes.txt", "mine"), ("old.csv", "x\n1\n")] {
        fs::write(out.join(name), text).expect("a file");
    }
    fs::write(out.join("bearing.json"), foreign.to_string()).expect("a file");
    done(says(folder.path(), &["bearing", "a.toml"]));
    assert!(folder.path().join("kept.csv").exists() && out.join("notes.txt").exists());
    assert!(!out.join("old.csv").exists() && out.join("balls.csv").exists());
    assert!(!out.join(".bearing.json.replaced").exists());
}
