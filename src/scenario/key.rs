//! Keys of a scenario by their paths: which there are, and which values each can have, in a file or on a command line.

use serde_json::{Number, Value};

use super::key_path::{entry, join, matches, set_value, value_at};
use super::node::{Content, Node};
use super::problems::Problems;
use super::quantity::{Dimension, Parsed};
use super::range::Range;
use super::schema::schema;
use super::{Issue, quantity, reader};
use crate::study::Variable;

/// A key whose value may be another one than that of the file, or several that change together.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Key {
    /// Its path as somebody wrote it, for instance `bearing[1].preload` or `bearing[*].preload`.
    pub path: String,
    /// Where its value is, or the values of several keys.
    paths: Vec<String>,
    schema: &'static Value,
    /// What it measures; of several that it can, what its value in the scenario does. `None` of a plain number.
    dimension: Option<Dimension>,
}

/// Every key of a number outside some tables; lists have as many entries as `given` has.
pub(super) fn number_keys(given: &Value, left_out: &[&str]) -> Vec<Key> {
    let mut keys = all_keys(given, left_out);
    keys.retain(|key| !key.is_text());
    keys
}

/// As [`number_keys`], with those of words and other texts.
pub(super) fn all_keys(given: &Value, left_out: &[&str]) -> Vec<Key> {
    let mut keys = Vec::new();
    collect(schema(), Some(given), "", left_out, &mut keys);
    keys
}

fn collect(
    schema: &'static Value,
    given: Option<&Value>,
    path: &str,
    left_out: &[&str],
    keys: &mut Vec<Key>,
) {
    let mut key = Key::at(path, schema);
    let written = given.and_then(Value::as_str);
    let written = written.and_then(|text| quantity::parse(text, &Dimension::from_key(schema)).ok());
    key.dimension = written.map(|parsed| parsed.dimension).or(key.dimension);
    for (name, property) in schema["properties"].as_object().into_iter().flatten() {
        let inner = join(&key.path, name);
        if !left_out.contains(&inner.as_str()) {
            let given = given.and_then(|table| table.get(name));
            collect(property, given, &inner, left_out, keys);
        }
    }
    let items = given.and_then(Value::as_array).into_iter().flatten();
    for (index, item) in items.enumerate() {
        let inner = entry(&key.path, index);
        collect(&schema["items"], Some(item), &inner, left_out, keys);
    }
    if key.is_number() || key.is_text() {
        keys.push(key);
    }
}

/// The key of some paths among those known, or an issue about `place`, where they are given.
pub(super) fn find(known: &[Key], paths: &[String], place: &str) -> Result<Key, Issue> {
    let mut found: Option<Key> = None;
    for path in paths {
        let matching = known.iter().filter(|key| matches(path, &key.path));
        let matching: Vec<_> = matching.collect();
        if matching.is_empty() && is_left_out(known, path) {
            let message = format!("what is asked does not depend on `{path}`");
            return Err(Issue::new(place, message));
        }
        if matching.is_empty() {
            let paths = known.iter().map(|key| key.path.as_str());
            let issue = Issue::new(place, format!("the scenario has no number `{path}`"));
            if path.contains("[0]") {
                return Err(issue.help("the entries of a list are counted from 1"));
            }
            return Err(issue.help_nearest(path, paths, "for instance: \"speed.constant\""));
        }
        for key in matching {
            let all = found.get_or_insert_with(|| Key {
                path: paths.join(" and "),
                paths: Vec::new(),
                ..(*key).clone()
            });
            if all.measure() != key.measure() {
                let message = format!("`{}` and `{path}` cannot have one value", paths[0]);
                let issue = Issue::new(place, message);
                return Err(issue.help("keys that change together measure the same"));
            }
            all.paths.push(key.path.clone());
        }
    }
    found.ok_or_else(|| Issue::new(place, "it names no key"))
}

/// Whether a path is that of a key of a scenario whose table is not among those known.
fn is_left_out(known: &[Key], path: &str) -> bool {
    let (table, _) = path.split_once('.').unwrap_or((path, ""));
    let is_in_it = |key: &Key| key.path.split('.').next() == Some(table);
    let named = path
        .split('.')
        .try_fold(schema(), |own, step| own["properties"].get(step));
    named.is_some() && !known.iter().any(is_in_it)
}

impl Key {
    /// The key of a path, where `bearing[]` stands for any bearing.
    pub fn named(path: &str) -> Self {
        let step = |table: &'static Value, step: &str| match step.strip_suffix("[]") {
            Some(list) => &table["properties"][list]["items"],
            None => &table["properties"][step],
        };
        Self::at(path, path.split('.').fold(schema(), step))
    }

    fn at(path: &str, schema: &'static Value) -> Self {
        Self {
            path: path.to_owned(),
            paths: vec![path.to_owned()],
            schema,
            dimension: Dimension::from_key(schema).first().copied(),
        }
    }

    /// Its value in a scenario; none where none is written, or where several keys have different ones.
    pub fn value_in<'a>(&self, scenario: &'a Value) -> Option<&'a Value> {
        let mut values = self.paths.iter().map(|path| value_at(scenario, path));
        let first = values.next()??;
        values.all(|value| value == Some(first)).then_some(first)
    }

    /// Whether a scenario says its value, or each of several ones.
    pub fn is_given(&self, scenario: &Value) -> bool {
        let mut paths = self.paths.iter();
        paths.all(|path| value_at(scenario, path).is_some())
    }

    /// Checks its value in the file that is read.
    pub fn check_in(&self, problems: &mut Problems<'_>) {
        for path in &self.paths {
            self.read(path, problems);
        }
    }

    /// Sets its value in a scenario.
    pub fn set(&self, scenario: &mut Value, value: &Value) {
        for path in &self.paths {
            set_value(scenario, path, value);
        }
    }

    /// Whether it has all paths that another one has.
    pub fn covers(&self, other: &Self) -> bool {
        other.paths.iter().all(|path| self.paths.contains(path))
    }

    /// A path that another key has, too.
    pub fn shared_with(&self, other: &Self) -> Option<&str> {
        let mut paths = self.paths.iter();
        let shared = paths.find(|path| other.paths.contains(path));
        shared.map(String::as_str)
    }

    /// What two keys must have in common to have one value.
    fn measure(&self) -> (&Value, Option<Dimension>, Vec<&'static str>) {
        (&self.schema["type"], self.dimension, self.words())
    }

    /// The value at a path of the file that is read, if this key can have it.
    pub fn read(&self, path: &str, problems: &mut Problems<'_>) -> Option<Value> {
        self.value(problems.node(path)?, path, problems)
    }

    fn value(&self, node: &Node, path: &str, problems: &mut Problems<'_>) -> Option<Value> {
        let value = reader::value(node, self.schema, path, problems)?;
        match self.dimension {
            Some(due) if self.parsed(&value).is_none() => {
                let message = format!("`{}` is a {} here", reader::last(&self.path), due.name());
                problems.add(Issue::new(path, message).help("as its value in the scenario is"));
                None
            }
            _ => Some(value),
        }
    }

    /// The value that somebody types, without quotes; `name` is what messages call it.
    ///
    /// # Errors
    /// What keeps this key from having it.
    pub fn typed(&self, text: &str, name: &str) -> Result<Value, Issue> {
        let text = text.trim();
        if self.is_plain() && text.parse::<f64>().is_err() {
            let message = format!("`{}` must be a number, not \"{text}\"", reader::last(name));
            return Err(Issue::new(name, message));
        }
        let content = match self.is_plain() {
            true => Content::from_number(text),
            false => Content::Plain(text.into()),
        };
        let node = Node {
            span: 0..0,
            content,
        };
        let mut problems = Problems::new(&node, "".as_ref());
        let value = self.value(&node, name, &mut problems);
        let issue = problems.issues.into_iter().next();
        value.ok_or_else(|| issue.unwrap_or_else(|| Issue::new(name, "it cannot be read")))
    }

    /// The words that it can be; none of a number.
    pub fn words(&self) -> Vec<&'static str> {
        reader::choices(self.schema)
    }

    /// Whether the key at a path of a scenario is a text, and no quantity.
    pub fn is_text_at(path: &str) -> bool {
        let steps = path.split('.').map(|step| match step.split_once('[') {
            Some((list, _)) => format!("{list}[]"),
            None => step.to_owned(),
        });
        Self::named(&steps.collect::<Vec<_>>().join(".")).is_text()
    }

    /// Whether it is a word out of several, or any text.
    pub fn is_text(&self) -> bool {
        !self.words().is_empty() || self.schema["type"] == "string" && self.dimension.is_none()
    }

    /// Whether it is a number without a dimension.
    fn is_plain(&self) -> bool {
        matches!(self.schema["type"].as_str(), Some("integer" | "number"))
    }

    /// Whether it is a number, with or without a dimension.
    fn is_number(&self) -> bool {
        self.is_plain() || self.dimension.is_some()
    }

    /// Whether it is a whole number.
    pub fn is_whole(&self) -> bool {
        self.schema["type"] == "integer"
    }

    /// Whether it can have a value, SI units.
    pub fn contains(&self, si: f64) -> bool {
        Range::from_schema(self.schema).contains(si)
    }

    /// SI value and unit of a quantity.
    fn parsed(&self, value: &Value) -> Option<Parsed> {
        quantity::parse(value.as_str()?, &[self.dimension?]).ok()
    }

    /// The number that a checked value is, in SI units.
    pub fn si(&self, value: &Value) -> f64 {
        let quantity = self.parsed(value).map(|parsed| parsed.si);
        quantity.or(value.as_f64()).unwrap_or(f64::NAN)
    }

    /// The value that this key has for a number in SI units.
    pub fn written(&self, si: f64) -> Value {
        match self.dimension {
            Some(dimension) => format!("{si} {}", dimension.si_symbol()).into(),
            None if self.is_whole() => Value::from(si as i64),
            None => Number::from_f64(si).map_or(Value::Null, Value::Number),
        }
    }

    /// What varies, shown in the unit of `value`.
    pub fn variable(&self, value: &Value) -> Variable {
        let unit = self.dimension.map_or("", Dimension::si_symbol);
        let shown = self.parsed(value).map(|parsed| parsed.unit);
        // a scale with another zero has no size of its own
        let shown = shown.and_then(|unit| Some((unit.size()?, unit.symbol)));
        let (shown_size, shown_unit) = shown.unwrap_or((1.0, unit.to_owned()));
        Variable {
            key: self.path.clone(),
            words: Vec::new(),
            unit: unit.to_owned(),
            shown_unit: shown_unit.replacen("um", "µm", 1),
            shown_size,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_that_change_together_measure_the_same() {
        let given = serde_json::json!({ "bearing": [{}, {}], "load": [{ "constant": {} }] });
        let known = number_keys(&given, &[]);
        let found = |paths: &[&str]| {
            let paths: Vec<_> = paths.iter().map(|path| (*path).to_owned()).collect();
            find(&known, &paths, "key")
        };
        let both = found(&["bearing[*].preload", "load[1].constant.z"]).unwrap();
        assert_eq!(both.paths.len(), 3);
        let mut scenario = given.clone();
        both.set(&mut scenario, &"5 N".into());
        assert_eq!(scenario["bearing"][1]["preload"], "5 N");
        assert_eq!(scenario["load"][0]["constant"]["z"], "5 N");
        let refused = found(&["bearing[*].preload", "bearing[*].position"]).unwrap_err();
        assert!(refused.message.contains("cannot have one value"));
        assert!(found(&["bearing[7].preload"]).is_err());
        let zeroth = found(&["bearing[0].preload"]).unwrap_err();
        assert_eq!(
            zeroth.help.as_deref(),
            Some("the entries of a list are counted from 1")
        );
        let second = found(&["bearing[2].preload"]).unwrap();
        assert_eq!(both.shared_with(&second), Some("bearing[2].preload"));
        second.set(&mut scenario, &"7 N".into());
        assert_eq!(scenario["bearing"][1]["preload"], "7 N");
        assert_eq!(
            second.shared_with(&found(&["bearing[1].preload"]).unwrap()),
            None
        );
    }
}
