//! Scenes that are hard on the program, or that say what their writer did not mean: each ends in time, and with a word
//! that helps.

use std::io::{BufRead, BufReader};
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

use tempfile::TempDir;

use crate::support::{PROGRAM, done, jeffcott, root, told, verb};

fn scene(name: &str) -> PathBuf {
    root()
        .join("tests/scenarios/hard")
        .join(name)
        .with_extension("toml")
}

fn answer(of: &str, name: &str, more: &[&str]) -> Output {
    let out = TempDir::new().expect("a folder");
    let output = verb(of, &[scene(name)], out.path(), more).output();
    output.expect("the command starts")
}

#[track_caller]
fn assert_says(output: &Output, parts: &[&str]) {
    let told = told(output);
    for part in parts {
        assert!(told.contains(part), "`{part}` in\n{told}");
    }
}

#[track_caller]
fn assert_silent_on(output: &Output, part: &str) {
    let told = told(output);
    assert!(!told.contains(part), "`{part}` in\n{told}");
}

#[test]
fn a_load_beyond_any_contact_is_an_error_with_its_numbers() {
    let output = answer("run", "shock-1e9", &["--no-verify"]);
    assert_eq!(output.status.code(), Some(1));
    assert_says(&output, &["a ball carries 1.767e8 N", "3.97 mm", "units"]);
}

/// Of a shaft that hardly anything holds 700 N at 20 Hz make 2 P/(m ω²) = 34.3 mm in half a period, where `contact = "linear"` knows
/// no balls; the settled motion of 150 N stays below their radius and far above what their races bear.
#[test]
fn a_linear_law_is_watched_as_the_balls_would_be() {
    for (verb, time) in [("run", "2.5000e-2 s"), ("steady", "2.7")] {
        let output = answer(verb, "linear-law-far", &["--no-verify"]);
        assert_eq!(output.status.code(), Some(1), "{verb}");
        let there = format!("bearing 1: at t = {time}");
        assert_says(
            &output,
            &[
                &there,
                "a ball would carry, where contact = \"linear\"",
                "radius of the ball, 3.32 mm",
            ],
        );
    }
    let folder = TempDir::new().expect("a folder");
    let text = std::fs::read_to_string(scene("linear-law-far")).expect("a scene");
    let file = folder.path().join("scene.toml");
    std::fs::write(&file, text.replace("700 N", "150 N")).expect("a written file");
    let output = verb("steady", &[&file], folder.path(), &["--no-verify"]).output();
    let output = done(output.expect("the command starts"));
    assert_says(
        &output,
        &[
            "would be pressed onto the inner race",
            "the model stays linear",
        ],
    );
}

/// The races of the same scene keep a dent where the shock has 50 kN.
#[test]
fn pressures_over_the_motion_are_told_with_their_time() {
    let text = std::fs::read_to_string(scene("shock-1e9")).expect("a scene");
    let folder = TempDir::new().expect("a folder");
    let file = folder.path().join("scene.toml");
    std::fs::write(&file, text.replace("-1e9 N", "-50 kN")).expect("a written file");
    let output = verb("run", &[&file], folder.path(), &["--no-verify"]).output();
    let output = output.expect("the command starts");
    assert!(output.status.success(), "{}", told(&output));
    assert_says(
        &output,
        &["bearing 1: at t = 3.", "onto the inner race", "ISO 76"],
    );
}

#[test]
fn speeds_where_the_inertia_of_balls_counts_are_told() {
    let output = answer("run", "hertz-20000rpm", &["--no-verify"]);
    assert_says(&output, &["770000 mm/min", "contact = \"jones\""]);
}

/// 100 times gravity for a millisecond on a preloaded pair: balls lose contact at the end of the shock.
#[test]
fn no_method_loops_at_one_instant() {
    let text = std::fs::read_to_string(scene("strong-base-shock")).expect("a scene");
    let folder = TempDir::new().expect("a folder");
    let file = folder.path().join("scene.toml");
    for method in [
        "auto",
        "verner76",
        "exponential",
        "rodas",
        "dopri5",
        "dop853",
    ] {
        let text = format!("{text}\nmethod = \"{method}\"\n");
        std::fs::write(&file, text).expect("a written file");
        let mut child = verb("run", &[&file], folder.path(), &["--no-verify"])
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("the command starts");
        let started = Instant::now();
        while child.try_wait().expect("its state").is_none() {
            let is_late = started.elapsed() > Duration::from_secs(60);
            if is_late {
                child.kill().expect("it is killed");
            }
            assert!(!is_late, "{method} does not end");
            std::thread::sleep(Duration::from_millis(2));
        }
    }
}

/// The balls' inertia grows beyond what any balance holds: their solution took trials without end.
#[test]
fn balls_under_any_inertia_come_to_an_end() {
    let out = TempDir::new().expect("a folder");
    let file = out.path().join("scene.toml");
    let text = std::fs::read_to_string(scene("drive-beyond-any-bearing")).expect("a scene");
    let text = text.replace(
        "\"tolerance\" = 9e-09",
        "\"tolerance\" = 9e-09, \"step_limit\" = 200",
    );
    std::fs::write(&file, text).expect("a written file");
    let output = verb("run", &[&file], out.path(), &["--no-verify"]).output();
    let output = output.expect("the command starts");
    assert_eq!(output.status.code(), Some(1));
    assert_says(&output, &["200 steps", "integrator.step_limit"]);
}

#[test]
fn a_run_beyond_the_memory_is_refused_beforehand() {
    let out = TempDir::new().expect("a folder");
    // a spectrum of its own is of the whole record
    let text = std::fs::read_to_string(scene("many-samples")).expect("a scene");
    let file = out.path().join("many-samples.toml");
    let text = format!("{text}\n[[spectrum]]\nchannels = [\"displacement\", \"force\"]\n");
    std::fs::write(&file, text).expect("a written file");
    let command = format!("ulimit -v 300000; exec '{PROGRAM}' run \"$0\" --out \"$1\"");
    let output = Command::new("bash")
        .args(["-c", &command])
        .args([file, out.path().to_owned()])
        .output()
        .expect("a shell");
    assert_eq!(output.status.code(), Some(2), "{}", told(&output));
    assert_says(
        &output,
        &[
            "it needs about",
            "MB are there under the limit",
            "set spectrum = false",
        ],
    );
    assert!(!out.path().join("many-samples").exists());
}

#[test]
fn check_says_what_a_run_takes() {
    let file = scene("many-samples");
    let output = done(
        jeffcott()
            .args(["check", "--json"])
            .arg(&file)
            .output()
            .expect("it starts"),
    );
    let found: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let demand = &found[0]["demand"];
    assert_eq!(demand["samples"], 4_074_367);
    let between = |key: &str, low: f64, high: f64| {
        let value = demand[key].as_f64().expect("a number");
        assert!((low..high).contains(&value), "{key}: {value:e}");
    };
    // the table was measured: 1.8 GB
    between("memory_bytes", 4e7, 6e7);
    between("table_bytes", 1.6e9, 2.6e9);
    let output = done(
        jeffcott()
            .arg("check")
            .arg(&file)
            .output()
            .expect("it starts"),
    );
    let text = crate::support::text(&output.stdout);
    assert!(text.contains("4074367 samples, about"), "{text}");
}

/// A shock of 3e5 N on a light shaft: its motion takes hours.
#[test]
fn a_run_that_hardly_gets_on_says_why() {
    let out = TempDir::new().expect("a folder");
    let mut child = verb(
        "run",
        &[scene("hard-shock-on-jones-balls")],
        out.path(),
        &["--no-verify"],
    )
    .stdout(Stdio::null())
    .stderr(Stdio::piped())
    .spawn()
    .expect("the command starts");
    let lines = BufReader::new(child.stderr.take().expect("its messages")).lines();
    let told = lines
        .map_while(Result::ok)
        .find(|line| line.contains("slow: at t = "));
    child.kill().expect("it is killed");
    child.wait().expect("its end");
    let told = told.expect("it says that it is slow");
    for part in [" left; steps of ", "highest natural frequency", "tolerance"] {
        assert!(told.contains(part), "`{part}` in\n{told}");
    }
    // tables are for constant speeds, and this shaft is driven
    assert!(!told.contains("table = true"), "{told}");
    assert!(!told.contains("steps of 0.0e0 s"), "{told}");
    assert!(told.contains(" Hz (tilt of the shaft): "), "{told}");
}

#[test]
fn a_pair_that_faces_the_same_way_is_told() {
    let output = done(answer("run", "pair-facing-same-way", &["--no-verify"]));
    assert_says(
        &output,
        &[
            "face the same way, +z",
            "write facing = \"-z\" in `bearing[2]`",
        ],
    );
}

#[test]
fn a_single_angular_contact_bearing_without_thrust_is_told() {
    let output = done(answer("run", "radial-load-on-7205c", &["--no-verify"]));
    assert_says(
        &output,
        &["needs an axial load", "constant = { z = \"500 N\" }"],
    );
    assert_silent_on(&output, "-0.00°");
}

#[test]
fn a_bearing_that_is_pulled_the_wrong_way_is_told() {
    let output = done(answer("run", "pulled-the-wrong-way", &["--no-verify"]));
    assert_says(&output, &["loaded the wrong way: 12 of 12"]);
}

/// A run-up has no plain spectrum, and a trace of 100 000 rows at most, unless more is asked for.
#[test]
fn a_run_up_writes_what_people_look_at() {
    let out = TempDir::new().expect("a folder");
    let run = |spectrum: &str, more: &[&str]| {
        let text = std::fs::read_to_string(scene("run-up-24000rpm")).expect("a scene");
        let text = text.replace("[output]", &format!("[output]\nspectrum = {spectrum}"));
        let text = text.replace("spectrum = none\n", "");
        let file = out.path().join("scene.toml");
        std::fs::write(&file, text).expect("a written file");
        let output = verb("run", &[&file], out.path(), more).output();
        done(output.expect("the command starts"))
    };
    let rows = || {
        let trace = std::fs::File::open(out.path().join("scene/trace.csv")).expect("trace.csv");
        BufReader::new(trace).lines().count() - 1
    };
    let spectrum = out.path().join("scene/spectrum.csv");
    let output = run("none", &["--no-verify"]);
    assert_says(&output, &["note: ", "at most 100 000 rows", "--every"]);
    assert!(!spectrum.exists() && (50_000..=100_000).contains(&rows()));
    let output = run("true", &["--no-verify", "--every", "1"]);
    assert_says(&output, &["24000 rpm (2513.3 rad/s)"]);
    assert_silent_on(&output, "at most 100 000 rows");
    assert!(spectrum.exists() && rows() > 200_000);
}

#[test]
fn the_method_that_ran_is_not_advised() {
    let output = done(answer("run", "irregular-by-verner76", &[]));
    assert_says(&output, &["the measured error is"]);
    assert_silent_on(&output, "set method");
}

#[test]
fn a_study_tells_of_an_error_far_beyond_the_tolerance() {
    let output = done(answer("study", "two-6205-clearances", &[]));
    assert_says(
        &output,
        &["run 0", ": the measured error is", "× the tolerance 1e-8"],
    );
}

/// A study warns of what a run of it warns of, those alike once, and each run's stand in the table.
#[test]
fn a_study_warns_as_its_runs_do() {
    let folder = TempDir::new().expect("a folder");
    let base = changed("steady-7205c", &[("\"0.01 mm\"", "\"1 mm\"")], &folder);
    let study = format!(
        "base = {:?}\n[[axis]]\nkey = \"speed.constant\"\nvalues = [\"480 rad/s\", \"490 rad/s\", \"500 rad/s\"]\n\
         [keep]\nnumbers = [\"x_rms_m\"]\n",
        base.file_name().expect("a name")
    );
    let file = folder.path().join("study.toml");
    std::fs::write(&file, study).expect("a written file");
    let output = verb("study", &[&file], folder.path(), &[]).output();
    let output = done(output.expect("the command starts"));
    assert_says(
        &output,
        &["run 0 and 2 more: the eccentricity of 1.0000 mm gives e·ω = 480 mm/s"],
    );
    let mut runs = csv::Reader::from_path(folder.path().join("study/runs.csv")).expect("runs.csv");
    let last = runs.headers().expect("names").len() - 1;
    assert_eq!(&runs.headers().expect("names")[last], "warnings");
    let cells: Vec<_> = runs.records().map(|row| row.expect("a row")).collect();
    assert!(cells[2][last].contains("e·ω = 500 mm/s"), "{cells:?}");
}

/// A shipped scenario with parts of it replaced, in a folder.
fn changed(name: &str, parts: &[(&str, &str)], folder: &TempDir) -> PathBuf {
    let path = root().join("scenarios").join(name).with_extension("toml");
    let mut text = std::fs::read_to_string(path).expect("a scenario");
    for (part, other) in parts {
        assert!(text.contains(part), "{part}");
        text = text.replace(part, other);
    }
    let file = folder.path().join("scene.toml");
    std::fs::write(&file, text).expect("a written file");
    file
}

/// The axial and the tilting motion of a symmetric pair are round-off, 1e-19 m and 1e-18 rad: no line, no crest factor,
/// no aliasing, no difference between runs.
#[test]
fn round_off_is_no_vibration() {
    let out = TempDir::new().expect("a folder");
    let text = std::fs::read_to_string(scene("symmetric-pair")).expect("a scene");
    for (name, tolerance) in [("first", "1e-8"), ("second", "1e-9")] {
        let file = out.path().join(name).with_extension("toml");
        std::fs::write(&file, text.replace("1e-8", tolerance)).expect("a written file");
        let output = verb("run", &[&file], out.path(), &[]).output();
        let output = done(output.expect("the command starts"));
        assert_silent_on(&output, "aliasing");
    }
    let first = out.path().join("first");
    let peaks = std::fs::read_to_string(first.join("peaks.csv")).expect("peaks.csv");
    let mut channels: Vec<_> = peaks.lines().skip(1).collect();
    channels.retain(|line| !line.starts_with("x,") && !line.starts_with("y,"));
    assert_eq!(channels.len(), 2, "{peaks}");
    let forces = ["force_x,", "force_y,"];
    for (line, force) in channels.iter().zip(forces) {
        assert!(line.starts_with(force), "{peaks}");
    }
    let summary = std::fs::read_to_string(first.join("summary.json")).expect("summary.json");
    let summary: serde_json::Value = serde_json::from_str(&summary).expect("JSON");
    for entry in summary["motion"]["statistics"].as_array().expect("a list") {
        let channel = entry["channel"].as_str().expect("a name");
        let moves = ["x_m", "y_m", "force_x_N", "force_y_N"].contains(&channel)
            || channel.starts_with("bearing");
        assert_eq!(entry["crest_factor"].is_number(), moves, "{entry}");
    }
    let compare = |more: &[&str]| {
        let mut command = jeffcott();
        command
            .arg("compare")
            .args([first.clone(), out.path().join("second")]);
        command.args(more).output().expect("the command starts")
    };
    done(compare(&["--relative", "1e-4"]));
    assert_eq!(compare(&["--relative", "0"]).status.code(), Some(1));
}

#[test]
fn doubtful_values_are_told_before_the_run() {
    let cases = [
        ("ratio = 0.02 ", "ratio = 0 ", "`damping.ratio` is 0"),
        ("settle = \"0.2 s\"", "", "no `settle` in `[time]`"),
    ];
    for (part, other, warning) in cases {
        let folder = TempDir::new().expect("a folder");
        let file = changed("steady-7205c", &[(part, other)], &folder);
        let output = jeffcott().arg("check").arg(file).output();
        assert_says(&output.expect("the command starts"), &[warning]);
    }
    let folder = TempDir::new().expect("a folder");
    let metres = ("position = \"10 mm\"", "position = \"10 m\"");
    let output = jeffcott()
        .arg("check")
        .arg(changed("coal-impact-7205c", &[metres], &folder))
        .output();
    assert_says(
        &output.expect("the command starts"),
        &["9970.0 mm outside the bearings, which span 60.0 mm"],
    );
}

/// At rest the ellipses end below the shoulders, in a shock along the axis they pass them.
#[test]
fn contact_ellipses_that_are_cut_off_are_told_with_their_time() {
    let folder = TempDir::new().expect("a folder");
    let shoulder = (
        "facing = \"+z\"",
        "shoulder_angle = \"33 deg\"\nfacing = \"+z\"",
    );
    let shock = (
        "[time]",
        "[[load]]\nshock = { peak = { z = \"5 kN\" }, duration = \"4 ms\", at = \"0.03 s\" }\n[time]",
    );
    for (parts, is_cut) in [(vec![shoulder], false), (vec![shoulder, shock], true)] {
        let file = changed("steady-7205c", &parts, &folder);
        let output = verb("run", &[&file], folder.path(), &["--no-verify"]).output();
        let output = done(output.expect("the command starts"));
        let warning = "s the contact ellipse of a ball reaches";
        match is_cut {
            true => assert_says(&output, &["bearing 1: at t = 3.", warning, "race"]),
            false => assert_silent_on(&output, warning),
        }
    }
}

#[test]
fn too_many_bearings_and_too_large_files_are_refused() {
    let folder = TempDir::new().expect("a folder");
    let file = folder.path().join("scene.toml");
    let text = std::fs::read_to_string(scene("radial-load-on-7205c")).expect("a scene");
    let check = || {
        let output = jeffcott()
            .arg("check")
            .arg(&file)
            .output()
            .expect("it starts");
        assert_eq!(output.status.code(), Some(2));
        output
    };
    let many = text.clone() + &"[[bearing]]\ncatalogue = \"7205C\"\n".repeat(64);
    std::fs::write(&file, many).expect("a written file");
    assert_says(&check(), &["65 `[[bearing]]` tables; at most 64"]);
    let many = text.clone() + &"[[load]]\nconstant = { y = \"1 N\" }\n".repeat(1000);
    std::fs::write(&file, many).expect("a written file");
    assert_says(&check(), &["1001 `[[load]]` tables; at most 1000"]);
    std::fs::write(&file, text + &"# much\n".repeat(3_000_000)).expect("a written file");
    assert_says(&check(), &["larger than the 16 MB"]);
}
