//! Files with anything in them: scenarios, studies, load series and rows of studies, changed at random from
//! good ones, are taken or refused in words, without a panic and in time.
//!
//! Each test takes a few seconds. `JEFFCOTT_MUTANTS=20000 cargo test --lib campaign` changes each kind of file so often,
//! scenarios four times as often; the numbers drawn are the same every time.

use std::fmt::Write;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use tempfile::TempDir;

use crate::ask::{AskError, StudyQuestion, merge};
use crate::report::many::open;
use crate::scenario::{self, Format, ScenarioError};
use crate::simulate::{Model, Monitor, RunSize, simulate};
use crate::study::many::{Direction, Outcome, RunRecord, Shard};

/// Longest time that one file may take.
const LONGEST: Duration = Duration::from_secs(30);
/// Steps that a run of a changed scenario is followed for.
const STEPS: u64 = 60;
/// Samples of it.
const SAMPLES: f64 = 40.0;

/// How many files of each kind are made of the good ones.
fn mutants() -> u64 {
    let asked = std::env::var("JEFFCOTT_MUTANTS").ok();
    asked.map_or(400, |text| text.parse().expect("a whole number"))
}

/// The same numbers every time: xorshift by Marsaglia.
struct Chance(u64);

impl Chance {
    fn from_seed(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % count.max(1) as u64) as usize
    }

    fn one<'a, T: ?Sized>(&mut self, of: &[&'a T]) -> &'a T {
        of[self.below(of.len())]
    }
}

/// What is written in place of numbers, words and lines.
const NUMBERS: [&str; 22] = [
    "0",
    "-1",
    "1e-300",
    "1e300",
    "nan",
    "inf",
    "-0.0",
    "1e-9",
    "1e9",
    "3",
    "0.5",
    "2",
    "1e4",
    "-1e-6",
    "100",
    "64",
    "7.5",
    "4294967296",
    "18446744073709551616",
    "1e-3",
    "0.999",
    "9007199254740993",
];
const WORDS: [&str; 30] = [
    "N",
    "kN",
    "mm",
    "um",
    "s",
    "ms",
    "rad/s",
    "rpm",
    "Hz",
    "kHz",
    "kg",
    "auto",
    "hertz",
    "jones",
    "linear",
    "rodas",
    "exponential",
    "verner76",
    "dopri5",
    "dop853",
    "+z",
    "-z",
    "all",
    "radial",
    "true",
    "false",
    "gn",
    "x",
    "tilt_x",
    "µ",
];
const LINES: [&str; 25] = [
    "[[bearing]]\ncatalogue = \"6205\"",
    "[[load]]\nconstant = { z = \"10 N\" }",
    "[[spectrum]]\nkind = \"whirl\"",
    "[[spectrum]]\nkind = \"envelope\"\nband = [\"1 Hz\", \"2 Hz\"]",
    "[[load]]\nharmonic = { amplitude = { x = \"1 N\" }, frequency = \"1 kHz\" }",
    "[[load]]\nshock = { peak = { x = \"1e9 N\" }, duration = \"1 us\", at = \"1 ms\" }",
    "[output]\nsample_rate = \"1 GHz\"",
    "film = true",
    "table = true",
    "contact = \"auto\"",
    "preload = \"1 MN\"",
    "spring_preload = \"1 N\"",
    "position = \"1 m\"",
    "[initial]\ndisplacement = { x = \"1 m\" }",
    "cage = \"operating\"",
    "[[load]]\nnoise = { rms = { x = \"1 N\" }, low = \"1 Hz\", high = \"1 MHz\", lines = 4096, seed = 1 }",
    "duration = \"1e6 s\"",
    "[damping]\nratio = 30",
    "energy = true",
    "balls = true",
    "maps = true",
    "every = 1000000",
    "[a.b.c.d]",
    "method = \"rodas\"",
    "arrangement = \"tandem\"\nspacing = \"1 um\"",
];

/// A text with some of it changed.
fn changed(text: &str, chance: &mut Chance) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for _ in 0..1 + chance.below(4) {
        let line = chance.below(lines.len());
        match chance.below(8) {
            0 => drop(lines.remove(line)),
            1 => lines.insert(line, lines[chance.below(lines.len())].clone()),
            2 => lines.insert(line, chance.one(&LINES).to_owned()),
            3 => {
                let other = chance.below(lines.len());
                lines.swap(line, other);
            }
            4 => lines[line] = with_byte_changed(&lines[line], chance),
            5 => {
                lines[line] = with_part_replaced(&lines[line], char::is_alphabetic, &WORDS, chance)
            }
            _ => {
                let number = |c: char| c.is_ascii_digit() || ".e+-".contains(c);
                lines[line] = with_part_replaced(&lines[line], number, &NUMBERS, chance);
            }
        }
        if lines.is_empty() {
            lines.push(String::new());
        }
    }
    lines.join("\n")
}

fn with_byte_changed(line: &str, chance: &mut Chance) -> String {
    let place = chance.below(line.chars().count() + 1);
    let mut characters: Vec<char> = line.chars().collect();
    let new = chance.one(&[
        "\"", "[", "]", "{", "}", "=", ".", ",", "0", "a", "µ", "\u{0}", " ", "-",
    ]);
    characters.splice(
        place..(place + chance.below(2)).min(characters.len()),
        new.chars(),
    );
    characters.into_iter().collect()
}

/// A line with one of its stretches of some characters replaced.
fn with_part_replaced(
    line: &str,
    of: impl Fn(char) -> bool,
    by: &[&str],
    chance: &mut Chance,
) -> String {
    let mut parts: Vec<String> = Vec::new();
    let mut inside = false;
    for c in line.chars() {
        if parts.is_empty() || of(c) != inside {
            parts.push(String::new());
            inside = of(c);
        }
        if let Some(part) = parts.last_mut() {
            part.push(c);
        }
    }
    let places: Vec<_> = (0..parts.len())
        .filter(|part| parts[*part].chars().all(&of))
        .collect();
    if let Some(place) = places.get(chance.below(places.len())) {
        parts[*place] = chance.one(by).to_owned();
    }
    parts.concat()
}

/// Tries `count` inputs: none panics, and none takes too long. `make` gives an input in words, `take` takes it.
fn campaign<T: Send>(
    count: u64,
    make: impl Fn(&mut Chance) -> T + Sync,
    show: impl Fn(&T) -> String + Sync,
    take: impl Fn(&T, &mut Chance) + Sync,
) {
    let current = Mutex::new(String::new());
    let (running, ended) = channel();
    thread::scope(|scope| {
        scope.spawn(|| {
            let running = running;
            for seed in 0..count {
                let mut chance = Chance::from_seed(seed + 1);
                let input = make(&mut chance);
                *current.lock().expect("a whole text") = show(&input);
                let taken = catch_unwind(AssertUnwindSafe(|| take(&input, &mut chance)));
                assert!(taken.is_ok(), "input {seed} panics:\n{}", show(&input));
                running.send(()).expect("somebody waits");
            }
        });
        loop {
            match ended.recv_timeout(LONGEST) {
                Ok(()) => {}
                Err(RecvTimeoutError::Disconnected) => break,
                Err(RecvTimeoutError::Timeout) => {
                    // the thread that hangs could not be waited for
                    eprintln!(
                        "an input takes too long:\n{}",
                        current.lock().expect("a whole text")
                    );
                    std::process::abort();
                }
            }
        }
    });
}

/// All that is wrong is told in words.
fn assert_told(error: &ScenarioError) {
    assert!(!error.issues.is_empty());
    assert!(!error.render(false).trim().is_empty());
    for issue in error.issues_json().as_array().expect("a list") {
        assert!(
            issue["message"]
                .as_str()
                .is_some_and(|text| !text.trim().is_empty()),
            "{issue}"
        );
    }
}

/// Follows the first steps of a motion.
fn begin(mut model: Model) {
    let Ok(size) = RunSize::from_model(&model) else {
        return;
    };
    if size.memory > 2e8 {
        return;
    }
    model.duration = (model.duration * SAMPLES / size.samples as f64).min(model.duration);
    model.settle = model.settle.min(0.5 * model.duration);
    model.integrator.step_limit = STEPS;
    let stop = AtomicBool::new(false);
    let mut monitor = Monitor {
        stop: &stop,
        progress: &mut |_| {},
    };
    let mut report = Nobody;
    match simulate(&model, &mut report, &mut monitor) {
        Ok(run) => assert!(
            run.warnings
                .iter()
                .all(|warning| !warning.trim().is_empty())
        ),
        Err(error) => assert!(!error.to_string().trim().is_empty()),
    }
}

struct Nobody;

impl crate::simulate::TraceSink for Nobody {
    fn sample(&mut self, _: &crate::rotor::Sample) -> std::io::Result<()> {
        Ok(())
    }
}

fn scenarios() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios")
}

fn texts(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path());
    let mut files: Vec<_> = entries
        .filter(|path| path.extension().is_some_and(|end| end == "toml"))
        .collect();
    files.sort();
    files
        .iter()
        .map(|file| fs::read_to_string(file).expect("a text"))
        .collect()
}

#[test]
fn changed_scenarios_are_taken_or_refused() {
    let hard = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/scenarios/hard");
    let texts = [texts(&scenarios()), texts(&hard)].concat();
    let make = |chance: &mut Chance| changed(&texts[chance.below(texts.len())], chance);
    let taken = AtomicU64::new(0);
    let count = 4 * mutants();
    campaign(
        count,
        make,
        String::clone,
        |text, chance| match scenario::parse(text, "mutant.toml", Format::Toml) {
            Err(error) => assert_told(&error),
            Ok(scenario) => {
                taken.fetch_add(1, Ordering::Relaxed);
                let begun = scenario.model.filter(|_| chance.below(3) == 0);
                if let Some(model) = begun {
                    begin(model);
                }
            }
        },
    );
    // neither are all good nor all refused
    let taken = taken.into_inner();
    assert!(
        (count / 20..count / 2).contains(&taken),
        "{taken} of {count}"
    );
}

#[test]
fn changed_studies_are_taken_or_refused() {
    let texts = texts(&scenarios().join("studies"));
    let folder = TempDir::new().expect("a folder");
    fs::create_dir(folder.path().join("studies")).expect("a folder");
    for entry in fs::read_dir(scenarios()).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_file() {
            fs::copy(&path, folder.path().join(path.file_name().expect("a name"))).expect("a copy");
        }
    }
    let file = folder.path().join("studies/mutant.toml");
    let make = |chance: &mut Chance| changed(&texts[chance.below(texts.len())], chance);
    campaign(mutants(), make, String::clone, |text, _| {
        fs::write(&file, text).expect("a written file");
        match scenario::load_study(&file, &[]) {
            Err(error) => assert_told(&error),
            Ok(study) => {
                let last = study.plan.runs().unwrap_or(u64::MAX).saturating_sub(1);
                for point in [0, last] {
                    if let Err(error) = study.model(&study.plan.values(point)) {
                        assert!(!error.message.trim().is_empty());
                    }
                }
            }
        }
    });
}

#[test]
fn changed_load_series_are_taken_or_refused() {
    let mut table = "t_s,x_N,z_N\n".to_owned();
    for row in 0..12 {
        writeln!(
            table,
            "{},{},{}",
            f64::from(row) * 1e-3,
            row % 5,
            0.25 * f64::from(row)
        )
        .expect("a text");
    }
    let folder = TempDir::new().expect("a folder");
    let name = folder.path().join("scene.toml").display().to_string();
    let base = fs::read_to_string(scenarios().join("steady-7205c.toml")).expect("a scenario");
    let scene = base + "\n[[load]]\nseries = { file = \"load.csv\" }\n";
    fs::write(folder.path().join("load.csv"), &table).expect("a written file");
    scenario::parse(&scene, &name, Format::Toml).expect("it is good as it is");
    let make = |chance: &mut Chance| changed(&table, chance);
    campaign(mutants(), make, String::clone, |text, _| {
        fs::write(folder.path().join("load.csv"), text).expect("a written file");
        if let Err(error) = scenario::parse(&scene, &name, Format::Toml) {
            assert_told(&error);
        }
    });
}

#[test]
fn changed_rows_are_gone_on_with_or_refused() {
    let folder = TempDir::new().expect("a folder");
    let study = scenario::load_study(&scenarios().join("studies/resonance-7205c.toml"), &[])
        .expect("it is good");
    let question = StudyQuestion::new(&study, Shard::WHOLE).expect("its first run can be made");
    let open = || open(folder.path(), question.head(), question.runs(), false);
    let (_, mut rows) = open().expect("a folder");
    for run in rows.head.runs.clone() {
        let numbers = vec![run as f64; rows.head.numbers.len()];
        let outcome = Outcome {
            numbers,
            ..Outcome::default()
        };
        let row = RunRecord {
            run,
            direction: Direction::Alone,
            values: study.plan.values(run),
            outcome: Ok(outcome),
        };
        rows.add(&row).expect("it is written");
    }
    drop(rows);
    let path = folder.path().join("runs.jsonl");
    let text = fs::read_to_string(&path).expect("rows");
    let make = |chance: &mut Chance| changed(&text, chance) + "\n";
    campaign(mutants(), make, String::clone, |text, chance| {
        fs::write(&path, text).expect("a written file");
        let mut errors = vec![open().err().map(AskError::from)];
        if chance.below(20) == 0 {
            // as the only part of a study
            let part = folder.path().join("runs.part-1-of-1.jsonl");
            fs::write(part, text).expect("a written file");
            errors.push(merge(folder.path()).err());
        }
        let mut errors = errors.into_iter().flatten();
        assert!(errors.all(|error| !error.to_string().trim().is_empty()));
    });
}
