//! A table as CSV.

use std::io::{self, Write};

use super::{Column, ColumnKind};

/// Writes rows of numbers in the shortest form that reads back to the same value; a cell is empty where there is none.
#[derive(Debug)]
pub struct CsvTable<W: Write> {
    writer: W,
    kinds: Vec<ColumnKind>,
    /// Kept from row to row for its room.
    line: Vec<u8>,
}

impl<W: Write> CsvTable<W> {
    /// Writes the header.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn new(mut writer: W, columns: &[Column]) -> io::Result<Self> {
        let names: Vec<&str> = columns.iter().map(|column| &*column.name).collect();
        writeln!(writer, "{}", names.join(","))?;
        Ok(Self {
            writer,
            kinds: columns.iter().map(|column| column.kind.clone()).collect(),
            line: Vec::new(),
        })
    }

    /// Writes a row, one number a column.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn row(&mut self, row: &[f64]) -> io::Result<()> {
        self.line.clear();
        for (value, kind) in row.iter().zip(&self.kinds) {
            cell(*value, kind, &mut self.line);
            self.line.push(b',');
        }
        if let Some(last) = self.line.last_mut() {
            *last = b'\n';
        }
        self.writer.write_all(&self.line)
    }

    /// Gives the writer back.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn finish(mut self) -> io::Result<W> {
        self.writer.flush()?;
        Ok(self.writer)
    }
}

fn cell(value: f64, kind: &ColumnKind, line: &mut Vec<u8>) {
    match kind {
        ColumnKind::Number | ColumnKind::Count if value.is_nan() => {}
        ColumnKind::Number => {
            let mut digits = ryu::Buffer::new();
            line.extend_from_slice(digits.format(value).as_bytes());
        }
        ColumnKind::Count => {
            // writing to a vector cannot fail
            let _ = write!(line, "{}", value as i64);
        }
        ColumnKind::Word(words) => {
            let word = words.get(value as usize).map_or("", String::as_str);
            push_word(word, line);
        }
    }
}

/// A word, between quotes where it holds what separates cells.
fn push_word(word: &str, line: &mut Vec<u8>) {
    if !word.contains([',', '"', '\n', '\r']) {
        line.extend_from_slice(word.as_bytes());
        return;
    }
    line.push(b'"');
    line.extend_from_slice(word.replace('"', "\"\"").as_bytes());
    line.push(b'"');
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_all_their_digits() -> Result<(), std::io::Error> {
        let columns = [Column::number("x_m"), Column::count("balls")];
        let mut table = CsvTable::new(Vec::new(), &columns)?;
        table.row(&[0.1 + 0.2, 7.0])?;
        assert_eq!(table.finish()?, b"x_m,balls\n0.30000000000000004,7\n");
        Ok(())
    }
}
