//! From `[study]` to its questions: each value is put into the checked scenario, which is then
//! checked again.

use std::path::Path;

use serde_json::{Map, Number, Value};

use super::dimension::{Dimension, Unit};
use super::input::{Questions, StudyInput};
use super::issue::Issue;
use super::node::Node;
use super::problems::Problems;
use super::schema::schema;
use super::walk::{self, Range, nearest};
use super::{build as build_scenario, quantity};
use crate::study::{Study, StudyPoint, Variable};

/// Tables that play no part in a static question.
const MOTION: [&str; 5] = ["damping", "initial", "time", "integrator", "output"];

/// A key that can vary.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Key<'a> {
    pub path: String,
    schema: &'a Value,
}

/// A value of the key, and where it was given.
pub(super) struct Given {
    pub value: Value,
    path: String,
}

/// The study, as far as nothing contradicts it; `echo` is the scenario with its defaults.
pub(super) fn build(
    input: &StudyInput,
    echo: &Value,
    problems: &mut Problems<'_>,
) -> Option<Study> {
    let base = without(echo, &[&MOTION[..], &["study"]].concat());
    let key = varied(&input.vary, &base, problems)?;
    let given = match &input.values {
        Some(values) => listed(values.len(), input, &key, problems)?,
        None => spaced(input, &key, problems)?,
    };
    let mut points = Vec::with_capacity(given.len());
    for Given { value, path } in &given {
        let question = questions(&base, &key.path, value, problems.folder())
            .map(|questions| questions.question)
            .map_err(|issue| problems.refuse(at_value(issue, &key.path, value, path), &[]))
            .ok()?;
        let value = key.si(value);
        points.push(StudyPoint { value, question });
    }
    Some(Study {
        variable: key.variable(&given.first()?.value),
        points,
        positions: input.positions.map(|positions| positions as usize),
    })
}

/// A scenario without some of its tables.
pub(super) fn without(echo: &Value, left_out: &[&str]) -> Value {
    let mut base = echo.clone();
    if let Value::Object(tables) = &mut base {
        tables.retain(|name, _| !left_out.contains(&name.as_str()));
    }
    base
}

/// The key of a path among those known.
///
/// # Errors
/// The path that is nearest, if any is near.
pub(super) fn find(known: Vec<Key<'static>>, path: &str) -> Result<Key<'static>, Option<String>> {
    let near = nearest(path, known.iter().map(|key| key.path.as_str())).map(str::to_owned);
    known.into_iter().find(|key| key.path == path).ok_or(near)
}

/// The key that a static question varies.
fn varied(path: &str, base: &Value, problems: &mut Problems<'_>) -> Option<Key<'static>> {
    let refuse = |near: Option<String>| {
        let root = path.split(['.', '[']).next().unwrap_or_default();
        let message = if MOTION.contains(&root) {
            format!("`{path}` plays no part in a static question")
        } else {
            format!("the scenario has no number `{path}`")
        };
        let help = match near {
            Some(known) => format!("did you mean `{known}`?"),
            None => "for instance: vary = \"speed.constant\"".to_owned(),
        };
        problems.refuse(Issue::new("study.vary", message).help(help), &[]);
    };
    find(keys(base, &[&MOTION[..], &["study"]].concat()), path)
        .map_err(refuse)
        .ok()
}

/// Every key of a number outside some tables; lists have as many entries as `given` has.
pub(super) fn keys(given: &Value, left_out: &[&str]) -> Vec<Key<'static>> {
    let mut keys = all_keys(given, left_out);
    keys.retain(|key| !key.is_word());
    keys
}

/// As [`keys`], with those of a word out of several.
pub(super) fn all_keys(given: &Value, left_out: &[&str]) -> Vec<Key<'static>> {
    let mut keys = Vec::new();
    collect(schema(), Some(given), "", left_out, &mut keys);
    keys
}

/// Whether a schema is that of a word out of several.
fn is_word(schema: &Value) -> bool {
    let variants = schema["oneOf"].as_array();
    let listed = variants.is_some_and(|all| all.iter().all(|one| one["const"].is_string()));
    listed || schema["enum"].is_array()
}

fn collect<'a>(
    schema: &'a Value,
    given: Option<&Value>,
    path: &str,
    left_out: &[&str],
    keys: &mut Vec<Key<'a>>,
) {
    let is_number = matches!(schema["type"].as_str(), Some("integer" | "number"));
    if is_number || schema.get("x-dimension").is_some() || is_word(schema) {
        let path = path.to_owned();
        keys.push(Key { path, schema });
    }
    for (name, property) in schema["properties"].as_object().into_iter().flatten() {
        let inner = if path.is_empty() {
            name.clone()
        } else {
            format!("{path}.{name}")
        };
        if !left_out.contains(&inner.as_str()) {
            let given = given.and_then(|table| table.get(name));
            collect(property, given, &inner, left_out, keys);
        }
    }
    let items = given.and_then(Value::as_array).into_iter().flatten();
    for (index, item) in items.enumerate() {
        let path = format!("{path}[{index}]");
        collect(&schema["items"], Some(item), &path, left_out, keys);
    }
}

/// The values of the list.
fn listed(
    count: usize,
    input: &StudyInput,
    key: &Key<'_>,
    problems: &mut Problems<'_>,
) -> Option<Vec<Given>> {
    for (name, value) in [("from", &input.from), ("to", &input.to)] {
        if value.is_some() {
            let message = format!("`{name}` needs `count`, not `values`");
            let issue = Issue::new(format!("study.{name}"), message).help("remove it");
            problems.refuse(issue, &["study.values".to_owned()]);
        }
    }
    let values: Vec<_> = (0..count)
        .map(|index| key.read(format!("study.values[{index}]"), problems))
        .collect();
    values.into_iter().collect()
}

/// Evenly spaced values.
fn spaced(input: &StudyInput, key: &Key<'_>, problems: &mut Problems<'_>) -> Option<Vec<Given>> {
    for (name, value) in [("from", &input.from), ("to", &input.to)] {
        if value.is_none() {
            let message = format!("`study` needs `{name}` where `count` is given");
            let issue = Issue::new(format!("study.{name}"), message);
            problems.refuse(issue, &["study.count".to_owned()]);
        }
    }
    if key.is_whole() {
        let message = format!("`{}` is a whole number: list its `values`", input.vary);
        let issue = Issue::new("study.vary", message);
        problems.refuse(issue, &["study.count".to_owned()]);
        return None;
    }
    let ends = ["from", "to"].map(|name| key.read(format!("study.{name}"), problems));
    let [Some(first), Some(last)] = ends else {
        return None;
    };
    let steps = input.count?.checked_sub(1)?;
    let inner = (1..steps).map(|step| {
        let part = f64::from(step) / f64::from(steps);
        let si = key.si(&first.value) * (1.0 - part) + key.si(&last.value) * part;
        let value = key.written(si);
        let path = "study.vary".to_owned();
        Given { value, path }
    });
    let inner: Vec<_> = inner.collect();
    Some(std::iter::once(first).chain(inner).chain([last]).collect())
}

impl Key<'_> {
    /// The value that stands at `path` of the file, if this key can have it.
    pub fn read(&self, path: String, problems: &mut Problems<'_>) -> Option<Given> {
        let node = problems.node(&path)?;
        let value = walk::value(node, self.schema, &path, problems)?;
        Some(Given { value, path })
    }

    /// Whether it is a word out of several.
    pub fn is_word(&self) -> bool {
        is_word(self.schema)
    }

    /// Whether it is a whole number.
    pub fn is_whole(&self) -> bool {
        self.schema["type"] == "integer"
    }

    /// What it measures; `None` for a plain number.
    pub fn dimension(&self) -> Option<Dimension> {
        Dimension::named(self.schema["x-dimension"].as_str()?)
    }

    /// Whether it can have a value, SI units.
    pub fn contains(&self, si: f64) -> bool {
        match self.dimension() {
            Some(_) => Range::of_quantity(self.schema).contains(si),
            None => Range::of_number(self.schema).contains(si),
        }
    }

    /// SI value and unit of a quantity.
    fn parsed(&self, value: &Value) -> Option<(f64, &'static Unit)> {
        let parsed = quantity::parse(value.as_str()?, self.dimension()?).ok()?;
        Some((parsed.si, parsed.unit))
    }

    /// The number that a checked value is, in SI units.
    pub fn si(&self, value: &Value) -> f64 {
        let quantity = self.parsed(value).map(|(si, _)| si);
        quantity.or(value.as_f64()).unwrap_or(f64::NAN)
    }

    /// The value that this key has for a number in SI units.
    pub fn written(&self, si: f64) -> Value {
        match self.dimension() {
            Some(dimension) => format!("{si} {}", dimension.units()[0].symbol).into(),
            None => Number::from_f64(si).map_or(Value::Null, Value::Number),
        }
    }

    /// What varies, shown in the unit of `value`.
    pub fn variable(&self, value: &Value) -> Variable {
        let shown = self.parsed(value).map(|(_, unit)| unit);
        Variable {
            key: self.path.clone(),
            unit: self
                .dimension()
                .map_or("", |dimension| dimension.units()[0].symbol),
            shown_unit: shown.map_or("", |unit| unit.symbol),
            shown_size: shown.map_or(1.0, |unit| unit.si(1.0)),
        }
    }
}

/// What the scenario asks with one value put in.
pub(super) fn questions(
    base: &Value,
    path: &str,
    value: &Value,
    folder: &Path,
) -> Result<Questions, Issue> {
    let mut scenario = base.clone();
    put(&mut scenario, path, value);
    questions_of(&scenario, folder)
}

/// What a scenario asks; the files that it names stand in `folder`.
pub(super) fn questions_of(scenario: &Value, folder: &Path) -> Result<Questions, Issue> {
    let root = Node::from(scenario);
    let mut problems = Problems::new(&root, folder);
    let built = build_scenario(&root, &mut problems);
    let (issues, _) = problems.finish();
    match (built, issues.into_iter().next()) {
        (Some((_, questions)), None) => Ok(questions),
        (_, Some(issue)) => Err(issue),
        (None, None) => Err(Issue::new("", "the scenario asks nothing")),
    }
}

/// Puts a value into a tree, making the tables on its way.
pub(super) fn put(tree: &mut Value, path: &str, value: &Value) {
    let mut place = tree;
    for step in path.split(['.', '[']) {
        let index = step.strip_suffix(']').and_then(|index| index.parse().ok());
        place = match index {
            Some(index) => match place.get_mut::<usize>(index) {
                Some(item) => item,
                None => return,
            },
            None => {
                if !place.is_object() {
                    *place = Value::Object(Map::new());
                }
                &mut place[step]
            }
        };
    }
    *place = value.clone();
}

/// A problem that one value makes, as a problem of where the value was given.
fn at_value(issue: Issue, key: &str, value: &Value, path: &str) -> Issue {
    let mut moved = Issue::new(path, format!("with {key} = {value}: {}", issue.message));
    moved.help = issue.help;
    moved
}
