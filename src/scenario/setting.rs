//! Values that a command line puts in place of those of a file.

use super::key::Key;
use super::node::{Content, Entry, Node, read_toml};
use super::problems::Issue;

/// `key=value` as it was typed.
pub(super) struct Setting<'a> {
    key: &'a str,
    value: &'a str,
    /// Where it begins: places of options count on behind the text of the file.
    start: usize,
}

impl<'a> Setting<'a> {
    /// Of a text that begins at a place.
    ///
    /// # Errors
    /// That it is no key with a value.
    pub fn new(text: &'a str, start: usize) -> Result<Self, Issue> {
        let (key, value) = text.split_once('=').ok_or_else(|| {
            let issue = Issue::new("", format!("`{text}` sets no key"));
            let place = start..start + text.len();
            issue
                .help("write KEY=VALUE, as in speed.constant=\"2000 rpm\"")
                .at(Some(place))
        })?;
        let key = key.trim();
        Ok(Self { key, value, start })
    }

    /// Puts its value into a tree.
    ///
    /// # Errors
    /// That its key leads nowhere.
    pub fn apply(&self, root: &mut Node) -> Result<(), Issue> {
        let steps: Vec<_> = self.key.split(['.', '[']).collect();
        self.put(root, &steps).map_err(|message| {
            let place = self.start..self.start + self.key.len();
            Issue::new(self.key, message).at(Some(place))
        })
    }

    /// Puts its value where some steps lead to from a node.
    fn put(&self, node: &mut Node, steps: &[&str]) -> Result<(), String> {
        let [step, rest @ ..] = steps else {
            *node = self.node();
            return Ok(());
        };
        let span = self.start..self.start + self.key.len();
        if let Some(number) = step.strip_suffix(']') {
            let Content::List(items) = &mut node.content else {
                return Err(format!("`{}` is no list here", self.key));
            };
            let count = items.len();
            let all = match (number, super::key_path::index(step)) {
                ("*", _) => 0..count,
                (_, Some(index)) if index == count => {
                    items.push(Node::table(span));
                    index..index + 1
                }
                (_, Some(index)) if index < count => index..index + 1,
                _ => {
                    return Err(format!(
                        "`{}` has no entry {number}: they count from 1 to {count}, and {} makes another",
                        self.key,
                        count + 1
                    ));
                }
            };
            return items[all]
                .iter_mut()
                .try_for_each(|item| self.put(item, rest));
        }
        let Content::Table(entries) = &mut node.content else {
            return Err(format!("`{}` is in no table here", self.key));
        };
        let known = entries.iter().position(|entry| entry.key == *step);
        let place = known.unwrap_or_else(|| {
            let (key, key_span) = ((*step).to_owned(), span.clone());
            let is_list = rest.first().is_some_and(|next| next.ends_with(']'));
            let node = match is_list {
                true => Node {
                    span,
                    content: Content::List(Vec::new()),
                },
                false => Node::table(span),
            };
            entries.push(Entry {
                key,
                key_span,
                node,
            });
            entries.len() - 1
        });
        self.put(&mut entries[place].node, rest)
    }

    /// Its value: of TOML, or a text without quotes.
    fn node(&self) -> Node {
        const BEFORE: &str = "v=";
        let begin = self.start + self.key.len() + 1;
        let root = read_toml(&format!("{BEFORE}{}", self.value)).ok();
        let entries = root.map(|root| root.content);
        let read = match entries {
            Some(Content::Table(entries)) => entries.into_iter().next(),
            _ => None,
        };
        let read = read.map(|entry| entry.node.moved(|place| place + begin - BEFORE.len()));
        let is_text = Key::is_text_at(self.key);
        read.filter(|node| !(is_text && node.content.kind() == "a number"))
            .unwrap_or_else(|| Node {
                span: begin..begin + self.value.len(),
                content: Content::Plain(self.value.trim().into()),
            })
    }
}
