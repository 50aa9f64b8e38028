//! Data elements of a MAT-file of level 5, as MathWorks, "MAT-File Format", gives them: a tag of type
//! and length, then the data, padded to eight bytes; up to four bytes stand inside the tag.

use std::io::{self, Write};

/// Types of data.
const INT8: u32 = 1;
const UINT16: u32 = 4;
const INT32: u32 = 5;
const UINT32: u32 = 6;
const DOUBLE: u32 = 9;
const MATRIX: u32 = 14;

/// Classes of arrays.
const CHARACTERS: u32 = 4;
const DOUBLES: u32 = 6;

/// Bytes of a tag, and of what data are padded to.
const TAG: u64 = 8;
/// Most bytes that stand inside a tag.
const INSIDE: usize = 4;

/// Most rows of a column: the length of a matrix is a signed number of 32 bits to some readers, and
/// the elements beside the data take less than 128 bytes.
pub(super) const MOST_ROWS: u64 = ((1 << 31) - 128) / 8;

/// The 128 bytes that a file begins with.
pub(super) fn header() -> [u8; 128] {
    let mut header = [b' '; 128];
    let text = concat!(
        "MATLAB 5.0 MAT-file, written by jeffcott ",
        env!("CARGO_PKG_VERSION")
    );
    header[..text.len()].copy_from_slice(text.as_bytes());
    // no data of subsystems, version 1, and the order of bytes
    header[116..124].fill(0);
    header[124..].copy_from_slice(&[0x00, 0x01, b'I', b'M']);
    header
}

/// Writes all of a column of `rows` doubles but its numbers, 8 bytes each, which are to follow; they need
/// no padding.
pub(super) fn column_start(writer: &mut impl Write, name: &str, rows: u64) -> io::Result<()> {
    let data = 8 * rows;
    let about = about(DOUBLES, [rows, 1], name);
    tag(writer, MATRIX, about.len() as u64 + TAG + data)?;
    writer.write_all(&about)?;
    tag(writer, DOUBLE, data)
}

/// Writes a text, ASCII alone: other characters are read differently by different readers.
pub(super) fn text(writer: &mut impl Write, name: &str, text: &str) -> io::Result<()> {
    words(writer, name, &[text.to_owned()])
}

/// Writes words as the rows of a matrix of characters, filled up with blanks.
pub(super) fn words(writer: &mut impl Write, name: &str, words: &[String]) -> io::Result<()> {
    let width = words.iter().map(|word| word.len()).max().unwrap_or(0);
    let letter = |word: &String, place: usize| word.as_bytes().get(place).copied().unwrap_or(b' ');
    let letters = (0..width).flat_map(|place| words.iter().map(move |word| letter(word, place)));
    let letters: Vec<u8> = letters.flat_map(|byte| [byte, 0]).collect();
    let mut content = about(CHARACTERS, [words.len() as u64, width as u64], name);
    element(&mut content, UINT16, &letters);
    tag(writer, MATRIX, content.len() as u64)?;
    writer.write_all(&content)
}

/// Class, dimensions and name of an array.
fn about(class: u32, [rows, columns]: [u64; 2], name: &str) -> Vec<u8> {
    let pair = |first: u32, second: u32| [first.to_le_bytes(), second.to_le_bytes()].concat();
    let mut bytes = Vec::new();
    element(&mut bytes, UINT32, &pair(class, 0));
    element(&mut bytes, INT32, &pair(rows as u32, columns as u32));
    element(&mut bytes, INT8, name.as_bytes());
    bytes
}

/// Appends a whole element.
fn element(bytes: &mut Vec<u8>, kind: u32, data: &[u8]) {
    let length = data.len() as u32;
    if (1..=INSIDE).contains(&data.len()) {
        bytes.extend((length << 16 | kind).to_le_bytes());
    } else {
        bytes.extend(kind.to_le_bytes());
        bytes.extend(length.to_le_bytes());
    }
    bytes.extend(data);
    bytes.resize(bytes.len().next_multiple_of(TAG as usize), 0);
}

fn tag(writer: &mut impl Write, kind: u32, length: u64) -> io::Result<()> {
    let length = u32::try_from(length).map_err(io::Error::other)?;
    writer.write_all(&kind.to_le_bytes())?;
    writer.write_all(&length.to_le_bytes())
}
