//! The tables of a run in other formats, thinned, and with chosen columns.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use tempfile::TempDir;

use crate::support::{SHORT_VARYING_COMPLIANCE, changed, done, jeffcott_in, json, shipped, told};

/// A folder with a short scenario in it: bearings that lose contact.
fn scene(output: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let name = "varying-compliance-6306";
    let file = changed(folder.path(), name, &SHORT_VARYING_COMPLIANCE);
    let text = fs::read_to_string(&file).unwrap();
    let (before, _) = text.split_once("[output]").unwrap_or((&text, ""));
    let scene = folder.path().join("scene.toml");
    fs::write(scene, format!("{before}\n[output]\n{output}\n")).unwrap();
    folder
}

fn jeffcott(folder: &TempDir, arguments: &[&str]) -> Output {
    jeffcott_in(folder, arguments)
}

#[track_caller]
fn run(folder: &TempDir, arguments: &[&str]) {
    let arguments = [&["run", "scene.toml", "--no-verify"], arguments].concat();
    done(jeffcott(folder, &arguments));
}

fn result(folder: &TempDir, name: &str) -> PathBuf {
    folder.path().join("output/scene").join(name)
}

/// Rows of a CSV file, cell by cell, the header first.
fn rows(path: &Path) -> Vec<Vec<String>> {
    let text = fs::read_to_string(path).unwrap();
    let row = |line: &str| line.split(',').map(str::to_owned).collect();
    text.lines().map(row).collect()
}

#[test]
fn one_of_every_so_many_samples_is_the_same_sample() {
    let folder = scene("balls = true");
    run(&folder, &[]);
    let names = ["trace.csv", "trace_balls.csv"];
    let full = names.map(|name| rows(&result(&folder, name)));
    let spectrum = fs::read(result(&folder, "spectrum.csv")).unwrap();
    run(&folder, &["--every", "7"]);
    for (name, full) in names.iter().zip(full) {
        let kept: Vec<_> = full[1..].iter().step_by(7).cloned().collect();
        assert!(rows(&result(&folder, name))[1..] == kept, "{name}");
    }
    assert!(fs::read(result(&folder, "spectrum.csv")).unwrap() == spectrum);
    let summary = json(&result(&folder, "summary.json"));
    assert_eq!(summary["scenario"]["output"]["every"], 7);
}

#[test]
fn chosen_channels_stand_behind_the_time_in_their_order() {
    let folder = scene("channels = [\"force_y\", \"x\"]");
    run(&folder, &[]);
    assert_eq!(
        rows(&result(&folder, "trace.csv"))[0],
        ["t_s", "force_y_N", "x_m"]
    );
    let by_key = fs::read(result(&folder, "trace.csv")).unwrap();
    run(&folder, &["--channels", "y,balls_loaded"]);
    assert_eq!(
        rows(&result(&folder, "trace.csv"))[0],
        ["t_s", "y_m", "balls_loaded"]
    );
    run(&folder, &["--channels", "force_y,x"]);
    assert!(fs::read(result(&folder, "trace.csv")).unwrap() == by_key);
    let output = jeffcott(&folder, &["run", "scene.toml", "--channels", "fx"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(told(&output).contains("force_x"));
}

#[test]
fn accelerations_stand_in_the_trace_where_asked_for() {
    let folder = scene("");
    run(&folder, &["--channels", "x_velocity,x_acceleration"]);
    let rows = rows(&result(&folder, "trace.csv"));
    assert_eq!(rows[0], ["t_s", "x_velocity_m_s", "x_acceleration_m_s2"]);
    let values = |column: usize| -> Vec<f64> {
        let cells = rows[1..].iter().map(|row| row[column].parse());
        cells.map(|cell| cell.expect("a number")).collect()
    };
    let [time, velocity, acceleration] = [0, 1, 2].map(values);
    let largest = acceleration.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
    // the trapezoid of the one is the change of the other
    for n in 1..time.len() {
        let interval = time[n] - time[n - 1];
        let mean = 0.5 * (acceleration[n] + acceleration[n - 1]);
        let change = velocity[n] - velocity[n - 1];
        assert!(
            (mean * interval - change).abs() < 0.02 * interval * largest,
            "row {n}"
        );
    }
}

#[test]
fn what_a_linear_bearing_does_not_know_is_missing() {
    let folder = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(shipped("linear-7205c")).unwrap();
    fs::write(folder.path().join("scene.toml"), text).unwrap();
    run(&folder, &["--channels", "x,largest_ball_load,balls_loaded"]);
    let rows = rows(&result(&folder, "trace.csv"));
    assert!(rows.len() > 100);
    for row in &rows[1..] {
        assert!(row[1].parse::<f64>().is_ok());
        assert_eq!(row[2..], ["", ""]);
    }
    done(jeffcott(
        &folder,
        &["compare", "output/scene", "output/scene"],
    ));
}

#[test]
fn a_table_for_matlab_is_answered_with_its_formats() {
    let folder = scene("formats = [\"mat\"]");
    for arguments in [
        &["run", "scene.toml"][..],
        &["run", "scene.toml", "--format", "mat"],
    ] {
        let output = jeffcott(&folder, arguments);
        assert_eq!(output.status.code(), Some(2));
        assert!(
            told(&output).contains("MATLAB reads CSV by `readtable`"),
            "{}",
            told(&output)
        );
    }
}

#[cfg(not(feature = "parquet"))]
#[test]
fn a_build_without_parquet_says_so() {
    let folder = scene("formats = [\"parquet\"]");
    let output = jeffcott(&folder, &["run", "scene.toml"]);
    assert_eq!(output.status.code(), Some(2));
    let message = told(&output);
    assert!(message.contains("built without Parquet"), "{message}");
    assert!(message.contains("--features parquet"), "{message}");
}

#[cfg(feature = "parquet")]
mod parquet_files {
    use super::*;
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;

    #[test]
    fn tables_of_another_format_do_not_outlive_a_run() {
        let folder = scene("");
        run(&folder, &["--format", "parquet"]);
        assert!(
            result(&folder, "trace.parquet").exists() && !result(&folder, "trace.csv").exists()
        );
        let parquet = fs::read(result(&folder, "trace.parquet")).unwrap();
        run(&folder, &["--format", "parquet"]);
        assert!(fs::read(result(&folder, "trace.parquet")).unwrap() == parquet);
        run(&folder, &[]);
        assert!(
            !result(&folder, "trace.parquet").exists() && result(&folder, "trace.csv").exists()
        );
        let hidden = fs::read_dir(result(&folder, "")).unwrap();
        let hidden = hidden.filter(|entry| {
            let name = entry.as_ref().unwrap().file_name();
            name.to_string_lossy().starts_with('.')
        });
        assert_eq!(hidden.count(), 0);
    }

    #[test]
    fn they_hold_the_cells_of_the_csv() {
        let folder = scene("balls = true\nformats = [\"csv\", \"parquet\"]");
        run(&folder, &[]);
        for stem in ["trace", "trace_balls", "events", "spectrum"] {
            let csv = rows(&result(&folder, &format!("{stem}.csv")));
            let file = fs::File::open(result(&folder, &format!("{stem}.parquet"))).unwrap();
            let reader = SerializedFileReader::new(file).unwrap();
            let read = reader.get_row_iter(None).unwrap();
            let mut count = 0;
            for (row, written) in read.zip(&csv[1..]) {
                let cells: Vec<String> = row.unwrap().get_column_iter().map(cell).collect();
                let same = |(cell, written): (&String, &String)| {
                    cell == written || cell.parse::<f64>() == written.parse::<f64>()
                };
                assert!(
                    cells.iter().zip(written).all(same),
                    "{stem}: {cells:?} {written:?}"
                );
                count += 1;
            }
            assert_eq!(count, csv.len() - 1, "{stem}");
            let metadata = reader
                .metadata()
                .file_metadata()
                .key_value_metadata()
                .unwrap();
            let version = metadata
                .iter()
                .find(|entry| entry.key == "jeffcott_version")
                .unwrap();
            assert_eq!(version.value.as_deref(), Some(env!("CARGO_PKG_VERSION")));
        }
    }

    fn cell((_, field): (&String, &Field)) -> String {
        match field {
            Field::Null => String::new(),
            Field::Str(word) => word.clone(),
            Field::Int(number) => number.to_string(),
            Field::Double(number) => format!("{number:e}"),
            other => panic!("{other:?}"),
        }
    }
}
