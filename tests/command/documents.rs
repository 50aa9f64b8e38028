//! Every command, every scenario and every link of the README and of the manual works as it stands.
//!
//! A block of TOML that starts with a comment `# name.toml` is a file of this name: the commands of its page find
//! it. A block that is no whole scenario is checked in place of the same tables of a shipped one.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;

use crate::support::{PROGRAM, copy_folder, jeffcott_in, root, scenarios, shipped_text, told};

/// Tables that a study alone has.
const STUDY: [&str; 4] = ["axis", "cycles", "keep", "set"];

/// Its commands are run by a test of their own, which looks at what they draw.
const GALLERY: &str = "docs/gallery.md";

/// What completes a block that is no whole scenario.
const BASE: &str = "back-to-back-7205c";

/// What stands in for the programs that a page may name beside `jeffcott`: a run by cargo is one of `jeffcott`.
const STAND_INS: &str = r#"set -e
cargo() {
    case "$1" in
        run) shift 3; jeffcott "$@" ;;
        test|install|bench|doc|fmt|clippy) ;;
        *) return 1 ;;
    esac
}
sbatch() { :; }
pip() { :; }
mdbook() { :; }
"#;

/// A page with its folder, from the root.
pub struct Page {
    path: PathBuf,
    pub text: String,
}

impl Page {
    pub fn read(path: PathBuf) -> Self {
        let text = fs::read_to_string(root().join(&path)).expect("a readable page");
        Self { path, text }
    }

    fn name(&self) -> String {
        self.path.display().to_string()
    }

    /// The fenced blocks in one language.
    fn blocks(&self, language: &str) -> Vec<String> {
        let fence = format!("\n```{language}\n");
        let rest = self.text.split(&fence).skip(1);
        rest.map(|rest| rest.split("\n```").next().unwrap_or_default().to_owned() + "\n")
            .collect()
    }

    /// The blocks that are files, with their names.
    fn files(&self) -> Vec<(String, String)> {
        let blocks = self.blocks("toml").into_iter();
        blocks
            .filter_map(|text| Some((file_name(&text)?, text)))
            .collect()
    }

    /// A folder with the shipped scenarios and the files of the page.
    pub fn folder(&self) -> tempfile::TempDir {
        let folder = tempfile::tempdir().expect("a temporary folder");
        copy_folder(&scenarios(), &folder.path().join("scenarios"));
        for (name, text) in self.files() {
            fs::write(folder.path().join(name), text).expect("a writable folder");
        }
        folder
    }

    /// The commands of the page, one after the other as they stand, in a folder; how many there are.
    pub fn run_commands(&self, folder: &Path) -> usize {
        let programs = Path::new(PROGRAM).parent().expect("a folder").display();
        let path = std::env::var("PATH").unwrap_or_default();
        let script = format!("{STAND_INS}{}", self.blocks("sh").join("\n"));
        let mut shell = Command::new("bash");
        shell.args(["-v", "-c", &script]).current_dir(folder);
        shell.env("PATH", format!("{programs}:{path}"));
        let output = shell.output().expect("a shell");
        assert!(
            output.status.success(),
            "{}: {}",
            self.name(),
            told(&output)
        );
        let lines = self.blocks("sh").join("\n");
        let calls = |line: &&str| line.starts_with("jeffcott ") || line.starts_with("cargo run ");
        lines.lines().filter(calls).count()
    }

    /// The scenarios and studies of the page, as files in a folder with those that are shipped.
    fn write_scenarios(&self, folder: &Path) -> Vec<String> {
        let mut written = Vec::new();
        for (number, text) in self.blocks("toml").into_iter().enumerate() {
            let table: toml::Table = text
                .parse()
                .unwrap_or_else(|error| panic!("{}: {error}\n{text}", self.name()));
            let study = table.contains_key("base");
            let whole = table.contains_key("shaft") && table.contains_key("speed");
            let name = file_name(&text);
            let part = !study && !whole;
            if part && name.is_some() {
                continue; // a file of another kind, which a command of the page reads
            }
            let name = name.unwrap_or_else(|| format!("block-{number}.toml"));
            let text = match part {
                true if STUDY.iter().any(|key| table.contains_key(*key)) => completed_study(table),
                true => completed(table),
                false => text,
            };
            fs::write(folder.join(&name), text).expect("a writable folder");
            written.push(name);
        }
        written
    }
}

/// The name in the comment that begins a file.
fn file_name(text: &str) -> Option<String> {
    let name = text.lines().next()?.strip_prefix("# ")?;
    let right = name.ends_with(".toml") && !name.contains([' ', '/']);
    right.then(|| name.to_owned())
}

/// The tables of a shipped scenario, those of a block in their place.
fn completed(block: toml::Table) -> String {
    let mut whole: toml::Table = shipped_text(BASE).parse().expect("a shipped scenario");
    whole.extend(block);
    whole.to_string()
}

/// The tables of a study with a base and an axis.
fn completed_study(block: toml::Table) -> String {
    let text =
        format!("base = '{BASE}.toml'\n[[axis]]\nkey = 'speed.constant'\nvalues = ['500 rad/s']\n");
    let mut whole: toml::Table = text.parse().expect("a study");
    whole.extend(block);
    whole.to_string()
}

fn collect(folder: &Path, pages: &mut Vec<Page>) {
    for entry in fs::read_dir(root().join(folder)).expect("a readable folder") {
        let path = folder.join(entry.expect("a readable entry").file_name());
        if root().join(&path).is_dir() {
            collect(&path, pages);
        } else if path.extension().is_some_and(|ending| ending == "md") {
            pages.push(Page::read(path));
        }
    }
}

fn pages() -> Vec<Page> {
    let mut pages = Vec::new();
    for name in ["README.md", "CONTRIBUTING.md"] {
        pages.push(Page::read(name.into()));
    }
    for folder in ["docs", "scenarios"] {
        collect(Path::new(folder), &mut pages);
    }
    assert!(pages.len() >= 15, "the manual is there");
    pages
}

#[test]
fn every_command_ends_well() {
    let pages = pages();
    let run: usize = thread::scope(|scope| {
        let all: Vec<_> = pages
            .iter()
            .filter(|page| page.path != Path::new(GALLERY))
            .map(|page| scope.spawn(|| page.run_commands(page.folder().path())))
            .collect();
        let counts = all
            .into_iter()
            .map(|page| page.join().expect("the commands of a page end well"));
        counts.sum()
    });
    assert!(run >= 40, "only {run} commands found");
}

#[test]
fn every_scenario_and_every_study_is_right() {
    let mut checked = 0;
    for page in pages() {
        let folder = page.folder();
        // a study may name a shipped scenario as its neighbour
        copy_folder(&scenarios(), folder.path());
        let names = page.write_scenarios(folder.path());
        checked += names.len();
        if !names.is_empty() {
            let mut words = vec!["check"];
            words.extend(names.iter().map(String::as_str));
            let output = jeffcott_in(&folder, &words);
            assert!(
                output.status.success(),
                "{}: {}",
                page.name(),
                told(&output)
            );
        }
    }
    assert!(checked >= 6, "only {checked} scenarios found");
}

/// The targets of links and pictures, but not those of other sites.
fn links(text: &str) -> Vec<String> {
    let prose: Vec<&str> = text.split("\n```").step_by(2).collect();
    let prose = prose.join("\n");
    let targets = prose.split("](").skip(1);
    let targets = targets.filter_map(|rest| rest.split(')').next());
    targets
        .filter(|target| !target.contains("://"))
        .map(str::to_owned)
        .collect()
}

/// The anchors that forges and mdBook give to the headings of a page.
fn anchors(text: &str) -> Vec<String> {
    let headings = text.lines().filter(|line| line.starts_with('#'));
    headings
        .map(|line| {
            let words = line.trim_start_matches('#').trim().to_lowercase();
            let words = words.replace(' ', "-");
            words
                .chars()
                .filter(|letter| letter.is_alphanumeric() || "-_".contains(*letter))
                .collect()
        })
        .collect()
}

#[test]
fn every_link_leads_somewhere() {
    for page in pages() {
        let folder = root().join(page.path.parent().expect("a folder"));
        for link in links(&page.text) {
            let (file, anchor) = link.split_once('#').unwrap_or((&link, ""));
            let target = if file.is_empty() {
                root().join(&page.path)
            } else {
                folder.join(file)
            };
            assert!(target.exists(), "{}: {link}", page.name());
            if !anchor.is_empty() {
                let text = fs::read_to_string(&target).expect("a readable page");
                let known = anchors(&text).iter().any(|known| known == anchor);
                assert!(known, "{}: {link}", page.name());
            }
        }
    }
}

#[test]
fn every_page_of_the_manual_stands_in_its_contents() {
    let contents = fs::read_to_string(root().join("docs/SUMMARY.md")).expect("docs/SUMMARY.md");
    let listed = links(&contents);
    for page in pages() {
        let Ok(inside) = page.path.strip_prefix("docs") else {
            continue;
        };
        let inside = inside.display().to_string();
        assert!(
            inside == "SUMMARY.md" || listed.contains(&inside),
            "{inside} is not in docs/SUMMARY.md"
        );
    }
}

#[test]
fn the_readme_is_short() {
    let readme = Page::read("README.md".into());
    let lines = readme.text.lines().count();
    assert!(lines <= 140, "README.md has {lines} lines");
}

#[test]
fn the_front_of_the_manual_links_every_chapter() {
    let chapters =
        links(&fs::read_to_string(root().join("docs/SUMMARY.md")).expect("docs/SUMMARY.md"));
    let linked = links(&Page::read("docs/README.md".into()).text);
    let unlinked = chapters
        .iter()
        .filter(|chapter| *chapter != "README.md" && !linked.contains(chapter));
    assert_eq!(unlinked.collect::<Vec<_>>(), Vec::<&String>::new());
}
