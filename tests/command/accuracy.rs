//! `jeffcott accuracy` and `jeffcott run --no-verify` as a user meets them.

use std::fs;
use std::process::Output;

use serde_json::Value;
use tempfile::TempDir;

use crate::support::{jeffcott_in as jeffcott, json, loaded_7205c};

fn scene(contact: &str) -> TempDir {
    let folder = TempDir::new().unwrap();
    let text = loaded_7205c(contact, "");
    fs::write(folder.path().join("scene.toml"), text).unwrap();
    folder
}

fn out(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

#[test]
fn table_csv_json_and_figures_tell_the_same() {
    let folder = scene("contact = \"hertz\"");
    let arguments = [
        "accuracy",
        "scene.toml",
        "--methods",
        "dop853,dopri5",
        "--tolerances",
        "1e-6,1e-4",
    ];
    let output = jeffcott(folder.path(), &arguments);
    assert!(output.status.success(), "{output:?}");
    let text = out(&output);
    println!("{text}");
    assert!(text.lines().all(|line| line.chars().count() <= 100));
    assert!(text.contains("the uncertainty") && text.contains("no bearing has a [bearing.oil]"));

    let results = folder.path().join("output/scene");
    let json = json(&results.join("accuracy.json"));
    let rows = json["methods"].as_array().unwrap();
    assert_eq!(rows.len(), 4);
    let table = fs::read_to_string(results.join("accuracy.csv")).unwrap();
    let lines: Vec<&str> = table.lines().collect();
    let header: Vec<&str> = lines[0].split(',').collect();
    let column = header
        .iter()
        .position(|name| *name == "error_displacement_relative");
    for (row, line) in rows.iter().zip(&lines[1..]) {
        let cells: Vec<&str> = line.split(',').collect();
        assert_eq!(cells.len(), header.len());
        let error: f64 = cells[column.unwrap()].parse().unwrap();
        assert_eq!(row["error"]["displacement_relative"], error);
        assert!(error > 0.0 && row["cost"]["wall_time_s"].as_f64().unwrap() > 0.0);
    }
    // the loosest tolerance first, however they were given
    assert_eq!(rows[0]["tolerance"], 1e-4);
    let rungs = json["ladder"]["rungs"].as_array().unwrap();
    let ladder = fs::read_to_string(results.join("ladder.csv")).unwrap();
    assert!(ladder.lines().count() > rungs.len());
    for name in ["accuracy.svg", "ladder.svg"] {
        let svg = fs::read_to_string(results.join(name)).unwrap();
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
        assert!(!svg.contains("NaN"));
    }
    let svg = fs::read_to_string(results.join("accuracy.svg")).unwrap();
    for name in ["dop853", "dopri5", "error force relative"] {
        assert!(svg.contains(name), "{name}");
    }
}

#[test]
fn what_is_wrong_on_the_command_line_is_named() {
    let folder = scene("contact = \"hertz\"");
    for (arguments, words) in [
        (["--methods", "dop835"], "did you mean \"dop853\"?"),
        (
            ["--tolerances", "2"],
            "`tolerance` must be at least 1e-13 and at most 0.01, not 2",
        ),
        (["--longest", "5"], "`time` needs a unit, as in \"0.2 s\""),
    ] {
        let all = [&["accuracy", "scene.toml"][..], &arguments].concat();
        let output = jeffcott(folder.path(), &all);
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.contains(words), "{message}");
    }
    let standing = folder.path().join("scene.toml");
    let text = fs::read_to_string(&standing).unwrap();
    fs::write(&standing, text.split("[time]").next().unwrap()).unwrap();
    let output = jeffcott(folder.path(), &["accuracy", "scene.toml"]);
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(message.contains("the scenario has no [time]"), "{message}");
}

#[test]
fn a_run_tells_what_its_second_pass_costs_and_can_leave_it_out() {
    let folder = TempDir::new().unwrap();
    // two passes by one method: the share is that of their tolerances
    let named = "[integrator]\nmethod = \"verner76\"\n";
    let scene = loaded_7205c("contact = \"hertz\"", named);
    fs::write(folder.path().join("scene.toml"), scene).unwrap();
    let run = |more: &[&str]| {
        let arguments = [&["run", "scene.toml"][..], more].concat();
        let output = jeffcott(folder.path(), &arguments);
        assert!(output.status.success(), "{output:?}");
        let summary = folder.path().join("output/scene/summary.json");
        (out(&output), json(&summary))
    };
    let (text, verified) = run(&["-v"]);
    assert!(text.contains("% of all evaluations"), "{text}");
    let error = &verified["measured_error"];
    let share = error["reference_share_of_evaluations"].as_f64().unwrap();
    let [main, second] = [&verified["counters"], &error["reference_counters"]]
        .map(|counters| counters["evaluations"].as_f64().unwrap());
    assert_eq!(share, second / (main + second));
    assert!((0.5..0.8).contains(&share), "{share}");

    let (text, bare) = run(&["--no-verify"]);
    assert!(!text.contains("  error "), "{text}");
    assert_eq!(bare["measured_error"], Value::Null);
    assert_eq!(bare["scenario"]["integrator"]["verify"], false);
    assert_eq!(bare["counters"], verified["counters"]);
}

#[test]
fn what_was_chosen_and_why_is_printed_and_kept() {
    let folder = scene("contact = \"auto\"\nmodel_error = 0.05");
    let output = jeffcott(folder.path(), &["run", "scene.toml"]);
    let text = out(&output);
    println!("{text}");
    assert!(output.status.success());
    assert!(text.lines().all(|line| line.chars().count() <= 100));
    let summary = json(&folder.path().join("output/scene/summary.json"));
    let choice = &summary["contact_choice"];
    let chosen = choice["chosen"].as_str().unwrap();
    assert!(text.contains(&format!("contact       {chosen}: the cheapest within")));
    assert_eq!(choice["compared_with"], "jones");
    assert!(choice["cheaper"].as_array().unwrap().len() >= 2);
    assert_eq!(summary["scenario"]["model"]["contact"], "auto");
    let output = jeffcott(folder.path(), &["bearing", "scene.toml", "--json"]);
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(answer["contact_choice"]["chosen"].is_string());
}
