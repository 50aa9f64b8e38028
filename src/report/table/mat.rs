//! A table as a MAT-file of level 5: one variable a column.
//!
//! Data elements are those of MathWorks, "MAT-File Format": a tag of type and length, then the data, padded to eight
//! bytes; up to four bytes stand inside the tag.

use std::fmt::Write as _;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::{fs, io};

use super::Origin;
use crate::table::{Column, ColumnKind};

/// Rows that are kept in memory.
const BLOCK: usize = 8192;

/// Writes a table as variables that `load` of MATLAB and `scipy.io.loadmat` read: a column vector a
/// column under its name, words as numbers from 1 with the words themselves in `<name>_names`, and the
/// texts `jeffcott_version` and `scenario_json`.
///
/// A MAT-file holds one whole column after another and their length before the first number. The rows
/// therefore wait in a file beside it, in blocks of columns, until they are all there; memory does not
/// grow with them. The file is not compressed.
#[derive(Debug)]
pub struct MatTable<W: Write> {
    writer: W,
    columns: Vec<Column>,
    /// Blocks that are full, each with its columns one after another.
    blocks: Scratch,
    full: u64,
    /// The block being filled, [`BLOCK`] rows a column.
    open: Vec<f64>,
    filled: usize,
}

impl<W: Write> MatTable<W> {
    /// Writes the texts; rows wait in a file at `scratch`, which is gone in the end.
    ///
    /// # Errors
    /// What the writer and the file system answer.
    pub fn new(
        mut writer: W,
        columns: &[Column],
        origin: &Origin,
        scratch: &Path,
    ) -> io::Result<Self> {
        writer.write_all(&file_header())?;
        write_text(&mut writer, "jeffcott_version", Origin::VERSION)?;
        write_text(&mut writer, "scenario_json", &ascii(&origin.scenario))?;
        for column in columns {
            if let ColumnKind::Word(words) = &column.kind {
                write_words(&mut writer, &format!("{}_names", column.name()), words)?;
            }
        }
        Ok(Self {
            writer,
            columns: columns.to_vec(),
            blocks: Scratch::create(scratch)?,
            full: 0,
            open: vec![0.0; BLOCK * columns.len()],
            filled: 0,
        })
    }

    /// Takes a row, one number a column.
    ///
    /// # Errors
    /// What the file system answers; more rows than a MAT-file holds.
    pub fn row(&mut self, row: &[f64]) -> io::Result<()> {
        for ((place, value), column) in row.iter().enumerate().zip(&self.columns) {
            self.open[place * BLOCK + self.filled] = match &column.kind {
                ColumnKind::Word(_) => value + 1.0,
                _ => *value,
            };
        }
        self.filled += 1;
        if self.filled < BLOCK {
            return Ok(());
        }
        if self.rows() > MOST_ROWS {
            return Err(io::Error::other(format!(
                "a MAT-file holds at most {MOST_ROWS} rows: write fewer (`every`) or another format"
            )));
        }
        for column in self.open.chunks_exact(BLOCK) {
            self.blocks.file.write_all(&encoded(column))?;
        }
        self.full += 1;
        self.filled = 0;
        Ok(())
    }

    fn rows(&self) -> u64 {
        self.full * BLOCK as u64 + self.filled as u64
    }

    /// Writes the columns and gives the writer back.
    ///
    /// # Errors
    /// What the writer and the file system answer.
    pub fn finish(mut self) -> io::Result<W> {
        let (rows, width) = (self.rows(), self.columns.len());
        let mut bytes = vec![0; size_of::<f64>() * BLOCK];
        for (place, column) in self.columns.iter().enumerate() {
            column_start(&mut self.writer, &column.name(), rows)?;
            for block in 0..self.full {
                let start = (block * width as u64 + place as u64) * bytes.len() as u64;
                self.blocks.read(start, &mut bytes)?;
                self.writer.write_all(&bytes)?;
            }
            let last = &self.open[place * BLOCK..][..self.filled];
            self.writer.write_all(&encoded(last))?;
        }
        self.writer.flush()?;
        Ok(self.writer)
    }
}

fn encoded(numbers: &[f64]) -> Vec<u8> {
    let bytes = numbers.iter().flat_map(|number| number.to_le_bytes());
    bytes.collect()
}

/// JSON with every character beyond ASCII escaped: the same JSON to whoever decodes it.
fn ascii(json: &str) -> String {
    let mut text = String::with_capacity(json.len());
    for letter in json.chars() {
        if letter.is_ascii() {
            text.push(letter);
            continue;
        }
        for unit in letter.encode_utf16(&mut [0; 2]) {
            // writing to a string cannot fail
            let _ = write!(text, "\\u{unit:04x}");
        }
    }
    text
}

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
const MOST_ROWS: u64 = ((1 << 31) - 128) / 8;

/// The 128 bytes that a file begins with.
fn file_header() -> [u8; 128] {
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
fn column_start(writer: &mut impl Write, name: &str, rows: u64) -> io::Result<()> {
    let data = 8 * rows;
    let about = about(DOUBLES, [rows, 1], name);
    write_tag(writer, MATRIX, about.len() as u64 + TAG + data)?;
    writer.write_all(&about)?;
    write_tag(writer, DOUBLE, data)
}

/// Writes a text, ASCII alone: other characters are read differently by different readers.
fn write_text(writer: &mut impl Write, name: &str, text: &str) -> io::Result<()> {
    write_words(writer, name, &[text.to_owned()])
}

/// Writes words as the rows of a matrix of characters, filled up with blanks.
fn write_words(writer: &mut impl Write, name: &str, words: &[String]) -> io::Result<()> {
    let width = words.iter().map(|word| word.len()).max().unwrap_or(0);
    let letter = |word: &String, place: usize| word.as_bytes().get(place).copied().unwrap_or(b' ');
    let letters = (0..width).flat_map(|place| words.iter().map(move |word| letter(word, place)));
    let letters: Vec<u8> = letters.flat_map(|byte| [byte, 0]).collect();
    let mut content = about(CHARACTERS, [words.len() as u64, width as u64], name);
    element(&mut content, UINT16, &letters);
    write_tag(writer, MATRIX, content.len() as u64)?;
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

fn write_tag(writer: &mut impl Write, kind: u32, length: u64) -> io::Result<()> {
    let length = u32::try_from(length).map_err(io::Error::other)?;
    writer.write_all(&kind.to_le_bytes())?;
    writer.write_all(&length.to_le_bytes())
}

/// A file for writing, then reading; removed when dropped.
#[derive(Debug)]
struct Scratch {
    file: File,
    path: PathBuf,
}

impl Scratch {
    /// Creates the file.
    fn create(path: &Path) -> io::Result<Self> {
        let mut options = File::options();
        options.read(true).write(true).create(true).truncate(true);
        Ok(Self {
            file: options.open(path)?,
            path: path.to_owned(),
        })
    }

    /// Fills `bytes` from the place `start`.
    fn read(&mut self, start: u64, bytes: &mut [u8]) -> io::Result<()> {
        self.file.seek(SeekFrom::Start(start))?;
        self.file.read_exact(bytes)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // there is nobody left to tell of a failure
        let _ = fs::remove_file(&self.path);
    }
}

#[cfg(test)]
mod tests {
    use super::ascii;

    #[test]
    fn escaped_json_means_the_same() {
        let value = serde_json::json!({ "title": "5 µm 𝛼" });
        let escaped = ascii(&value.to_string());
        assert_eq!(escaped, r#"{"title":"5 \u00b5m \ud835\udefc"}"#);
        assert_eq!(escaped.parse::<serde_json::Value>().ok(), Some(value));
    }
}
