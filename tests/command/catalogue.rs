//! Bearings by designation, by the line of a catalogue and from a file of one's own.

use std::fs;

use serde_json::Value;

use crate::support::{jeffcott, jeffcott_in, root, text};

const OWN: &str = "designation,bore_mm,outside_diameter_mm,contact_angle_deg,dynamic_rating_N,static_rating_N\n\
                   MY-6406,30,90,0,43000,23800\n";

const LINE: [&str; 11] = [
    "estimate",
    "--bore",
    "40mm",
    "--outside-diameter",
    "80mm",
    "--contact-angle",
    "0deg",
    "--dynamic",
    "29.1kN",
    "--static",
    "17.9kN",
];

#[test]
fn a_page_of_one_bearing() {
    let output = jeffcott_in(root(), &["catalogue", "6208-2RS/C3"]);
    let page = text(&output.stdout);
    assert!(output.status.success());
    for part in [
        "6208",
        "9 of 11.906 mm (estimated)",
        "class C3",
        "NSK",
        "f0 14.03",
    ] {
        assert!(page.contains(part), "{part}: {page}");
    }
    assert!(!page.contains("6205"));
}

/// The README says how many bearings the catalogue holds.
#[test]
fn as_many_bearings_as_the_readme_says() {
    let output = jeffcott_in(root(), &["catalogue", "--json"]);
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    let count = |key: &str| found[key].as_array().map_or(0, Vec::len);
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let words: Vec<_> = readme.split_whitespace().collect();
    for (key, kind) in [("bearings", "ball"), ("roller_bearings", "roller")] {
        let count = count(key).to_string();
        assert!(
            words.windows(2).any(|pair| pair == [count.as_str(), kind]),
            "{count} {kind}"
        );
    }
}

#[test]
fn a_page_of_one_roller_bearing() {
    let output = jeffcott_in(root(), &["catalogue", "NU 206/C3"]);
    let page = text(&output.stdout);
    assert!(output.status.success(), "{}", text(&output.stderr));
    for part in ["cylindrical", "7.5 × ", "46 mm", "Koyo", "next best"] {
        assert!(page.contains(part), "{part}: {page}");
    }
    let output = jeffcott_in(root(), &["catalogue", "22212", "--json"]);
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(found["kind"], "spherical");
    assert_eq!(found["width_mm"], 28.0);
}

#[test]
fn an_unknown_designation_suggests_no_other_number() {
    let output = jeffcott_in(root(), &["catalogue", "62089"]);
    assert_eq!(output.status.code(), Some(2));
    let message = text(&output.stderr);
    assert!(message.contains("[bearing.ratings]") && !message.contains("did you mean"));
}

#[test]
fn the_estimate_of_a_line_has_the_ratings_beside_the_geometry() {
    let output = jeffcott_in(root(), &[&LINE[..], &["--json"]].concat());
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(found["balls"], 9);
    for (key, printed) in [
        ("dynamic_rating_N", 29_100.0),
        ("static_rating_N", 17_900.0),
    ] {
        let rating = found[key].as_f64().unwrap();
        assert!((rating / printed - 1.0).abs() < 0.01, "{key}: {rating}");
        assert_eq!(found["printed"][key], printed);
    }
    assert!(
        found["estimated"]
            .as_array()
            .is_some_and(|names| names.len() == 5)
    );
    assert_eq!(found["runner_up"]["balls"], 10);
    let note = found["notes"][0].as_str().unwrap();
    assert!(note.contains("10 balls of 11.112 mm"), "{note}");
    let settled = jeffcott_in(
        root(),
        &[&LINE[..], &["--f0", "14", "--balls", "9", "--json"]].concat(),
    );
    let settled: Value = serde_json::from_slice(&settled.stdout).unwrap();
    assert_eq!(settled["notes"].as_array().map(Vec::len), Some(0));
    let refused = jeffcott_in(root(), &[&LINE[..9], &["--static", "3 kN"]].concat());
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).contains("give `balls` and `ball_diameter`"));
}

/// The rollers of Koyo's NU206: 13 of 7.5 × 8 mm, as a motor of them has.
#[test]
fn rollers_are_estimated_from_their_line() {
    const LINE: [&str; 13] = [
        "estimate",
        "--kind",
        "cylindrical",
        "--bore",
        "30mm",
        "--outside-diameter",
        "62mm",
        "--width",
        "16mm",
        "--dynamic",
        "25kN",
        "--static",
        "22.7kN",
    ];
    let told = jeffcott_in(root(), &[&LINE[..], &["--json"]].concat());
    let found: Value = serde_json::from_slice(&told.stdout).unwrap();
    let rated = found["static_rating_N"].as_f64().unwrap() / 22.7e3;
    assert!((rated - 1.0).abs() < 0.02, "{found}");
    assert_eq!(found["printed"]["width_m"], 0.016);
    let told = jeffcott_in(root(), &LINE);
    assert!(text(&told.stdout).contains("rollers"));
    let balls = jeffcott_in(root(), &[&LINE[..], &["--f0", "14"]].concat());
    assert_eq!(balls.status.code(), Some(2));
    assert!(text(&balls.stderr).contains("belongs to balls"));
    let kind = jeffcott_in(root(), &[&LINE[..2], &["conical"], &LINE[3..]].concat());
    assert_eq!(kind.status.code(), Some(2));
}

#[test]
fn a_file_of_ones_own_may_have_roller_bearings() {
    let folder = tempfile::tempdir().unwrap();
    let rollers = "designation,kind,bore_mm,outside_diameter_mm,width_mm,contact_angle_deg,dynamic_rating_N,\
                   static_rating_N,rollers,roller_diameter_mm,roller_length_mm\n\
                   MY-N206,cylindrical,30,62,16,0,29300,28700,13,7.5,8\nMY-6406,,30,90,,0,43000,23800,,,\n";
    fs::write(folder.path().join("own.csv"), rollers).unwrap();
    let named = ["--catalogue", "own.csv", "catalogue", "my-n206", "--json"];
    let output = jeffcott_in(folder.path(), &named);
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(found["estimate"]["rollers"], 13);
    assert_eq!(found["estimate"]["estimated"], false);
    let scenario = "catalogue_file = \"own.csv\"\n[shaft]\nmass = \"5 kg\"\nfreedoms = \"radial\"\n\
        [speed]\nconstant = \"3000 rpm\"\n[[bearing]]\ncatalogue = \"MY-N206/C3\"\n[[load]]\nconstant = { y = \"-300 N\" }\n";
    fs::write(folder.path().join("a.toml"), scenario).unwrap();
    let output = jeffcott_in(folder.path(), &["bearing", "a.toml", "--json"]);
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(
        answer["bearings"][0]["geometry"]["rollers"], 13,
        "{}",
        answer["bearings"][0]["geometry"]
    );
}

#[test]
fn a_file_of_ones_own_is_looked_up_first() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("own.csv"), OWN).unwrap();
    let named = ["--catalogue", "own.csv", "catalogue", "my-6406"];
    let output = jeffcott_in(folder.path(), &named);
    assert!(text(&output.stdout).contains("7 of 16.669 mm"));
    let mut by_environment = jeffcott();
    by_environment
        .args(["catalogue", "MY-6406"])
        .current_dir(folder.path());
    let output = by_environment
        .env("JEFFCOTT_CATALOGUE", "own.csv")
        .output()
        .unwrap();
    assert!(text(&output.stdout).contains("7 of 16.669 mm"));
    let scenario = "catalogue_file = \"own.csv\"\n[shaft]\nmass = \"5 kg\"\nfreedoms = \"radial\"\n\
        [speed]\nconstant = \"3000 rpm\"\n[[bearing]]\ncatalogue = \"MY-6406/C3\"\n[[load]]\nconstant = { y = \"-300 N\" }\n";
    fs::write(folder.path().join("a.toml"), scenario).unwrap();
    let output = jeffcott_in(folder.path(), &["bearing", "a.toml", "--json"]);
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    let geometry = &answer["bearings"][0]["geometry"];
    assert_eq!(
        (&geometry["balls"], &geometry["estimated"]),
        (&7.into(), &true.into())
    );
    fs::write(
        folder.path().join("own.csv"),
        OWN.replace("30,90", "thirty,90"),
    )
    .unwrap();
    let output = jeffcott_in(folder.path(), &["check", "a.toml"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("line 2: `bore_mm` has \"thirty\""));
}
