//! Every command and every scenario in the README works as it stands.

use std::fs;

use jeffcott::scenario::{self, Format};

use crate::support::{copy_folder, jeffcott_in, root, scenarios, told};

/// The fenced blocks of the README in one language.
fn blocks(language: &str) -> Vec<String> {
    let text = fs::read_to_string(root().join("README.md")).expect("README.md");
    let fence = format!("```{language}\n");
    text.split(&fence)
        .skip(1)
        .map(|rest| rest.split("```").next().unwrap_or_default().to_owned())
        .collect()
}

/// The command lines of all shell blocks.
fn commands() -> Vec<String> {
    let lines = blocks("sh").join("\n");
    lines
        .lines()
        .map(str::to_owned)
        .filter(|line| !line.is_empty())
        .collect()
}

#[test]
fn every_jeffcott_command_ends_well() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    copy_folder(&scenarios(), &folder.path().join("scenarios"));
    let mut run = 0;
    for line in commands() {
        let Some(arguments) = line
            .strip_prefix("cargo run --release -- ")
            .or_else(|| line.strip_prefix("jeffcott "))
        else {
            continue;
        };
        let words: Vec<&str> = arguments
            .split_whitespace()
            .take_while(|word| *word != ">")
            .collect();
        let output = jeffcott_in(&folder, &words);
        assert!(output.status.success(), "{line}: {}", told(&output));
        run += 1;
    }
    assert!(run >= 4, "only {run} commands found in the README");
}

#[test]
fn the_other_commands_are_the_ones_that_are_known_to_work() {
    for line in commands() {
        let known = [
            "cargo run --release -- ",
            "jeffcott ",
            "cargo test",
            "cargo install --path .",
            "cargo bench",
        ];
        assert!(
            known.iter().any(|start| line.starts_with(start)),
            "untested command: {line}"
        );
    }
}

#[test]
fn every_scenario_is_right() {
    let mut scenarios = blocks("toml");
    // studies of many runs name a base
    scenarios.retain(|text| !text.starts_with("base = "));
    assert!(!scenarios.is_empty());
    for text in scenarios {
        if let Err(error) = scenario::parse(&text, "README.md", Format::Toml) {
            panic!("{}", error.render(false));
        }
    }
}
