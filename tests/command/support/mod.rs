//! What the tests of the command share: how it is started and what it said, the files that it is given and
//! those that it leaves.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output};
use std::thread;
use std::time::Duration;

use serde_json::Value;

/// The path of the command.
pub const PROGRAM: &str = env!("CARGO_BIN_EXE_jeffcott");

/// The command, without arguments.
pub fn jeffcott() -> Command {
    Command::new(PROGRAM)
}

/// What the command says to arguments in a folder.
pub fn jeffcott_in(folder: impl AsRef<Path>, arguments: &[&str]) -> Output {
    let mut command = jeffcott();
    command.args(arguments).current_dir(folder);
    command.output().expect("the command starts")
}

/// A verb for files, with its results in a folder.
pub fn verb<P: AsRef<Path>>(verb: &str, files: &[P], out: &Path, more: &[&str]) -> Command {
    let mut command = jeffcott();
    command.arg(verb).args(files.iter().map(AsRef::as_ref));
    command.arg("--out").arg(out).args(more);
    command
}

/// What was written to a stream.
pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// The messages of a command.
pub fn told(output: &Output) -> String {
    text(&output.stderr)
}

/// The output of a command that must end well.
#[track_caller]
pub fn done(output: Output) -> Output {
    assert!(output.status.success(), "{}", told(&output));
    output
}

/// Waits until a file has so many bytes.
pub fn wait_for(file: &Path, bytes: u64) {
    while fs::metadata(file).map_or(0, |data| data.len()) < bytes {
        thread::sleep(Duration::from_millis(2));
    }
}

/// Interrupts a command as the keyboard does.
pub fn interrupt(child: &Child) {
    let kill = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(kill.expect("kill starts").success());
}

/// Where the crate lies.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The folder of the shipped scenarios.
pub fn scenarios() -> PathBuf {
    root().join("scenarios")
}

/// A shipped scenario, or a study as `studies/…`, by its name without ending.
pub fn shipped(name: &str) -> PathBuf {
    scenarios().join(name).with_extension("toml")
}

/// The text of a shipped scenario.
pub fn shipped_text(name: &str) -> String {
    fs::read_to_string(shipped(name)).expect("a shipped scenario")
}

/// The files of a folder that end in `.toml`, sorted.
pub fn toml_files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a readable folder");
    let mut files: Vec<_> = entries
        .map(|entry| entry.expect("a readable entry").path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
        .collect();
    files.sort();
    files
}

/// A copy of a shipped scenario in a folder, some of its text replaced.
pub fn changed(folder: &Path, name: &str, changes: &[(&str, &str)]) -> PathBuf {
    let mut text = shipped_text(name);
    for (old, new) in changes {
        assert!(text.contains(old), "{name} has no {old}");
        text = text.replace(old, new);
    }
    let file = folder.join(name).with_extension("toml");
    fs::write(&file, text).expect("a writable folder");
    file
}

/// What makes of `varying-compliance-6306` a run that settles for a second and keeps its forty ball passes.
pub const SHORT_VARYING_COMPLIANCE: [(&str, &str); 2] = [
    ("duration = \"14.126 s\"", "duration = \"1.544 s\""),
    ("settle = \"13.582 s\"", "settle = \"1 s\""),
];

/// A 7205C at 500 rad/s, loaded, for 0.03 s, with more tables at its end; `contact` is what `[model]` says.
pub fn loaded_7205c(contact: &str, tables: &str) -> String {
    format!(
        "[shaft]\nmass = \"5 kg\"\neccentricity = \"5 um\"\nfreedoms = \"translational\"\n\
         gravity = true\n[speed]\nconstant = \"500 rad/s\"\n[[bearing]]\ncatalogue = \"7205C\"\n\
         [model]\n{contact}\n[damping]\nratio = 0.02\n\
         [[load]]\nconstant = {{ y = \"-300 N\", z = \"1000 N\" }}\n\
         [time]\nduration = \"0.03 s\"\nsettle = \"0.01 s\"\n{tables}"
    )
}

/// Names of what stands in a folder, sorted.
pub fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a readable folder");
    let name = |entry: fs::DirEntry| entry.file_name().to_string_lossy().into_owned();
    let mut names: Vec<_> = entries
        .map(|entry| name(entry.expect("a readable entry")))
        .collect();
    names.sort();
    names
}

/// All files of a folder, and of the folders in it, with their bytes.
pub fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut all = Vec::new();
    for name in names(folder) {
        let path = folder.join(&name);
        if path.is_dir() {
            all.extend(files(&path));
        } else {
            all.push((name, fs::read(path).expect("a readable file")));
        }
    }
    all.sort();
    all
}

/// A copy of a folder with the folders in it.
pub fn copy_folder(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("a writable folder");
    for name in names(from) {
        let (path, target) = (from.join(&name), to.join(&name));
        if path.is_dir() {
            copy_folder(&path, &target);
        } else {
            fs::copy(&path, &target).expect("a copy");
        }
    }
}

/// A file of JSON.
pub fn json(path: &Path) -> Value {
    let text = fs::read_to_string(path).expect("a readable file");
    serde_json::from_str(&text).expect("JSON")
}

/// A column of numbers of a table by its name.
pub fn column(table: &Path, name: &str) -> Vec<f64> {
    let mut reader = csv::Reader::from_path(table).expect("a table");
    let names = reader.headers().expect("names").clone();
    let place = names.iter().position(|known| known == name);
    let place = place.unwrap_or_else(|| panic!("no column {name} in {}", table.display()));
    let cell = |row: Result<csv::StringRecord, csv::Error>| row.expect("a row")[place].parse();
    let numbers: Result<_, _> = reader.records().map(cell).collect();
    numbers.expect("numbers")
}
