//! From a record to its cause: one made record a fault, in every form, found by the commands of the manual.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::support::{column, done, jeffcott_in, json, root};

/// Samples a second, so that a step has few digits.
const RATE: f64 = 25_000.0;
const ACCELERATION: [&str; 2] = ["housing1_y_acceleration_m_s2", "m/s^2"];
const DISPLACEMENT: [&str; 2] = ["y_m", "m"];
const BEARING: &str = "9, 7.94 mm, 39.04 mm";

/// What a sensor gives of a shipped scene with some values of its own, with noise.
fn measured(folder: &Path, scene: &str, name: &str, settings: &[&str]) -> Vec<f64> {
    let file = root().join(format!("scenarios/{scene}.toml"));
    let mut arguments = vec!["run", file.to_str().unwrap(), "--no-verify"];
    let shared = [
        "output.sample_rate=25 kHz",
        "output.report=false",
        "output.figures=false",
    ];
    for setting in shared.iter().chain(settings) {
        arguments.extend(["--set", setting]);
    }
    done(jeffcott_in(folder, &arguments));
    let trace = folder.join("output").join(scene).join("trace.csv");
    let samples = column(&trace, name);
    let settled = &samples[(0.2 * RATE) as usize..];
    let mut state = 1_u64;
    let noise = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 33) as f64 / f64::from(1 << 30) - 1.0
    };
    let count = settled.len() as f64;
    let mean = settled.iter().sum::<f64>() / count;
    let squares = settled.iter().map(|x| (x - mean).powi(2));
    let rms = (squares.sum::<f64>() / count).sqrt();
    let noises = std::iter::repeat_with(noise);
    settled
        .iter()
        .zip(noises)
        .map(|(x, noise)| x + 0.3 * rms * noise)
        .collect()
}

fn bytes(samples: &[f64]) -> Vec<u8> {
    samples
        .iter()
        .flat_map(|sample| sample.to_le_bytes())
        .collect()
}

fn words(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

fn csv(samples: &[f64], unit: &str) -> Vec<u8> {
    let rows = samples.iter().map(|sample| format!("{sample:?}\n"));
    (format!("sensor [{unit}]\n") + &rows.collect::<String>()).into_bytes()
}

fn wav(samples: &[f64]) -> Vec<u8> {
    let (rate, size) = (RATE as u32, 8 * samples.len() as u32);
    // floating point, one channel, 64 bits
    let layout = words(&[16, 1 << 16 | 3, rate, 8 * rate, 64 << 16 | 8]);
    let riff = [
        b"RIFF",
        &words(&[36 + size])[..],
        b"WAVEfmt ",
        &layout,
        b"data",
    ]
    .concat();
    [riff, words(&[size]), bytes(samples)].concat()
}

/// A variable `X105_DE_time` of N × 1, as in the files of Case Western Reserve.
fn mat(samples: &[f64]) -> Vec<u8> {
    let (count, size) = (samples.len() as u32, 8 * samples.len() as u32);
    let mut file = format!("{:124}", "MATLAB 5.0 MAT-file").into_bytes();
    file.extend(b"\0\x01IM");
    let name = b"X105_DE_time\0\0\0\0";
    file.extend(words(&[14, 16 + 16 + 8 + 16 + 8 + size]));
    file.extend(words(&[6, 8, 6, 0, 5, 8, count, 1, 1, 12]));
    file.extend(name);
    file.extend(words(&[9, size]));
    [file, bytes(samples)].concat()
}

/// A binary dataset 58 of real numbers of 64 bits at even times.
fn uff(samples: &[f64], unit: &str) -> Vec<u8> {
    let count = samples.len();
    let mut text = format!("    -1\n    58b     1     2{:>12}{:>12}\n", 11, 8 * count);
    text += "sensor\nNONE\nNONE\nNONE\nNONE\n";
    text += &format!(
        "{:>5}{:>10}{:>5}{:>10} {:<10}{:>10}{:>4}\n",
        1, 0, 0, 0, "NONE", 1, 2
    );
    text += &format!(
        "{:>10}{count:>10}{:>10}{:>13}{:>13}{:>13}\n",
        4,
        1,
        "0.",
        1.0 / RATE,
        "0."
    );
    for (number, unit) in [(17, "s"), (0, unit), (0, "NONE"), (0, "NONE")] {
        text += &format!("{number:>10}{:37}{unit:<20}\n", "");
    }
    [text.as_bytes(), &bytes(samples), b"\n    -1\n"].concat()
}

/// What `analyze` finds in a record in every form, all the same to round-off.
fn found_in_every_form(folder: &Path, samples: &[f64], unit: &str) -> Value {
    let (rate, of_unit) = (["--rate", "25 kHz"], ["--unit", unit]);
    let forms: [(&str, Vec<u8>, Vec<&str>); 4] = [
        ("sensor.csv", csv(samples, unit), rate.to_vec()),
        ("sensor.wav", wav(samples), of_unit.to_vec()),
        ("sensor.mat", mat(samples), [rate, of_unit].concat()),
        ("sensor.uff", uff(samples, unit), Vec::new()),
    ];
    let mut first: Option<Value> = None;
    for (file, content, options) in forms {
        fs::write(folder.join(file), content).unwrap();
        let common = [
            "analyze",
            file,
            "--speed",
            "1797 rpm",
            "--bearing",
            BEARING,
            "--out",
            "found",
        ];
        done(jeffcott_in(folder, &[&common[..], &options].concat()));
        let found = json(&folder.join("found/sensor/record.json"));
        assert_eq!(found["samples"], samples.len());
        let first = first.get_or_insert_with(|| found.clone());
        for list in ["/spectra/0/lines", "/peaks"] {
            let lines = |it: &Value| it.pointer(list).and_then(Value::as_array).cloned();
            let [known, own] = [&*first, &found].map(|it| lines(it).unwrap_or_default());
            assert_eq!(known.len(), own.len(), "{file}");
            for (a, b) in known.iter().zip(&own) {
                assert_eq!(a["name"], b["name"], "{file}");
                for key in ["at", "value", "f_Hz", "amplitude"] {
                    let [a, b] = [a, b].map(|line| line[key].as_f64().unwrap_or(0.0));
                    assert!((a - b).abs() <= 1e-9 * a.abs(), "{file} {key}: {a} {b}");
                }
            }
        }
    }
    first.unwrap()
}

/// Names of the lines of the envelope, the strongest first.
fn names(found: &Value) -> Vec<&str> {
    let lines = found["spectra"][0]["lines"].as_array().unwrap().iter();
    lines.map(|line| line["name"].as_str().unwrap()).collect()
}

#[test]
fn a_spall_of_the_outer_race_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let [name, unit] = ACCELERATION;
    let samples = measured(folder.path(), "spall-outer-6205", name, &[]);
    let found = found_in_every_form(folder.path(), &samples, unit);
    assert_eq!(names(&found)[..3], ["BPFO", "2×BPFO", "3×BPFO"]);
    assert_eq!(found["cage_slip"][0]["race"], "outer");
}

#[test]
fn a_spall_of_the_inner_race_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let [name, unit] = ACCELERATION;
    let samples = measured(folder.path(), "spall-inner-6205", name, &[]);
    let found = found_in_every_form(folder.path(), &samples, unit);
    let names = names(&found);
    assert!(
        ["BPFI", "BPFI − 1×"]
            .iter()
            .all(|line| names.contains(line)),
        "{names:?}"
    );
    assert_eq!(found["cage_slip"][0]["race"], "inner");
}

/// Its lines beside that of the outer race are not taken for a cage that slips: by its own spin it rolls.
#[test]
fn a_spall_of_a_ball_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let [name, unit] = ACCELERATION;
    let samples = measured(folder.path(), "spall-ball-6205", name, &[]);
    let found = found_in_every_form(folder.path(), &samples, unit);
    let names = names(&found);
    assert!(
        ["2×BSF", "cage"].iter().all(|line| names.contains(line)),
        "{names:?}"
    );
    let slip = &found["cage_slip"][0];
    let [cage_slip, uncertainty] =
        ["cage_slip", "uncertainty"].map(|key| slip[key].as_f64().unwrap());
    assert!(
        slip["race"].is_null() && cage_slip.abs() < uncertainty,
        "{slip}"
    );
}

/// By a sensor of displacement.
#[test]
fn an_unbalance_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let ([name, unit], heavy) = (DISPLACEMENT, ["shaft.eccentricity=200 um"]);
    let samples = measured(folder.path(), "healthy-6205", name, &heavy);
    let found = found_in_every_form(folder.path(), &samples, unit);
    let peaks = found["peaks"].as_array().unwrap().iter();
    let height = |peak: &&Value| peak["amplitude"].as_f64().unwrap();
    let strongest = peaks
        .max_by(|a, b| height(a).total_cmp(&height(b)))
        .unwrap();
    assert_eq!(strongest["name"], "1×");
}
