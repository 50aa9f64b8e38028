//! Studies of many runs: nothing is lost, made twice or told wrong.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};

use tempfile::TempDir;

use crate::support::{
    PROGRAM, column, done, files, jeffcott, scenarios, told, toml_files, verb, wait_for,
};

fn shipped(name: &str) -> PathBuf {
    crate::support::shipped(&format!("studies/{name}"))
}

fn study(file: &Path, out: &Path, more: &[&str]) -> Output {
    let output = verb("study", &[file], out, more).output();
    output.expect("the command starts")
}

/// Starts a study that is to be killed, and waits until its rows have so many bytes.
fn begun(file: &Path, out: &Path, bytes: u64) -> Child {
    let child = verb("study", &[file], out, &[])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the command starts");
    wait_for(&out.join("small").join("runs.jsonl"), bytes);
    child
}

/// Puts the parts of a study together.
fn merge(folder: &Path) -> Output {
    let output = jeffcott().args(["study", "merge"]).arg(folder).output();
    output.expect("the command starts")
}

/// Asserts that the files of a study in parts are those of the whole.
#[track_caller]
fn assert_same_files(whole: &Path, parts: &Path) {
    for (name, bytes) in files(whole) {
        let merged = fs::read(parts.join(&name)).expect("the same file");
        assert!(merged == bytes, "{name} differs");
    }
}

/// A study on the linear shaft, a run of which takes a millisecond.
fn written(folder: &Path, text: &str) -> PathBuf {
    let base = scenarios().join("linear-7205c.toml");
    let file = folder.join("small.toml");
    let text = format!("base = '{}'\n{text}", base.display());
    fs::write(&file, text).expect("a writable folder");
    file
}

const SPEEDS: &str = "
[[axis]]
key = 'speed.constant'
from = '100 rad/s'
to = '400 rad/s'
count = 40
";

fn rows(folder: &Path) -> Vec<csv::StringRecord> {
    let mut reader = csv::Reader::from_path(folder.join("runs.csv")).expect("a table");
    reader.records().map(|row| row.expect("a row")).collect()
}

// What a study leaves.

/// Runs a shipped study to its end, without a failed run: it draws what it is about.
#[track_caller]
fn run_shipped(name: &str, figure: &str, out: &Path) -> serde_json::Value {
    let output = done(study(&shipped(name), out, &["--json"]));
    let folder = out.join(name);
    assert!(folder.join(figure).exists(), "{name} has no {figure}");
    assert!(folder.join("report.html").exists(), "{name} has no page");
    assert!(!folder.join("runs.jsonl").exists(), "{name}");
    serde_json::from_slice(&output.stdout).expect("JSON")
}

/// With those that tests below look into, every shipped study runs.
#[test]
fn every_shipped_study_runs() {
    let out = TempDir::new().expect("a folder");
    for (name, figure) in [
        ("clearance-nu206", "response.svg"),
        ("hysteresis-6306", "bifurcation.svg"),
        ("map-6306", "map.svg"),
        ("spall-growth-6205", "response.svg"),
        ("tolerances-7205c", "sensitivity.svg"),
        ("waterfall-6306", "waterfall.svg"),
    ] {
        run_shipped(name, figure, out.path());
    }
    // a hundredth of the long one
    let long = shipped("bifurcation-6306");
    done(study(&long, out.path(), &["--shard", "50/100"]));
    let known = toml_files(&scenarios().join("studies"));
    // nine studies more or less long, one that draws spectra, and a fit
    assert_eq!(known.len(), 11, "{known:?}");
}

#[test]
fn every_cell_of_a_grid_has_its_spectrum_and_named_peaks() {
    let out = TempDir::new().expect("a folder");
    let fewer = ["axis[1].count=2", "axis[2].count=2", "verify_every=0"];
    let fewer = fewer.iter().flat_map(|set| ["--set", set]);
    let more: Vec<_> = fewer.chain(["--json"]).collect();
    let output = done(study(&shipped("spectra-7205c"), out.path(), &more));
    let told: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(told["digest"]["runs"], 4);
    let folder = out.path().join("spectra-7205c");
    let drawn = fs::read_to_string(folder.join("spectra.svg")).expect("a figure");
    for cell in ["250 rad/s, 200 N", "2500 rad/s, 1000 N"] {
        assert!(drawn.contains(cell), "{cell}");
    }
    assert!(folder.join("waterfall.svg").exists());
    let peaks = fs::read_to_string(folder.join("peaks.csv")).expect("a table");
    for run in 0..4 {
        let mut lines = peaks
            .lines()
            .filter(|line| line.starts_with(&format!("{run},")));
        assert!(lines.any(|line| !line.ends_with(',')), "{run}");
    }
}

#[test]
fn words_vary_along_an_axis() {
    let out = TempDir::new().expect("a folder");
    let text =
        "ask = 'bearing'\n[[axis]]\nkey = 'bearing[*].catalogue'\nvalues = ['7205C', '7208C']\n";
    let file = written(out.path(), text);
    done(study(&file, out.path(), &[]));
    let folder = out.path().join("small");
    let rows = rows(&folder);
    assert_eq!([&rows[0][2], &rows[1][2]], ["7205C", "7208C"]);
    let stiffness = column(&folder.join("runs.csv"), "stiffness_x_N_m");
    assert_ne!(stiffness[0], stiffness[1]);
    let spaced = text.replace(
        "values = ['7205C', '7208C']",
        "from = '7205C'\nto = '7208C'\ncount = 3",
    );
    let refused = study(&written(out.path(), &spaced), out.path(), &[]);
    assert!(crate::support::told(&refused).contains("list its `values`"));
}

/// The balanced shaft answers where its balls pass at a natural frequency.
#[test]
fn a_resonance_is_where_balls_pass_at_a_natural_frequency() {
    let out = TempDir::new().expect("a folder");
    let answer = run_shipped("resonance-7205c", "response.svg", out.path());
    let digest = &answer["digest"];
    let natural = digest["numbers"]["natural_frequency_1_Hz"]["mean"]
        .as_f64()
        .expect("a number");
    // ball passes a revolution of the 7205C at its nominal contact angle, as in any run's summary
    let expected = natural * std::f64::consts::TAU / 4.805_06;
    let peaks = digest["resonances"].as_array().expect("a list");
    let near = peaks.iter().any(|peak| {
        let at = peak["at"].as_f64().expect("a number");
        peak["number"] == "z_rms_m" && (at / expected - 1.0).abs() < 0.02
    });
    assert!(near, "no peak of z near {expected} rad/s: {peaks:#?}");
}

/// One thread or three, in one piece or in parts: the same bytes.
#[test]
fn threads_and_parts_do_not_change_a_byte() {
    let folder = TempDir::new().expect("a folder");
    let file = written(folder.path(), SPEEDS);
    let out = |name: &str| folder.path().join(name);
    for (name, threads) in [("one", "1"), ("three", "3")] {
        let output = study(&file, &out(name), &["--threads", threads]);
        assert!(output.status.success(), "{}", told(&output));
    }
    let one = files(&out("one").join("small"));
    assert!(one.iter().any(|(name, _)| name == "report.html"));
    assert_eq!(one, files(&out("three").join("small")));
    for part in ["2/3", "1/3", "3/3"] {
        let output = study(&file, &out("parts"), &["--shard", part]);
        assert!(output.status.success(), "{}", told(&output));
    }
    done(merge(&out("parts").join("small")));
    assert_same_files(&out("one").join("small"), &out("parts").join("small"));
}

/// Tasks of a Slurm array make the parts of a study.
#[cfg(unix)]
#[test]
fn an_array_of_tasks_makes_the_parts() {
    let folder = TempDir::new().expect("a folder");
    let file = written(folder.path(), SPEEDS);
    assert!(
        study(&file, &folder.path().join("whole"), &[])
            .status
            .success()
    );
    let parts = folder.path().join("parts");
    let script = scenarios().join("studies").join("slurm.sh");
    for task in ["3", "1", "2"] {
        let output = Command::new("bash")
            .arg(&script)
            .args([&file, &parts])
            .env("JEFFCOTT", PROGRAM)
            .env("SLURM_ARRAY_TASK_ID", task)
            .env("SLURM_ARRAY_TASK_COUNT", "3")
            .output()
            .expect("bash starts");
        assert!(output.status.success(), "{}", told(&output));
    }
    done(merge(&parts.join("small")));
    assert_same_files(
        &folder.path().join("whole").join("small"),
        &parts.join("small"),
    );
}

/// What a study does not keep is not found out; what it keeps is the same as among all numbers.
#[test]
fn numbers_do_not_depend_on_which_others_are_kept() {
    let folder = TempDir::new().expect("a folder");
    let text = format!(
        "base = '{}'\n[[axis]]\nkey = 'speed.constant'\nvalues = ['400 rad/s', '500 rad/s']\n",
        scenarios().join("steady-7205c.toml").display()
    );
    let all = folder.path().join("all.toml");
    fs::write(&all, &text).expect("a file");
    assert!(study(&all, folder.path(), &[]).status.success());
    for kept in [
        "z_rms_m",
        "bearing_1_life_h",
        "y_order_1_m",
        "force_x_rms_N",
        "stiffness_x_N_m",
    ] {
        let few = folder.path().join("few.toml");
        fs::write(&few, format!("{text}[keep]\nnumbers = ['{kept}']\n")).expect("a file");
        assert!(study(&few, folder.path(), &["--restart"]).status.success());
        let [all, few] = ["all", "few"].map(|name| folder.path().join(name).join("runs.csv"));
        let [all, few] = [all, few].map(|table| column(&table, kept));
        assert_eq!(all, few, "{kept}");
    }
}

/// Killed at any time, a study goes on from the runs that are done, and ends with the same bytes.
#[test]
fn a_killed_study_goes_on_and_loses_nothing() {
    let folder = TempDir::new().expect("a folder");
    let long = SPEEDS.replace("count = 40", "count = 400");
    let file = written(folder.path(), &long);
    let whole = folder.path().join("whole");
    assert!(study(&file, &whole, &[]).status.success());
    let killed = folder.path().join("killed");
    let mut child = begun(&file, &killed, 20_000);
    child.kill().expect("a process to kill");
    child.wait().expect("its end");
    assert!(!killed.join("small").join("runs.json").exists());
    let output = study(&file, &killed, &[]);
    assert!(output.status.success(), "{}", told(&output));
    assert!(
        told(&output).contains("going on behind"),
        "{}",
        told(&output)
    );
    assert_eq!(files(&whole.join("small")), files(&killed.join("small")));
}

/// A study that was changed after a kill does not go on from other runs; nothing is lost.
#[test]
fn a_changed_study_is_refused_until_it_is_to_begin_anew() {
    let folder = TempDir::new().expect("a folder");
    let file = written(folder.path(), SPEEDS);
    let rows = folder.path().join("small").join("runs.jsonl");
    fs::create_dir_all(rows.parent().expect("a folder")).expect("a folder");
    fs::write(&rows, b"no rows").expect("a file");
    let output = study(&file, folder.path(), &[]);
    assert_eq!(output.status.code(), Some(2));
    assert!(told(&output).contains("--restart"), "{}", told(&output));
    assert_eq!(fs::read(&rows).expect("the file"), b"no rows");
    let output = study(&file, folder.path(), &["--restart"]);
    assert!(output.status.success(), "{}", told(&output));
}

/// A run that fails is told with its error, alone gives the same one, and keeps no other from its end.
#[test]
fn failed_runs_are_recorded_and_made_alone() {
    let folder = TempDir::new().expect("a folder");
    // past 0.2 s nothing is left of the run after its settle time
    let axis = "[[axis]]\nkey = 'time.settle'\nvalues = ['0 s', '0.1 s', '0.6 s']\n";
    let file = written(folder.path(), axis);
    let output = study(&file, folder.path(), &[]);
    assert_eq!(output.status.code(), Some(1), "{}", told(&output));
    let rows = rows(&folder.path().join("small"));
    let status: Vec<_> = rows.iter().map(|row| &row[row.len() - 3]).collect();
    assert_eq!(status, ["done", "done", "failed"]);
    let error = rows[2][rows[2].len() - 2].to_owned();
    assert!(error.contains("settle"), "{error}");
    let alone = study(&file, folder.path(), &["--only", "2"]);
    assert_eq!(alone.status.code(), Some(1));
    assert!(told(&alone).contains(&error), "{}", told(&alone));
    let alone = study(&file, folder.path(), &["--only", "2", "--json"]);
    let alone: serde_json::Value = serde_json::from_slice(&alone.stdout).expect("JSON");
    let printed = alone["error"].as_str().expect("an error");
    assert_eq!(printed, format!("run 2: {error}"));
}

/// A run made alone is the run of the study.
#[test]
fn a_run_alone_is_that_of_the_study() {
    let folder = TempDir::new().expect("a folder");
    let file = written(folder.path(), SPEEDS);
    assert!(study(&file, folder.path(), &[]).status.success());
    let small = folder.path().join("small");
    let mut reader = csv::Reader::from_path(small.join("runs.csv")).expect("a table");
    let names = reader.headers().expect("names").clone();
    let column = |name: &str| {
        names
            .iter()
            .position(|known| known == name)
            .expect("a column")
    };
    let row = rows(&small).swap_remove(10);
    let output = study(&file, folder.path(), &["--only", "10"]);
    assert!(output.status.success(), "{}", told(&output));
    let summary = fs::read_to_string(small.join("run-10").join("summary.json")).expect("a file");
    let summary: serde_json::Value = serde_json::from_str(&summary).expect("JSON");
    let number = |name: &str| row[column(name)].parse::<f64>().expect("a number");
    assert_eq!(
        summary["counters"]["evaluations"].as_f64(),
        Some(number("evaluations"))
    );
    assert_eq!(
        summary["equilibrium"]["y_m"].as_f64(),
        Some(number("y_equilibrium_m"))
    );
    assert_eq!(
        summary["measured_error"]["relative"].as_f64(),
        Some(number("measured_error"))
    );
}

/// The bearings of a pair share stiffness and damping of the shaft, and stand in files of their own over the
/// speed: a table `BearingElement_…` of TOML, whose keys are those of ROSS's `BearingElement`.
#[test]
fn bearings_are_written_as_ross_reads_them() {
    let out = TempDir::new().expect("a folder");
    run_shipped("stiffness-7205c", "map.svg", out.path());
    let folder = out.path().join("stiffness-7205c");
    let [runs, stiffness] = ["runs.csv", "stiffness.csv"].map(|name| folder.join(name));
    let whole = column(&runs, "stiffness_x_N_m");
    let both = column(&stiffness, "kxx_N_m");
    let damping = column(&stiffness, "cxx_N_s_m");
    assert_eq!((whole.len(), both.len()), (30, 60));
    for (run, whole) in whole.iter().enumerate() {
        let sum = |entries: &[f64]| entries[2 * run] + entries[2 * run + 1];
        assert!((sum(&both) / whole - 1.0).abs() < 1e-12, "run {run}");
        // 2 ζ √(K m) with ζ = 0.02 and m = 5 kg
        let ratio = sum(&damping) / (2.0 * 0.02 * (whole * 5.0).sqrt());
        assert!((ratio - 1.0).abs() < 1e-12, "run {run}: {ratio}");
    }
    let map = fs::read_to_string(folder.join("map.svg")).expect("a figure");
    assert!(map.contains("stiffness z in N/µm"));
    // at 1600 rad/s the least preload holds the shaft less stiffly than at 100 rad/s
    assert!(whole[5] < 0.99 * whole[0], "{} {}", whole[0], whole[5]);
    for (bearing, place) in (1..=2).flat_map(|bearing| (1..=5).map(move |place| (bearing, place))) {
        let name = format!("ross_bearing_{bearing}_{place}.toml");
        let text = fs::read_to_string(folder.join(&name)).expect("a file of ROSS");
        assert!(text.contains("speed in rad/s, k in N/m"), "{text}");
        let tables: toml::Table = text.parse().expect("TOML");
        assert_eq!(tables.len(), 1, "{name}");
        let element = tables[&format!("BearingElement_bearing_{bearing}")]
            .as_table()
            .expect("a table");
        let known = [
            "n", "tag", "speed", "kxx", "kxy", "kyx", "kyy", "kzz", "cxx", "cxy", "cyx", "cyy",
            "czz",
        ];
        let mut keys: Vec<_> = element.keys().map(String::as_str).collect();
        let mut expected = known.to_vec();
        keys.sort_unstable();
        expected.sort_unstable();
        assert_eq!(keys, expected, "{name}");
        let list = |key: &str| -> Vec<f64> {
            let values = element[key].as_array().expect("a list");
            let numbers = values
                .iter()
                .map(|value| value.as_float().expect("a float"));
            numbers.collect()
        };
        assert_eq!(list("speed"), [100.0, 400.0, 700.0, 1000.0, 1300.0, 1600.0]);
        let rows = (0..6).map(|speed| 12 * (place - 1) + 2 * speed + bearing - 1);
        let expected: Vec<_> = rows.map(|row| both[row]).collect();
        assert_eq!(list("kxx"), expected, "{name}");
    }
}

/// Of the numbers that a study names, and of the measured error, the table of runs has a column.
#[test]
fn a_study_keeps_the_numbers_that_it_names() {
    let folder = TempDir::new().expect("a folder");
    let keep = "[keep]\nnumbers = ['x_rms_m', 'natural_frequency_1_Hz']\n";
    let file = written(folder.path(), &format!("{SPEEDS}{keep}"));
    let output = study(&file, folder.path(), &[]);
    assert!(output.status.success(), "{}", told(&output));
    let small = folder.path().join("small");
    let mut reader = csv::Reader::from_path(small.join("runs.csv")).expect("a table");
    let names: Vec<_> = reader
        .headers()
        .expect("names")
        .iter()
        .map(str::to_owned)
        .collect();
    let expected = [
        "run",
        "direction",
        "speed_constant_rad_s",
        "natural_frequency_1_Hz",
        "x_rms_m",
        "measured_error",
        "status",
        "error",
        "warnings",
    ];
    assert_eq!(names, expected);
    let figure = fs::read_to_string(small.join("response.svg")).expect("a figure");
    assert!(figure.contains("natural frequency 1 in Hz") && !figure.contains("ball load"));
}

/// Runs counted in ball passes last as many at every speed: each leaves as many points.
#[test]
fn runs_last_so_many_cycles_at_their_own_speed() {
    let folder = TempDir::new().expect("a folder");
    let base = scenarios().join("varying-compliance-6306.toml");
    let cycles = |of: &str, poincare: &str| {
        format!(
            "base = '{}'\nverify_every = 0\n[[axis]]\nkey = 'speed.constant'\n\
             values = ['50 rad/s', '100 rad/s', '330 rad/s']\n[cycles]\nof = '{of}'\nsettle = 20\n\
             kept = 40\n[keep]\nnumbers = ['x_rms_m']\npoincare = '{poincare}'\n",
            base.display()
        )
    };
    let file = folder.path().join("cycles.toml");
    // 8 balls roll past 3.0841 times a revolution
    let pass = 8.0 * 0.5 * (1.0 - 11.9062 / 52.0);
    for (of, order) in [("ball_pass", pass), ("revolution", 1.0)] {
        fs::write(&file, cycles(of, of)).expect("a writable folder");
        let output = study(&file, folder.path(), &["--restart"]);
        assert!(output.status.success(), "{}", told(&output));
        let table = folder.path().join("cycles").join("poincare.csv");
        let (runs, times) = (column(&table, "run"), column(&table, "t_s"));
        for (run, speed) in [50.0, 100.0, 330.0].into_iter().enumerate() {
            let own = runs.iter().zip(&times);
            let own: Vec<f64> = own
                .filter(|(number, _)| **number == run as f64)
                .map(|(_, time)| *time * speed * order / std::f64::consts::TAU)
                .collect();
            // whole revolutions are looked at, and the ends are between samples
            assert!((35..=41).contains(&own.len()), "{of}: {}", own.len());
            assert!(
                own.iter().all(|cycle| (20.0..60.1).contains(cycle)),
                "{own:?}"
            );
        }
    }
    // a run alone has the same times, and they stand in its summary
    let output = study(&file, folder.path(), &["--only", "2"]);
    assert!(output.status.success(), "{}", told(&output));
    let summary = folder.path().join("cycles/run-2/summary.json");
    let summary = fs::read_to_string(summary).expect("a summary");
    let summary: serde_json::Value = serde_json::from_str(&summary).expect("JSON");
    let duration = summary["scenario"]["time"]["duration"]
        .as_str()
        .expect("a time");
    let duration: f64 = duration.trim_end_matches(" s").parse().expect("a number");
    let expected = 60.0 * std::f64::consts::TAU / 330.0;
    assert!((duration / expected - 1.0).abs() < 1e-12, "{duration}");
}

const MASSES: &str = "
[[axis]]
key = 'shaft.mass'
values = ['5 kg', '6 kg']
";

/// Cycles of a scene that has none, or beside a time that is given as well, are refused.
#[test]
fn cycles_that_contradict_are_refused() {
    let folder = TempDir::new().expect("a folder");
    let cycles = |of: &str| format!("[cycles]\nof = '{of}'\nkept = 10\n");
    let set = "[[set]]\nkey = 'time.duration'\nvalue = '1 s'\n";
    for (base, text, reason) in [
        (
            "linear-7205c.toml",
            format!("{SPEEDS}{}", cycles("ball_pass")),
            "no rolling element passes here",
        ),
        (
            "linear-7205c.toml",
            format!("{SPEEDS}{set}{}", cycles("revolution")),
            "`cycles` decides `time.duration`",
        ),
        (
            "run-up-7205c.toml",
            format!("{MASSES}{}", cycles("revolution")),
            "a constant speed above zero",
        ),
    ] {
        let file = folder.path().join("cycles.toml");
        let base = scenarios().join(base);
        let text = format!("base = '{}'\n{text}", base.display());
        fs::write(&file, text).expect("a writable folder");
        let output = study(&file, folder.path(), &["--restart"]);
        assert_eq!(output.status.code(), Some(2), "{}", told(&output));
        assert!(told(&output).contains(reason), "{}", told(&output));
    }
}

/// A trace a run stands beside the tables, the same as of that run alone; those of an earlier study go.
#[test]
fn traces_are_kept_on_request() {
    let folder = TempDir::new().expect("a folder");
    let traced = format!(
        "{}[keep]\ntraces = true\n",
        SPEEDS.replace("count = 40", "count = 5")
    );
    let file = written(folder.path(), &traced);
    let traces = folder.path().join("small").join("traces");
    fs::create_dir_all(&traces).expect("a folder");
    fs::write(traces.join("trace-7.csv"), b"of an earlier study").expect("a file");
    fs::write(traces.join("mine.csv"), b"of the reader").expect("a file");
    for (part, there) in [("2/2", 3), ("1/2", 5)] {
        let output = study(&file, folder.path(), &["--shard", part]);
        assert!(output.status.success(), "{}", told(&output));
        let names = files(&traces).into_iter().map(|(name, _)| name);
        let names: Vec<_> = names.filter(|name| name != "mine.csv").collect();
        assert_eq!(names.len(), there, "{names:?}");
    }
    let output = study(&file, folder.path(), &["--only", "3"]);
    assert!(output.status.success(), "{}", told(&output));
    let alone = folder.path().join("small").join("run-3").join("trace.csv");
    let [kept, alone] =
        [traces.join("trace-3.csv"), alone].map(|path| fs::read(path).expect("a trace"));
    assert!(kept == alone);
}

/// Static questions are asked in parts as in one piece; what has no answer keeps no other from its own. The JSON that is
/// printed is that of the file.
#[test]
fn static_questions_make_tables_figures_and_parts() {
    let folder = TempDir::new().expect("a folder");
    let base = scenarios().join("seed/shaft.toml");
    let file = folder.path().join("small.toml");
    let text = format!(
        "base = '{}'\nask = 'bearing'\n[[axis]]\nkey = 'load[1].constant.z'\n\
         values = ['200 N', '1 kN', '500 MN']\n[keep]\npositions = 16\n",
        base.display()
    );
    fs::write(&file, text).expect("a writable folder");
    let whole = folder.path().join("whole");
    let output = study(&file, &whole, &["--json"]);
    assert_eq!(output.status.code(), Some(1), "{}", told(&output));
    let whole = whole.join("small");
    let mut printed: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert!(printed["files"].is_array());
    printed.as_object_mut().expect("a document").remove("files");
    let sealed = fs::read(whole.join("runs.json")).expect("a file");
    let sealed: serde_json::Value = serde_json::from_slice(&sealed).expect("JSON");
    assert_eq!(printed, sealed);
    let written = files(&whole).into_iter().map(|(name, _)| name);
    let written: Vec<_> = written.filter(|name| name != "response.svg").collect();
    let expected = [
        "around.csv",
        "contact_angle.svg",
        "deformation.svg",
        "report.html",
        "runs.csv",
        "runs.json",
        "stiffness.svg",
    ];
    assert_eq!(written, expected);
    assert_eq!(column(&whole.join("around.csv"), "run").len(), 2 * 16);
    let error = &rows(&whole)[2];
    assert!(
        error[error.len() - 2].contains("no static equilibrium"),
        "{error:?}"
    );
    for part in ["2/2", "1/2"] {
        let output = study(&file, folder.path(), &["--shard", part]);
        assert!(output.status.success(), "{}", told(&output));
    }
    let parts = folder.path().join("small");
    assert_eq!(merge(&parts).status.code(), Some(1));
    assert_same_files(&whole, &parts);
    let output = study(&file, folder.path(), &["--only", "1"]);
    assert!(output.status.success(), "{}", told(&output));
    assert!(parts.join("run-1/bearing.json").exists());
}

// Bad input.

/// Wrong studies are refused before a run begins, with what to do.
#[test]
fn wrong_studies_are_refused_with_a_word_on_what_to_do() {
    let folder = TempDir::new().expect("a folder");
    for (text, message) in [
        (
            "[[axis]]\nkey = 'speed.constnt'\nvalues = ['1 rad/s']\n",
            "did you mean `speed.constant`?",
        ),
        ("[[axis]]\nkey = 'speed.constant'\nvalues = []\n", "values"),
        ("axis = []\n", "axis"),
        (
            "[[axis]]\nkey = 'speed.constant'\nfrom = '1 rad/s'\nto = '2 rad/s'\ncount = 100000\n\
             [[axis]]\nkey = 'shaft.mass'\nfrom = '1 kg'\nto = '2 kg'\ncount = 100000\n",
            "at most 1e9 in a study",
        ),
        (
            "sampling = 'sobol'\nruns = 4\n[[axis]]\nkey = 'shaft.mass'\ndistribution = 'normal'\n\
             mean = '1 kg'\ndeviation = '1 kg'\n",
            "needs `lowest` here",
        ),
        (
            "[[axis]]\nkey = 'shaft.mass'\ndistribution = 'uniform'\nfrom = '1 kg'\nto = '2 kg'\n",
            "a distribution has no values for a grid",
        ),
        (
            "sampling = 'monte_carlo'\n[[axis]]\nkey = 'shaft.mass'\nvalues = ['1 kg']\n",
            "runs that are drawn need a number of them",
        ),
        ("[[axis]]\nkey = 'shaft.mass'\nvalues = ['1 m']\n", "values"),
        (
            "[[axis]]\nkey = 'shaft.mass'\nvalues = ['1 kg']\n[keep]\nnumbers = ['x_rms']\n",
            "did you mean `x_rms_m`?",
        ),
        (
            "[[axis]]\nkey = 'shaft.mass'\nvalues = ['1 kg']\n[[set]]\nkey = 'model.contact'\nvalue = 'jonas'\n",
            "jones",
        ),
        (
            "[[axis]]\nkey = 'model.contact'\nvalues = ['jonas']\n",
            "jones",
        ),
        (
            "[[axis]]\nkey = 'shaft.mass'\nvalues = ['1 kg']\n[[set]]\nkey = 'shaft.mass'\nvalue = '2 kg'\n",
            "`shaft.mass` changes along an axis, and the value here has no effect",
        ),
        (
            "[[axis]]\nkey = 'shaft.mass'\nvalues = ['1 kg']\n[[set]]\nkey = 'speed.constant'\nvalue = '2 rad/s'\n\
             [[set]]\nkey = 'speed.constant'\nvalue = '3 rad/s'\n",
            "`speed.constant` is set already",
        ),
        (
            "sampling = 'sobol'\nruns = 4\nsweep = 'up'\n[[axis]]\nkey = 'shaft.mass'\nvalues = ['1 kg']\n",
            "no neighbours",
        ),
    ] {
        let file = written(folder.path(), text);
        let output = study(&file, folder.path(), &[]);
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert!(told(&output).contains(message), "{text}\n{}", told(&output));
        assert!(!folder.path().join("small").exists(), "{text}");
    }
    let missing = folder.path().join("missing.toml");
    fs::write(
        &missing,
        "base = 'none.toml'\n[[axis]]\nkey = 'x'\nvalues = [1]\n",
    )
    .expect("a file");
    let output = study(&missing, folder.path(), &[]);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        told(&output).contains("there is no scenario"),
        "{}",
        told(&output)
    );
}

/// What cannot be written is said at once.
#[test]
fn a_folder_that_cannot_be_written_is_told() {
    let folder = TempDir::new().expect("a folder");
    let file = written(folder.path(), SPEEDS);
    let taken = folder.path().join("taken");
    fs::write(&taken, b"a file").expect("a file");
    let output = study(&file, &taken, &[]);
    assert_eq!(output.status.code(), Some(1));
    assert!(told(&output).contains("cannot create"), "{}", told(&output));
}

/// Runs a study whose files may have so many kilobytes, as on a disk that is full then.
#[cfg(unix)]
fn study_on_small_disk(file: &Path, out: &Path, kilobytes: u32) -> Output {
    // what is too large is refused instead of ending the process
    let script = format!("trap '' XFSZ; ulimit -f {kilobytes}; exec \"$@\"");
    Command::new("bash")
        .args(["-c", &script, "bash", PROGRAM, "study"])
        .arg(file)
        .arg("--out")
        .arg(out)
        .output()
        .expect("the command starts")
}

/// On a full disk the runs that are done stay; with room again the study goes on from them to the same bytes.
#[cfg(unix)]
#[test]
fn a_full_disk_is_told_and_loses_nothing() {
    let folder = TempDir::new().expect("a folder");
    let whole = folder.path().join("whole");
    for (name, keep, room, told_file) in [
        ("rows", "", 16, "runs.jsonl"),
        ("head", "", 1, "runs.jsonl"),
        // rows of three numbers are small, a trace is not
        (
            "traces",
            "[keep]\nnumbers = ['x_rms_m']\ntraces = true\n",
            60,
            "trace-",
        ),
    ] {
        let file = written(folder.path(), &format!("{SPEEDS}{keep}"));
        let out = folder.path().join(name);
        let output = study_on_small_disk(&file, &out, room);
        assert_eq!(output.status.code(), Some(1), "{name}: {}", told(&output));
        let message = told(&output);
        assert!(message.contains("cannot write"), "{message}");
        assert!(message.contains(told_file), "{name}: {message}");
        assert!(!out.join("small").join("runs.json").exists(), "{name}");
        let output = study(&file, &out, &[]);
        assert!(output.status.success(), "{name}: {}", told(&output));
        if name == "rows" {
            assert!(
                told(&output).contains("going on behind"),
                "{}",
                told(&output)
            );
        }
        assert!(study(&file, &whole, &["--restart"]).status.success());
        let [whole, out] = [&whole, &out].map(|folder| files(&folder.join("small")));
        assert!(whole == out, "{name}");
    }
}

/// A study that is being made is not made a second time in the same folder.
#[test]
fn two_processes_do_not_make_the_same_runs() {
    let folder = TempDir::new().expect("a folder");
    let file = written(folder.path(), &SPEEDS.replace("count = 40", "count = 4000"));
    let mut first = begun(&file, folder.path(), 10_000);
    let second = study(&file, folder.path(), &["--restart"]);
    first.kill().expect("a process to kill");
    first.wait().expect("its end");
    assert_eq!(second.status.code(), Some(1));
    assert!(
        told(&second).contains("another process"),
        "{}",
        told(&second)
    );
}

/// A missing part is named; parts of different studies do not go together.
#[test]
fn parts_that_make_no_whole_are_refused() {
    let folder = TempDir::new().expect("a folder");
    let file = written(folder.path(), SPEEDS);
    let merge = || merge(&folder.path().join("small"));
    assert!(
        study(&file, folder.path(), &["--shard", "1/2"])
            .status
            .success()
    );
    let output = merge();
    assert_eq!(output.status.code(), Some(2));
    assert!(
        told(&output).contains("1 of 2 parts are missing: 2"),
        "{}",
        told(&output)
    );
    let other = written(folder.path(), &format!("seed = 3\n{SPEEDS}"));
    assert!(
        study(&other, folder.path(), &["--shard", "2/2"])
            .status
            .success()
    );
    let output = merge();
    assert_eq!(output.status.code(), Some(2));
    assert!(told(&output).contains("study.seed"), "{}", told(&output));
}

/// A trace that was lost or cut off on its way to the other parts is named with its run.
#[test]
fn parts_whose_traces_are_not_whole_are_refused() {
    let folder = TempDir::new().expect("a folder");
    let traced = format!(
        "{}[keep]\nnumbers = ['x_rms_m']\ntraces = true\n",
        SPEEDS.replace("count = 40", "count = 4")
    );
    let file = written(folder.path(), &traced);
    for part in ["1/2", "2/2"] {
        let output = study(&file, folder.path(), &["--shard", part]);
        assert!(output.status.success(), "{}", told(&output));
    }
    let small = folder.path().join("small");
    let trace = small.join("traces").join("trace-2.csv");
    let whole = fs::read(&trace).expect("a trace");
    let mut changed = whole.clone();
    changed[whole.len() / 2] ^= 1;
    let cut = whole[..whole.len() - 7].to_vec();
    for (bytes, reason) in [
        (None, "it is missing"),
        (Some(cut), "bytes"),
        (Some(changed), "it is not what the run wrote"),
    ] {
        match bytes {
            None => fs::remove_file(&trace).expect("a trace"),
            Some(bytes) => fs::write(&trace, bytes).expect("a writable folder"),
        }
        let output = merge(&small);
        assert_eq!(output.status.code(), Some(2));
        let told = told(&output);
        assert!(
            told.contains("run 2 has a trace") && told.contains(reason),
            "{told}"
        );
        assert!(!small.join("runs.json").exists());
    }
    fs::write(&trace, whole).expect("a writable folder");
    done(merge(&small));
    // each trace is named in the table of them
    let table = fs::read_to_string(small.join("traces.csv")).expect("a table");
    assert_eq!(table.lines().count(), 5, "{table}");
}

/// The schema that editors read is that of the program.
#[test]
fn the_schema_of_studies_is_up_to_date() {
    let output = jeffcott().args(["schema", "--study"]).output();
    let output = output.expect("the command starts");
    let kept = fs::read(scenarios().join("study.schema.json")).expect("the schema");
    assert!(
        kept == output.stdout,
        "run `jeffcott schema --study > scenarios/study.schema.json`"
    );
}

#[test]
fn an_axis_changes_several_keys_together() {
    let base = scenarios().join("back-to-back-7205c.toml");
    let stiffness = |key: &str| {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("together.toml");
        let text = format!(
            "base = '{}'\nverify_every = 0\n[[axis]]\nkey = {key}\nvalues = ['200 N', '400 N']\n\
             [[set]]\nkey = ['time.settle', 'initial.velocity.x']\nvalue = '0.01 s'\n",
            base.display()
        );
        // settle time and duration measure the same, a velocity does not
        fs::write(&file, &text).expect("a writable folder");
        let refused = told(&study(&file, folder.path(), &[]));
        assert!(refused.contains("cannot have one value"), "{refused}");
        let times = "[[set]]\nkey = 'time.settle'\nvalue = '0.01 s'\n\
                     [[set]]\nkey = 'time.duration'\nvalue = '0.03 s'\n";
        let (axes, _) = text.split_once("[[set]]").expect("a table");
        fs::write(&file, format!("{axes}{times}")).expect("a writable folder");
        done(study(&file, folder.path(), &[]));
        let runs = folder.path().join("together/runs.csv");
        column(&runs, "stiffness_z_N_m")
    };
    let both = stiffness("'bearing[*].preload'");
    let listed = stiffness("['bearing[1].preload', 'bearing[2].preload']");
    let first = stiffness("'bearing[1].preload'");
    assert_eq!(both, listed);
    assert_eq!(both[0], first[0]);
    assert!(
        both[1] > first[1] && first[1] > first[0],
        "{both:?} {first:?}"
    );
}

/// A key that varies and a number of the answer have columns of their own, also where both are a preload or a rating.
#[test]
fn columns_of_keys_and_of_answers_are_apart() {
    let folder = TempDir::new().expect("a folder");
    let base = scenarios().join("arrangement-7205c.toml");
    let axis = |key: &str, from: &str, to: &str| {
        format!("[[axis]]\nkey = 'bearing[*].{key}'\nfrom = '{from}'\nto = '{to}'\ncount = 2\n")
    };
    let axes = axis("preload", "100 N", "200 N") + &axis("dynamic_rating", "15 kN", "16 kN");
    let file = folder.path().join("apart.toml");
    fs::write(
        &file,
        format!("base = '{}'\nask = 'bearing'\n{axes}", base.display()),
    )
    .expect("a writable folder");
    done(study(&file, folder.path(), &[]));
    let table = fs::read_to_string(folder.path().join("apart/runs.csv")).expect("a table");
    let head: Vec<&str> = table.lines().next().expect("a head").split(',').collect();
    let mut names = head.clone();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), head.len(), "{head:?}");
}
