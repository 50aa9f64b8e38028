//! Help at hand: examples of every verb, completions, manual pages, and tables that fit a terminal.

use std::fs;
use std::path::Path;
use std::process::Output;

use tempfile::TempDir;

use crate::support::{
    SHORT_VARYING_COMPLIANCE, changed, jeffcott_in, names, scenarios, text, toml_files,
};

/// Most characters of a line.
const WIDTH: usize = 100;

fn jeffcott(folder: &Path, line: &str) -> Output {
    jeffcott_in(folder, &line.split_whitespace().collect::<Vec<_>>())
}

/// Verbs, as the help of the command lists them.
fn verbs() -> Vec<String> {
    let help = text(&jeffcott(Path::new("."), "--help").stdout);
    let (_, list) = help.split_once("Commands:\n").unwrap();
    let lines = list.lines().take_while(|line| !line.is_empty());
    let names = lines.filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    names
        .filter_map(|line| line.split_whitespace().next())
        .filter(|verb| *verb != "help")
        .map(str::to_owned)
        .collect()
}

/// A folder with the shipped scenarios in it.
fn shipped() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let tables = [scenarios().join("journal-bearing.csv")];
    for path in toml_files(&scenarios()).into_iter().chain(tables) {
        fs::copy(&path, folder.path().join(path.file_name().unwrap())).unwrap();
    }
    folder
}

#[test]
fn the_help_of_every_verb_shows_an_example_of_it() {
    let verbs = verbs();
    assert!(verbs.len() >= 10, "{verbs:?}");
    for verb in verbs {
        let help = text(&jeffcott(Path::new("."), &format!("{verb} --help")).stdout);
        assert!(help.contains("Example"), "{verb}");
        assert!(
            help.contains(&format!("\n  jeffcott {verb}")),
            "{verb}: {help}"
        );
    }
}

#[test]
fn the_short_help_of_every_verb_can_be_read() {
    for verb in verbs() {
        for line in text(&jeffcott(Path::new("."), &format!("{verb} -h")).stdout).lines() {
            let width = line.chars().count();
            assert!(width <= 3 * WIDTH, "{verb}: {width} characters\n{line}");
        }
    }
}

#[test]
fn every_shell_completes_every_verb_and_option() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let output = jeffcott(Path::new("."), &format!("completions {shell}"));
        assert!(output.status.success());
        let script = text(&output.stdout);
        for word in verbs() {
            assert!(script.contains(&word), "{shell}: {word}");
        }
        for word in ["no-verify", "channels"] {
            assert!(script.contains(word), "{shell}: {word}");
        }
        // the library completes values in these
        let values = ["bash", "zsh", "fish"].contains(&shell);
        assert_eq!(script.contains("force_x"), values, "{shell}");
    }
    let output = jeffcott(Path::new("."), "completions tcsh");
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn the_manual_has_a_page_of_the_command_and_of_every_verb() {
    let folder = tempfile::tempdir().unwrap();
    let printed = jeffcott(folder.path(), "man");
    assert!(
        text(&printed.stdout).starts_with(".ie \\n(.g"),
        "{}",
        text(&printed.stdout)
    );
    assert!(jeffcott(folder.path(), "man --out man1").status.success());
    let mut expected: Vec<String> = verbs()
        .iter()
        .map(|verb| format!("jeffcott-{verb}.1"))
        .collect();
    expected.push("jeffcott.1".to_owned());
    expected.sort();
    assert_eq!(names(&folder.path().join("man1")), expected);
    let page = fs::read_to_string(folder.path().join("man1/jeffcott-run.1")).unwrap();
    assert!(
        page.contains("\\-\\-no\\-verify") && page.contains("jeffcott run"),
        "{page}"
    );
    fs::write(folder.path().join("file"), "").unwrap();
    let refused = jeffcott(folder.path(), "man --out file");
    assert_eq!(refused.status.code(), Some(1));
    assert!(text(&refused.stderr).contains("cannot create"));
}

#[test]
fn what_is_no_terminal_gets_no_colour() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("bad.toml"), "[shaft]\nmass = 5\n").unwrap();
    for line in [
        "check bad.toml",
        "run --fly",
        "--help",
        "compare a b",
        "run --help",
    ] {
        let Output { stdout, stderr, .. } = jeffcott(folder.path(), line);
        assert!(!stdout.contains(&0x1b) && !stderr.contains(&0x1b), "{line}");
    }
}

#[test]
fn no_line_of_a_result_is_wider_than_a_terminal() {
    let folder = shipped();
    let name = "varying-compliance-6306";
    changed(folder.path(), name, &SHORT_VARYING_COMPLIANCE);
    let lines = [
        "catalogue",
        "check steady-7205c.toml drive-start-7205c.toml",
        "run steady-7205c.toml back-to-back-7205c.toml varying-compliance-6306.toml",
        "run drive-start-7205c.toml coal-impact-7205c.toml linear-7205c.toml --no-verify",
        "bearing steady-7205c.toml bearing-7205c.toml arrangement-7205c.toml",
        "bearing back-to-back-7205c.toml varying-compliance-6306.toml linear-7205c.toml",
        "steady steady-7205c.toml",
        "accuracy steady-7205c.toml --methods dop853,dopri5 --tolerances 1e-4,1e-6",
        "compare output/steady-7205c output/back-to-back-7205c --worst 3 --common",
        "compare output/steady-7205c output/linear-7205c --lines --worst 3",
        "compare output/varying-compliance-6306 output/steady-7205c",
    ];
    for line in lines {
        let output = jeffcott(folder.path(), line);
        assert!(
            output.status.code() != Some(2),
            "{line}: {}",
            text(&output.stderr)
        );
        for row in text(&output.stdout).lines() {
            let width = row.chars().count();
            assert!(width <= WIDTH, "{line}: {width} characters\n{row}");
        }
    }
}
