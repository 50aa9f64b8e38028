//! Tables as text: rows of numbers below a header or none, however separated.

mod columns;
mod dialect;
mod header;
mod stamp;

use super::bytes::Bytes;
use super::{MOST_CHANNELS, Problem, Record, too_many};
use dialect::{Rows, is_passed};

#[cfg(feature = "parquet")]
pub(super) use columns::add;
#[cfg(not(feature = "parquet"))]
use header::Heading;
#[cfg(feature = "parquet")]
pub(super) use header::Heading;

/// What spreadsheets write in front of a file.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Reads a table whose first bytes are known.
pub(super) fn read(record: &mut Record, head: &[u8], mut bytes: Bytes<'_>) -> Result<(), Problem> {
    let is_whole = head.len() as u64 == bytes.left();
    let text = head.strip_prefix(BYTE_ORDER_MARK).unwrap_or(head);
    // old Macintosh programs end lines with a carriage return alone
    let end = match text.contains(&b'\n') || !text.contains(&b'\r') {
        true => b'\n',
        false => b'\r',
    };
    let mut lines: Vec<&[u8]> = text.split(|byte| *byte == end).collect();
    if !is_whole {
        // the rest of the last line is not known
        lines.pop();
    }
    let rows = Rows::find(&lines, is_whole)?;
    if rows.columns > MOST_CHANNELS {
        return Err(too_many());
    }
    if rows.is_ambiguous(&lines) {
        let what = "commas are read as separators of two columns of whole numbers; write points if they are decimal commas";
        record.warn(what);
    }
    if let Some(problem) = rows.with_two_commas(&lines) {
        return Err(problem);
    }
    record.numbers = header::numbers(&lines, &rows);
    let mut headings = header::read(&lines, &rows);
    // a row has at least a sign and a separator a column
    let row_length = (lines[rows.start].len() + 1).max(2 * rows.columns);
    let expected = bytes.left() as usize / row_length;
    let empty = |_| Vec::with_capacity(expected);
    let mut columns: Vec<_> = (0..rows.columns).map(empty).collect();
    fill(record, &mut columns, &mut bytes, end, &rows)?;
    if !rows.stamps.is_empty() {
        stamp::join(&mut columns[rows.stamps.clone()]);
        headings[rows.stamps.start] = Heading::of_times();
    }
    columns::add(record, headings, columns)
}

/// Adds columns whose names say what the header of a file says.
pub(super) fn add_named(
    record: &mut Record,
    named: Vec<(String, Vec<f64>)>,
) -> Result<(), Problem> {
    let (names, columns): (Vec<_>, Vec<_>) = named.into_iter().unzip();
    let units = vec![String::new(); names.len()];
    columns::add(record, header::of_columns(&names, &units), columns)
}

/// Reads all rows, in lines that end with a byte.
fn fill(
    record: &mut Record,
    columns: &mut [Vec<f64>],
    bytes: &mut Bytes<'_>,
    end: u8,
    rows: &Rows,
) -> Result<(), Problem> {
    let (mut line, mut number) = (Vec::new(), 0);
    let mut first_stamps = vec![None; columns.len()];
    while bytes.line(end, &mut line)? {
        number += 1;
        if number <= rows.start || is_passed(&line) {
            continue;
        }
        match row(columns, &mut first_stamps, rows, &line) {
            Ok(()) => {}
            Err(what) if line.ends_with(&[end]) => return Err(Problem::line(number as u64, what)),
            // a recorder that was stopped, or a copy, may end within a line
            Err(what) => {
                record.warn(format!(
                    "the last line, {number}, is not whole and left out: {what}"
                ));
                let whole = columns.iter().map(Vec::len).min().unwrap_or(0);
                columns.iter_mut().for_each(|column| column.truncate(whole));
            }
        }
    }
    Ok(())
}

/// Adds the numbers of a row to the columns.
fn row(
    columns: &mut [Vec<f64>],
    first_stamps: &mut [Option<i128>],
    rows: &Rows,
    line: &[u8],
) -> Result<(), String> {
    let expected = columns.len();
    let mut count = 0;
    for cell in rows.dialect.cells(line) {
        if let Some(column) = columns.get_mut(count) {
            let number = match rows.stamps.contains(&count) {
                true => stamp::since_first(cell, &mut first_stamps[count]),
                false => rows.dialect.number(cell),
            };
            column.push(number.ok_or_else(|| no_number(cell, count))?);
        }
        count += 1;
    }
    match count == expected {
        true => Ok(()),
        false => Err(format!("{count} cells, where the first row has {expected}")),
    }
}

/// What is wrong with a cell.
fn no_number(cell: &[u8], column: usize) -> String {
    let text = String::from_utf8_lossy(cell);
    let way_out = match text.contains([':', '/']) {
        true => "; dates and times are read as `2026-03-01T12:00:00.5`",
        false => "",
    };
    format!(
        "`{text:.40}` in column {} is not a number{way_out}",
        column + 1
    )
}
