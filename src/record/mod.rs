//! Measured records: the file of a sensor, recorder or simulation → its channels, and what the file says of each.
//!
//! What a file lacks, such as the rate or a unit, is `None`: nothing is guessed. The form of a file is recognised by its content;
//! its name only matters for text that could be anything.
//!
//! ```no_run
//! let record = jeffcott::record::Record::open("112.mat".as_ref())?;
//! for channel in &record.channels {
//!     println!("{}: {} samples, {:?}", channel.name, channel.samples.len(), channel.sampling);
//! }
//! # Ok::<(), jeffcott::record::RecordError>(())
//! ```

mod bytes;
mod error;
mod even;
mod form;
mod mat;
#[cfg(feature = "parquet")]
mod parquet;
mod sampling;
mod text;
mod uff;
mod unit;
mod wav;

use std::collections::{HashMap, HashSet};
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

use crate::table::Table;
use bytes::Bytes;

pub use error::{Problem, RecordError};
pub(crate) use even::{at_even_times, between, bridge, on_line};
pub use form::Form;
pub(crate) use sampling::Gaps;
pub use sampling::Sampling;
pub(crate) use unit::in_brackets;

/// Most channels of a file.
const MOST_CHANNELS: usize = 4096;

/// What a file holds.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// How the file is written.
    pub form: Form,
    /// Its channels, with names of which no two are equal.
    pub channels: Vec<RecordChannel>,
    /// Numbers that stand alone in the file, with their names: `X112RPM`, `bearing.sr`.
    pub numbers: Vec<(String, f64)>,
    /// Texts in the file, with their names.
    pub texts: Vec<(String, String)>,
    /// What was left out and why, and what is doubtful.
    pub warnings: Vec<String>,
}

/// A channel of a record.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RecordChannel {
    /// Its name in the file; `column1` or `channel1` where there is none.
    pub name: String,
    /// Its samples as in the file, NaN where one is missing; integers of a WAV file as fractions of full scale.
    pub samples: Vec<f64>,
    /// When they were taken.
    pub sampling: Sampling,
    /// What is measured, if the file says it: `acceleration`, `x_velocity`.
    pub quantity: Option<String>,
    /// Its unit as it is written: `m/s^2`, `µm`.
    pub unit: Option<String>,
    /// The number of the node at which the sensor sits.
    pub node: Option<i64>,
    /// The direction in which it measures: `+x`, `-rz`.
    pub direction: Option<String>,
}

impl RecordChannel {
    /// A channel of which nothing else is known.
    fn new(name: String, samples: Vec<f64>) -> Self {
        Self {
            name,
            samples,
            ..Self::default()
        }
    }
}

impl Record {
    /// Reads a file.
    ///
    /// # Errors
    /// The file cannot be opened, is of no known form, or is broken, and where.
    pub fn open(path: &Path) -> Result<Self, RecordError> {
        let opened = open_regular(path, u64::MAX).and_then(|file| {
            let length = file.metadata()?.len();
            Ok((file, length))
        });
        let read = opened.map_err(Problem::Read);
        let read = read.and_then(|(file, length)| Self::read(file, length, path));
        let name = path.display().to_string();
        read.map_err(|problem| RecordError { name, problem })
    }

    /// Reads bytes as the file of this name.
    ///
    /// # Errors
    /// The bytes are of no known form, or broken, and where.
    pub fn from_bytes(bytes: &[u8], name: &str) -> Result<Self, RecordError> {
        let read = Self::read(bytes, bytes.len() as u64, Path::new(name));
        let name = name.to_owned();
        read.map_err(|problem| RecordError { name, problem })
    }

    /// Columns that are in memory, with their names, which say what those of a file say: units, and which of them are times.
    ///
    /// # Errors
    /// No column holds a sample.
    pub fn from_columns(
        columns: impl IntoIterator<Item = (String, Vec<f64>)>,
        name: &str,
    ) -> Result<Self, RecordError> {
        let mut record = Self::new(Form::Memory);
        let added = text::add_named(&mut record, columns.into_iter().collect());
        match added.and_then(|()| record.check()) {
            Ok(()) => Ok(record),
            Err(problem) => Err(RecordError {
                name: name.to_owned(),
                problem,
            }),
        }
    }

    /// Of a form, with nothing in it.
    fn new(form: Form) -> Self {
        Self {
            form,
            channels: Vec::new(),
            numbers: Vec::new(),
            texts: Vec::new(),
            warnings: Vec::new(),
        }
    }

    fn read(mut file: impl Read, length: u64, path: &Path) -> Result<Self, Problem> {
        let mut head = Vec::new();
        (&mut file).take(form::HEAD).read_to_end(&mut head)?;
        let mut record = Self::new(Form::recognise(&head, path)?);
        let bytes = Bytes::new(head.chain(file), length);
        match record.form {
            Form::Text => text::read(&mut record, &head, bytes),
            Form::Wav => wav::read(&mut record, bytes),
            Form::Mat => mat::read(&mut record, bytes),
            Form::Universal => uff::read(&mut record, bytes),
            Form::Memory => Ok(()),
            #[cfg(feature = "parquet")]
            Form::Parquet => parquet::read(&mut record, bytes),
        }?;
        record.check()?;
        Ok(record)
    }

    /// Makes names unique, and tells where times do not rise.
    fn check(&mut self) -> Result<(), Problem> {
        if self
            .channels
            .iter()
            .all(|channel| channel.samples.is_empty())
        {
            let mut why = vec!["it has no channel of samples".to_owned()];
            why.append(&mut self.warnings);
            return Err(Problem::Unfit(why.join("; ")));
        }
        let mut unordered = Vec::new();
        let names = self.channels.iter().map(|channel| channel.name.clone());
        let mut taken: HashSet<String> = names.collect();
        let mut known = HashMap::new();
        for channel in &mut self.channels {
            let count = known.entry(channel.name.clone()).or_insert(0);
            *count += 1;
            if *count > 1 {
                let number = |count: usize| format!("{}#{count}", channel.name);
                while !taken.insert(number(*count)) {
                    *count += 1;
                }
                channel.name = number(*count);
            }
            if let Sampling::Unordered(row) = channel.sampling
                && !unordered.contains(&row)
            {
                unordered.push(row);
                let name = &channel.name;
                let text =
                    format!("the times of `{name}` do not rise at row {row}: its rate is unknown");
                self.warnings.push(text);
            }
        }
        Ok(())
    }

    /// What is to be reported of samples that are missing.
    pub fn missing(&self) -> Vec<String> {
        let reported = |channel: &RecordChannel| {
            let missing = channel.samples.iter().filter(|it| !it.is_finite());
            let (missing, name) = (missing.count(), &channel.name);
            let text = format!("of the samples of `{name}`, {missing} are missing or infinite");
            (missing > 0).then_some(text)
        };
        self.channels.iter().filter_map(reported).collect()
    }

    /// A channel by its name.
    pub fn channel(&self, name: &str) -> Option<&RecordChannel> {
        self.channels.iter().find(|channel| channel.name == name)
    }

    /// The channels as a table: name, number of samples, rate and duration where the file says when they were taken, quantity,
    /// unit, and place with direction.
    pub fn list(&self) -> Table<'static> {
        let word = |text: &Option<String>| text.clone().unwrap_or_default();
        Table::from_items(&self.channels)
            .word("channel", |it| &it.name)
            .count("samples", |it| it.samples.len() as f64)
            .number("rate", "Hz", |it| it.sampling.rate())
            .number("duration", "s", |it| it.sampling.duration(it.samples.len()))
            .word("quantity", |it| word(&it.quantity))
            .word("unit", |it| word(&it.unit))
            .word("place", |it| match it.node {
                Some(node) => format!("{node} {}", word(&it.direction)),
                None => word(&it.direction),
            })
            .end()
    }

    /// Adds a warning.
    fn warn(&mut self, what: impl Into<String>) {
        self.warnings.push(what.into());
    }

    /// Adds a channel, of which there may not be too many.
    fn add(&mut self, channel: RecordChannel) -> Result<(), Problem> {
        if self.channels.len() == MOST_CHANNELS {
            return Err(too_many());
        }
        self.channels.push(channel);
        Ok(())
    }
}

fn too_many() -> Problem {
    let what = format!("it has more than {MOST_CHANNELS} channels; are its samples in rows?");
    Problem::Unfit(what)
}

/// Opens a file of at most so many bytes that ends: no device, pipe or folder.
pub(crate) fn open_regular(path: &Path, most: u64) -> io::Result<File> {
    let known = fs::metadata(path)?;
    if !known.is_file() {
        return Err(io::Error::other("it is not a regular file"));
    }
    if known.len() > most {
        let (has, most) = (known.len() >> 20, most >> 20);
        let message = format!("it has {has} MB, and {most} MB are the most");
        return Err(io::Error::other(message));
    }
    File::open(path)
}
