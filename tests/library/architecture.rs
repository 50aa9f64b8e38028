//! The floors of the crate: code depends downwards only, and each library stands on its own floor.

use std::fs;
use std::path::{Path, PathBuf};

/// Lowest first; `simulate` and `quasi_static` are single files. The integrator knows no rotor: it is
/// the rotor that implements the integrator's trait.
const FLOORS: [&str; 20] = [
    "table",
    "record",
    "keys",
    "numerics",
    "physics",
    "bearing",
    "integrate",
    "shooting",
    "rotor",
    "analysis",
    "quasi_static",
    "simulate",
    "steady",
    "measurement",
    "study",
    "fit",
    "scenario",
    "report",
    "ask",
    "cli",
];

/// Libraries and the only floors that may name them.
const LIBRARIES: [(&str, &[&str]); 19] = [
    ("ode_solvers", &["integrate"]),
    ("rustfft", &["analysis"]),
    ("realfft", &["analysis"]),
    ("ellip", &["physics"]),
    ("csv", &["bearing", "report", "scenario"]),
    ("flate2", &["record"]),
    ("parquet", &["record", "report"]),
    ("ryu", &["report"]),
    ("png", &["report"]),
    ("crc32fast", &["report"]),
    ("comfy_table", &["report"]),
    ("clap", &["cli"]),
    ("clap_complete", &["cli"]),
    ("clap_mangen", &["cli"]),
    ("ctrlc", &["cli"]),
    ("indicatif", &["cli"]),
    ("toml", &["record", "scenario"]),
    ("jsonc_parser", &["scenario"]),
    ("annotate_snippets", &["scenario"]),
];

/// Every source file with its floor and its code (comments taken out).
fn sources() -> Vec<(PathBuf, String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    collect(&root, &mut files);
    files
        .into_iter()
        .map(|path| {
            let inside = path.strip_prefix(&root).expect("a file below src");
            let first = inside.components().next().expect("a file name");
            let floor = first
                .as_os_str()
                .to_string_lossy()
                .trim_end_matches(".rs")
                .to_owned();
            let text = fs::read_to_string(&path).expect("a readable source file");
            let code = text
                .lines()
                .filter(|line| !line.trim_start().starts_with("//"))
                .collect::<Vec<_>>()
                .join("\n");
            (inside.to_owned(), floor, code)
        })
        .collect()
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a readable folder") {
        let path = entry.expect("a readable entry").path();
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}

fn level(floor: &str) -> Option<usize> {
    FLOORS.iter().position(|name| *name == floor)
}

/// Whether `code` names the path `prefix::`, not as the end of a longer name.
fn names(code: &str, prefix: &str) -> bool {
    let path = format!("{prefix}::");
    code.match_indices(&path).any(|(at, _)| {
        !code[..at]
            .ends_with(|before: char| before.is_alphanumeric() || before == '_' || before == ':')
    })
}

#[test]
fn every_source_file_stands_on_a_floor() {
    for (file, floor, _) in sources() {
        let known =
            level(&floor).is_some() || ["internals", "lib", "main"].contains(&floor.as_str());
        assert!(known, "{} stands on no floor", file.display());
    }
}

/// First words of the paths in every `use crate::{…}`.
fn grouped(code: &str) -> Vec<&str> {
    let mut words = Vec::new();
    for (at, group) in code.match_indices("crate::{") {
        let (mut depth, mut start) = (1, at + group.len());
        for (place, c) in code[start..].char_indices() {
            let place = at + group.len() + place;
            match c {
                '{' => depth += 1,
                '}' => depth -= 1,
                _ => {}
            }
            if depth == 0 || (depth == 1 && c == ',') {
                let path = code[start..place].trim();
                words.extend(path.split([':', ' ', '{']).next());
                start = place + c.len_utf8();
            }
            if depth == 0 {
                break;
            }
        }
    }
    words
}

#[test]
fn grouped_imports_are_seen() {
    let code = "use crate::{report::{A, B}, cli::run,\n    physics as p};";
    assert_eq!(grouped(code), ["report", "cli", "physics"]);
}

#[test]
fn no_floor_names_a_higher_one() {
    for (file, floor, code) in sources() {
        let Some(own) = level(&floor) else { continue };
        let grouped = grouped(&code);
        for higher in &FLOORS[own + 1..] {
            let named = names(&code, &format!("crate::{higher}")) || grouped.contains(higher);
            assert!(!named, "{} names the higher floor {higher}", file.display());
        }
    }
}

#[test]
fn each_library_stands_on_its_own_floor_only() {
    for (file, floor, code) in sources() {
        for (library, floors) in LIBRARIES {
            let allowed = floors.contains(&floor.as_str());
            assert!(
                allowed || !names(&code, library),
                "{} names {library}",
                file.display()
            );
        }
    }
}

#[test]
fn the_main_file_is_short() {
    let main = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/main.rs");
    let lines = fs::read_to_string(main)
        .expect("src/main.rs")
        .lines()
        .count();
    assert!(lines <= 20, "src/main.rs has {lines} lines");
}
