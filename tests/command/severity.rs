//! Zones of ISO 20816-3, and scenarios that leave out which freedoms move.

use std::fs;
use std::path::Path;
use std::process::Output;

use serde_json::Value;

use crate::support::{done, json, text, told, verb};

/// A shaft on one 6205 at 50 Hz, with tables and keys of the shaft put in.
fn scene(unbalance: &str, shaft: &str, tables: &str) -> String {
    format!(
        "[shaft]\nmass = \"5 kg\"\nunbalance = \"{unbalance}\"\ngravity = true\n{shaft}\n\
         [speed]\nconstant = \"3000 rpm\"\n[[bearing]]\ncatalogue = \"6205\"\n{tables}\n\
         [damping]\nratio = 0.03\n[time]\nduration = \"0.3 s\"\nsettle = \"0.1 s\"\n"
    )
}

const RADIAL: &str = "freedoms = \"radial\"";
const MACHINE: &str = "[machine]\ngroup = 2\nsupport = \"rigid\"";
const HOUSING: &str = "[bearing.housing]\nmass = \"3 kg\"\nstiffness = { x = \"20 N/um\", y = \"30 N/um\" }\n\
    damping = { x = \"500 N s/m\", y = \"500 N s/m\" }";

fn run(folder: &Path, scenario: &str) -> (Output, Value) {
    let file = folder.join("scene.toml");
    fs::write(&file, scenario).expect("a file");
    let output = done(
        verb("run", &[file], folder, &["--no-verify"])
            .output()
            .unwrap(),
    );
    let summary = json(&folder.join("scene/summary.json"));
    (output, summary)
}

/// RMS about its mean of a column of the trace from a time on.
fn rms(folder: &Path, column: &str, from: f64) -> f64 {
    let trace = fs::read_to_string(folder.join("scene/trace.csv")).expect("a trace");
    let mut lines = trace.lines();
    let header = lines.next().expect("a header").split(',');
    let index = header.clone().position(|name| name == column);
    let index = index.unwrap_or_else(|| panic!("{column} of {header:?}"));
    let rows = lines.map(|line| line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)));
    let rows: Vec<Vec<f64>> = rows.map(Iterator::collect).collect();
    let late = rows.iter().filter(|row| row[0] >= from);
    let values: Vec<f64> = late.map(|row| row[index]).collect();
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares = values.iter().map(|value| (value - mean).powi(2));
    (squares.sum::<f64>() / count).sqrt()
}

#[test]
fn the_zone_is_that_of_the_housing_where_there_is_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let scenario = scene("200 g mm", RADIAL, &format!("{HOUSING}\n{MACHINE}"));
    // ball passes at 3.06 times the speed beat with three times it, 3 Hz apart
    let scenario = scenario.replace("0.3 s", "0.8 s");
    let (output, summary) = run(folder.path(), &scenario);
    let found = &summary["vibration_severity"];
    assert_eq!(found["channel"], "housing1_x_velocity_m_s");
    let level = found["rms_m_s"].as_f64().expect("a number");
    let expected = rms(folder.path(), "housing1_x_velocity_m_s", 0.1);
    assert!(
        (level / expected - 1.0).abs() < 0.03,
        "{level} and {expected}"
    );
    assert_eq!(found["zone"], if level > 1.4e-3 { "B" } else { "A" });
    assert!(found["remarks"].is_null(), "{found}");
    let both = &summary["motion"]["housing_velocity_rms"];
    assert_eq!(both.as_array().map(Vec::len), Some(2));
    let shown = text(&output.stdout);
    let line = "boundaries 1.4, 2.8, 4.5 mm/s (group 2, rigid support)";
    let words = shown.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("of ISO 20816-3:2022"), "{shown}");
    // what machines are judged by stands before the motion of the shaft
    let place = |text: &str| {
        words
            .find(text)
            .unwrap_or_else(|| panic!("{text} in {shown}"))
    };
    assert!(
        place("of housing1 along y") < place("vibration x"),
        "{shown}"
    );
    assert!(words.contains(line), "{shown}");
}

#[test]
fn a_zone_of_the_shaft_is_told_and_large_machines_have_wider() {
    let folder = tempfile::tempdir().expect("a folder");
    let zone = |machine: &str| {
        let (output, summary) = run(folder.path(), &scene("600 g mm", RADIAL, machine));
        let found = summary["vibration_severity"].clone();
        (text(&output.stdout), found)
    };
    let (shown, found) = zone(MACHINE);
    assert!(
        shown.contains("this is the velocity of the shaft"),
        "{shown}"
    );
    let level = 1e3 * found["rms_m_s"].as_f64().expect("a number");
    // between the boundaries B/C of both supports of group 2
    assert!((2.8..4.5).contains(&level), "{level} mm/s");
    assert_eq!(found["zone"], "C");
    let (_, flexible) = zone("[machine]\ngroup = 2\nsupport = \"flexible\"");
    assert_eq!(flexible["zone"], "B");
    let (_, large) = zone("[machine]\ngroup = 1\nsupport = \"flexible\"");
    assert_eq!(
        large["boundaries_m_s"],
        serde_json::json!([3.5e-3, 7.1e-3, 11e-3])
    );
    let (shown, none) = zone("");
    assert!(none.is_null() && !shown.contains("20816"), "{shown}");
}

/// Housings of 20 kg on 0.3 N/µm each, a shaft of 40 kg with 200 kg mm: 7.5 mm/s RMS at 5 Hz.
const SLOW: &str = "[shaft]\nmass = \"40 kg\"\nunbalance = \"200 kg mm\"\nfreedoms = \"radial\"\ngravity = true\n\
    [speed]\nconstant = \"300 rpm\"\n[[bearing]]\ncatalogue = \"6213\"\n[bearing.housing]\nmass = \"40 kg\"\n\
    stiffness = { x = \"0.6 N/um\", y = \"0.6 N/um\" }\ndamping = { x = \"4 kN s/m\", y = \"4 kN s/m\" }\n\
    [damping]\nratio = 0.03\n[machine]\ngroup = 2\nsupport = \"rigid\"\n\
    [time]\nduration = \"2 s\"\nsettle = \"1 s\"\n[output]\nsamples_per_revolution = 512\n";

#[test]
fn below_600_rpm_the_zone_counts_from_2_hz() {
    let folder = tempfile::tempdir().expect("a folder");
    let (output, summary) = run(folder.path(), SLOW);
    let found = &summary["vibration_severity"];
    assert_eq!(found["zone"], "D", "{found}");
    assert_eq!(found["band_Hz"], serde_json::json!([2.0, 1000.0]));
    let level = found["rms_m_s"].as_f64().expect("a number");
    let column = found["channel"].as_str().expect("a name");
    assert!(column.starts_with("housing1_"), "{column}");
    let expected = rms(folder.path(), column, 1.0);
    assert!(
        (level / expected - 1.0).abs() < 5e-3,
        "{level} and {expected}"
    );
    assert!((7e-3..8e-3).contains(&level), "{level}");
    // it stands first below the title
    let shown = text(&output.stdout);
    let second = shown.lines().nth(1).expect("a line");
    assert!(second.trim_start().starts_with("zone"), "{shown}");
}

#[test]
fn a_record_that_does_not_hold_the_band_has_no_zone_and_is_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let none = |from: &str, to: &str| {
        let (output, summary) = run(folder.path(), &SLOW.replace(from, to));
        assert!(summary["vibration_severity"].is_null(), "{to}");
        assert!(!text(&output.stdout).contains("\n  zone "), "{to}");
        let warnings = summary["warnings"].to_string();
        assert!(
            warnings.contains("no zone of ISO 20816-3:2022"),
            "{warnings}"
        );
        warnings
    };
    assert!(none("\"2 s\"", "\"1.39 s\"").contains("0.200 s"));
    assert!(none("= 512", "= 256").contains("samples_per_revolution = 400 or more"));
    assert!(none("300 rpm", "100 rpm").contains("120 to 30000 rpm"));
}

#[test]
fn a_machine_whose_speed_changes_has_no_zone_and_is_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let changing = "from = \"1000 rpm\"\nto = \"3000 rpm\"\nover = \"0.3 s\"";
    let scenario = scene("20 g mm", RADIAL, MACHINE).replace("constant = \"3000 rpm\"", changing);
    let (output, summary) = run(folder.path(), &scenario);
    assert!(summary["vibration_severity"].is_null());
    assert!(told(&output).contains("`[machine]` has no effect"));
}

#[test]
fn freedoms_that_are_left_out_follow_from_the_inertia() {
    let folder = tempfile::tempdir().expect("a folder");
    let (output, summary) = run(folder.path(), &scene("20 g mm", "", ""));
    assert_eq!(summary["scenario"]["shaft"]["freedoms"], "radial");
    assert!(told(&output).contains("no `freedoms` in `[shaft]`"));
    let inertia = "inertia_transverse = \"0.02 kg m^2\"\ninertia_polar = \"0.01 kg m^2\"";
    let second = "position = \"-60 mm\"\n[[bearing]]\ncatalogue = \"6205\"\nposition = \"60 mm\"\n\
        [[load]]\nconstant = { z = \"100 N\" }";
    let (output, summary) = run(folder.path(), &scene("20 g mm", inertia, second));
    assert_eq!(summary["scenario"]["shaft"]["freedoms"], "all");
    assert!(!told(&output).contains("no `freedoms`"));
}
