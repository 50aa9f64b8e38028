//! Foreign text as a terminal may have it.

use std::fmt::Write;

/// Whether a character commands a terminal, or turns the direction of the text behind it (UAX 9).
fn commands(c: char) -> bool {
    let turns = matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    turns || c.is_control() && !matches!(c, '\n' | '\t')
}

/// Whether a text has none of the characters that [`visible`] shows.
pub(crate) fn is_visible(text: &str) -> bool {
    !text.contains(commands)
}

/// A text whose control characters but line ends and tabs, and whose marks of direction, are seen: `\u001b` for escape, as
/// JSON has it.
pub(crate) fn visible(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for c in text.chars() {
        if commands(c) {
            // writing to a text cannot fail
            let _ = write!(shown, "\\u{:04x}", u32::from(c));
        } else {
            shown.push(c);
        }
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_of_terminals_and_marks_of_direction_are_seen() {
        let seen = visible("a\u{1b}[2Jb\tc\n\u{9b}\r\u{202e}d");
        assert_eq!(seen, "a\\u001b[2Jb\tc\n\\u009b\\u000d\\u202ed");
        assert!(is_visible("θ in µm, 2 × 3\n") && !is_visible("\u{2066}"));
    }
}
