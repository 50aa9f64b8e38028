//! A table as a MAT-file of level 5: one variable a column.

use std::fmt::Write as _;
use std::io::{self, Write};
use std::path::Path;

use super::scratch::Scratch;
use super::{Column, ColumnKind, Origin, mat_element};

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
    /// Kept for its room.
    bytes: Vec<u8>,
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
        writer.write_all(&mat_element::header())?;
        mat_element::text(&mut writer, "jeffcott_version", Origin::VERSION)?;
        mat_element::text(&mut writer, "scenario_json", &ascii(&origin.scenario))?;
        for column in columns {
            if let ColumnKind::Word(words) = &column.kind {
                mat_element::words(&mut writer, &format!("{}_names", column.name), words)?;
            }
        }
        Ok(Self {
            writer,
            columns: columns.to_vec(),
            blocks: Scratch::create(scratch)?,
            full: 0,
            open: vec![0.0; BLOCK * columns.len()],
            filled: 0,
            bytes: Vec::with_capacity(8 * BLOCK),
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
        if self.rows() > mat_element::MOST_ROWS {
            return Err(io::Error::other(format!(
                "a MAT-file holds at most {} rows: write fewer (`every`) or another format",
                mat_element::MOST_ROWS
            )));
        }
        for column in self.open.chunks_exact(BLOCK) {
            encode(column, &mut self.bytes);
            self.blocks.append(&self.bytes)?;
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
        let column_bytes = size_of::<f64>() * BLOCK;
        for (place, column) in self.columns.iter().enumerate() {
            mat_element::column_start(&mut self.writer, &column.name, rows)?;
            self.bytes.resize(column_bytes, 0);
            for block in 0..self.full {
                let start = (block * width as u64 + place as u64) * column_bytes as u64;
                self.blocks.read(start, &mut self.bytes)?;
                self.writer.write_all(&self.bytes)?;
            }
            encode(&self.open[place * BLOCK..][..self.filled], &mut self.bytes);
            self.writer.write_all(&self.bytes)?;
        }
        self.writer.flush()?;
        Ok(self.writer)
    }
}

fn encode(numbers: &[f64], bytes: &mut Vec<u8>) {
    bytes.clear();
    bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
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
