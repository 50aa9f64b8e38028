//! Roller bearings wherever ball bearings may be: in housings, on shafts that bend, and asked by every verb.

use std::f64::consts::PI;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;
use tempfile::TempDir;

use crate::support::{changed, column, done, jeffcott_in, json, text, told, verb};

/// Length, m, and diameter of the shaft, and the distance of its bearings.
const LENGTH: f64 = 0.2;
const DIAMETER: f64 = 0.03;
const SPAN: f64 = 0.16;
/// Density of the shaft, kg/m³, and Young's modulus where it bends, Pa: some fifty times that of steel.
const DENSITY: f64 = 7850.0;
const STIFF: f64 = 1e13;
/// Load in the middle, N.
const LOAD: f64 = 900.0;

/// A ball and a roller bearing with what each has on top, and the place in front of which positions count, m.
fn on_bearings(shaft: &str, housing: &str, middle: f64) -> String {
    let [left, right] = [-0.5, 0.5].map(|part| middle + part * SPAN);
    format!(
        "{shaft}[speed]\nconstant = \"3000 rpm\"\n[damping]\nratio = 0.02\n\
         [[bearing]]\ncatalogue = \"6206\"\nposition = \"{left} m\"\n{housing}\
         [[bearing]]\ncatalogue = \"NU206\"\nposition = \"{right} m\"\n{housing}\
         [[load]]\nposition = \"{middle} m\"\nconstant = {{ y = \"-{LOAD} N\", z = \"60 N\" }}\n\
         [time]\nduration = \"0.1 s\"\nsettle = \"0.05 s\"\n"
    )
}

fn rigid(housing: &str) -> String {
    let mass = DENSITY * PI / 4.0 * DIAMETER.powi(2) * LENGTH;
    let polar = mass * DIAMETER.powi(2) / 8.0;
    let transverse = mass * (DIAMETER.powi(2) / 16.0 + LENGTH.powi(2) / 12.0);
    let shaft = format!(
        "[shaft]\nmass = \"{mass} kg\"\ninertia_transverse = \"{transverse} kg m^2\"\n\
         inertia_polar = \"{polar} kg m^2\"\n"
    );
    on_bearings(&shaft, housing, 0.0)
}

fn bending() -> String {
    let shaft = format!(
        "[shaft]\nmaterial = {{ youngs_modulus = \"{STIFF} Pa\" }}\n\
         [[shaft.section]]\nlength = \"{LENGTH} m\"\nouter_diameter = \"{DIAMETER} m\"\n"
    );
    on_bearings(&shaft, "", 0.5 * LENGTH)
}

fn written(folder: &TempDir, name: &str, text: &str) -> PathBuf {
    let file = folder.path().join(format!("{name}.toml"));
    fs::write(&file, text).expect("a written file");
    file
}

/// What a verb finds of a scene: its document.
#[track_caller]
fn found(question: &str, file: &Path, more: &[&str]) -> Value {
    let out = file.parent().expect("a folder").join("out");
    done(
        verb(question, &[file], &out, more)
            .output()
            .expect("an answer"),
    );
    let name = match question {
        "run" => "summary",
        question => question,
    };
    let stem = file.file_stem().expect("a name");
    json(&out.join(stem).join(format!("{name}.json")))
}

fn frequencies(file: &Path) -> Vec<f64> {
    found("campbell", file, &["--highest-frequency", "2500 Hz"]);
    let folder = file.with_extension("");
    let name = folder.file_name().expect("a name");
    let table = file.parent().expect("a folder").join("out").join(name);
    column(&table.join("campbell.csv"), "frequency_Hz")
}

/// The shaft sinks into stiff housings by F/2k more than without, and its frequencies stay.
#[test]
fn stiff_housings_give_way_by_their_stiffness_alone() {
    let folder = TempDir::new().expect("a folder");
    let stiffness = 1e12;
    let housing = format!(
        "[bearing.housing]\nmass = \"1 kg\"\nstiffness = {{ x = \"{stiffness} N/m\", y = \"{stiffness} N/m\", z = \
         \"{stiffness} N/m\" }}\n"
    );
    let [free, held] = [("free", ""), ("held", housing.as_str())]
        .map(|(name, housing)| written(&folder, name, &rigid(housing)));
    let [free_y, held_y] = [&free, &held].map(|file| {
        let found = found("bearing", file, &[]);
        found["equilibrium"]["y_m"].as_f64().expect("a number")
    });
    let sunk = (free_y - held_y) * 2.0 * stiffness / LOAD;
    assert!((sunk - 1.0).abs() < 0.02, "{sunk}");
    for (free, held) in frequencies(&free).iter().zip(frequencies(&held)) {
        assert!((held / free - 1.0).abs() < 1e-4, "{free} {held}");
    }
}

/// A shaft that bends hardly sinks by F L³/48EI + F L/4κGA more in its middle than a rigid one; its frequencies are
/// nearly those, and its motion is.
#[test]
fn a_shaft_that_hardly_bends_sinks_by_its_own_deflection() {
    let folder = TempDir::new().expect("a folder");
    let [rigid, bending] = [("rigid", rigid("")), ("bending", bending())]
        .map(|(name, text)| written(&folder, name, &text));
    let [rigid_y, bending_y] = [&rigid, &bending].map(|file| {
        let found = found("bearing", file, &[]);
        found["equilibrium"]["y_m"].as_f64().expect("a number")
    });
    let area = PI / 4.0 * DIAMETER.powi(2);
    let second_moment = area * DIAMETER.powi(2) / 16.0;
    // Cowper's coefficient of a round section at ν = 0.3, and G = E/2.6
    let shear = 0.886 * area * STIFF / 2.6;
    let deflection =
        LOAD * SPAN.powi(3) / (48.0 * STIFF * second_moment) + LOAD * SPAN / (4.0 * shear);
    // the slopes at its ends turn the bearings, which takes some per cent more
    let sunk = (rigid_y - bending_y) / deflection;
    assert!((sunk - 1.0).abs() < 0.04, "{sunk}");
    for (rigid, bending) in frequencies(&rigid).iter().zip(frequencies(&bending)) {
        assert!((bending / rigid - 1.0).abs() < 0.01, "{rigid} {bending}");
    }
    let [rigid, bending] = [&rigid, &bending].map(|file| {
        let summary = found("run", file, &["--no-verify"]);
        summary["largest_ball_load_N"].as_f64().expect("a number")
    });
    assert!((bending / rigid - 1.0).abs() < 0.02, "{rigid} {bending}");
}

/// Where rollers alone roll, no message speaks of balls; a ball pass is the name of a frequency.
#[test]
fn messages_of_roller_bearings_speak_of_no_balls() {
    let folder = TempDir::new().expect("a folder");
    let scene = |name: &str, from: &str, to: &str| {
        let rollers = [
            ("catalogue = \"6206\"", "catalogue = \"NU206\""),
            (from, to),
        ];
        let file = changed(folder.path(), "spall-outer-nu206.toml", &rollers);
        let own = folder.path().join(name);
        fs::rename(file, own).expect("a name of its own");
    };
    scene("turning.toml", "on = \"outer\"", "on = \"inner\"");
    scene(
        "linear.toml",
        "[damping]",
        "[model]\ncontact = \"linear\"\n[damping]",
    );
    let jitter = "cage_jitter = { amplitude = \"20 deg\" }\nroughness";
    scene("jitter.toml", "roughness", jitter);
    let signal: String = (0..4000)
        .map(|sample| f64::from(sample) / 4000.0)
        .map(|time| format!("{time},{}\n", (2.0 * PI * 100.0 * time).sin()))
        .collect();
    fs::write(folder.path().join("signal.csv"), format!("t_s,a\n{signal}")).expect("a record");
    for (arguments, says) in [
        (&["steady", "turning.toml"][..], "there is no steady motion"),
        (&["check", "linear.toml"], "freezes the force"),
        (&["check", "jitter.toml"], "with these rollers"),
        (
            &[
                "analyze",
                "signal.csv",
                "--speed",
                "1500 rpm",
                "--bearing",
                "NU206",
            ],
            "roller spin",
        ),
    ] {
        let output = jeffcott_in(&folder, arguments);
        let told = (text(&output.stdout) + &told(&output)).replace("ball pass", "");
        assert!(told.contains(says), "{told}");
        let mut words = told.split(|letter: char| !letter.is_alphanumeric());
        assert!(
            !words.any(|word| matches!(word, "ball" | "balls")),
            "{told}"
        );
    }
}
