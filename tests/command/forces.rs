//! Forces of single bearings and motions of housings, wherever a user asks for columns or numbers.

use std::f64::consts::TAU;
use std::fs;
use std::path::PathBuf;

use tempfile::TempDir;

use crate::support::{column, done, jeffcott_in, told};

const SPEED: &str = "[speed]\nconstant = \"3600 rpm\"\n";
/// `K u + C u̇` in closed form.
const SPRING: &str = "[[element]]\nlinear = { stiffness = { x = \"3750 N/mm\", y = \"3750 N/mm\" }, damping = { x = \
                      \"1500 N s/m\", y = \"1500 N s/m\" } }\n";
const SHAFT: &str =
    "[shaft]\nmass = \"60 kg\"\neccentricity = \"20 um\"\nfreedoms = \"radial\"\ngravity = true\n";
const HOUSED: &str = "[[bearing]]\ncatalogue = \"6205\"\nposition = \"0 mm\"\nhousing = { mass = \"3 kg\", stiffness = { x = \
                      \"50 N/um\", y = \"40 N/um\" }, damping = { x = \"5 kN s/m\", y = \"5 kN s/m\" } }\n";
/// `k |1 + i c ω/k| |u|` of the spring, with |u| = 35.4516 µm.
const FIRST_ORDER: f64 = 134.447;
const WEIGHT: f64 = 588.399;

struct Scene(TempDir);

impl Scene {
    fn new(parts: &[&str]) -> Self {
        let folder = TempDir::new().expect("a temporary folder");
        fs::write(folder.path().join("scene.toml"), parts.concat()).expect("a written file");
        Self(folder)
    }

    #[track_caller]
    fn ask(&self, arguments: &[&str]) -> &Self {
        let (verb, more) = arguments.split_first().expect("a verb");
        let named = [&[*verb, "scene.toml"], more, &["--out", "out"]].concat();
        done(jeffcott_in(self.0.path(), &named));
        self
    }

    fn file(&self, name: &str) -> PathBuf {
        self.0.path().join("out/scene").join(name)
    }

    fn column(&self, table: &str, name: &str) -> Vec<f64> {
        column(&self.file(table), name)
    }

    /// A number of every run of a study that keeps some, or what it answers where there is none such.
    fn study(&self, number: &str) -> Result<Vec<f64>, String> {
        let text = format!(
            "base = \"scene.toml\"\n[[axis]]\nkey = \"shaft.eccentricity\"\nvalues = [\"10 um\", \"20 um\"]\n[keep]\nnumbers = \
             [\"{number}\"]\n"
        );
        fs::write(self.0.path().join("many.toml"), text).expect("a written file");
        let output = jeffcott_in(self.0.path(), &["study", "many.toml", "--out", "out"]);
        if !output.status.success() {
            return Err(told(&output));
        }
        Ok(column(&self.0.path().join("out/many/runs.csv"), number))
    }
}

#[track_caller]
fn close(found: f64, expected: f64, tolerance: f64) {
    let apart = (found - expected).abs();
    assert!(
        apart <= tolerance * expected.abs(),
        "{found}, not {expected}"
    );
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

#[test]
fn a_linear_element_alone_bears_weight_and_unbalance() {
    let time = "[time]\nduration = \"1.5 s\"\nsettle = \"1.2 s\"\n[[spectrum]]\nchannels = [\"force\", \"element1_force_y\"]\n\
                window = \"rectangular\"\n[[spectrum]]\nkind = \"whirl\"\nchannels = [\"element1_force_x\", \
                \"element1_force_y\"]\n";
    let scene = Scene::new(&[SHAFT, SPRING, SPEED, time]);
    scene.ask(&["run", "--channels", "force_y,element1_force_y"]);
    let total = scene.column("trace.csv", "force_y_N");
    assert_eq!(total, scene.column("trace.csv", "element1_force_y_N"));
    close(mean(&total[total.len() - 128..]), WEIGHT, 1e-5);
    let frequencies = scene.column("spectrum_peak.csv", "f_Hz");
    let bin = frequencies
        .iter()
        .position(|frequency| (frequency - 60.0).abs() < 1e-6);
    let bin = bin.expect("the shaft frequency");
    for name in ["force_x", "force_y", "element1_force_y"] {
        let amplitudes = scene.column("spectrum_peak.csv", &format!("{name}_peak_N"));
        close(amplitudes[bin], FIRST_ORDER, 1e-5);
    }
    let turning = scene.column("spectrum_whirl_peak.csv", "element1_force_x_iy_peak_N");
    let largest = turning
        .iter()
        .fold(0.0, |most: f64, value| most.max(*value));
    close(largest, FIRST_ORDER, 1e-2);
    for number in ["element1_force_y_mean_N", "force_y_mean_N"] {
        close(scene.study(number).expect("a number")[1], WEIGHT, 1e-5);
    }
    for number in ["element1_force_x_order_1_N", "force_x_order_1_N"] {
        let found = scene.study(number).expect("a number");
        close(found[1], FIRST_ORDER, 1e-4);
        close(found[0], 0.5 * FIRST_ORDER, 1e-4);
    }
}

#[test]
fn bearings_and_elements_count_apart() {
    let balls = "[[bearing]]\ncatalogue = \"7205C\"\npreload = \"300 N\"\n";
    let time = "[damping]\nratio = 0.1\n[time]\nduration = \"0.05 s\"\nsettle = \"0 s\"\n";
    let undamped = SPRING
        .split(", damping")
        .next()
        .expect("a spring")
        .to_owned()
        + " }\n";
    let scene = Scene::new(&[SHAFT, &undamped, balls, SPEED, time]);
    scene.ask(&["run"]);
    let of = |name: &str| scene.column("trace.csv", name);
    let (y, total) = (of("y_m"), of("force_y_N"));
    let [spring, balls] = ["element1_force_y_N", "bearing1_force_y_N"].map(of);
    for row in 0..y.len() {
        close(spring[row], -3.75e6 * y[row], 1e-9);
        close(spring[row] + balls[row], total[row], 1e-9);
    }
    let refused = scene.study("bearing2_force_y_mean_N");
    refused.expect_err("one bearing");
    let output = jeffcott_in(
        scene.0.path(),
        &["run", "scene.toml", "--channels", "bearing2_force_y"],
    );
    assert_eq!(output.status.code(), Some(2), "{}", told(&output));
    assert!(told(&output).contains("number of bearings is 1"));
}

#[test]
fn housings_move_in_steady_motions_spectra_of_whirl_and_studies() {
    let time = "[damping]\nratio = 0.1\n[time]\nduration = \"0.5 s\"\nsettle = \"0.4 s\"\n[[spectrum]]\nwindow = \"rectangular\"\n\
                channels = [\"housing1_x\", \"bearing1_force_x\"]\n[[spectrum]]\nkind = \"whirl\"\nchannels = [\"housing1_x\", \
                \"housing1_y\", \"housing1_x_velocity\", \"housing1_y_velocity\"]\n[model]\ncontact = \"linear\"\n";
    let light = SHAFT.replace("60 kg", "5 kg");
    let scene = Scene::new(&[&light, HOUSED, SPEED, time]);
    scene.ask(&["run"]).ask(&["steady"]);
    let frequencies = scene.column("spectrum_peak.csv", "f_Hz");
    let bin = frequencies
        .iter()
        .position(|frequency| (frequency - 60.0).abs() < 1e-6);
    let bin = bin.expect("the shaft frequency");
    for (number, name) in [
        ("housing1_x_order_1_m", "housing1_x_peak_m"),
        ("bearing1_force_x_order_1_N", "bearing1_force_x_peak_N"),
    ] {
        let expected = scene.column("spectrum_peak.csv", name)[bin];
        close(scene.study(number).expect("a number")[1], expected, 1e-9);
    }
    scene.column("spectrum_whirl_peak.csv", "housing1_x_iy_velocity_peak_m_s");
    let [place, rate, acceleration] = ["", "_velocity", "_acceleration"].map(|of| {
        let unit = of
            .replace("_velocity", "m_s")
            .replace("_acceleration", "m_s2");
        let unit = if unit.is_empty() { "m" } else { &unit };
        let values = scene.column("steady_trace.csv", &format!("housing1_x{of}_{unit}"));
        values
            .into_iter()
            .fold(0.0, |most: f64, value| most.max(value.abs()))
    });
    assert!(place > 0.0 && rate > 0.0);
    close(acceleration, rate * TAU * 60.0, 1e-2);
    let error = scene.study("nothing_like_it").expect_err("no such number");
    for name in ["housing1_x_order_1_m", "bearing1_force_x_mean_N"] {
        assert!(error.contains(name), "{error}");
    }
}
