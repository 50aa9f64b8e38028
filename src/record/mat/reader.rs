//! Data elements of a MATLAB file: a tag with type and length, then data, which may be further elements.

use super::Value;
use crate::record::Problem;
use crate::record::bytes::{Bytes, Kind, Number};

/// Types of elements.
pub(super) const MATRIX: u32 = 14;
pub(super) const COMPRESSED: u32 = 15;

/// Structs and cells within each other that are followed.
const DEEPEST: usize = 32;
/// Channels of one matrix; a larger one holds something else.
const MOST_SERIES: u64 = 256;
/// Longest name of a field or text, in bytes.
const LONGEST_NAME: usize = 256;
const LONGEST_TEXT: u64 = 1 << 16;

/// Type and length of an element.
pub(super) struct Tag {
    pub kind: u32,
    pub length: u64,
    /// Data that stand in the tag itself.
    small: Option<[u8; 4]>,
}

/// Reads elements one after the other.
pub(super) struct Reader<'r, 'a> {
    bytes: &'r mut Bytes<'a>,
    big_endian: bool,
    /// End of the matrix that is being read.
    end: u64,
    /// What is not read, and why.
    left_out: &'r mut Vec<String>,
}

impl<'r, 'a> Reader<'r, 'a> {
    pub fn new(bytes: &'r mut Bytes<'a>, big_endian: bool, left_out: &'r mut Vec<String>) -> Self {
        let end = bytes.at() + bytes.left();
        Self {
            bytes,
            big_endian,
            end,
            left_out,
        }
    }

    /// The next tag, whose data are there.
    pub fn tag(&mut self) -> Result<Tag, Problem> {
        let [first, second]: [[u8; 4]; 2] = [self.bytes.array()?, self.bytes.array()?];
        let [word, length] = [first, second].map(|word| match self.big_endian {
            true => u32::from_be_bytes(word),
            false => u32::from_le_bytes(word),
        });
        if word >> 16 != 0 {
            return Ok(Tag {
                kind: word & 0xffff,
                length: (word >> 16).min(4).into(),
                small: Some(second),
            });
        }
        let length = length.into();
        self.bytes.need(length)?;
        if self.bytes.at() + length > self.end {
            return Err(self.bytes.problem("an element is longer than its variable"));
        }
        Ok(Tag {
            kind: word,
            length,
            small: None,
        })
    }

    /// Goes to the end of what began at a place, or of the file, as padding may be missing there.
    pub fn skip_to(&mut self, end: u64) -> Result<(), Problem> {
        let Some(count) = end.checked_sub(self.bytes.at()) else {
            return Err(self.bytes.problem("a variable is longer than it says"));
        };
        self.bytes.skip(count.min(self.bytes.left()))
    }

    /// The matrix of so many bytes, with its name.
    pub fn matrix(&mut self, length: u64, depth: usize) -> Result<(String, Value), Problem> {
        if length == 0 {
            return Ok((String::new(), Value::Nothing));
        }
        if depth > DEEPEST {
            let what = format!("more than {DEEPEST} structs and cells within each other");
            return Err(self.bytes.problem(what));
        }
        let outer = self.end;
        self.end = self.bytes.at() + length;
        let flags = self.few()?.first().map_or(0, |flags| *flags as u32);
        let (class, is_complex) = (flags as u8, flags & 0x800 != 0);
        // an object has no dimensions
        let dimensions = if class == 17 { vec![0.0] } else { self.few()? };
        let (rows, further) = dimensions.split_first().unwrap_or((&0.0, &[]));
        let (rows, columns) = (*rows as u64, further.iter().product::<f64>() as u64);
        let name = self.text()?;
        let count = rows.saturating_mul(columns);
        let value = match class {
            1 => self.cells(count, depth)?,
            2 => self.structs(count, depth)?,
            // of an object of a class of old the fields, behind the name of the class
            3 => self.text().and_then(|_| self.structs(count, depth))?,
            4 => Value::Text(self.text()?),
            6..=15 if count == 0 => Value::Nothing,
            6..=15 if rows.min(columns) <= MOST_SERIES => {
                let real = self.series(rows, columns)?;
                match is_complex {
                    true => Value::Complex([real, self.series(rows, columns)?]),
                    false => Value::Series(real),
                }
            }
            _ => {
                let what = match class {
                    5 => "a sparse matrix",
                    6..=15 => "a large matrix",
                    16 => "a function",
                    17 => "an object, such as a table or timetable",
                    _ => "of an unknown class",
                };
                let text = format!("`{name}` is {what} and is left out; save plain arrays");
                self.left_out.push(text);
                Value::Nothing
            }
        };
        self.skip_to(self.end)?;
        self.end = outer;
        Ok((name, value))
    }

    fn cells(&mut self, count: u64, depth: usize) -> Result<Value, Problem> {
        self.have(count)?;
        let cells = (0..count).map(|_| self.child(depth));
        Ok(Value::Cells(cells.collect::<Result<_, _>>()?))
    }

    fn structs(&mut self, count: u64, depth: usize) -> Result<Value, Problem> {
        let width = self.few()?.first().map_or(0, |width| *width as usize);
        let tag = self.tag()?;
        let names = self.data(&tag)?;
        if width == 0 || width > LONGEST_NAME || names.is_empty() {
            return Ok(Value::Nothing);
        }
        let names: Vec<String> = names.chunks(width).map(until_zero).collect();
        self.have(count.saturating_mul(names.len() as u64))?;
        let element = |_| names.iter().map(|_| self.child(depth)).collect();
        let elements = (0..count).map(element).collect::<Result<_, _>>()?;
        Ok(Value::Structs { names, elements })
    }

    /// Makes sure that so many fields or cells have bytes enough: each has a tag at least.
    fn have(&self, children: u64) -> Result<(), Problem> {
        match children <= self.end.saturating_sub(self.bytes.at()) / 8 {
            true => Ok(()),
            false => Err(self.bytes.problem("more fields or cells than bytes")),
        }
    }

    fn child(&mut self, depth: usize) -> Result<Value, Problem> {
        let tag = self.tag()?;
        if tag.kind != MATRIX || tag.small.is_some() {
            return Err(self.bytes.problem("there is no field or cell here"));
        }
        Ok(self.matrix(tag.length, depth + 1)?.1)
    }

    /// The columns of a matrix, which stand one after the other, or its rows where these are longer.
    fn series(&mut self, rows: u64, columns: u64) -> Result<Vec<Vec<f64>>, Problem> {
        let tag = self.tag()?;
        let has = tag.length / self.number(&tag)?.size();
        if rows.saturating_mul(columns) != has {
            let what = format!("a matrix of {rows} by {columns} has {has} numbers");
            return Err(self.bytes.problem(what));
        }
        let (count, length) = (rows.min(columns) as usize, rows.max(columns) as usize);
        let mut series: Vec<_> = (0..count).map(|_| Vec::with_capacity(length)).collect();
        let by_rows = rows < columns;
        let mut place = 0;
        self.numbers(&tag, |value| {
            series[if by_rows {
                place % count
            } else {
                place / length
            }]
            .push(value);
            place += 1;
        })?;
        Ok(series)
    }

    /// The few numbers of an element: flags, dimensions, lengths.
    fn few(&mut self) -> Result<Vec<f64>, Problem> {
        let tag = self.tag()?;
        if tag.length > 256 {
            return Err(self.bytes.problem("a variable has more than 32 dimensions"));
        }
        let mut few = Vec::new();
        self.numbers(&tag, |value| few.push(value))?;
        Ok(few)
    }

    /// Gives `take` the numbers of an element.
    fn numbers(&mut self, tag: &Tag, mut take: impl FnMut(f64)) -> Result<(), Problem> {
        let number = self.number(tag)?;
        if let Some(small) = tag.small {
            number.each(&small[..tag.length as usize], &mut take);
            return Ok(());
        }
        let end = self.bytes.at() + tag.length.next_multiple_of(8);
        self.bytes
            .numbers(tag.length / number.size(), number, take)?;
        self.skip_to(end)
    }

    /// How the numbers of an element are written.
    fn number(&self, tag: &Tag) -> Result<Number, Problem> {
        let kind = match tag.kind {
            1 => Kind::I8,
            2 => Kind::U8,
            3 => Kind::I16,
            4 | 17 => Kind::U16,
            5 => Kind::I32,
            6 => Kind::U32,
            7 => Kind::F32,
            9 => Kind::F64,
            12 => Kind::I64,
            13 => Kind::U64,
            kind => {
                let what = format!("an element of type {kind} where numbers should be");
                return Err(self.bytes.problem(what));
            }
        };
        let big_endian = self.big_endian;
        Ok(Number { kind, big_endian })
    }

    /// The bytes of a short element, of which a long one is cut.
    fn data(&mut self, tag: &Tag) -> Result<Vec<u8>, Problem> {
        if let Some(small) = tag.small {
            return Ok(small[..tag.length as usize].to_vec());
        }
        let end = self.bytes.at() + tag.length.next_multiple_of(8);
        let data = self.bytes.take(tag.length.min(LONGEST_TEXT))?;
        self.skip_to(end)?;
        Ok(data)
    }

    /// A text, of UTF-8 or of numbers of 16 bits.
    fn text(&mut self) -> Result<String, Problem> {
        let tag = self.tag()?;
        let data = self.data(&tag)?;
        if !matches!(tag.kind, 4 | 17) {
            return Ok(until_zero(&data));
        }
        let mut units = Vec::new();
        self.number(&tag)?
            .each(&data, &mut |unit| units.push(unit as u16));
        Ok(String::from_utf16_lossy(&units))
    }
}

/// The text in front of the first zero.
fn until_zero(bytes: &[u8]) -> String {
    let text = bytes.split(|byte| *byte == 0).next().unwrap_or_default();
    String::from_utf8_lossy(text).into_owned()
}
