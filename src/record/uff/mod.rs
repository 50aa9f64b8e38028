//! Universal files: datasets between lines `-1`, of which 58 (text) and 58b (binary) hold functions of time.

mod data;
mod header;

use super::bytes::Bytes;
use super::{Problem, Record, RecordChannel, Sampling};
use data::{Form, Values};
use header::Header;

/// The line that begins and ends a dataset.
const DELIMITER: &[u8] = b"    -1";

/// Reads all functions of time; other datasets are passed over.
pub(super) fn read(record: &mut Record, mut bytes: Bytes<'_>) -> Result<(), Problem> {
    let bytes = bytes.take(bytes.left())?;
    let mut lines = Lines {
        bytes: &bytes,
        at: 0,
        number: 0,
    };
    while let Some(line) = lines.next() {
        if line != DELIMITER {
            continue;
        }
        let Some(first) = lines.next() else { break };
        match first.get(..6).map(<[u8]>::trim_ascii_start) {
            Some(b"58") => function(record, &mut lines, first)?,
            _ => while lines.next().is_some_and(|line| line != DELIMITER) {},
        }
    }
    Ok(())
}

/// Reads a function up to the end of its dataset.
fn function(record: &mut Record, lines: &mut Lines<'_>, first: &[u8]) -> Result<(), Problem> {
    let form = Form::parse(first).map_err(|what| Problem::line(lines.number, what))?;
    let header = Header::read(lines)?;
    let values = data::read(lines, form, &header)?;
    let name = header.name();
    if !header.is_over_time() {
        let what = "is a function of another quantity than time and is left out";
        record.warn(format!("`{name}` {what}"));
        return Ok(());
    }
    let sampling = sampling(&header, &values);
    let channel = |name, samples| RecordChannel {
        sampling: sampling.clone(),
        quantity: header.quantity().map(str::to_owned),
        unit: header.unit(),
        node: Some(header.node),
        direction: header.direction().map(str::to_owned),
        ..RecordChannel::new(name, samples)
    };
    if !header.is_complex {
        return record.add(channel(name, values.real));
    }
    record.add(channel(format!("{name}.real"), values.real))?;
    record.add(channel(format!("{name}.imaginary"), values.imaginary))
}

fn sampling(header: &Header, values: &Values) -> Sampling {
    if !header.is_even {
        let times = values.abscissa.iter().map(|time| time / header.per_second);
        return Sampling::from_times(&times.collect::<Vec<_>>());
    }
    let rate = header.per_second / header.step;
    let start = header.start / header.per_second;
    match rate > 0.0 && rate.is_finite() {
        true => Sampling::Even { rate, start },
        false => Sampling::Unknown,
    }
}

/// The lines of a file, between which binary data may stand.
struct Lines<'a> {
    bytes: &'a [u8],
    /// Bytes in front of the next line.
    at: usize,
    /// Number of the last line, from 1.
    number: u64,
}

impl<'a> Lines<'a> {
    /// The next line without blanks at its end.
    fn next(&mut self) -> Option<&'a [u8]> {
        let rest = self.rest();
        let end = rest.iter().position(|byte| *byte == b'\n');
        let length = end.unwrap_or(rest.len());
        self.at = self.bytes.len().min(self.at + length + 1);
        self.number += 1;
        (!rest.is_empty()).then(|| rest[..length].trim_ascii_end())
    }

    /// The bytes from here on.
    fn rest(&self) -> &'a [u8] {
        &self.bytes[self.at..]
    }

    /// The file ends here, where more should follow.
    fn cut(&self) -> Problem {
        let byte = self.bytes.len() as u64;
        Problem::Cut { byte }
    }
}
