//! How a table is written: what separates its cells, and what its numbers have for a decimal point.

use std::ops::Range;

use super::{no_number, stamp};
use crate::record::Problem;

/// Rows in a row from which a table is recognised, unless the file ends before.
const ENOUGH: usize = 3;

/// What separates cells, and whether decimals follow a comma.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Dialect {
    separator: u8,
    decimal_comma: bool,
}

/// Separators with decimal points or commas; of two that read the same rows the first is taken.
#[rustfmt::skip]
const DIALECTS: [Dialect; 7] = [
    Dialect { separator: b',', decimal_comma: false },
    Dialect { separator: b';', decimal_comma: false },
    Dialect { separator: b';', decimal_comma: true },
    Dialect { separator: b'\t', decimal_comma: false },
    Dialect { separator: b'\t', decimal_comma: true },
    Dialect { separator: b' ', decimal_comma: false },
    Dialect { separator: b' ', decimal_comma: true },
];

/// The rows of a table.
pub(super) struct Rows {
    pub dialect: Dialect,
    /// Lines in front of the first.
    pub start: usize,
    pub columns: usize,
    /// Neighbouring columns that hold dates and times of the day.
    pub stamps: Range<usize>,
    /// How many there are in the first lines.
    count: usize,
}

impl Rows {
    /// The rows of numbers in the first lines of a file, written as most of them can be read; `is_whole` says that there are
    /// no further lines.
    pub fn find(lines: &[&[u8]], is_whole: bool) -> Result<Self, Problem> {
        // of equal ones the last is taken
        let dialects = DIALECTS.iter().rev();
        let found = dialects.filter_map(|dialect| dialect.first_rows(lines, is_whole));
        let best =
            found.max_by_key(|rows| (rows.count >= ENOUGH && rows.are_named(lines), rows.count));
        best.ok_or_else(|| no_rows(lines))
    }

    /// Whether the last line above has a name a column.
    fn are_named(&self, lines: &[&[u8]]) -> bool {
        let mut above = lines[..self.start].iter().rev();
        above.find(|line| !is_passed(line)).is_some_and(|line| {
            // a comma between names separates numbers, too
            let is_comma = self.dialect.decimal_comma && line.contains(&b',');
            !is_comma && self.dialect.header_cells(line).len() == self.columns
        })
    }

    /// What is wrong where commas are decimal signs and stand between the cells as well: half as many names as cells.
    pub fn with_two_commas(&self, lines: &[&[u8]]) -> Option<Problem> {
        let mut above = lines[..self.start].iter().rev();
        let header = above.find(|line| !is_passed(line))?;
        let names = self.dialect.header_cells(header).len();
        (self.dialect == DIALECTS[0] && names > 1 && 2 * names == self.columns).then(|| {
            let what = format!(
                "the header has {names} names and the rows have {} cells: commas stand between cells and before decimals; export it \
                 with semicolons or tabs between cells, or with decimal points",
                self.columns
            );
            Problem::line(self.start as u64 + 1, what)
        })
    }

    /// Whether one column with decimal commas looks the same: two columns of whole numbers without names.
    pub fn is_ambiguous(&self, lines: &[&[u8]]) -> bool {
        let digits = b"0123456789-,\r";
        let mut rows = lines[self.start..].iter();
        self.columns == 2
            && self.dialect == DIALECTS[0]
            && !self.are_named(lines)
            && rows.all(|row| row.iter().all(|sign| digits.contains(sign)))
    }
}

impl Dialect {
    /// The first rows with equally many numbers.
    fn first_rows(self, lines: &[&[u8]], is_whole: bool) -> Option<Rows> {
        let mut found: Option<Rows> = None;
        let filled = lines
            .iter()
            .enumerate()
            .filter(|(_, line)| !is_passed(line));
        for (start, line) in filled {
            let columns = self.columns(line);
            match &mut found {
                Some(rows) if columns == Some(rows.columns) => rows.count += 1,
                Some(rows) if rows.count >= ENOUGH => break,
                _ => {
                    found = columns.map(|columns| Rows {
                        dialect: self,
                        start,
                        columns,
                        stamps: self.stamps(line),
                        count: 1,
                    });
                }
            }
        }
        found.filter(|rows| rows.count >= ENOUGH || is_whole)
    }

    /// Number of cells of a line, if all are numbers or empty, and one at least is a number.
    fn columns(self, line: &[u8]) -> Option<usize> {
        let values = self.cells(line).map(|cell| self.value(cell));
        let values: Vec<f64> = values.collect::<Option<_>>()?;
        let is_filled = values.iter().any(|value| value.is_finite());
        is_filled.then_some(values.len())
    }

    /// The number in a cell, or that of its date or time.
    fn value(self, cell: &[u8]) -> Option<f64> {
        let stamp = || stamp::nanoseconds(cell).map(|time| time as f64);
        self.number(cell).or_else(stamp)
    }

    /// The first neighbouring cells of a line that hold dates or times.
    fn stamps(self, line: &[u8]) -> Range<usize> {
        let are_stamps: Vec<bool> = self
            .cells(line)
            .map(|cell| self.number(cell).is_none())
            .collect();
        let start = are_stamps.iter().take_while(|is_stamp| !**is_stamp).count();
        let count = are_stamps[start..]
            .iter()
            .take_while(|is_stamp| **is_stamp)
            .count();
        start..start + count
    }

    /// The cells of a line, without blanks and quotes around them.
    pub fn cells(self, line: &[u8]) -> impl Iterator<Item = &[u8]> {
        let by_blanks = self.separator == b' ';
        let is_separator = move |byte: &u8| match by_blanks {
            true => byte.is_ascii_whitespace(),
            false => *byte == self.separator,
        };
        let line = line.strip_suffix(b"\n").unwrap_or(line);
        let cells = line
            .split(is_separator)
            .map(|cell| match cell.trim_ascii() {
                [b'"', inner @ .., b'"'] => inner.trim_ascii(),
                cell => cell,
            });
        cells.filter(move |cell| !(by_blanks && cell.is_empty()))
    }

    /// The cells of a header, in which quotes may hold separators and a unit may follow its name behind a blank.
    pub fn header_cells(self, line: &[u8]) -> Vec<String> {
        // what is not UTF-8 is Latin-1, of which each byte is the character of that number
        let text = String::from_utf8(line.to_vec());
        let text = text.unwrap_or_else(|_| line.iter().map(|byte| char::from(*byte)).collect());
        let by_blanks = self.separator == b' ';
        let mut is_quoted = false;
        let cells = text.split(|sign: char| {
            is_quoted ^= sign == '"';
            let separates = sign == self.separator.into() || (by_blanks && sign == '\t');
            separates && !is_quoted
        });
        let cells = cells.map(|cell| {
            let cell = cell.trim();
            let inner = cell.strip_prefix('"').and_then(|it| it.strip_suffix('"'));
            // within quotes two of them stand for one
            let inner = inner.map(|inner| inner.replace("\"\"", "\""));
            let text = inner.unwrap_or_else(|| cell.trim_matches('"').to_owned());
            text.trim().to_owned()
        });
        if !by_blanks {
            return cells.collect();
        }
        let mut names: Vec<String> = Vec::new();
        for word in cells.filter(|word| !word.is_empty()) {
            match names.last_mut() {
                Some(name) if word.starts_with(['[', '(']) => *name = format!("{name} {word}"),
                _ => names.push(word),
            }
        }
        names
    }

    /// The number in a cell, NaN if it is empty.
    pub fn number(self, cell: &[u8]) -> Option<f64> {
        if cell.is_empty() {
            return Some(f64::NAN);
        }
        if !self.decimal_comma {
            return parsed(std::str::from_utf8(cell).ok()?);
        }
        // a point would separate thousands
        if cell.contains(&b'.') {
            return None;
        }
        let mut copy = [0; 40];
        let copy = copy.get_mut(..cell.len())?;
        copy.copy_from_slice(cell);
        if let Some(comma) = copy.iter_mut().find(|sign| **sign == b',') {
            *comma = b'.';
        }
        parsed(std::str::from_utf8(copy).ok()?)
    }
}

/// A number, whose exponent may follow a D, as Fortran writes it: `1.0D-3`.
fn parsed(text: &str) -> Option<f64> {
    let fortran = || text.replacen(['D', 'd'], "e", 1).parse().ok();
    text.parse().ok().or_else(fortran)
}

/// Says of the first line what in it is not a number, written as most of all lines can be read; lines above that have fewer numbers than
/// most are no rows. Where most lines have none, the first one with a cell that begins as a number is meant as a row.
fn no_rows(lines: &[&[u8]]) -> Problem {
    let filled = lines.iter().enumerate();
    let filled: Vec<_> = filled.filter(|(_, line)| !is_passed(line)).collect();
    if filled.is_empty() {
        return Problem::Unfit("it holds nothing but empty lines and comments".to_owned());
    }
    let is_number = |dialect: &Dialect, cell: &[u8]| dialect.value(cell).is_some();
    let numbers = |dialect: &Dialect| -> Vec<usize> {
        let cells = filled.iter().map(|(_, line)| dialect.cells(line));
        let numbers = cells.map(|cells| cells.filter(|cell| is_number(dialect, cell)).count());
        numbers.collect()
    };
    let all = |dialect: &&Dialect| numbers(dialect).iter().sum::<usize>();
    let dialect = DIALECTS
        .iter()
        .rev()
        .max_by_key(all)
        .unwrap_or(&DIALECTS[0]);
    let counts = numbers(dialect);
    let mut sorted = counts.clone();
    sorted.sort_unstable();
    let usual = sorted[sorted.len() / 2];
    let begins_as_number = |cell: &[u8]| matches!(cell.first(), Some(b'0'..=b'9' | b'+' | b'-'));
    let rows = filled.iter().zip(counts);
    let mut rows = rows.skip_while(|((_, line), count)| match usual {
        0 => !dialect.cells(line).any(begins_as_number),
        _ => *count < usual,
    });
    let wrong = rows.find_map(|((place, line), _)| {
        let mut cells = dialect.cells(line).enumerate();
        let (column, cell) = cells.find(|(_, cell)| !is_number(dialect, cell))?;
        Some((*place, no_number(cell, column)))
    });
    let needed = "rows with equally many numbers are needed, with commas, semicolons, tabs or blanks between them";
    match wrong {
        Some((place, what)) => Problem::line(place as u64 + 1, format!("{what}; {needed}")),
        None => Problem::Unfit(format!("no line has numbers alone: {needed}")),
    }
}

/// Whether a line is empty or a comment.
pub(super) fn is_passed(line: &[u8]) -> bool {
    matches!(line.trim_ascii_start().first(), None | Some(b'#' | b'%'))
}
