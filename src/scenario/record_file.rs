//! Files that describe a record, and records that a command line describes: two doors to one description.

use std::f64::consts::TAU;
use std::io::{self, Read};
use std::path::Path;
use std::sync::LazyLock;

use serde_json::Value;

use super::document::{Document, FileKind, STDIN, STDIN_NAME};
use super::input::{Output, RecordFileInput, Recorded, Turning as Turns, build_spectra};
use super::problems::Problems;
use super::schema::schema_of;
use super::signals::Signals;
use super::{Format, Issue, ScenarioError, echo, read_titled};
use crate::analysis::{
    Axis, Channel, Detrend, Scaling, Segment, SpectrumKind, SpectrumRequest, Window,
};
use crate::measurement::{Measurement, Turning};
use crate::record::{Problem, Record, RecordError};
use crate::rotor::Freedoms;
use crate::table::Table;

/// Channels whose envelopes are taken where no spectra are asked for.
const MOST_ENVELOPES: usize = 4;
/// Samples of the segments of their spectra at most.
const LONGEST_SEGMENT: usize = 1 << 20;

/// A record that is read, and what its description says.
#[derive(Debug)]
pub struct MeasuredFile {
    /// What was measured.
    pub measurement: Measurement,
    /// What is reported of it.
    pub about: RecordDescription,
}

/// What a description says of a record, but its samples.
#[derive(Debug)]
pub struct RecordDescription {
    /// Its title, or the name of its file.
    pub title: String,
    /// What of it is analysed, and as what.
    pub channels: Table<'static>,
    /// What is written.
    pub output: Output,
    /// The description with its defaults.
    pub echo: Value,
    /// What the user should know.
    pub warnings: Vec<String>,
}

/// JSON Schema (draft 7) of a file that describes a record.
pub fn record_schema() -> &'static Value {
    static SCHEMA: LazyLock<Value> = LazyLock::new(schema_of::<RecordFileInput>);
    &SCHEMA
}

/// Reads and checks a file .toml or .json that describes a record, with some values in place of its own, and the record that it names;
/// any other file is a record, of which a description as JSON says what it does not. Of standard input, `-`, what it holds tells
/// which of them it is.
///
/// # Errors
/// [`ScenarioError`] with everything that is wrong.
pub fn load_record(
    path: &Path,
    description: &str,
    settings: &[String],
) -> Result<MeasuredFile, ScenarioError> {
    if path == Path::new(STDIN) {
        return load_input(description, settings);
    }
    if ["toml", "json"]
        .iter()
        .any(|ending| path.extension() == Some(ending.as_ref()))
    {
        return check_record(&Document::open(path)?.with(settings)?);
    }
    let name = path.display().to_string();
    let document = Document::parse(description, &name, Format::Json)?.with(settings)?;
    match Record::open(path) {
        Ok(record) => check(&document, Some(record)),
        Err(error) => Err(document.refused(Issue::new("", error.problem.to_string()))),
    }
}

/// A description, or a record of which one as JSON says what it does not, from standard input.
fn load_input(description: &str, settings: &[String]) -> Result<MeasuredFile, ScenarioError> {
    let document = Document::parse(description, STDIN_NAME, Format::Json)?.with(settings)?;
    let refused = |problem: String| document.refused(Issue::new("", problem));
    let bytes = input_bytes().map_err(|error| refused(Problem::Read(error).to_string()))?;
    if let Some(text) = description_in(&bytes) {
        return check_record(&Document::of_input(text)?.with(settings)?);
    }
    match Record::from_bytes(&bytes, STDIN_NAME) {
        Ok(record) => check(&document, Some(record)),
        Err(error) => Err(refused(error.problem.to_string())),
    }
}

/// The record in a file, or in standard input of `-`.
///
/// # Errors
/// It cannot be read as a record.
pub fn open_record(path: &Path) -> Result<Record, RecordError> {
    if path != Path::new(STDIN) {
        return Record::open(path);
    }
    let name = STDIN_NAME.to_owned();
    match input_bytes() {
        Ok(bytes) => Record::from_bytes(&bytes, STDIN_NAME),
        Err(error) => Err(RecordError {
            name,
            problem: Problem::Read(error),
        }),
    }
}

fn input_bytes() -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    io::stdin().read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The text of a description of a record, which is JSON or has a table `[record]`; none of the bytes of a record.
fn description_in(bytes: &[u8]) -> Option<&str> {
    let text = std::str::from_utf8(bytes).ok()?;
    let is_table = |line: &str| {
        ["[record]", "[[record."]
            .iter()
            .any(|it| line.starts_with(it))
    };
    (text.trim_start().starts_with('{') || text.lines().any(is_table)).then_some(text)
}

/// A record of a name, of which a description as JSON and the settings say what its file does not.
///
/// # Errors
/// [`ScenarioError`] with everything that is wrong.
pub fn describe_record(
    record: Record,
    name: &str,
    description: &str,
    settings: &[String],
) -> Result<MeasuredFile, ScenarioError> {
    let document = Document::parse(description, name, Format::Json)?.with(settings)?;
    check(&document, Some(record))
}

/// Checks a description and reads the record that it names.
pub(super) fn check_record(document: &Document) -> Result<MeasuredFile, ScenarioError> {
    check(document, None)
}

fn check(document: &Document, record: Option<Record>) -> Result<MeasuredFile, ScenarioError> {
    document.check_kind(FileKind::Record)?;
    let mut problems = document.problems().about("the record");
    let built = build(document, record, &mut problems);
    let (mut file, warnings) = document.finish(built, problems)?;
    file.about.warnings.extend(warnings);
    Ok(file)
}

fn build(
    document: &Document,
    record: Option<Record>,
    problems: &mut Problems<'_>,
) -> Option<MeasuredFile> {
    let input: RecordFileInput = read_titled(record_schema(), problems)?;
    let bearings = problems.each("bearing", &input.bearing, |bearing, problems| {
        bearing.build(problems)
    });
    let output = input.output.build(problems);
    let record = match record {
        Some(record) => record,
        None => open(&input, document, problems)?,
    };
    let warnings = record.warnings.clone();
    let signals = Signals::new(&input, record, problems)?;
    let channels = signals.channels();
    let turning = signals.turning.as_ref();
    let speeds = turning.map_or([0.0; 3], Turning::speeds);
    let recorded = Recorded {
        freedoms: Freedoms::Radial,
        measured: Some(&channels),
        window: signals.length() as f64 / signals.rate,
        rate: signals.rate,
        turning: Turns {
            key: "speed",
            highest: speeds[2],
            steady: turning.and_then(Turning::steady),
            changes: turning.is_some_and(|turning| turning.steady().is_none()),
        },
    };
    let mut spectra = build_spectra(&input.spectrum, &recorded, problems);
    if input.spectrum.is_empty() {
        let turns = speeds[0] / TAU * recorded.window;
        let turns = recorded.turning.changes.then_some(turns);
        spectra = default_spectra(&channels, signals.length(), turns);
    }
    let about = RecordDescription {
        title: input.title.clone().unwrap_or_else(|| document.stem()),
        channels: signals.table(),
        output,
        echo: echo(&input),
        warnings,
    };
    Some(MeasuredFile {
        about,
        measurement: Measurement {
            rate: signals.rate,
            start: signals.start,
            bearings: bearings?,
            machine: input.machine.as_ref().map(|machine| machine.build()),
            window: input.output.window,
            spectra,
            turning: signals.turning,
            signals: signals.values,
        },
    })
}

/// The record that a description names, looked for from its folder.
fn open(
    input: &RecordFileInput,
    document: &Document,
    problems: &mut Problems<'_>,
) -> Option<Record> {
    let Some(file) = &input.record.file else {
        let issue = Issue::new("record.file", "`[record]` names no `file`");
        problems.refuse(
            issue.help("for instance: file = \"112.mat\", looked for from the folder of this file"),
        );
        return None;
    };
    let read = Record::open(&document.folder().join(file));
    problems.take(read.map_err(|error| Issue::new("record.file", error.to_string())))
}

/// Envelopes in the bands where channels knock most; where the speed changes over so many turns, over orders, then also the spectra of the
/// channels over orders. Of a long record they are means of its parts.
fn default_spectra(
    channels: &[Channel],
    length: usize,
    changing_turns: Option<f64>,
) -> Vec<SpectrumRequest> {
    let is_of_sensor =
        |channel: &&Channel| matches!(channel, Channel::Measured(_)) || channel.unit() == "m/s^2";
    let (axis, part) = match changing_turns {
        Some(turns) => {
            let part = turns * LONGEST_SEGMENT as f64 / length as f64;
            (Axis::Order, Segment::Revolutions(part.max(1.0) as u32))
        }
        None => (Axis::Frequency, Segment::Samples(LONGEST_SEGMENT)),
    };
    let request = |name: String, kind, channels: &[Channel]| SpectrumRequest {
        name,
        kind,
        channels: channels.to_vec(),
        scaling: Scaling::Peak,
        window: Window::Hann,
        segment: match length > LONGEST_SEGMENT {
            true => part,
            false => Segment::Whole,
        },
        overlap: 0.5,
        detrend: Detrend::Constant,
        axis,
    };
    let one_by_one = channels.iter().filter(is_of_sensor).take(MOST_ENVELOPES);
    let envelopes = one_by_one.map(|channel| {
        let name = match channels {
            [_] => "envelope".to_owned(),
            _ => format!("envelope_{channel}"),
        };
        request(name, SpectrumKind::ImpulsiveEnvelope, &[*channel])
    });
    let orders =
        changing_turns.map(|_| request("orders".to_owned(), SpectrumKind::Plain, channels));
    envelopes.chain(orders).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_records_are_taken_in_parts() {
        let channels = [Channel::Acceleration(0)];
        let segments = |length, turns| {
            let requests = default_spectra(&channels, length, turns);
            requests
                .iter()
                .map(|request| request.segment)
                .collect::<Vec<_>>()
        };
        let long = 4 * LONGEST_SEGMENT;
        assert_eq!(segments(1000, None), [Segment::Whole]);
        assert_eq!(segments(1000, Some(5.0)), [Segment::Whole; 2]);
        assert_eq!(segments(long, None), [Segment::Samples(LONGEST_SEGMENT)]);
        assert_eq!(
            segments(long, Some(4004.0)),
            [Segment::Revolutions(1001); 2]
        );
        assert_eq!(segments(long, Some(0.4)), [Segment::Revolutions(1); 2]);
    }
}
