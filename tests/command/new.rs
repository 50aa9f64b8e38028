//! `jeffcott new`: what it writes is right and runs, and nothing is written over.

use std::fs;

use crate::support::{done, jeffcott_in, text, told};

#[test]
fn a_new_scenario_is_right_runs_and_stays() {
    let folder = tempfile::tempdir().unwrap();
    let output = done(jeffcott_in(&folder, &["new", "shaft.toml"]));
    assert!(text(&output.stdout).contains("next: jeffcott run shaft.toml"));
    let written = fs::read(folder.path().join("shaft.toml")).unwrap();
    done(jeffcott_in(&folder, &["check", "shaft.toml"]));
    done(jeffcott_in(&folder, &["run", "shaft.toml", "--no-verify"]));
    assert!(folder.path().join("output/shaft/report.html").exists());
    let again = jeffcott_in(&folder, &["new", "shaft.toml", "--mass", "9 kg"]);
    assert_eq!(again.status.code(), Some(2));
    assert!(told(&again).contains("it is there already"));
    assert!(fs::read(folder.path().join("shaft.toml")).unwrap() == written);
}

#[test]
fn options_become_keys_of_the_scenario() {
    let folder = tempfile::tempdir().unwrap();
    let options =
        "--mass 8kg --speed 1500rpm --bearing 6205 --span 150mm --radial 300N --axial -20N";
    let arguments: Vec<_> = ["new", "-"].into_iter().chain(options.split(' ')).collect();
    let printed = text(&done(jeffcott_in(&folder, &arguments)).stdout);
    let scenario: toml::Table = printed.parse().unwrap();
    assert_eq!(scenario["shaft"]["mass"].as_str(), Some("8kg"));
    assert_eq!(scenario["speed"]["constant"].as_str(), Some("1500rpm"));
    let bearings = scenario["bearing"].as_array().unwrap();
    let positions = bearings.iter().map(|bearing| bearing["position"].as_str());
    assert_eq!(
        positions.collect::<Vec<_>>(),
        [Some("-75 mm"), Some("75 mm")]
    );
    let load = &scenario["load"][0]["constant"];
    assert_eq!(load["y"].as_str(), Some("-300N"));
    assert_eq!(load["z"].as_str(), Some("-20N"));
    assert!(fs::read_dir(&folder).unwrap().next().is_none());
}

#[test]
fn what_is_offered_in_comments_is_right() {
    let folder = tempfile::tempdir().unwrap();
    let printed = text(&done(jeffcott_in(&folder, &["new", "-"])).stdout);
    let mut offered = false;
    let lines = printed.lines().map(|line| {
        offered = line.starts_with("# [") || (offered && line.starts_with("# "));
        if offered { &line[2..] } else { line }
    });
    let lines: Vec<&str> = lines.collect();
    assert!(lines.contains(&"[[unbalance]]") && lines.contains(&"[bearing.housing]"));
    fs::write(folder.path().join("all.toml"), lines.join("\n")).unwrap();
    done(jeffcott_in(&folder, &["check", "all.toml"]));
}

#[test]
fn every_kind_of_bearing_and_speed_makes_a_right_scenario() {
    let folder = tempfile::tempdir().unwrap();
    let cases = [
        ("7205C", "80 mm", "3000 rpm"),
        ("7205C", "0 mm", "30000 rpm"),
        ("6306", "0 mm", "0 rpm"),
        ("6204", "33.3333 mm", "1 rpm"),
        ("NU206", "100 mm", "3000 rpm"),
        ("NU206", "0 mm", "3000 rpm"),
        ("30206", "0 mm", "3000 rpm"),
    ];
    for (number, (bearing, span, speed)) in cases.into_iter().enumerate() {
        let name = format!("{number}.toml");
        let options = ["--bearing", bearing, "--span", span, "--speed", speed];
        done(jeffcott_in(
            &folder,
            &[&["new", &name], &options[..]].concat(),
        ));
        done(jeffcott_in(&folder, &["bearing", &name]));
    }
    let pair = fs::read_to_string(folder.path().join("0.toml")).unwrap();
    assert!(
        pair.contains("arrangement = \"back-to-back\"") && pair.contains("preload = \"166 N\"")
    );
}

#[test]
fn a_wrong_answer_says_what_is_wrong_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    for (option, value, reason) in [
        ("--mass", "5", "`mass` needs a unit"),
        ("--bearing", "7205", "did you mean \"7205C\""),
        ("--span", "-1 mm", "zero or positive"),
        ("--radial", "3 kg", "is a mass"),
        ("--axial=1 N", "--bearing=NU206", "no axial load"),
    ] {
        let output = jeffcott_in(&folder, &["new", "shaft.toml", option, value]);
        assert_eq!(output.status.code(), Some(2), "{option}");
        assert!(
            told(&output).contains(reason),
            "{option}: {}",
            told(&output)
        );
    }
    let output = jeffcott_in(&folder, &["new", "shaft.yaml"]);
    assert_eq!(output.status.code(), Some(2));
    let output = jeffcott_in(&folder, &["new", "no/such/folder.toml"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(fs::read_dir(&folder).unwrap().next().is_none());
}
