//! The values of a function, as text or binary.

use std::ops::Range;

use super::{DELIMITER, Header, Lines};
use crate::record::Problem;
use crate::record::bytes::{Kind, Number};

/// Values of a function: its abscissa where that is uneven, real parts, and imaginary parts where it is complex.
#[derive(Default)]
pub(super) struct Values {
    pub abscissa: Vec<f64>,
    pub real: Vec<f64>,
    pub imaginary: Vec<f64>,
}

/// How values are written.
pub(super) enum Form {
    Text,
    Binary { big_endian: bool },
}

impl Form {
    /// As the first line of the dataset says: `58`, or `58b` with the order of the bytes and the form of the numbers.
    pub fn parse(line: &[u8]) -> Result<Self, &'static str> {
        if !matches!(line.get(6), Some(b'b' | b'B')) {
            return Ok(Self::Text);
        }
        let field = |range: Range<usize>| line.get(range).unwrap_or_default().trim_ascii();
        match (field(7..13), field(13..19)) {
            (b"1", b"2") => Ok(Self::Binary { big_endian: false }),
            (b"2", b"2") => Ok(Self::Binary { big_endian: true }),
            _ => Err("binary numbers that are not IEEE 754 are not read; export them as text"),
        }
    }
}

/// What numbers follow each other for each point.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    Abscissa,
    Real,
    Imaginary,
}

use Part::{Abscissa, Imaginary, Real};

impl Values {
    fn of_part(&mut self, part: Part) -> &mut Vec<f64> {
        match part {
            Abscissa => &mut self.abscissa,
            Real => &mut self.real,
            Imaginary => &mut self.imaginary,
        }
    }
}

/// Reads the values and the end of the dataset.
pub(super) fn read(lines: &mut Lines<'_>, form: Form, header: &Header) -> Result<Values, Problem> {
    let parts: &[Part] = match (header.is_even, header.is_complex) {
        (true, false) => &[Real],
        (true, true) => &[Real, Imaginary],
        (false, false) => &[Abscissa, Real],
        (false, true) => &[Abscissa, Real, Imaginary],
    };
    if header.count > lines.rest().len() as u64 {
        return Err(lines.cut());
    }
    let mut values = Values::default();
    for part in parts {
        values.of_part(*part).reserve_exact(header.count as usize);
    }
    match form {
        Form::Text => text(lines, header, parts, &mut values)?,
        Form::Binary { big_endian } => binary(lines, header, parts, big_endian, &mut values)?,
    }
    Ok(values)
}

/// Numbers with blanks between them, up to the end of the dataset.
fn text(
    lines: &mut Lines<'_>,
    header: &Header,
    parts: &[Part],
    values: &mut Values,
) -> Result<(), Problem> {
    let total = header.count as usize * parts.len();
    let mut taken = 0;
    while let Some(line) = lines.next().filter(|line| *line != DELIMITER) {
        let cells = line.split(u8::is_ascii_whitespace);
        for cell in cells.filter(|cell| !cell.is_empty()) {
            let value = number(cell).map_err(|what| Problem::line(lines.number, what))?;
            values.of_part(parts[taken % parts.len()]).push(value);
            taken += 1;
        }
    }
    if taken == total {
        return Ok(());
    }
    let what = format!("the dataset ends here, with {taken} numbers where {total} should be");
    Err(Problem::line(lines.number, what))
}

/// A number, whose exponent may be written with D.
fn number(cell: &[u8]) -> Result<f64, String> {
    let text = String::from_utf8_lossy(cell);
    let with_e = || text.replace(['D', 'd'], "E").parse();
    let read = text.parse().or_else(|_| with_e());
    read.map_err(|_| format!("`{text:.40}` is not a number"))
}

fn binary(
    lines: &mut Lines<'_>,
    header: &Header,
    parts: &[Part],
    big_endian: bool,
    values: &mut Values,
) -> Result<(), Problem> {
    // writers differ in the width of an abscissa, and some write all numbers double
    let widths = match header.is_double {
        true => [(Kind::F64, Kind::F64), (Kind::F32, Kind::F64)],
        false => [(Kind::F32, Kind::F32), (Kind::F64, Kind::F64)],
    };
    for (abscissa, value) in widths {
        let kind = |part: &Part| if *part == Abscissa { abscissa } else { value };
        let form = |part| Number {
            kind: kind(part),
            big_endian,
        };
        let size: u64 = parts.iter().map(|part| form(part).size()).sum();
        let Some(range) = extent(lines.rest(), header.count.saturating_mul(size)) else {
            continue;
        };
        for mut point in lines.rest()[range.clone()].chunks_exact(size as usize) {
            for part in parts {
                let one;
                (one, point) = point.split_at(form(part).size() as usize);
                form(part).each(one, &mut |number| values.of_part(*part).push(number));
            }
        }
        lines.at += range.end;
        while lines.next().is_some_and(|line| line != DELIMITER) {}
        return Ok(());
    }
    let count = header.count;
    let what = format!("{count} values begin here, after which there is no line `-1`");
    let why = "is the file cut, or were its line ends converted?";
    Err(Problem::byte(lines.at as u64, format!("{what}; {why}")))
}

/// Where so many bytes of data stand, behind which the dataset ends; stray line ends may stand on both sides.
fn extent(bytes: &[u8], length: u64) -> Option<Range<usize>> {
    let is_line_end = |byte: &&u8| matches!(byte, b'\r' | b'\n');
    let line_ends = |bytes: &[u8]| bytes.iter().take(2).take_while(is_line_end).count();
    (0..=line_ends(bytes)).find_map(|start| {
        let end = start.checked_add(length as usize)?;
        let behind = bytes.get(end..)?;
        let behind = &behind[line_ends(behind)..];
        let ends = behind.is_empty() || behind.starts_with(DELIMITER);
        ends.then_some(start..end)
    })
}
