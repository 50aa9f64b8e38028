//! Every file under `tests/scenarios/bad/` is refused with exit code 2 and exactly the message
//! that stands beside it. `JEFFCOTT_BLESS=1` writes the messages anew; read them before you
//! commit them.

use std::path::PathBuf;
use std::process::Output;

use crate::support::{jeffcott_in, root};

fn folder() -> PathBuf {
    root().join("tests/scenarios/bad")
}

fn check(arguments: &[&str]) -> Output {
    jeffcott_in(folder(), &[&["check"], arguments].concat())
}

fn bad_files() -> Vec<PathBuf> {
    let mut files: Vec<_> = std::fs::read_dir(folder())
        .expect("the folder of bad scenarios is there")
        .map(|entry| entry.expect("its entries can be read").path())
        .filter(|path| {
            path.is_file() && path.extension().is_some_and(|extension| extension != "txt")
        })
        .collect();
    files.sort();
    files
}

#[test]
fn each_bad_scenario_gives_its_message() {
    let bless = std::env::var_os("JEFFCOTT_BLESS").is_some();
    let mut wrong = Vec::new();
    for file in bad_files() {
        let name = file.file_name().unwrap().to_str().unwrap();
        let output = check(&[name]);
        let message = String::from_utf8(output.stderr).expect("messages are UTF-8");
        assert_eq!(output.status.code(), Some(2), "{name}: {message}");
        assert!(
            output.stdout.is_empty(),
            "{name}: messages belong on stderr"
        );
        let expected = file.with_extension("txt");
        if bless {
            std::fs::write(&expected, &message).expect("the message can be written");
        }
        let expected = std::fs::read_to_string(&expected).unwrap_or_default();
        if message != expected {
            wrong.push(format!("{name} gives\n{message}\ninstead of\n{expected}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_missing_file_and_a_folder_are_refused() {
    for name in ["missing.toml", ".", "..toml"] {
        let output = check(&[name]);
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{name}: {message}");
        assert!(message.starts_with("error: "), "{name}: {message}");
        assert!(message.contains(name), "{message}");
    }
}

#[test]
fn json_findings_name_key_line_and_column() {
    let output = check(&["--json", "bare-number.toml", "missing.toml"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stderr.is_empty());
    let findings: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let issue = &findings[0]["issues"][0];
    assert_eq!(issue["key"], "shaft.mass");
    assert_eq!((&issue["line"], &issue["column"]), (&2.into(), &8.into()));
    assert_eq!(findings[1]["ok"], false);
}
