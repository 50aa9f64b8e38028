//! `[[spectrum]]` from the scenario to the files.

use std::path::Path;

use serde_json::Value;

use crate::support::{done, json, loaded_7205c, verb};

/// The loaded shaft for 0.15 s after it has settled.
fn scene(spectra: &str) -> String {
    loaded_7205c("contact = \"hertz\"", spectra)
        .replace("0.03 s", "0.25 s")
        .replace("0.01 s", "0.1 s")
}

fn write(folder: &Path, text: &str) -> Value {
    let file = folder.join("shaft.toml");
    std::fs::write(&file, text).unwrap();
    let output = verb("run", &[&file], folder, &["--json", "--no-verify"]).output();
    done(output.expect("the command starts"));
    json(&folder.join("shaft/summary.json"))
}

#[test]
fn every_file_says_how_it_was_made_and_goes_with_its_table() {
    let spectra = "
[[spectrum]]
name = \"vibration\"
channels = [\"x_velocity\", \"moment_x\"]
scaling = \"density\"
window = \"hamming\"
segment = \"20 ms\"
overlap = 0.25
detrend = \"linear\"
[[spectrum]]
kind = \"whirl\"
channels = [\"force\"]
over = \"order\"
";
    let folder = tempfile::tempdir().unwrap();
    let summary = write(folder.path(), &scene(spectra));
    let vibration = &summary["spectra"][0];
    let expected = [
        ("table", Value::from("spectrum_vibration")),
        ("window", "hamming".into()),
        ("coherent_gain", 0.54.into()),
        ("detrend", "linear".into()),
        ("scaling", "density".into()),
        ("segment_samples", 204.into()),
        ("overlap_samples", 51.into()),
        ("averages", 8.into()),
    ];
    for (key, value) in expected {
        assert_eq!(vibration[key], value, "{key}");
    }
    let number = |key: &str| vibration[key].as_f64().unwrap();
    assert!((number("resolution_Hz") * 204.0 / number("sampling_rate_Hz") - 1.0).abs() < 1e-12);
    assert!((number("noise_bandwidth_Hz") / number("resolution_Hz") - 1.3628).abs() < 1e-4);
    let header = |name: &str| {
        let file = folder.path().join("shaft").join(name);
        let text = std::fs::read_to_string(file).unwrap();
        text.lines().next().unwrap().to_owned()
    };
    assert_eq!(
        header("spectrum_vibration.csv"),
        "f_Hz,order,x_velocity_density_m2_s2_per_Hz,moment_x_density_N2_m2_per_Hz"
    );
    assert_eq!(
        header("spectrum_whirl_peak_order.csv"),
        "order,f_Hz,force_x_iy_peak_N"
    );
    write(folder.path(), &scene(""));
    for name in ["spectrum_vibration.csv", "spectrum_whirl_peak_order.csv"] {
        assert!(!folder.path().join("shaft").join(name).exists(), "{name}");
    }
    assert!(folder.path().join("shaft/spectrum.csv").exists());
}
