//! What of a run is written: asked for on the command line instead of in the scenario.

use std::fmt;
use std::num::NonZeroU64;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use serde_json::{Value, json};

use crate::scenario::{Scenario, TableFormat, TraceChannel};

/// What of a run is written.
#[derive(Debug, clap::Args)]
pub struct Written {
    /// Formats of the tables, instead of `[output] formats`
    #[arg(long = "format", value_name = "FORMAT", value_delimiter = ',', value_parser = format_parser())]
    formats: Vec<TableFormat>,
    /// Write the first of every N samples, instead of `[output] every`; spectra rest on all
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(NonZeroU64))]
    every: Option<NonZeroU64>,
    /// What the written trace shows beside the time, instead of `[output] channels`
    #[arg(long, value_name = "NAME", value_delimiter = ',', value_parser = channel_parser())]
    channels: Vec<TraceChannel>,
}

fn format_parser() -> impl TypedValueParser<Value = TableFormat> {
    let built = || {
        TableFormat::ALL
            .into_iter()
            .filter(|format| format.is_built())
    };
    let names = PossibleValuesParser::new(built().map(TableFormat::extension));
    named(names, built().collect(), TableFormat::extension)
}

fn channel_parser() -> impl TypedValueParser<Value = TraceChannel> {
    let names = PossibleValuesParser::new(TraceChannel::ALL.map(|(_, name)| name));
    let all = TraceChannel::ALL.map(|(channel, _)| channel);
    named(names, all.to_vec(), TraceChannel::name)
}

/// Parses the name of one of `all`.
fn named<T: Copy + Send + Sync + 'static>(
    names: PossibleValuesParser,
    all: Vec<T>,
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    names.try_map(move |word| {
        let mut all = all.iter().copied();
        all.find(|one| name(*one) == word)
            .ok_or_else(|| format!("{word:?} is not known"))
    })
}

impl Written {
    /// Puts what is asked for in place of what the scenario says, also in what the summary tells.
    pub fn apply(&self, scenario: &mut Scenario) {
        let (output, echo) = (&mut scenario.output, &mut scenario.echo["output"]);
        if !self.formats.is_empty() {
            output.formats = without_repeats(&self.formats);
            echo["formats"] = names(&output.formats, TableFormat::extension);
        }
        if let Some(every) = self.every {
            output.every = every;
            echo["every"] = json!(every);
        }
        if !self.channels.is_empty() {
            let channels = without_repeats(&self.channels);
            echo["channels"] = names(&channels, TraceChannel::name);
            output.channels = Some(channels);
        }
    }
}

fn names<T: Copy>(all: &[T], name: fn(T) -> &'static str) -> Value {
    all.iter().map(|one| name(*one)).collect()
}

fn without_repeats<T: Copy + PartialEq>(all: &[T]) -> Vec<T> {
    let mut kept = Vec::new();
    for one in all {
        if !kept.contains(one) {
            kept.push(*one);
        }
    }
    kept
}

impl fmt::Display for Written {
    /// The options as they are typed, each with a blank before it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list = |words: Vec<&str>| words.join(",");
        if !self.formats.is_empty() {
            let formats = self.formats.iter().map(|format| format.extension());
            write!(f, " --format {}", list(formats.collect()))?;
        }
        if let Some(every) = self.every {
            write!(f, " --every {every}")?;
        }
        if !self.channels.is_empty() {
            let channels = self.channels.iter().map(|channel| channel.name());
            write!(f, " --channels {}", list(channels.collect()))?;
        }
        Ok(())
    }
}
