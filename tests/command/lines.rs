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
    // each of six maps has its bar
    assert_eq!(svg.matches("data:image/png;base64,").count(), 12);

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

/// 5 kg on 1.974 N/µm, 100 Hz, ζ = 0.02, eccentricity 0.5 mm. The largest |r| by `solve_ivp` of SciPy, DOP853 at 1e-10.
const RUN_UP: &str = "[shaft]\nmass = \"5 kg\"\neccentricity = \"0.5 mm\"\n[[element]]\n\
    linear = { stiffness = { x = \"1.9739208802178716e6 N/m\", y = \"1.9739208802178716e6 N/m\" }, \
    damping = { x = \"125.66370614359172 N s/m\", y = \"125.66370614359172 N s/m\" } }\n\
    [speed]\nfrom = \"0 rpm\"\nto = \"9000 rpm\"\nover = \"3 s\"\n[initial]\nfrom = \"zero\"\n\
    [time]\nduration = \"3 s\"\n";

#[test]
fn a_run_up_tells_its_largest_motion_and_tracks_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("run-up.toml");
    fs::write(&file, RUN_UP).expect("a file");
    let file = file.to_str().expect("a path");
    let output = jeffcott(&["run", file, "--no-verify"], folder.path());
    assert!(output.status.success(), "{}", text(&output.stderr));
    let summary = json(&folder.path().join("run-up/summary.json"));
    let number = |pointer: &str| {
        summary
            .pointer(pointer)
            .and_then(Value::as_f64)
            .expect("a number")
    };
    let rpm = |speed: f64| speed * 30.0 / std::f64::consts::PI;
    assert!((number("/run_up/radial/amplitude") - 10.515_0e-3).abs() < 1e-6);
    assert!((rpm(number("/run_up/radial/speed_rad_s")) - 6254.0).abs() < 2.0);
    assert!((number("/run_up/axes/x/amplitude") / 10.515_0e-3 - 1.0).abs() < 0.02);
    let passed = summary["run_up"]["critical_speeds_passed"]
        .as_array()
        .expect("speeds");
    assert_eq!(passed.len(), 1, "{passed:?}");
    let critical = passed[0]["speed_rad_s"].as_f64().map(rpm).expect("a speed");
    assert!((critical - 5998.8).abs() < 0.1, "{critical}");
    // 9.706 mm without the correction
    let tracks =
        fs::read_to_string(folder.path().join("run-up/order_tracks.csv")).expect("a table");
    let mut rows = tracks.lines();
    let column = rows.next().and_then(|head| {
        head.split(',')
            .position(|name| name == "order_1_x_amplitude_m")
    });
    let column = column.unwrap_or_else(|| panic!("{tracks:.200}"));
    let peak = rows.map(|row| {
        row.split(',')
            .nth(column)
            .and_then(|cell| cell.parse().ok())
            .unwrap_or(0.0)
    });
    let peak: f64 = peak.fold(0.0, f64::max);
    assert!((peak / 10.515_0e-3 - 1.0).abs() < 5e-3, "{peak}");
    assert!(number("/maps/order_tracks/tracks/0/bias") < 5e-3);
    let shown = text(&output.stdout);
    let second = shown.lines().nth(1).expect("a line");
    assert!(
        second.contains("peak") && second.contains("at 6254 rpm"),
        "{shown}"
    );
    assert!(shown.contains("passed 5998.8 rpm"), "{shown}");
}

/// 10 kg with 100 g mm on two bearings of constant stiffness, five revolutions kept, which repeat to 1e-9.
const FIVE_REVOLUTIONS: &str = "[shaft]\nmass = \"10 kg\"\ngravity = true\nfreedoms = \"all\"\n\
    inertia_transverse = \"0.1 kg m^2\"\ninertia_polar = \"0.05 kg m^2\"\n[[unbalance]]\namount = \"100 g mm\"\n\
    [[element]]\nposition = \"-100 mm\"\nlinear = { stiffness = { x = \"50 N/um\", y = \"50 N/um\", z = \"10 N/um\" }, \
    damping = { x = \"500 N s/m\", y = \"500 N s/m\", z = \"500 N s/m\" } }\n\
    [[element]]\nposition = \"100 mm\"\nlinear = { stiffness = { x = \"50 N/um\", y = \"50 N/um\" }, \
    damping = { x = \"500 N s/m\", y = \"500 N s/m\" } }\n\
    [speed]\nconstant = \"3000 rpm\"\n[time]\nduration = \"0.5 s\"\nsettle = \"0.4 s\"\n";

#[test]
fn what_repeats_has_settled_whatever_the_revolutions() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("five.toml");
    for settle in ["0.4 s", "0.36 s", "0.44 s"] {
        let scene = FIVE_REVOLUTIONS.replace("0.4 s", settle);
        fs::write(&file, scene).expect("a file");
        let path = file.to_str().expect("a path");
        let output = jeffcott(&["run", path, "--no-verify"], folder.path());
        assert!(output.status.success(), "{}", text(&output.stderr));
        let summary = json(&folder.path().join("five/summary.json"));
        let settling = &summary["motion"]["settling"];
        assert_eq!(settling["settled"], true, "{settle}: {settling}");
        for part in ["mean", "rms"] {
            let moved = settling[part].as_f64().expect("a number");
            assert!(moved.abs() < 1e-6, "{settle}: {settling}");
        }
        let warnings = summary["warnings"].to_string();
        assert!(!warnings.contains("not settled"), "{warnings}");
    }
}

/// A disc of 45.36 kg on a shaft of hardly any mass: a mode at 16 Hz, and those of the shaft from 31 kHz to 6 MHz.
const LIGHT_SHAFT: &str = "[shaft]\nmaterial = { youngs_modulus = \"30e6 psi\", density = \"1 kg/m^3\" }\n\
    [[shaft.section]]\nlength = \"30 in\"\nouter_diameter = \"1 in\"\n[[disc]]\nmass = \"100 lb\"\nposition = \"15 in\"\n\
    [[element]]\nposition = \"0 in\"\nlinear = { stiffness = { x = \"1e10 N/m\", y = \"1e10 N/m\" } }\n\
    [[element]]\nposition = \"30 in\"\nlinear = { stiffness = { x = \"1e10 N/m\", y = \"1e10 N/m\" } }\n\
    [speed]\nconstant = \"1200 rpm\"\n";

#[test]
fn a_campbell_diagram_shows_what_the_orders_reach() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("light.toml");
    fs::write(&file, LIGHT_SHAFT).expect("a file");
    let asked = |more: &[&str]| {
        let path = file.to_str().expect("a path");
        let given = ["campbell", path, "--to", "2000 rpm", "--count", "5"];
        let output = jeffcott(&[&given, more].concat(), folder.path());
        assert!(output.status.success(), "{}", text(&output.stderr));
        let shown = text(&output.stdout);
        assert!(!shown.contains("-0.0000"), "{shown}");
        let document = json(&folder.path().join("light/campbell.json"));
        let branches = document["branches"].as_array().map_or(0, Vec::len);
        (branches, document)
    };
    let (branches, document) = asked(&[]);
    assert_eq!(branches, 2, "{document}");
    let highest = document["highest_frequency_Hz"]
        .as_f64()
        .expect("a frequency");
    assert!((highest - 50.0).abs() < 1e-9, "{highest}");
    for critical in document["critical_speeds"].as_array().expect("speeds") {
        assert_eq!(critical["damping_ratio"].to_string(), "0.0");
    }
    let (more, document) = asked(&["--highest-frequency", "40 kHz"]);
    assert!(more > branches, "{document}");
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
    assert!(peak["phase_rad"].is_number() && peak["f_Hz"].is_number());
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
