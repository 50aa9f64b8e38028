//! Checks the tree against the schema, finding every problem in one pass.
//!
//! What passes is a JSON value that the structs of [`super::input`] deserialise from without
//! error. A value that is wrong, or whose key is misspelled, is replaced by an example, so that the
//! checks that follow find a complete table; [`Problems`] keeps them from speaking about it.

use std::collections::HashSet;

use serde::de::DeserializeOwned;
use serde_json::{Map, Number, Value};

use super::Issue;
use super::key_path::{entry, join};
use super::node::{Content, Entry, Node};
use super::problems::{Problems, nearest};
use super::range::Range;
use super::removed::way_left;
use super::wrong_value::{
    as_in, check, example, missing_key, needs_unit, quoted, stand_in, wrong_type,
};
use crate::analysis::Channel;

/// The whole tree as a struct that `schema` describes; its required values may be examples where
/// [`Problems`] holds an issue about them.
pub(super) fn read<T: DeserializeOwned>(schema: &Value, problems: &mut Problems<'_>) -> Option<T> {
    let value = value(problems.root, schema, "", problems)?;
    typed(value, problems)
}

/// A tree that was checked as a struct.
pub(super) fn typed<T: DeserializeOwned>(value: Value, problems: &mut Problems<'_>) -> Option<T> {
    serde_json::from_value(value)
        .map_err(|error| problems.add(Issue::new("", error.to_string())))
        .ok()
}

/// The value of a node, if it is what the schema asks for.
pub(super) fn value(
    node: &Node,
    schema: &Value,
    path: &str,
    problems: &mut Problems<'_>,
) -> Option<Value> {
    let mut reader = Reader {
        schema,
        path,
        problems,
    };
    reader.value(node)
}

/// The key at the end of a path.
pub(super) fn last(path: &str) -> &str {
    let key = path.rsplit('.').next().unwrap_or(path);
    key.split('[').next().unwrap_or(key)
}

/// The words that an enumeration allows.
pub(super) fn choices(schema: &Value) -> Vec<&str> {
    let plain = schema["enum"].as_array().into_iter().flatten();
    let documented = schema["oneOf"].as_array().into_iter().flatten();
    let words = documented.flat_map(|variant| {
        let listed = variant["enum"].as_array().into_iter().flatten();
        listed.chain([&variant["const"]])
    });
    plain.chain(words).filter_map(Value::as_str).collect()
}

/// A key while it is read.
struct Reader<'a, 'p> {
    schema: &'a Value,
    path: &'a str,
    problems: &'a mut Problems<'p>,
}

impl Reader<'_, '_> {
    fn value(&mut self, node: &Node) -> Option<Value> {
        if self.schema.get("x-dimension").is_some() {
            return self.quantity(&node.content);
        }
        let choices = choices(self.schema);
        if !choices.is_empty() {
            return self.choice(&node.content, &choices);
        }
        if let Some(types) = self.schema["type"].as_array() {
            return match &node.content {
                Content::List(items) if types.contains(&"array".into()) => self.list(items),
                content if types.contains(&"number".into()) => self.scalar(content),
                Content::Plain(text @ Value::String(_)) => Some(text.clone()),
                _ => self.refuse("must be a string or a list of strings"),
            };
        }
        match (self.schema["type"].as_str()?, &node.content) {
            ("object", Content::Table(entries)) => self.table(entries),
            ("array", Content::List(items)) => self.list(items),
            ("string", Content::Plain(value @ Value::String(_)))
            | ("boolean", Content::Plain(value @ Value::Bool(_))) => Some(value.clone()),
            ("number", Content::Plain(Value::Number(number))) => self.in_range(number.clone()),
            ("number", Content::NotFinite(_)) => self.refuse("must be a finite number"),
            ("integer", Content::Plain(Value::Number(number))) if is_whole(number) => {
                let float = number.as_f64().filter(|_| number.is_f64());
                let exact = float.filter(|number| number.abs() < 1e15);
                let value = self.in_range(exact.map_or(number.clone(), |n| (n as i64).into()))?;
                match value.is_f64() {
                    true => self.refuse(&format!("must be below 1e15, not {number}")),
                    false => Some(value),
                }
            }
            (expected, content) => {
                let issue = wrong_type(expected, content, self.schema, self.path);
                self.problems.add(issue.at(Some(node.span.clone())));
                None
            }
        }
    }

    fn key(&self) -> &str {
        last(self.path)
    }

    /// Adds what is wrong with the key, which then has no value.
    fn refuse(&mut self, wrong: &str) -> Option<Value> {
        let message = format!("`{}` {wrong}", self.key());
        self.problems.add(Issue::new(self.path, message));
        None
    }

    /// A quantity or a number, whose key is known only later.
    fn scalar(&mut self, content: &Content) -> Option<Value> {
        let value = match content {
            Content::Plain(value @ (Value::String(_) | Value::Number(_))) => Some(value.clone()),
            _ => None,
        };
        value.or_else(|| self.refuse("must be a finite number, or a number and a unit in quotes"))
    }

    fn in_range(&mut self, value: Number) -> Option<Value> {
        let range = Range::from_schema(self.schema);
        if value.as_f64().is_some_and(|number| range.contains(number)) {
            return Some(Value::Number(value));
        }
        let words = range.words(|limit| limit);
        let message = format!("`{}` must be {words}, not {value}", self.key());
        let mut issue = Issue::new(self.path, message);
        if range.is_choice() {
            issue.help = self.schema["description"]
                .as_str()
                .map(|text| text.replace('\n', " "));
        }
        self.problems.add(issue);
        None
    }

    /// One of some words.
    fn choice(&mut self, content: &Content, choices: &[&str]) -> Option<Value> {
        let written = match content {
            Content::Plain(Value::String(text)) => text.as_str(),
            _ => "",
        };
        let variants = self.schema["oneOf"].as_array().into_iter().flatten();
        let mut patterns = variants.filter(|variant| variant["pattern"].is_string());
        // the only pattern is that of columns that are like one that is listed
        let is_further = |channel: Channel| channel.is_further() && channel.name() == written;
        if choices.contains(&written) || patterns.next().is_some() && Channel::all().any(is_further)
        {
            return Some(written.into());
        }
        let words: Vec<_> = choices.iter().map(|word| format!("\"{word}\"")).collect();
        let message = format!("`{}` must be one of {}", self.key(), words.join(", "));
        let mut issue = Issue::new(self.path, message);
        let near = || nearest(written, choices.iter().copied());
        issue.help = way_left(written)
            .map(|way| format!("\"{written}\" is no longer there; {way}"))
            .or_else(|| near().map(|word| format!("did you mean \"{word}\"?")));
        self.problems.add(issue);
        None
    }

    fn list(&mut self, items: &[Node]) -> Option<Value> {
        let count = items.len() as u64;
        let limit = |name: &str| self.schema[name].as_u64();
        if limit("minItems").is_some_and(|least| count < least) {
            return self.refuse("must have at least one entry");
        }
        if let Some(most) = limit("maxItems").filter(|most| count > *most) {
            return self.refuse(&format!("must have at most {most} entries"));
        }
        let read = |(index, item)| {
            let path = entry(self.path, index);
            value(item, &self.schema["items"], &path, self.problems)
        };
        let values: Vec<_> = items.iter().enumerate().map(read).collect();
        let values: Option<Vec<_>> = values.into_iter().collect();
        values.map(Value::Array)
    }

    /// The text of the quantity, if it is one of the right dimension and in its range.
    fn quantity(&mut self, content: &Content) -> Option<Value> {
        let checked = match content {
            Content::Plain(Value::String(text)) => {
                check(text, self.schema, self.path).map(|()| Value::from(text.clone()))
            }
            Content::Plain(Value::Number(_)) | Content::NotFinite(_) => {
                Err(needs_unit(self.schema, self.path))
            }
            other => {
                let (key, kind) = (self.key(), other.kind());
                let message = format!("`{key}` must be a number and a unit in quotes, not {kind}");
                Err(Issue::new(self.path, message).help(as_in(self.schema)))
            }
        };
        checked.map_err(|issue| self.problems.add(issue)).ok()
    }

    /// The table with every key that is right, its required keys filled up by examples.
    fn table(&mut self, entries: &[Entry]) -> Option<Value> {
        let properties = self.schema["properties"].as_object()?;
        let given: HashSet<_> = entries.iter().map(|entry| entry.key.as_str()).collect();
        let mut values = Map::new();
        for entry in entries {
            match properties.get(&entry.key) {
                Some(property) => {
                    let inner = join(self.path, &entry.key);
                    let read = value(&entry.node, property, &inner, self.problems);
                    if let Some(value) = read.or_else(|| stand_in(property)) {
                        values.insert(entry.key.clone(), value);
                    }
                }
                None => {
                    let meant = self.unknown_key(entry, &given, properties);
                    let stand_in =
                        meant.and_then(|key| stand_in(&properties[key]).map(|it| (key, it)));
                    values.extend(stand_in.map(|(key, value)| (key.to_owned(), value)));
                }
            }
        }
        for (extension, one_is_due) in [("x-at-most-one", false), ("x-exactly-one", true)] {
            if let Some(group) = self.schema[extension].as_array() {
                let group: Vec<_> = group.iter().filter_map(Value::as_str).collect();
                self.exclusive_keys(entries, &group, one_is_due);
            }
        }
        if entries.is_empty() && self.schema["minProperties"].as_u64() == Some(1) {
            let known = quoted(properties.keys().map(String::as_str), ", ");
            let message = format!("{} needs at least one of {known}", self.table_name());
            self.problems.add(Issue::new(self.path, message));
        }
        let complete = self.fill_required(&given, &mut values);
        complete.then_some(Value::Object(values))
    }

    /// What the table is called: `[shaft]`, or the file as a whole.
    fn table_name(&self) -> String {
        match self.path {
            "" => self.problems.subject.to_owned(),
            path => format!("`{path}`"),
        }
    }

    /// Reports the required keys that are missing and puts examples in place of those that are
    /// missing or wrong; false where there is none to put.
    fn fill_required(&mut self, given: &HashSet<&str>, values: &mut Map<String, Value>) -> bool {
        let required = self.schema["required"].as_array().into_iter().flatten();
        let mut complete = true;
        for key in required.filter_map(Value::as_str) {
            let inner = join(self.path, key);
            let property = &self.schema["properties"][key];
            if !given.contains(key) && !self.problems.is_faulty(&inner) {
                let issue = missing_key(&inner, &self.table_name(), property);
                self.problems.add(issue);
            }
            if !values.contains_key(key) {
                match example(property) {
                    Some(example) => drop(values.insert(key.to_owned(), example)),
                    None => complete = false,
                }
            }
        }
        complete
    }

    /// Refuses a key that the table does not have; the key that was meant, where one is near.
    fn unknown_key<'k>(
        &mut self,
        entry: &Entry,
        given: &HashSet<&str>,
        known: &'k Map<String, Value>,
    ) -> Option<&'k str> {
        let key = &entry.key;
        let message = format!("{} has no key `{key}`", self.table_name());
        let has_it = |(_, of): &(_, &Value)| of["properties"].get(key).is_some();
        let tables = known.iter().filter(has_it);
        let tables: Vec<_> = tables.map(|(table, _)| join(self.path, table)).collect();
        let known = known.keys().map(String::as_str);
        let known = known.filter(|known| !known.starts_with('$'));
        // a key nearest to one that is here already is no misspelling of another
        let free = nearest(key, known.clone()).filter(|known| !given.contains(known));
        let way = way_left(key);
        let free = free.filter(|_| way.is_none());
        let help = match (way, free) {
            (Some(way), _) => way.to_owned(),
            (None, Some(known)) => {
                self.problems.mark_faulty(&join(self.path, known));
                format!("did you mean `{known}`?")
            }
            (None, None) if !tables.is_empty() => {
                let tables = quoted(tables.iter().map(String::as_str), " and ");
                format!("`{key}` is a key of {tables}")
            }
            (None, None) => format!("it knows {}", quoted(known, ", ")),
        };
        let issue = Issue::new(join(self.path, key), message).help(help);
        self.problems.add(issue.at(Some(entry.key_span.clone())));
        free
    }

    /// Refuses several keys of a group of which a table may have one only, or none where one is due.
    fn exclusive_keys(&mut self, entries: &[Entry], group: &[&str], one_is_due: bool) {
        let is_one = |entry: &&Entry| group.contains(&entry.key.as_str());
        let given: Vec<_> = entries.iter().filter(is_one).collect();
        let is_faulty = |key: &&str| self.problems.is_faulty(&join(self.path, key));
        match given[..] {
            [] if one_is_due && !group.iter().any(is_faulty) => {
                let group = quoted(group.iter().copied(), ", ");
                let message = format!("{} needs one of {group}", self.table_name());
                self.problems.add(Issue::new(self.path, message));
            }
            [_, second, ..] => {
                let keys = given.iter().map(|entry| entry.key.as_str());
                let keys = quoted(keys, " and ");
                let message = format!("{} cannot have {keys} together", self.table_name());
                let path = join(self.path, &second.key);
                let mut issue = Issue::new(path, message).help("keep one of them");
                let others = given.iter().filter(|entry| entry.key != second.key);
                let others = others.map(|entry| (entry.key.clone(), Some(entry.key_span.clone())));
                issue.related = others.collect();
                self.problems.add(issue.at(Some(second.key_span.clone())));
            }
            _ => {}
        }
    }
}

/// Whether a number is a whole one, of any size.
fn is_whole(number: &Number) -> bool {
    number.as_f64().is_some_and(|number| number.fract() == 0.0)
}
