//! The schema that editors read is the one of the library, and every shipped scenario
//! keeps to it.

use std::path::{Path, PathBuf};

use crate::scenario::{self, Format};

fn scenarios() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios")
}

fn shipped() -> Vec<PathBuf> {
    let files: Vec<_> = std::fs::read_dir(scenarios())
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| {
            path.extension()
                .is_some_and(|extension| extension == "toml")
        })
        .collect();
    assert!(files.len() >= 5, "the scenarios are shipped");
    files
}

#[test]
fn committed_schema_is_the_printed_one() {
    let committed = std::fs::read_to_string(scenarios().join("scenario.schema.json")).unwrap();
    let printed = format!("{:#}\n", scenario::schema());
    assert!(
        committed == printed,
        "write it anew: jeffcott schema > scenarios/scenario.schema.json"
    );
}

#[test]
fn shipped_scenarios_pass_without_warning() {
    for file in shipped() {
        let scenario = scenario::load(&file).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(
            scenario.warnings,
            Vec::<String>::new(),
            "{}",
            file.display()
        );
        let text = std::fs::read_to_string(&file).unwrap();
        assert!(
            text.starts_with("#:schema scenario.schema.json\n"),
            "{}",
            file.display()
        );
    }
}

#[test]
fn the_echo_of_a_scenario_is_the_same_scenario() {
    for file in shipped() {
        let original = scenario::load(&file).unwrap();
        let echo = original.echo.to_string();
        let name = file.display().to_string();
        let again =
            scenario::parse(&echo, &name, Format::Json).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(again, original);
    }
}
