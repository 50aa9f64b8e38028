//! How wide a text is, and what to do with one that is too wide. The font is the viewer's: widths are those of DejaVu Sans,
//! the widest of those that take the place of Helvetica.

use crate::scenario::visible;

/// Size of most texts, px.
pub(super) const SIZE: f64 = 12.0;
/// From one line of text to the next, px.
pub(super) const LINE: f64 = 16.0;

/// Width of a text, px.
pub(super) fn width(text: &str, size: f64) -> f64 {
    let letter = |letter: char| match letter {
        'i' | 'j' | 'l' | '\'' | 'I' | ' ' | '.' | ',' => 0.32,
        'f' | 't' | ':' | ';' | '/' | '|' | '!' | '(' | ')' | '-' | 'r' => 0.41,
        '⁰'..='⁹' | '¹' | '²' | '³' | '⁻' => 0.41,
        'm' | 'w' | 'M' | 'W' | '%' | '@' | '…' | '→' => 1.0,
        'A'..='Z' => 0.75,
        '=' | '+' | '−' | '<' | '>' | '×' => 0.84,
        'c' | 'k' | 's' | 'v' | 'x' | 'y' | 'z' => 0.59,
        _ => 0.64,
    };
    size * text.chars().map(letter).sum::<f64>()
}

/// A text in lines that are no wider than `most`; words that are, are cut.
pub(super) fn wrapped(text: &str, size: f64, most: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}"), size) <= most => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(shortened(word, size, most)),
        }
    }
    lines
}

/// A text that is no wider than `most`: what is too much is cut off.
pub(super) fn shortened(text: &str, size: f64, most: f64) -> String {
    if width(text, size) <= most {
        return text.to_owned();
    }
    let mut kept: String = text.to_owned();
    while kept.pop().is_some() && width(&kept, size) + size > most {}
    kept.trim_end().to_owned() + "…"
}

/// Text as XML and HTML have it, control characters seen.
pub(in crate::report) fn escaped(text: &str) -> String {
    let reserved = [
        ('&', "&amp;"),
        ('<', "&lt;"),
        ('>', "&gt;"),
        ('"', "&quot;"),
    ];
    let replaced = |text: String, (letter, entity): (char, &str)| text.replace(letter, entity);
    reserved.into_iter().fold(visible(text), replaced)
}
