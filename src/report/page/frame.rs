//! What every page is made of: one file without links, its data as JSON, read by the scripts in it.

use std::io::{self, Write};

use serde_json::Value;

use crate::scenario::visible;

const FRAME: &str = include_str!("page.html");
const STYLE: &str = include_str!("page.css");
/// What every page's script builds on, in order.
const SCRIPTS: [&str; 4] = [
    include_str!("frame.js"),
    include_str!("pen.js"),
    include_str!("figure.js"),
    include_str!("reading.js"),
];

/// A page around some data.
#[derive(Debug, Clone, Copy)]
pub(in crate::report) struct Frame<'a> {
    /// Its title, any text.
    pub title: &'a str,
    /// File beside the page that says the same without scripts.
    pub sealed: &'a str,
    /// Scripts that show the data, in order.
    pub scripts: &'a [&'a str],
}

impl Frame<'_> {
    /// Writes the page.
    pub fn write(&self, data: &Value, out: &mut impl Write) -> io::Result<()> {
        let parts = [
            ("title", escaped(self.title)),
            ("sealed", escaped(self.sealed)),
            ("style", STYLE.to_owned()),
            // no text in the data can end the element that it stands in
            ("data", data.to_string().replace('<', "\\u003c")),
            ("script", [&SCRIPTS, self.scripts].concat().concat()),
        ];
        fill(FRAME, &parts, out)
    }
}

/// Writes the frame with every `{{name}}` replaced by the part of that name.
fn fill(frame: &str, parts: &[(&str, String)], out: &mut impl Write) -> io::Result<()> {
    let mut pieces = frame.split("{{");
    out.write_all(pieces.next().unwrap_or_default().as_bytes())?;
    for piece in pieces {
        let (name, rest) = piece.split_once("}}").unwrap_or(("", piece));
        let part = parts.iter().find(|(part, _)| *part == name);
        if let Some((_, text)) = part {
            out.write_all(text.as_bytes())?;
        }
        out.write_all(rest.as_bytes())?;
    }
    Ok(())
}

/// Text as it may stand in HTML.
fn escaped(text: &str) -> String {
    let mut html = String::with_capacity(text.len());
    for c in visible(text).chars() {
        match c {
            '&' => html += "&amp;",
            '<' => html += "&lt;",
            '>' => html += "&gt;",
            '"' => html += "&quot;",
            c => html.push(c),
        }
    }
    html
}
