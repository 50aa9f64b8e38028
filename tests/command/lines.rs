//! What a user meets: files of steady runs and run-ups, and `jeffcott campbell`.

use std::fs;
use std::path::Path;
use std::process::Output;

use serde_json::Value;

use crate::support::{changed, jeffcott_in, json, names, root, text};

fn jeffcott(arguments: &[&str], folder: &Path) -> Output {
    let out = folder.to_str().expect("a path of letters");
    jeffcott_in(root(), &[arguments, &["--out", out]].concat())
}

const MAPS: [&str; 6] = [
    "campbell.csv",
    "campbell.svg",
    "order_tracks.csv",
    "order_tracks.svg",
    "waterfall.csv",
    "waterfall.svg",
];

#[test]
fn a_run_up_is_mapped_and_a_later_run_without_maps_leaves_none() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = folder.path().join("run-up-7205c");
    let output = jeffcott(&["run", "scenarios/run-up-7205c.toml"], folder.path());
    assert!(output.status.success(), "{}", text(&output.stderr));
    let written = names(&run);
    for name in MAPS {
        assert!(written.contains(&name.to_owned()), "{name} of {written:?}");
    }
    let summary = json(&run.join("summary.json"));
    assert_eq!(summary["maps"]["waterfall"]["window"], "hann");
    assert!(summary["maps"]["order_tracks"]["window_revolutions"].is_number());
    assert!(summary["critical_speeds"].is_array());
    assert_eq!(summary["motion"]["kind"]["name"], "periodic");
    let svg = fs::read_to_string(run.join("waterfall.svg")).expect("a figure");
    assert_eq!(svg.matches("data:image/png;base64,").count(), 6);
    assert!(!svg.contains("#010203"), "a place without its picture");

    let without = changed(
        folder.path(),
        "run-up-7205c",
        &[("[output]", "[output]\nmaps = false\nmotion = false")],
    );
    let output = jeffcott(&["run", without.to_str().expect("a path")], folder.path());
    assert!(output.status.success(), "{}", text(&output.stderr));
    let left = names(&run);
    for name in MAPS.iter().chain(&["poincare.csv", "orbit.svg"]) {
        assert!(!left.contains(&(*name).to_owned()), "{name} of {left:?}");
    }
    let summary = json(&run.join("summary.json"));
    assert!(summary["motion"].is_null() && summary["maps"].is_null());
}

#[test]
fn a_steady_run_has_its_points_and_its_orbit() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = jeffcott(
        &["run", "scenarios/steady-7205c.toml", "--no-verify"],
        folder.path(),
    );
    assert!(output.status.success(), "{}", text(&output.stderr));
    let shown = text(&output.stdout);
    assert!(shown.contains("repeats every revolution"), "{shown}");
    assert!(
        shown.lines().all(|line| line.chars().count() <= 110),
        "{shown}"
    );
    let run = folder.path().join("steady-7205c");
    let table = fs::read_to_string(run.join("poincare.csv")).expect("a table");
    let mut lines = table.lines();
    let header = lines.next().expect("a header");
    assert!(
        header.starts_with("section,number,t_s,x_m,y_m,z_m,tilt_x_rad,tilt_y_rad,x_velocity_m_s")
    );
    // 23 whole revolutions of 0.3 s, and 4.805 ball passes in each
    let count = |name: &str| table.lines().filter(|line| line.starts_with(name)).count();
    assert!(
        (20..=23).contains(&count("revolution")),
        "{}",
        count("revolution")
    );
    assert!(
        (105..=111).contains(&count("ball_pass")),
        "{}",
        count("ball_pass")
    );
    assert!(names(&run).contains(&"orbit.svg".to_owned()));
    let summary = json(&run.join("summary.json"));
    let motion = &summary["motion"];
    assert_eq!(motion["settling"]["settled"], true);
    assert_eq!(motion["statistics"][0]["channel"], "x_m");
    assert!(
        motion["velocity_rms"]["x"]["rms_m_s"]
            .as_f64()
            .expect("a number")
            > 0.0
    );
    let peak = &summary["peaks"][0];
    assert!(peak["phase_rad"].is_number() && peak["other_names"].is_array());
}

#[test]
fn keys_that_do_not_fit_the_speed_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let maps = changed(
        folder.path(),
        "steady-7205c",
        &[("[output]", "[output]\nmaps = true")],
    );
    let output = jeffcott(&["run", maps.to_str().expect("a path")], folder.path());
    assert_eq!(output.status.code(), Some(2));
    let told = text(&output.stderr);
    assert!(told.contains("the speed does not change"), "{told}");
    assert!(told.contains("jeffcott campbell"), "{told}");
    let motion = changed(
        folder.path(),
        "run-up-7205c",
        &[
            ("[output]", "[output]\nmotion = true"),
            ("settle = \"0.3 s\"", "settle = \"0.1 s\""),
        ],
    );
    let output = jeffcott(&["run", motion.to_str().expect("a path")], folder.path());
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("the speed changes after `settle`"));
}

#[test]
fn campbell_writes_table_figure_and_critical_speeds() {
    let folder = tempfile::tempdir().expect("a folder");
    let arguments = [
        "campbell",
        "scenarios/back-to-back-7205c.toml",
        "--to",
        "60000 rpm",
        "--orders",
        "1,2",
        "--json",
    ];
    let output = jeffcott(&arguments, folder.path());
    assert!(output.status.success(), "{}", text(&output.stderr));
    let answer: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let written = names(&folder.path().join("back-to-back-7205c"));
    assert_eq!(
        written,
        [
            "campbell.csv",
            "campbell.html",
            "campbell.json",
            "campbell.svg"
        ]
    );
    for critical in answer["critical_speeds"]
        .as_array()
        .expect("critical speeds")
    {
        let number = |key: &str| critical[key].as_f64().expect("a number");
        let shaft = number("order") * number("speed_rad_s") / std::f64::consts::TAU;
        // as far as the stiffness of an equilibrium is found
        assert!(
            (number("frequency_Hz") / shaft - 1.0).abs() < 1e-8,
            "{critical}"
        );
    }
    let branches = answer["branches"].as_array().expect("branches");
    let whirls: Vec<&str> = branches
        .iter()
        .filter_map(|branch| branch["whirl"].as_str())
        .collect();
    assert_eq!(
        whirls,
        ["axial", "backward", "forward", "backward", "forward"]
    );
}

#[test]
fn a_wrong_range_of_speeds_is_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = "scenarios/back-to-back-7205c.toml";
    let empty = jeffcott(
        &["campbell", scene, "--from", "500 rpm", "--to", "100 rpm"],
        folder.path(),
    );
    assert_eq!(empty.status.code(), Some(2));
    assert!(
        text(&empty.stderr).contains("has no range"),
        "{}",
        text(&empty.stderr)
    );
    let unit = jeffcott(&["campbell", scene, "--to", "100"], folder.path());
    assert_eq!(unit.status.code(), Some(2));
    assert!(
        text(&unit.stderr).contains("`speed` needs a unit"),
        "{}",
        text(&unit.stderr)
    );
}

/// The limits of the model are told of at the highest speed, as `run` tells of them.
#[test]
fn campbell_warns_of_unbalance_and_pressure() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("heavy.toml");
    let mut scene = crate::support::shipped_text("steady-7205c");
    for (from, to) in [("0.01 mm", "0.3 mm"), ("1000 N", "60000 N")] {
        scene = scene.replace(from, to);
    }
    fs::write(&file, scene).expect("a written file");
    let file = file.to_str().expect("a path of letters");
    let arguments = ["campbell", file, "--to", "4000 rad/s", "--count", "2"];
    let told = text(&jeffcott(&arguments, folder.path()).stderr);
    for words in [
        "beyond balance grade G 100",
        "the inner race exceeds",
        "the outer race exceeds",
        "d_m·n is",
    ] {
        assert!(told.contains(words), "{words}: {told}");
    }
}
