//! `jeffcott steady` as a user meets it.

use std::fs;
use std::path::Path;
use std::process::Output;

use crate::support::{jeffcott_in, names, root, text};

fn jeffcott(folder: &Path, arguments: &[&str]) -> Output {
    let out = folder.to_str().expect("a path of letters");
    jeffcott_in(root(), &[&["steady"], arguments, &["--out", out]].concat())
}

const FILES: [&str; 6] = [
    "steady_trace.csv",
    "steady_spectrum.csv",
    "steady_trace.svg",
    "steady_spectrum.svg",
    "steady.html",
    "steady.json",
];

#[test]
fn the_same_motion_gives_the_same_bytes() {
    let folders =
        [tempfile::tempdir(), tempfile::tempdir()].map(|folder| folder.expect("a folder"));
    for name in ["steady-7205c", "varying-compliance-6306"] {
        let file = format!("scenarios/{name}.toml");
        for folder in &folders {
            let output = jeffcott(folder.path(), &[&file]);
            assert!(output.status.success(), "{}", text(&output.stderr));
        }
        for file in FILES {
            let [first, second] = [0, 1].map(|k| {
                fs::read(folders[k].path().join(name).join(file)).expect("a file of the answer")
            });
            assert!(first == second, "{name}/{file}");
        }
        let left = names(&folders[0].path().join(name));
        assert_eq!(left.len(), FILES.len(), "nothing else stands in the folder");
    }
}

#[test]
fn json_tells_period_stability_and_multipliers() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = jeffcott(
        folder.path(),
        &["scenarios/varying-compliance-6306.toml", "--json"],
    );
    assert!(output.status.success(), "{}", text(&output.stderr));
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(answer["multiple"], 2);
    assert_eq!(answer["stable"], true);
    assert!(
        answer["measured_error"]["relative"]
            .as_f64()
            .is_some_and(|error| error < 1e-6)
    );
    let single = &answer["single_period_multipliers"][0];
    assert!(
        single["re"].as_f64().is_some_and(|re| re < -1.0),
        "{single}"
    );
}

#[test]
fn a_response_writes_its_branches() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = jeffcott(
        folder.path(),
        &[
            "scenarios/varying-compliance-6306.toml",
            "--over",
            "speed.constant",
            "--from",
            "195 rad/s",
            "--to",
            "200 rad/s",
            "--no-doubled",
        ],
    );
    assert!(output.status.success(), "{}", text(&output.stderr));
    let folder = folder.path().join("varying-compliance-6306");
    let table = fs::read_to_string(folder.join("response.csv")).expect("response.csv");
    let mut rows = table.lines();
    let header = rows.next().expect("a header");
    assert!(
        header.starts_with("branch,multiple,speed_constant_rad_s,period_s,stable,neutral,x_mean_m"),
        "{header}"
    );
    assert!(
        header.ends_with("multiplier_4_re,multiplier_4_im,multiplier_4_error"),
        "{header}"
    );
    let last = rows.last().expect("rows");
    assert!(last.starts_with("1,1,200.0,"), "{last}");
    assert_eq!(last.split(',').count(), header.split(',').count());
}

/// A branch that is cut off is no answer to what was asked: the files stand, and the exit code is 1.
#[test]
fn a_branch_that_goes_on_beyond_its_motions_fails_and_says_why() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = jeffcott(
        folder.path(),
        &[
            "scenarios/varying-compliance-6306.toml",
            "--over",
            "speed.constant",
            "--from",
            "195 rad/s",
            "--to",
            "400 rad/s",
            "--no-doubled",
            "--points",
            "5",
        ],
    );
    assert_eq!(output.status.code(), Some(1));
    let words = text(&output.stderr);
    assert!(words.contains("beyond its 5 motions"), "{words}");
    let written = folder.path().join("varying-compliance-6306/response.csv");
    assert!(written.exists());
}

/// What is wrong with a command line is code 2, a scene without a steady motion is code 1.
#[test]
fn exit_codes_tell_wrong_input_from_no_steady_motion() {
    let folder = tempfile::tempdir().expect("a folder");
    let run_up = jeffcott(folder.path(), &["scenarios/run-up-7205c.toml"]);
    assert_eq!(run_up.status.code(), Some(1));
    assert!(
        text(&run_up.stderr).contains("set speed.constant"),
        "{}",
        text(&run_up.stderr)
    );
    assert!(!folder.path().join("run-up-7205c").exists());
    let over = |key: &str, from: &str, to: &str| {
        let file = "scenarios/balanced-7205c.toml";
        let output = jeffcott(
            folder.path(),
            &[file, "--over", key, "--from", from, "--to", to],
        );
        (output.status.code(), text(&output.stderr))
    };
    for (key, from, to, told) in [
        (
            "speed.constnt",
            "1 rad/s",
            "2 rad/s",
            "did you mean `speed.constant`?",
        ),
        (
            "speed.constant",
            "100",
            "200 rad/s",
            "`100` is no value of `speed.constant`",
        ),
        (
            "speed.constant",
            "100 N",
            "200 rad/s",
            "`100 N` is no value",
        ),
        ("speed.constant", "100 rad/s", "100 rad/s", "the same value"),
        ("shaft.mass", "1 kg", "-1 kg", "`mass` must be at least"),
        (
            "bearing[1].clearance_change",
            "0 um",
            "9 mm",
            "with bearing[1].clearance_change",
        ),
        (
            "time.duration",
            "1 s",
            "2 s",
            "does not depend on `time.duration`",
        ),
    ] {
        let (code, words) = over(key, from, to);
        assert_eq!(code, Some(2), "{key}: {words}");
        assert!(words.contains(told), "{key}: {words}");
    }
    let alone = jeffcott(
        folder.path(),
        &["scenarios/balanced-7205c.toml", "--over", "speed.constant"],
    );
    assert_eq!(alone.status.code(), Some(2));
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 0);
}

/// Programs are told, too, what keeps a file from an answer.
#[test]
fn json_tells_of_files_that_cannot_be_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("a path of letters");
    for verb in ["run", "steady", "bearing"] {
        let output = jeffcott_in(root(), &[verb, "nowhere.toml", "--json", "--out", out]);
        assert_eq!(output.status.code(), Some(2));
        let answer: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
        assert_eq!(answer["file"], "nowhere.toml");
        let error = answer["error"].as_str().expect("an error");
        assert!(error.contains("cannot read"), "{error}");
    }
    let output = jeffcott_in(root(), &["compare", "nowhere.csv", "nor.csv", "--json"]);
    assert_eq!(output.status.code(), Some(2));
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert!(answer["error"].is_string());
}

/// Two 6205 under different loads: at their loaded angles two ball-pass frequencies, whose ratio the load changes.
#[test]
fn a_branch_over_a_load_is_followed_with_rolling_cages() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene =
        fs::read_to_string(root().join("tests/scenarios/hard/two-6205.toml")).expect("a scene");
    let scene = scene
        .replace("\"2.5 um\"", "\"0 um\"")
        .replace("position = \"60 mm\"", "position = \"120 mm\"")
        .replace("{ y = \"-300 N\" }", "{ y = \"-300 N\", z = \"100 N\" }")
        + "[integrator]\ntolerance = 1e-6\n";
    let file = folder.path().join("scene.toml");
    fs::write(&file, scene).expect("a written file");
    let file = file.to_str().expect("a path of letters");
    let over = [
        "--over",
        "load[1].constant.z",
        "--from",
        "100 N",
        "--to",
        "105 N",
    ];
    let output = jeffcott(
        folder.path(),
        &[&[file, "--no-verify", "--points", "2"], &over[..]].concat(),
    );
    let told = text(&output.stderr);
    assert!(
        told.contains("changes the ratio of the two frequencies"),
        "{told}"
    );
    assert!(
        told.contains("here they roll at the free contact angle"),
        "{told}"
    );
    assert!(
        text(&output.stdout).contains("2 motions, 2 of them stable"),
        "{told}"
    );
}
