//! A file as it was written: its text and the tree of its values.

use std::io::{self, Read};
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::node::{Node, read_json, read_toml};
use super::problems::Problems;
use super::setting::Setting;
use super::{Format, Issue, Scenario, ScenarioError, visible};
use crate::record::open_regular;

/// Most bytes of a file.
const LARGEST: u64 = 16 << 20;

/// What stands for standard input where a file is asked for.
pub(crate) const STDIN: &str = "-";
/// What messages call standard input, and results that come of it.
pub(crate) const STDIN_NAME: &str = "stdin";

/// What a file asks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FileKind {
    /// What happens in a scene.
    Scenario,
    /// Many runs of a scenario.
    Study,
    /// Values of quantities of a scenario.
    Fit,
    /// What a record of sensors holds.
    Record,
}

impl FileKind {
    /// What messages call a file of this kind.
    fn name(self) -> &'static str {
        match self {
            Self::Scenario => "a scenario",
            Self::Study => "a study file",
            Self::Fit => "a fit file",
            Self::Record => "a description of a record of sensors",
        }
    }
}

/// A text that is TOML or JSON.
#[derive(Debug)]
pub(super) struct Document {
    /// What messages call the file.
    pub name: String,
    text: String,
    root: Node,
    /// What a command line sets, a line each.
    options: String,
}

/// What a text says, unchecked: its tables and values as they are written, without defaults.
///
/// # Errors
/// [`ScenarioError`] where it is no TOML or JSON.
pub fn written(text: &str, name: &str, format: Format) -> Result<Value, ScenarioError> {
    let document = Document::parse(text, name, format)?;
    Ok(Value::from(&document.root))
}

impl Document {
    /// Reads a file in the language that the end of its name tells; `-` is standard input, whose JSON begins with a
    /// brace.
    pub fn open(path: &Path) -> Result<Self, ScenarioError> {
        if path == Path::new(STDIN) {
            return Self::of_input(&text_of(path)?);
        }
        let extension = path.extension().and_then(|end| end.to_str());
        match extension.map(str::to_ascii_lowercase).as_deref() {
            Some("toml") => Self::open_as(path, Format::Toml),
            Some("json") => Self::open_as(path, Format::Json),
            _ => Err(unreadable(path, "a scenario file ends in .toml or .json")),
        }
    }

    /// Reads the text of standard input.
    pub fn of_input(text: &str) -> Result<Self, ScenarioError> {
        let format = match text.trim_start().starts_with('{') {
            true => Format::Json,
            false => Format::Toml,
        };
        Self::parse(text, STDIN_NAME, format)
    }

    /// Reads a file in a language.
    pub fn open_as(path: &Path, format: Format) -> Result<Self, ScenarioError> {
        Self::parse(&text_of(path)?, &path.display().to_string(), format)
    }

    /// Reads a text; `name` is what messages call it.
    pub fn parse(text: &str, name: &str, format: Format) -> Result<Self, ScenarioError> {
        // places in the text count from behind a byte order mark
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let root = match format {
            Format::Toml => read_toml(text),
            Format::Json => read_json(text),
        };
        Ok(Self {
            root: root.map_err(|issues| ScenarioError::new(name, text, issues))?,
            name: name.to_owned(),
            text: text.to_owned(),
            options: String::new(),
        })
    }

    /// With some values in place of its own, each as `key=value`.
    ///
    /// # Errors
    /// [`ScenarioError`] with those that can be put nowhere.
    pub fn with(mut self, settings: &[String]) -> Result<Self, ScenarioError> {
        let mut issues = Vec::new();
        for text in settings {
            let start = self.text.len() + self.options.len();
            let setting = Setting::new(text, start);
            issues.extend(
                setting
                    .and_then(|setting| setting.apply(&mut self.root))
                    .err(),
            );
            self.options += text;
            self.options.push('\n');
        }
        match issues.is_empty() {
            true => Ok(self),
            false => Err(self.error(issues)),
        }
    }

    fn error(&self, issues: Vec<Issue>) -> ScenarioError {
        ScenarioError {
            options: self.options.clone(),
            ..ScenarioError::new(&self.name, &self.text, issues)
        }
    }

    /// What kind of file it is, by a table or key that no other kind has; none where that is not clear.
    pub fn kind(&self) -> Option<FileKind> {
        let has = |key| self.root.find(key).is_some();
        match (has("shaft"), has("base")) {
            (true, true) => None,
            (true, false) => Some(FileKind::Scenario),
            _ if has("unknown") || has("observation") => Some(FileKind::Fit),
            (false, true) => Some(FileKind::Study),
            (false, false) => has("record").then_some(FileKind::Record),
        }
    }

    /// Refuses a file of another kind than that which is due.
    pub fn check_kind(&self, due: FileKind) -> Result<(), ScenarioError> {
        let Some(kind) = self.kind().filter(|kind| *kind != due) else {
            return Ok(());
        };
        let (key, names, help) = match kind {
            FileKind::Scenario => (
                "shaft",
                "",
                "use `jeffcott run`, `bearing`, `steady`, `campbell` or `accuracy`",
            ),
            FileKind::Study => (
                "base",
                ": it names the scenario that its runs start from",
                "use `jeffcott study`, or give that scenario",
            ),
            FileKind::Fit => (
                "unknown",
                ": it names the scenario whose quantities are sought",
                "use `jeffcott fit`, or give that scenario",
            ),
            FileKind::Record => ("record", "", "use `jeffcott analyze`"),
        };
        let message = format!("this is {}, not {}{names}", kind.name(), due.name());
        Err(self.refused(Issue::new(key, message).help(help)))
    }

    /// The scenario that it names by its `base`, and the folder of that; `None` where nothing is there.
    ///
    /// # Errors
    /// [`ScenarioError`] of that scenario.
    pub fn base(
        &self,
        named: &str,
        problems: &mut Problems<'_>,
    ) -> Result<Option<(Scenario, PathBuf)>, ScenarioError> {
        if problems.is_faulty("base") {
            return Ok(None);
        }
        let base = self.folder().join(named);
        if base.exists() {
            let folder = base.parent().unwrap_or(Path::new("")).to_owned();
            return Ok(Some((super::load(&base)?, folder)));
        }
        let message = format!("there is no scenario {}", base.display());
        let help = format!(
            "`{named}` is looked for from the folder of {}",
            problems.subject
        );
        problems.add(Issue::new("base", message).help(help));
        Ok(None)
    }

    /// The folder that files named in it are relative to.
    pub fn folder(&self) -> &Path {
        Path::new(&self.name).parent().unwrap_or(Path::new(""))
    }

    /// Its title where it gives none: the name of the file.
    pub fn stem(&self) -> String {
        let stem = Path::new(&self.name).file_stem();
        let stem = stem.map_or(self.name.as_str().into(), |stem| stem.to_string_lossy());
        visible(&stem.replace(['\n', '\t'], " "))
    }

    /// Nothing found yet in it.
    pub fn problems(&self) -> Problems<'_> {
        Problems::new(&self.root, self.folder())
    }

    /// The error of a single problem, shown at its place.
    pub fn refused(&self, issue: Issue) -> ScenarioError {
        let mut problems = self.problems();
        problems.add(issue);
        self.error(problems.issues)
    }

    /// What was made of it and the warnings, or everything that is wrong with it.
    pub fn finish<T>(
        &self,
        made: Option<T>,
        problems: Problems<'_>,
    ) -> Result<(T, Vec<String>), ScenarioError> {
        let issues = problems.issues;
        match made {
            Some(made) if issues.is_empty() => Ok((made, problems.warnings)),
            _ => Err(self.error(issues)),
        }
    }
}

/// The text of a file of a size that can be kept.
fn text_of(path: &Path) -> Result<String, ScenarioError> {
    let bytes = bytes_of(path)
        .map_err(|error| unreadable(path, &format!("cannot read the file: {error}")))?;
    if bytes.len() as u64 > LARGEST {
        let message = format!(
            "the file is larger than the {} MB that a scenario or study may have; a long load belongs in the \
             CSV file of a `series`",
            LARGEST >> 20
        );
        return Err(unreadable(path, &message));
    }
    String::from_utf8(bytes).map_err(|error| {
        let byte = error.utf8_error().valid_up_to();
        let message = format!("the file is not UTF-8 text: byte {byte} is wrong");
        unreadable(path, &message)
    })
}

/// The text of a file that a scenario names, of at most so many bytes.
///
/// # Errors
/// What is wrong with it.
pub(super) fn file_text(path: &Path, most: u64) -> Result<String, String> {
    let mut text = String::new();
    let read = open_regular(path, most).and_then(|mut file| file.read_to_string(&mut text));
    read.map_err(|error| format!("it cannot be read: {error}"))?;
    Ok(text)
}

/// The bytes of a file, as many as it may have and one more.
fn bytes_of(path: &Path) -> io::Result<Vec<u8>> {
    let source: &mut dyn Read = match path == Path::new(STDIN) {
        true => &mut io::stdin(),
        // a longer one is refused with advice
        false => &mut open_regular(path, u64::MAX)?,
    };
    let mut bytes = Vec::new();
    source.take(LARGEST + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn unreadable(path: &Path, message: &str) -> ScenarioError {
    let issue = Issue::new("", message);
    ScenarioError::new(&path.display().to_string(), "", vec![issue])
}
