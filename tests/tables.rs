//! The tables of a run in other formats, thinned, and with chosen columns.

#![allow(clippy::unwrap_used)] // a test that cannot go on fails

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use jeffcott::report::{Column, ColumnKind, MatTable, Origin};
use matfile::{MatFile, NumericData};
use tempfile::TempDir;

/// A folder with a short scenario in it: bearings that lose contact.
fn scene(output: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let shipped =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios/varying-compliance-6306.toml");
    let text = fs::read_to_string(shipped).unwrap();
    let (before, _) = text.split_once("[output]").unwrap_or((&text, ""));
    fs::write(
        folder.path().join("scene.toml"),
        format!("{before}\n[output]\n{output}\n"),
    )
    .unwrap();
    folder
}

fn jeffcott(folder: &TempDir, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_jeffcott"));
    command.args(arguments).current_dir(folder);
    command.output().unwrap()
}

#[track_caller]
fn run(folder: &TempDir, arguments: &[&str]) {
    let output = jeffcott(
        folder,
        &[&["run", "scene.toml", "--no-verify"], arguments].concat(),
    );
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{message}");
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

/// Numeric variables of a MAT-file by name.
fn numbers(path: &Path) -> BTreeMap<String, Vec<f64>> {
    let mat = MatFile::parse(fs::File::open(path).unwrap()).unwrap();
    let arrays = mat.arrays().iter().filter_map(|array| match array.data() {
        NumericData::Double { real, .. } => Some((array.name().to_owned(), real.clone())),
        _ => None,
    });
    arrays.collect()
}

#[test]
fn mat_files_hold_the_numbers_of_the_csv_bit_by_bit() {
    let folder = scene("balls = true\nenergy = true\nformats = [\"csv\", \"mat\"]");
    run(&folder, &[]);
    for stem in ["trace", "trace_balls", "energy", "events", "spectrum"] {
        let csv = rows(&result(&folder, &format!("{stem}.csv")));
        let mat = numbers(&result(&folder, &format!("{stem}.mat")));
        assert_eq!(mat.len(), csv[0].len(), "{stem}");
        for (place, name) in csv[0]
            .iter()
            .enumerate()
            .filter(|(_, name)| *name != "event")
        {
            let cell = |row: &Vec<String>| row[place].parse().unwrap_or(f64::NAN);
            let written: Vec<u64> = csv[1..].iter().map(cell).map(f64::to_bits).collect();
            let read: Vec<u64> = mat[name].iter().map(|number| number.to_bits()).collect();
            assert!(written == read, "{name} of {stem}");
        }
    }
}

#[test]
fn a_mat_file_of_many_blocks_is_put_together_in_order() {
    let folder = tempfile::tempdir().unwrap();
    let columns = [
        Column::number("t"),
        Column::number("x_m"),
        Column::of("n", ColumnKind::Count),
    ];
    let origin = Origin {
        scenario: "{}".to_owned(),
    };
    for count in [0u32, 1, 8191, 8192, 8193, 20_000] {
        let scratch = folder.path().join("rows");
        let mut table = MatTable::new(Vec::new(), &columns, &origin, &scratch).unwrap();
        for row in 0..count {
            let row = f64::from(row);
            table.row(&[row, row.sqrt(), row % 3.0]).unwrap();
        }
        let bytes = table.finish().unwrap();
        assert!(!scratch.exists());
        assert_eq!(bytes.len() % 8, 0);
        if count == 0 {
            continue; // the reader knows no empty matrix
        }
        let mat = MatFile::parse(&bytes[..]).unwrap();
        let x = mat.find_by_name("x_m").unwrap();
        assert_eq!(x.size(), &vec![count as usize, 1]);
        let NumericData::Double { real, .. } = x.data() else {
            panic!("{:?}", x.data());
        };
        let expected: Vec<f64> = (0..count).map(|row| f64::from(row).sqrt()).collect();
        assert!(*real == expected);
    }
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
    let summary = fs::read_to_string(result(&folder, "summary.json")).unwrap();
    let summary: serde_json::Value = summary.parse().unwrap();
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
    assert!(String::from_utf8_lossy(&output.stderr).contains("force_x"));
}

#[test]
fn tables_of_another_format_do_not_outlive_a_run() {
    let folder = scene("");
    run(&folder, &["--format", "mat"]);
    assert!(result(&folder, "trace.mat").exists() && !result(&folder, "trace.csv").exists());
    let mat = fs::read(result(&folder, "trace.mat")).unwrap();
    run(&folder, &["--format", "mat"]);
    assert!(fs::read(result(&folder, "trace.mat")).unwrap() == mat);
    run(&folder, &[]);
    assert!(!result(&folder, "trace.mat").exists() && result(&folder, "trace.csv").exists());
    let hidden = fs::read_dir(result(&folder, "")).unwrap();
    let hidden = hidden.filter(|entry| {
        let name = entry.as_ref().unwrap().file_name();
        name.to_string_lossy().starts_with('.')
    });
    assert_eq!(hidden.count(), 0);
}

#[test]
fn a_resumed_run_writes_what_is_asked_for_when_it_goes_on() {
    let folder = scene("");
    let written = ["--every", "3", "--channels", "x", "--format", "csv,mat"];
    run(&folder, &written);
    let names = ["trace.csv", "trace.mat", "spectrum.csv", "summary.json"];
    let whole = names.map(|name| fs::read(result(&folder, name)).unwrap());
    run(&folder, &["--stop-at", "0.05 s"]);
    run(&folder, &[&written[..], &["--resume"]].concat());
    for (name, whole) in names.iter().zip(whole) {
        assert!(fs::read(result(&folder, name)).unwrap() == whole, "{name}");
    }
}

#[test]
fn the_command_that_goes_on_repeats_what_is_written() {
    let folder = scene("");
    let arguments = [
        "run",
        "scene.toml",
        "--stop-at",
        "0.05 s",
        "--every",
        "3",
        "--channels",
        "x",
    ];
    let output = jeffcott(&folder, &arguments);
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(
        message.contains("--every 3 --channels x --resume"),
        "{message}"
    );
}

#[cfg(not(feature = "parquet"))]
#[test]
fn a_build_without_parquet_says_so() {
    let folder = scene("formats = [\"parquet\"]");
    let output = jeffcott(&folder, &["run", "scene.toml"]);
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(message.contains("built without Parquet"), "{message}");
    assert!(message.contains("--features parquet"), "{message}");
}

#[cfg(feature = "parquet")]
mod parquet_files {
    use super::*;
    use jeffcott::report::ParquetTable;
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;

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

    #[test]
    fn row_groups_follow_each_other_and_the_same_rows_give_the_same_bytes() {
        let columns: Vec<Column> = (0..64).map(|n| Column::number(format!("c{n}"))).collect();
        let origin = Origin {
            scenario: "{}".to_owned(),
        };
        let write = || {
            let mut table = ParquetTable::new(Vec::new(), &columns, &origin).unwrap();
            for row in 0..40_000 {
                table.row(&[f64::from(row); 64]).unwrap();
            }
            table.finish().unwrap()
        };
        let bytes = write();
        assert!(bytes == write());
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("table.parquet");
        fs::write(&path, bytes).unwrap();
        let reader = SerializedFileReader::new(fs::File::open(path).unwrap()).unwrap();
        assert_eq!(reader.metadata().num_row_groups(), 3);
        let rows = reader.get_row_iter(None).unwrap().enumerate();
        for (number, row) in rows {
            let row = row.unwrap();
            let (_, last) = row.get_column_iter().last().unwrap();
            assert_eq!(*last, Field::Double(number as f64));
        }
    }
}
