//! `jeffcott compare`: what agrees, what differs, what cannot be compared.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Output, Stdio};

use jeffcott::report::compare::{Comparison, Rules, Tolerance, Tolerances, compare};
use tempfile::TempDir;

use crate::support::jeffcott;

const TRACE: &str = "t_s,x_m\n0.0,0.0\n0.1,2e-6\n0.2,-1e-6\n";
const SPECTRUM: &str = "f_Hz,x_amplitude_m,x_phase_rad\n1.0,1e-6,3.14159\n2.0,1e-14,0.3\n";

fn files(first: &str, second: &str) -> (TempDir, PathBuf, PathBuf) {
    let folder = TempDir::new().unwrap();
    let paths = ["a.csv", "b.csv"].map(|name| folder.path().join(name));
    fs::write(&paths[0], first).unwrap();
    fs::write(&paths[1], second).unwrap();
    let [first, second] = paths;
    (folder, first, second)
}

fn compared(first: &str, second: &str, relative: f64) -> Comparison {
    let (_folder, first, second) = files(first, second);
    let tolerances = Tolerances::uniform(Tolerance::new(relative, 0.0).unwrap());
    compare(&first, &second, &Rules::new(tolerances)).unwrap()
}

fn command(arguments: &[&Path], options: &[&str]) -> Output {
    let mut command = jeffcott();
    command.arg("compare").args(arguments).args(options);
    command.output().unwrap()
}

/// Exit code and both streams.
fn result(output: &Output) -> (i32, String) {
    let text = [output.stdout.as_slice(), output.stderr.as_slice()].concat();
    (
        output.status.code().unwrap(),
        String::from_utf8(text).unwrap(),
    )
}

#[test]
fn a_table_agrees_with_itself_exactly() {
    for text in [TRACE, SPECTRUM] {
        assert!(compared(text, text, 0.0).agrees());
    }
}

#[test]
fn the_tolerance_is_relative_to_the_largest_of_the_column() {
    let moved = TRACE
        .replace("0.1,2e-6", "0.1,2.0002e-6")
        .replace("0.0,0.0", "0.0,1e-10");
    assert!(compared(TRACE, &moved, 1.1e-4).agrees());
    let strict = compared(TRACE, &moved, 9e-5);
    let x = &strict.tables[0].columns[1];
    assert_eq!((x.column.name().as_str(), x.failures), ("x_m", 1));
    let worst = x.worst().unwrap();
    assert_eq!(
        (worst.row, worst.at, worst.first, worst.second),
        (2, 0.1, 2e-6, 2.0002e-6)
    );
}

#[test]
fn phases_agree_modulo_a_turn_and_where_there_is_nothing() {
    let turned = SPECTRUM
        .replace("3.14159", "-3.141595")
        .replace("0.3\n", "-2.0\n");
    assert!(compared(SPECTRUM, &turned, 1e-5).agrees());
    let other = SPECTRUM.replace("3.14159", "3.13");
    let comparison = compared(SPECTRUM, &other, 1e-5);
    assert_eq!(comparison.tables[0].columns[2].failures, 1);
}

#[test]
fn nan_agrees_with_nan_only_and_infinity_with_itself() {
    let with = |value: &str| TRACE.replace("-1e-6", value);
    assert!(compared(&with("NaN"), &with("NaN"), 0.0).agrees());
    assert!(compared(&with("inf"), &with("inf"), 0.0).agrees());
    for (a, b) in [
        ("NaN", "1"),
        ("inf", "-inf"),
        ("inf", "1e300"),
        ("NaN", "inf"),
    ] {
        assert!(!compared(&with(a), &with(b), 1.0).agrees(), "{a} {b}");
        assert!(!compared(&with(b), &with(a), 1.0).agrees(), "{b} {a}");
    }
}

#[test]
fn rows_columns_and_axes_that_do_not_match_are_named() {
    let message = |second: &str| {
        let comparison = compared(TRACE, second, 1e-6);
        assert!(!comparison.agrees());
        comparison.tables[0].differences[0].to_string()
    };
    let shorter = TRACE.replace("0.2,-1e-6\n", "");
    assert_eq!(
        message(&shorter),
        "3 rows against 2: the first 2 are compared"
    );
    let renamed = message(&TRACE.replace("x_m", "y_m"));
    assert!(renamed.contains("a.csv has the column x_m"), "{renamed}");
    let delayed = message(&TRACE.replace("0.1,", "0.11,"));
    assert!(delayed.starts_with("the axes t_s differ"), "{delayed}");
}

#[test]
fn the_order_of_columns_does_not_matter() {
    let swapped = "x_m,t_s\n0.0,0.0\n2e-6,0.1\n-1e-6,0.2\n";
    assert!(compared(TRACE, swapped, 0.0).agrees());
}

/// Words are equal or not; where one table has words and the other nothing, they are not.
#[test]
fn words_of_tables_are_compared_row_by_row() {
    let table = "run,direction,race,x_m\n0,alone,,1e-6\n1,up,,2e-6\n2,up,,3e-6\n";
    assert!(compared(table, table, 0.0).agrees());
    let differences = |second: &str| {
        let comparison = compared(table, second, 0.0);
        assert!(!comparison.agrees());
        let differences = &comparison.tables[0].differences;
        differences
            .iter()
            .map(ToString::to_string)
            .collect::<Vec<_>>()
    };
    let told = differences(
        &table
            .replace("up", "down")
            .replace("0,alone,,", "0,alone,inner,"),
    );
    assert_eq!(told.len(), 2, "{told:?}");
    assert!(
        told[0].contains("direction") && told[0].contains("row 2"),
        "{told:?}"
    );
    assert!(
        told[1].contains("race") && told[1].contains("row 1"),
        "{told:?}"
    );
    let told = differences(&table.replace("direction", "way"));
    assert!(
        told[0].ends_with("column direction") && told[1].ends_with("column way"),
        "{told:?}"
    );
}

#[test]
fn exit_codes_tell_equal_different_and_unusable() {
    let (folder, a, b) = files(TRACE, &TRACE.replace("2e-6", "3e-6"));
    assert_eq!(result(&command(&[&a, &a], &[])).0, 0);
    let (code, text) = result(&command(&[&a, &b], &[]));
    assert_eq!(code, 1);
    assert!(text.contains("x_m") && text.contains("1 row"), "{text}");
    assert_eq!(result(&command(&[&a, &b], &["--column", "x_m=0.5"])).0, 0);
    assert_eq!(result(&command(&[&a, &b], &["--absolute", "1e-6"])).0, 0);
    let missing = folder.path().join("missing.csv");
    let (code, text) = result(&command(&[&a, &missing], &[]));
    assert_eq!(code, 2);
    assert!(
        text.contains("cannot read") && text.contains("missing.csv"),
        "{text}"
    );
}

#[test]
fn what_cannot_be_compared_says_why() {
    let (folder, a, b) = files(TRACE, "t_s,x_m\n0.0,fast\n");
    let unusable = |arguments: &[&Path], options: &[&str], expected: &str| {
        let (code, text) = result(&command(arguments, options));
        assert_eq!(code, 2, "{text}");
        assert!(text.contains(expected), "{text}");
        assert!(!text.contains("panicked"), "{text}");
    };
    unusable(
        &[&a, &b],
        &[],
        "line 2, column \"x_m\": \"fast\" is not a number",
    );
    unusable(
        &[&a, &a],
        &["--relative", "-1"],
        "the relative tolerance is -1",
    );
    unusable(
        &[&a, &a],
        &["--absolute", "NaN"],
        "the absolute tolerance is NaN",
    );
    unusable(
        &[&a, &a],
        &["--column", "y_m=1"],
        "no table has a column \"y_m\"; there are: t_s, x_m",
    );
    unusable(&[&a, &a], &["--column", "x_m"], "expected NAME=R");
    unusable(
        &[&a, &a],
        &["--column", "x_m=1,-2"],
        "the absolute tolerance is -2",
    );
    unusable(&[&a, folder.path()], &[], "is a folder");
    unusable(&[folder.path(), Path::new("gone")], &[], "cannot read gone");
    unusable(
        &[folder.path(), folder.path()],
        &[],
        "holds a table to compare (trace.csv, spectrum.csv)",
    );
    for (content, expected) in [
        ("", "no rows of numbers"),
        ("method,kind\nhertz,alone\n", "no rows of numbers"),
        ("t_s,x_m\n", "no rows of numbers"),
        ("t_s,t_s\n1,2\n", "two columns named \"t_s\""),
        ("t_s,x_m\n1\n", "not a table"),
    ] {
        fs::write(&b, content).unwrap();
        unusable(&[&a, &b], &[], expected);
    }
    fs::write(&b, [0x74, 0xff, 0xfe, 0x0a]).unwrap();
    unusable(&[&a, &b], &[], "not a table");
}

#[test]
fn folders_are_compared_table_by_table() {
    let folder = TempDir::new().unwrap();
    let runs = ["old", "new"].map(|name| folder.path().join(name));
    for run in &runs {
        fs::create_dir(run).unwrap();
        fs::write(run.join("trace.csv"), TRACE).unwrap();
        fs::write(run.join("summary.json"), "{\"jeffcott\": \"0.2.0\"}").unwrap();
    }
    assert_eq!(result(&command(&[&runs[0], &runs[1]], &[])).0, 0);
    fs::write(runs[1].join("spectrum.csv"), SPECTRUM).unwrap();
    let (code, text) = result(&command(&[&runs[0], &runs[1]], &[]));
    assert_eq!(code, 1);
    assert!(text.contains("only one run has"), "{text}");
    assert!(text.contains("spectrum.csv"), "{text}");
}

#[test]
fn further_results_are_compared_with_the_first() {
    let (folder, a, b) = files(TRACE, &TRACE.replace("2e-6", "3e-6"));
    let page = folder.path().join("page.html");
    let options = ["--report", page.to_str().unwrap()];
    let (code, text) = result(&command(&[&a, &a, &b], &options));
    assert_eq!(code, 1, "{text}");
    let equal = text.find("equal within tolerance").unwrap();
    assert!(
        text[equal..].contains("different: most of all x_m"),
        "{text}"
    );
    assert!(fs::read_to_string(page).unwrap().contains("</html>"));
    assert_eq!(result(&command(&[&a, &a, &a], &[])).0, 0);
    let output = command(&[&a, &b, &a], &["--json"]);
    let value: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(
        [0, 1].map(|other| value[other]["agrees"] == true),
        [false, true]
    );
    let refused = result(&command(&[&a, &b, &a], &["--figure", "figure.svg"]));
    assert_eq!(refused.0, 2);
    assert!(
        refused.1.contains("--figure draws two results"),
        "{}",
        refused.1
    );
}

#[test]
fn json_carries_the_worst_place() {
    let (_folder, a, b) = files(TRACE, &TRACE.replace("2e-6", "3e-6"));
    let output = command(&[&a, &b], &["--json"]);
    let value: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(value["agrees"], false);
    let x = &value["tables"][0]["columns"][1];
    assert_eq!(x["name"], "x_m");
    assert_eq!(x["worst"]["row"], 2);
    assert_eq!(x["worst"]["second"], 3e-6);
}

#[test]
fn a_reader_that_goes_away_does_not_change_the_verdict() {
    let (_folder, a, b) = files(TRACE, &TRACE.replace("2e-6", "3e-6"));
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let mut command = jeffcott();
    command
        .arg("compare")
        .args([&a, &b])
        .stdout(writer)
        .stderr(Stdio::piped());
    let (code, text) = result(&command.output().unwrap());
    assert_eq!((code, text.as_str()), (1, ""));
}

#[test]
fn several_places_of_a_column_stand_worst_first() {
    let moved = TRACE
        .replace("0.0,0.0", "0.0,1e-7")
        .replace("0.1,2e-6", "0.1,2.3e-6");
    let (_folder, a, b) = files(TRACE, &moved);
    let rules = Rules {
        worst: 2,
        ..Rules::default()
    };
    let comparison = compare(&a, &b, &rules).unwrap();
    let x = &comparison.tables[0].columns[1];
    let rows: Vec<u64> = x.places.iter().map(|place| place.row).collect();
    assert_eq!((rows, x.failures), (vec![2, 1], 2));
}

#[test]
fn the_tolerance_that_is_advised_lets_the_column_agree() {
    let (_folder, a, b) = files(TRACE, &TRACE.replace("2e-6", "2.123457e-6"));
    let (code, text) = result(&command(&[&a, &b], &["--absolute", "1e-9"]));
    assert_eq!(code, 1, "{text}");
    let (_, advised) = text.split_once("--column ").unwrap();
    let advised = advised.split_whitespace().next().unwrap();
    assert!(advised.starts_with("x_m="), "{text}");
    assert_eq!(result(&command(&[&a, &b], &["--column", advised])).0, 0);
}

/// A trace of so many rows, of which one of every so many is kept.
fn thinned(rows: u32, every: u32) -> String {
    let kept = (0..rows).step_by(every as usize);
    let rows = kept.map(|row| format!("{},{}\n", f64::from(row) * 0.1, (row * row) % 7));
    "t_s,x_m\n".to_owned() + &rows.collect::<String>()
}

#[test]
fn a_thinned_trace_is_compared_at_its_own_times() {
    for (rows, every) in [(10, 3), (9, 3), (100, 7), (8, 4)] {
        let (full, part) = (thinned(rows, 1), thinned(rows, every));
        for (first, second) in [(&full, &part), (&part, &full)] {
            let strict = compared(first, second, 1e-6);
            assert!(
                strict.tables[0]
                    .columns
                    .iter()
                    .all(|column| column.agrees())
            );
            assert!(!strict.agrees());
            let message = strict.to_string();
            let held = format!("holds one of every {every} samples");
            assert!(
                message.contains(&held) && message.contains("--common"),
                "{message}"
            );
            let (_folder, a, b) = files(first, second);
            assert_eq!(result(&command(&[&a, &b], &["--common"])).0, 0);
        }
        let other = part.replacen(",0\n", ",5\n", 1);
        let (_folder, a, b) = files(&full, &other);
        assert_eq!(result(&command(&[&a, &b], &["--common"])).0, 1);
    }
}

#[test]
fn what_ends_early_is_not_taken_for_thinned() {
    let early: String = thinned(10, 1)
        .lines()
        .take(5)
        .map(|line| format!("{line}\n"))
        .collect();
    let (_folder, a, b) = files(&thinned(10, 1), &early);
    let (code, text) = result(&command(&[&a, &b], &["--common"]));
    assert_eq!(code, 1, "{text}");
    assert!(text.contains("10 rows against 4"), "{text}");
}

/// A spectrum of lines on an axis with a step.
fn lined(step: f64, lines: &[(f64, f64)]) -> String {
    let amplitude = |at: f64| {
        let near = lines.iter().find(|line| (line.0 - at).abs() < 0.5 * step);
        near.map_or(1e-12, |line| line.1)
    };
    let rows = (0..(100.0 / step) as u32).map(|row| {
        let at = f64::from(row) * step;
        format!("{at},{:e},0\n", amplitude(at))
    });
    "f_Hz,x_amplitude_m,x_phase_rad\n".to_owned() + &rows.collect::<String>()
}

/// A mean of 32 µm hides no line of 1 nm.
#[test]
fn lines_are_measured_by_lines_and_not_by_the_mean() {
    let with_line = |line: f64| lined(1.0, &[(0.0, 32e-6), (30.0, line), (60.0, 2e-10)]);
    let (_folder, a, b) = files(&with_line(1e-9), &with_line(1.03e-9));
    for options in [
        &["--relative", "0.01"][..],
        &["--relative", "0.01", "--lines"],
    ] {
        let (code, text) = result(&command(&[&a, &b], options));
        assert_eq!(code, 1, "{text}");
        assert!(text.contains("30"), "{text}");
    }
    assert_eq!(result(&command(&[&a, &b], &["--relative", "0.04"])).0, 0);
    // the mean is 3e-5 of itself apart
    let moved = lined(1.0, &[(0.0, 32.001e-6), (30.0, 1e-9), (60.0, 2e-10)]);
    let (_folder, a, b) = files(&with_line(1e-9), &moved);
    assert_eq!(result(&command(&[&a, &b], &["--relative", "1e-4"])).0, 0);
    assert_eq!(result(&command(&[&a, &b], &["--relative", "1e-5"])).0, 1);
}

#[test]
fn a_tolerance_of_values_is_none_of_their_places() {
    let spectrum = lined(1.0, &[(10.0, 1e-6)]);
    let stretched = lined(1.04, &[(10.4, 1e-6)]);
    let (_folder, a, b) = files(&spectrum, &stretched);
    let (code, text) = result(&command(&[&a, &b], &["--relative", "0.05"]));
    assert_eq!(code, 1, "{text}");
    assert!(text.contains("f_Hz"), "{text}");
    let own = ["--relative", "0.05", "--column", "f_Hz=0.05"];
    assert!(!result(&command(&[&a, &b], &own)).1.contains("axes"));
}

#[test]
fn lines_that_are_not_significant_have_numbers() {
    let spectrum = |y: &str| {
        format!("f_Hz,x_amplitude_m,y_amplitude_m\n0.0,0.0,0.0\n1.0,1e-6,{y}\n2.0,0.0,0.0\n")
    };
    let (_folder, a, b) = files(&spectrum("1e-19"), &spectrum("2e-19"));
    let (code, text) = result(&command(&[&a, &b], &["--lines", "--absolute", "1e-15"]));
    assert_eq!(code, 0, "{text}");
    assert!(text.contains("1e-19") && text.contains("2e-19"), "{text}");
}

#[test]
fn lines_are_matched_within_a_bin_of_the_coarser_axis() {
    let fine = lined(0.5, &[(10.0, 1e-6), (30.5, 5e-7), (70.0, 2e-7)]);
    let coarse = lined(2.0, &[(10.0, 1.001e-6), (32.0, 5e-7), (70.0, 2e-7)]);
    let (_folder, a, b) = files(&fine, &coarse);
    assert_eq!(result(&command(&[&a, &b], &["--relative", "1e-2"])).0, 1);
    assert_eq!(
        result(&command(&[&a, &b], &["--relative", "1e-2", "--lines"])).0,
        0
    );
    let (code, text) = result(&command(&[&a, &b], &["--relative", "1e-4", "--lines=1"]));
    assert_eq!(code, 1, "{text}");
    assert!(text.contains("f_Hz = 10"), "{text}");
}

#[test]
fn a_line_without_partner_is_listed() {
    let one = lined(1.0, &[(10.0, 1e-6), (30.0, 5e-7)]);
    let other = lined(1.0, &[(10.0, 1e-6), (40.0, 5e-7)]);
    let (_folder, a, b) = files(&one, &other);
    let (code, text) = result(&command(&[&a, &b], &["--lines"]));
    assert_eq!(code, 1, "{text}");
    for (file, at) in [("a.csv", 30), ("b.csv", 40)] {
        let told = format!("{file} has the line at {at} Hz, 5.0000e-7");
        assert!(text.contains(&told), "{text}");
    }
    // the strongest is in both
    assert_eq!(result(&command(&[&a, &b], &["--lines=1"])).0, 0);
    let (code, text) = result(&command(&[&a, &b], &["--lines=0"]));
    assert_eq!(code, 2, "{text}");
    let (_folder, a, _) = files(TRACE, TRACE);
    let (code, text) = result(&command(&[&a, &a], &["--lines"]));
    assert_eq!(code, 2);
    assert!(text.contains("is no spectrum"), "{text}");
}

/// The answer to a comparison with a file of tolerances.
fn with_tolerances(content: &str, options: &[&str]) -> (i32, String) {
    let (folder, a, b) = files(TRACE, &TRACE.replace("2e-6", "3e-6"));
    let file = folder.path().join("tolerances.toml");
    fs::write(&file, content).unwrap();
    let options = [&["--tolerances", file.to_str().unwrap()], options].concat();
    result(&command(&[&a, &b], &options))
}

#[test]
fn tolerances_stand_in_a_file_and_options_go_before_it() {
    let column = "[[column]]\nname = \"x_m\"\nrelative = 0.5\n";
    assert_eq!(with_tolerances(column, &[]).0, 0);
    assert_eq!(with_tolerances("relative = 0.5", &[]).0, 0);
    assert_eq!(with_tolerances("absolute = 1e-6", &[]).0, 0);
    assert_eq!(
        with_tolerances("relative = 0.5", &["--relative", "1e-3"]).0,
        1
    );
    assert_eq!(with_tolerances(column, &["--column", "x_m=1e-3"]).0, 1);
}

#[test]
fn a_wrong_file_of_tolerances_is_shown_with_its_place() {
    for (content, expected) in [
        ("relativ = 1", "a file of tolerances has no key `relativ`"),
        ("relativ = 1", "did you mean `relative`?"),
        ("relative = -1", "`relative` must be at least 0, not -1"),
        ("relative = nan", "`relative` must be a finite number"),
        (
            "relative = \"1\"",
            "`relative` must be a number, not a string",
        ),
        ("[[column]]\nname = \"x_m\"", "needs `relative`"),
        (
            "[[column]]\nname = \"y_m\"\nrelative = 1",
            "no table has a column \"y_m\"",
        ),
        (
            "[[column]]\nname = \"y_m\"\nrelative = 1",
            "did you mean `x_m`?",
        ),
        ("relative =", "this is not TOML"),
        (
            "[[column]]\nname = \"x_m\"\nrelative = 1\n[[column]]\nname = \"x_m\"\nrelative = 2",
            "column \"x_m\" has a tolerance already",
        ),
    ] {
        let (code, text) = with_tolerances(content, &[]);
        assert_eq!(code, 2, "{content}: {text}");
        assert!(text.contains(expected), "{content}: {text}");
        assert!(text.contains("tolerances.toml:"), "{content}: {text}");
    }
    let (_folder, a, _) = files(TRACE, TRACE);
    let (code, text) = result(&command(&[&a, &a], &["--tolerances", "gone.toml"]));
    assert_eq!(code, 2);
    assert!(
        text.contains("cannot read the file") && text.contains("gone.toml"),
        "{text}"
    );
}

/// Lines of round-off beside those of x, by 1e-11 of it, are not compared by their ratio; a line above it is.
#[test]
fn decibels_leave_out_lines_of_round_off() {
    let spectrum = |line: f64| {
        let rows = (0..9).map(|n| {
            let y = if n == 4 { line } else { 0.0 };
            let x = if n == 2 { 1e-6 } else { 1e-9 };
            format!("{n},{x:e},{y:e}\n")
        });
        let rows: String = rows.collect();
        format!("f_Hz,x_amplitude_m,y_amplitude_m\n{rows}")
    };
    let options = ["--lines", "--decibels", "1"];
    for (pair, code) in [([1e-19, 5e-19], 0), ([1e-9, 5e-9], 1), ([1e-19, 1e-9], 1)] {
        let (_folder, a, b) = files(&spectrum(pair[0]), &spectrum(pair[1]));
        let (found, told) = result(&command(&[&a, &b], &options));
        assert_eq!(found, code, "{pair:?}: {told}");
    }
}

/// Within a difference that is not finite everything would agree.
#[test]
fn reach_and_decibels_are_finite_and_not_negative() {
    let spectrum = "f_Hz,x_amplitude_m\n0,0\n1,1e-6\n2,0\n";
    let (_folder, a, b) = files(spectrum, &spectrum.replace("1e-6", "5e-6"));
    for option in ["--decibels", "--reach"] {
        for value in ["NaN", "inf", "-1"] {
            let (code, told) = result(&command(&[&a, &b], &["--lines", option, value]));
            assert_eq!(code, 2, "{option} {value}: {told}");
        }
    }
}

/// What has nothing in common but the axis, or nothing at all, does not agree: the guard of a spectrum would sleep.
#[test]
fn nothing_in_common_is_no_agreement() {
    let (_folder, a, b) = files(TRACE, &TRACE.replace("x_m", "y_m"));
    let (code, told) = result(&command(&[&a, &b], &["--common"]));
    assert_eq!(code, 2, "{told}");
    assert!(
        told.contains("nothing was compared") && told.contains("y_m"),
        "{told}"
    );
    let (_folder, a, b) = files("t_s,x_m\n0,NaN\n1,NaN\n", "t_s,x_m\n0,NaN\n1,NaN\n");
    let (code, told) = result(&command(&[&a, &b], &[]));
    assert_eq!(code, 2, "{told}");
    // one number is enough, and one column alone is more than an axis
    let (_folder, a, b) = files("t_s,x_m\n0,NaN\n1,2\n", "t_s,x_m\n0,NaN\n1,2\n");
    assert_eq!(result(&command(&[&a, &b], &[])).0, 0);
    let (_folder, a, b) = files("x_m\n0\n1\n", "x_m\n0\n1\n");
    assert_eq!(result(&command(&[&a, &b], &[])).0, 0);
}

#[test]
fn what_is_compared_is_not_replaced_and_a_link_is_followed() {
    let (folder, a, b) = files(TRACE, TRACE);
    for option in ["--report", "--figure"] {
        let (code, told) = result(&command(&[&a, &b], &[option, b.to_str().unwrap()]));
        assert_eq!(code, 2, "{told}");
        assert!(told.contains("which is compared"), "{told}");
    }
    assert_eq!(fs::read_to_string(&b).unwrap(), TRACE);
    #[cfg(unix)]
    {
        let [page, link] = ["page.html", "link.html"].map(|name| folder.path().join(name));
        fs::write(&page, "old").unwrap();
        std::os::unix::fs::symlink(&page, &link).unwrap();
        let done = result(&command(&[&a, &b], &["--report", link.to_str().unwrap()]));
        assert_eq!(done.0, 0, "{}", done.1);
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert!(fs::read_to_string(&page).unwrap().contains("<html"));
        // a device takes what is written, and stays one
        let device = folder.path().join("device.html");
        std::os::unix::fs::symlink("/dev/null", &device).unwrap();
        let done = result(&command(&[&a, &b], &["--report", device.to_str().unwrap()]));
        assert_eq!(done.0, 0, "{}", done.1);
        assert!(fs::symlink_metadata(&device).unwrap().is_symlink());
    }
}

#[test]
fn a_figure_shows_the_columns_that_are_furthest_apart() {
    let (folder, a, b) = files(TRACE, &TRACE.replace("2e-6", "3e-6"));
    let figure = folder.path().join("new/figure.svg");
    let options = ["--figure", figure.to_str().unwrap()];
    assert_eq!(result(&command(&[&a, &b], &options)).0, 1);
    let svg = fs::read_to_string(&figure).unwrap();
    assert!(svg.contains("x in µm") && svg.contains("b − a in µm"));
    let (code, text) = result(&command(&[&a, &b], &["--figure", "/proc/none/figure.svg"]));
    assert_eq!(code, 2);
    assert!(text.contains("cannot create /proc/none"), "{text}");
    // equal results have nothing to show, and say so by an empty figure
    assert_eq!(result(&command(&[&a, &a], &options)).0, 0);
}
