//! Text that fits a terminal.

/// Most characters of a line.
pub(super) const WIDTH: usize = 100;

/// Breaks a text between words so that no line has more than 100 characters; lines after the first
/// begin with `indent` blanks. A word that is longer stands on a line of its own.
///
/// ```
/// use jeffcott::report::wrapped;
/// let text = format!("natural {}", ["540.29 Hz"; 12].join(", "));
/// let lines = wrapped(&text, 8);
/// assert!(lines.lines().all(|line| line.chars().count() <= 100));
/// assert!(lines.lines().skip(1).all(|line| line.starts_with("        540.29 Hz")));
/// ```
pub fn wrapped(text: &str, indent: usize) -> String {
    let mut out = String::new();
    let mut column = 0;
    for word in text.split_inclusive(' ') {
        let width = word.trim_end().chars().count();
        if column > indent && column + width > WIDTH {
            out.truncate(out.trim_end().len());
            out.push('\n');
            out.extend(std::iter::repeat_n(' ', indent));
            column = indent;
        }
        out.push_str(word);
        column += word.chars().count();
    }
    out
}
