//! `jeffcott analyze`: records of sensors, and traces of runs.

use std::f64::consts::TAU;
use std::fs;
use std::path::Path;
use std::process::Output;

use serde_json::Value;

use crate::support::{done, jeffcott_in, root, text, told};

const SCENE: &str = r#"
[shaft]
mass = "6 kg"
eccentricity = "4 um"
freedoms = "radial"
gravity = true
[speed]
constant = "1797 rpm"
[[bearing]]
catalogue = "6205"
[damping]
coefficients = { x = "500 N s/m", y = "500 N s/m" }
[[load]]
constant = { y = "-300 N" }
[time]
duration = "0.3 s"
settle = "0.1 s"
[integrator]
verify = false
[output]
window = "hann"
"#;

fn read(file: impl AsRef<Path>) -> Value {
    serde_json::from_str(&fs::read_to_string(file).unwrap()).unwrap()
}

/// Name, frequency and amplitude of the peaks of a channel.
fn peaks(document: &Value, channel: &str) -> Vec<(String, f64, f64)> {
    let peaks = document["peaks"].as_array().unwrap().iter();
    let own = peaks.filter(|peak| peak["channel"] == channel);
    own.map(|peak| {
        let name = peak["name"].as_str().unwrap_or_default().to_owned();
        (
            name,
            peak["f_Hz"].as_f64().unwrap(),
            peak["amplitude"].as_f64().unwrap(),
        )
    })
    .collect()
}

/// Spectra to round-off, with the names of shaft and ball passes; the page is there.
#[test]
fn a_trace_that_is_read_back_gives_the_spectra_of_its_run() {
    let folder = tempfile::tempdir().unwrap();
    let at = |path: &str| folder.path().join(path);
    fs::write(at("scene.toml"), SCENE).unwrap();
    done(jeffcott_in(&folder, &["run", "scene.toml"]));
    let trace = [
        "analyze",
        "output/scene/trace.csv",
        "--start",
        "0.1 s",
        "--bearing",
        "6205",
    ];
    done(jeffcott_in(&folder, &trace));
    let spectra = ["output/scene/spectrum.csv", "output/trace/spectrum.csv"];
    let compare = ["compare", spectra[0], spectra[1], "--relative", "1e-10"];
    done(jeffcott_in(&folder, &compare));
    let (run, record) = (
        read(at("output/scene/summary.json")),
        read(at("output/trace/record.json")),
    );
    let (own, again) = (peaks(&run, "y"), peaks(&record, "y"));
    assert_eq!(own.len(), again.len());
    for ((name, f, amplitude), (other, at, value)) in own.iter().zip(&again) {
        assert!((f - at).abs() < 1e-6 && (value / amplitude - 1.0).abs() < 1e-6);
        // the run knows natural frequencies, and weak lines of a record bear no name
        if name.trim_end_matches('×').parse::<u32>().is_ok() || name == "BPFO" {
            assert_eq!(name, other);
        }
    }
    assert!(again.iter().any(|(name, ..)| name == "1×"));
    let page = fs::read_to_string(at("output/trace/record.html")).unwrap();
    assert!(page.contains("trace") && page.contains("ball pass"));

    for by in ["name", "order", "frequency"] {
        let compare = [
            "compare",
            "output/scene",
            "output/trace",
            "--lines",
            "--by",
            by,
            "--decibels",
            "0.01",
            "--common",
            "--json",
            "--report",
            "both.html",
        ];
        let compared: Value =
            serde_json::from_str(&text(&jeffcott_in(&folder, &compare).stdout)).unwrap();
        let column = &compared["tables"][0]["columns"][0];
        let worst = &column["worst"];
        assert!(worst["difference"].as_f64() < Some(1e-6), "{by}: {worst}");
        assert!(worst["second_at"].is_number() && worst["allowed"] == 0.01);
        assert_eq!(worst["name"].is_string(), by == "name");
        let page = fs::read_to_string(at("both.html")).unwrap();
        assert!(page.contains("trace: "), "{by}");
    }
}

/// Records of other speeds and channels than the run: by name and order each line finds its own, by frequency none does.
#[test]
fn a_record_is_compared_with_a_run_of_another_speed() {
    let folder = tempfile::tempdir().unwrap();
    let at = |path: &str| folder.path().join(path);
    fs::write(at("scene.toml"), SCENE).unwrap();
    done(jeffcott_in(&folder, &["run", "scene.toml"]));
    // 2 µm at 1× of 20 Hz: √2 times the velocity amplitudes of 1.414 mm/s²
    let rows = (0..8000).map(|n| {
        let t = f64::from(n) / 8000.0;
        format!("{t},{}\n", 2.0 * (TAU * 20.0 * t).cos())
    });
    fs::write(
        at("made.csv"),
        "t [s],shaft [um]\n".to_owned() + &rows.collect::<String>(),
    )
    .unwrap();
    let analyze = ["analyze", "made.csv", "--speed", "1200 rpm"];
    done(jeffcott_in(&folder, &analyze));
    let compare = |options: &[&str]| {
        let both = [
            "compare",
            "output/scene",
            "output/made",
            "--lines",
            "--common",
        ];
        let output = jeffcott_in(&folder, &[&both, options].concat());
        (output.status.code(), text(&output.stdout) + &told(&output))
    };
    let (code, named) = compare(&["--by", "name", "--decibels", "200"]);
    assert!(code == Some(0) && named.contains("1×"), "{named}");
    let (_, ordered) = compare(&["--by", "order", "--decibels", "200"]);
    assert!(ordered.contains("order of b"), "{ordered}");
    let (code, placed) = compare(&["--decibels", "200"]);
    assert_eq!(code, Some(2));
    assert!(placed.contains("no line of"), "{placed}");
    let (code, placed) = compare(&["--decibels", "200", "--reach", "0.5"]);
    assert_eq!(code, Some(0), "{placed}");
}

/// A folder and a file; where there is none the scenario is wrong.
#[test]
fn a_record_is_laid_over_the_page_of_a_run() {
    let folder = tempfile::tempdir().unwrap();
    let at = |path: &str| folder.path().join(path);
    let rows = (0..4000).map(|n| format!("{},{}\n", f64::from(n) / 8000.0, n % 40));
    fs::write(
        at("made.csv"),
        "t [s],sensor [m/s^2]\n".to_owned() + &rows.collect::<String>(),
    )
    .unwrap();
    done(jeffcott_in(
        &folder,
        &["analyze", "made.csv", "--out", "found"],
    ));
    for file in ["found/made", "made.csv"] {
        let scene = format!("{SCENE}[[measured]]\nfile = \"{file}\"\n");
        fs::write(at("scene.toml"), scene).unwrap();
        done(jeffcott_in(&folder, &["run", "scene.toml"]));
        let page = fs::read_to_string(at("output/scene/report.html")).unwrap();
        assert!(page.contains("made: sensor") && page.contains("simulated: "));
        assert!(at("output/scene/measured.svg").exists());
    }
    fs::write(
        at("scene.toml"),
        format!("{SCENE}[[measured]]\nfile = \"none\"\n"),
    )
    .unwrap();
    let output = jeffcott_in(&folder, &["check", "scene.toml"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(told(&output).contains("there is no "));
}

/// As the manual shows it, on made files of the shape.
#[test]
fn layouts_of_data_sets_are_read() {
    let (cwru, mfpt, er16k) = (
        "9, 0.3126 in, 1.537 in",
        "8, 0.235 in, 1.245 in",
        "9, 7.9375 mm, 38.5 mm",
    );
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let records = root().join("tests/records");
    for arguments in [
        &[
            "cwru.mat",
            "--channel",
            "X112_DE_time",
            "--rate",
            "12 kHz",
            "--unit",
            "g",
            "--speed",
            "1797 rpm",
            "--bearing",
            cwru,
        ][..],
        &[
            "paderborn.mat",
            "--channel",
            "vibration_1",
            "--rate",
            "64 kHz",
            "--speed",
            "1500 rpm",
            "--bearing",
            "6203",
        ],
        &[
            "mfpt.mat",
            "--channel",
            "bearing.gs",
            "--rate",
            "97656 Hz",
            "--unit",
            "g",
            "--speed",
            "25 Hz",
            "--bearing",
            mfpt,
        ],
        &[
            "curtin.mat",
            "--channel",
            "Channel_1",
            "--rate",
            "51.2 kHz",
            "--unit",
            "m/s^2",
            "--tacho",
            "Channel_2",
            "--bearing",
            er16k,
        ],
        &["german.csv", "--speed", "3000 rpm"],
        &["i16.wav", "--scale", "50", "--unit", "m/s^2"],
        &["text.uff"],
    ] {
        let all = [&["analyze"], arguments, &["--out", out]].concat();
        done(jeffcott_in(&records, &all));
        let stem = arguments[0].split('.').next().unwrap();
        let document = read(folder.path().join(stem).join("record.json"));
        assert!(
            document["sealed"]
                .as_array()
                .unwrap()
                .iter()
                .any(|name| name == "record.html")
        );
        assert!(document["samples"].as_u64() > Some(16) && document["spectrum"].is_object());
    }
}

#[test]
fn a_list_shows_what_a_file_holds() {
    let records = root().join("tests/records");
    let listed = |arguments: &[&str]| text(&done(jeffcott_in(&records, arguments)).stdout);
    let text = listed(&["analyze", "cwru.mat", "--list"]);
    assert!(
        text.contains("X112_DE_time") && text.contains("X112RPM = 1797"),
        "{text}"
    );
    let json: Value =
        serde_json::from_str(&listed(&["analyze", "timed.csv", "--list", "--json"])).unwrap();
    assert_eq!(json["schema_version"], 1);
    assert_eq!(json["channels"][0]["samples"], 100.0);
    assert!((json["channels"][0]["rate_Hz"].as_f64().unwrap() - 25_600.0).abs() < 1e-6);
}

/// Each with what it says, and exit code 2.
#[test]
fn what_is_wrong_is_said_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let records = root().join("tests/records");
    let run = |arguments: &[&str]| -> Output {
        let all = [&["analyze"], arguments, &["--out", out.to_str().unwrap()]].concat();
        jeffcott_in(&records, &all)
    };
    for (arguments, words) in [
        (&["cwru.mat"][..], "does not say how many samples a second"),
        (
            &["mfpt.mat", "--channel", "bearing.gs"],
            "bearing.sr = 97656",
        ),
        (
            &["cwru.mat", "--rate", "12 kHz", "--channel", "X112_DE"],
            "did you mean `X112_DE_time`?",
        ),
        (
            &["cwru.mat", "--rate", "12 kHz", "--speed", "1797"],
            "needs a unit",
        ),
        (&["cwru.mat", "--rate", "12 kHz", "--window", "han"], "hann"),
        (&["version4.mat"], "save it again in MATLAB with `-v7`"),
        (&["missing.csv"], "cannot be read"),
    ] {
        let output = run(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(told(&output).contains(words), "{words}: {}", told(&output));
    }
    assert!(!out.exists());
}

/// The result of a record would be lost under that of another with its name.
#[test]
fn records_of_one_name_are_not_written_over_each_other() {
    let folder = tempfile::tempdir().expect("a folder");
    let records = ["a", "b"].map(|part| {
        let path = folder.path().join(part).join("r.csv");
        fs::create_dir(folder.path().join(part)).expect("a folder");
        fs::copy(root().join("tests/records/timed.csv"), &path).expect("a record");
        path.to_str().expect("a path").to_owned()
    });
    let out = folder.path().join("out");
    let out = out.to_str().expect("a path");
    let output = jeffcott_in(root(), &["analyze", &records[0], &records[1], "--out", out]);
    assert_eq!(output.status.code(), Some(2), "{}", told(&output));
    assert!(
        told(&output).contains("would be written to"),
        "{}",
        told(&output)
    );
}

#[test]
fn the_command_prints_the_schema_of_records() {
    let committed = fs::read(root().join("scenarios/record.schema.json")).unwrap();
    assert!(done(jeffcott_in(root(), &["schema", "--record"])).stdout == committed);
}

/// Also names with signs of paths, of one name but for signs, case or unit, and beside the times of a trace.
#[test]
fn names_of_channels_make_names_of_files() {
    let folder = tempfile::tempdir().unwrap();
    let long = "long".repeat(80);
    let mut table = format!("t_s,x_m,acc (m/s^2),../acc [mm/s],Acc [g],{long}\n");
    for n in 0..64 {
        let value = (0.7 * f64::from(n)).sin();
        let row = [f64::from(n) / 64.0, value, value, value, value, value];
        table += &row.map(|value| value.to_string()).join(",");
        table += "\n";
    }
    fs::write(folder.path().join("names.csv"), table).unwrap();
    done(jeffcott_in(&folder, &["analyze", "names.csv"]));
    let output = folder.path().join("output/names");
    let document = read(output.join("record.json"));
    let channels = document["channels"].as_array().unwrap().iter();
    let shown: Vec<_> = channels
        .map(|of| [&of["channel"], &of["unit"]].map(|word| word.as_str().unwrap_or_default()))
        .collect();
    let cut = &long[..64];
    let expected = [
        ["x", "m"],
        ["acc", "m/s^2"],
        ["acc_2", "m/s"],
        ["Acc_3", "m/s^2"],
        [cut, ""],
    ];
    assert_eq!(shown, expected);
    for name in ["acc", "acc_2", "Acc_3", cut] {
        let file = format!("spectrum_envelope_{name}.csv");
        assert!(output.join(&file).is_file(), "{file}");
    }
}
