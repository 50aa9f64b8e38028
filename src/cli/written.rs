//! What of a run is written: asked for on the command line instead of in the scenario.

use std::num::NonZeroU64;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use serde::de::DeserializeOwned;
use serde_json::json;

use crate::analysis::Channel;
use crate::numerics::distinct::each_once;
use crate::rotor::RotorDefinition;
use crate::scenario::{Scenario, TableFormat};

/// What of a run is written.
#[derive(Debug, clap::Args)]
pub struct Written {
    /// Formats of the tables, instead of `[output] formats`
    #[arg(long = "format", value_name = "FORMAT", value_delimiter = ',', value_parser = format_parser())]
    formats: Vec<TableFormat>,
    /// Write the first of every N samples, instead of `[output] every`; spectra rest on all
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(NonZeroU64))]
    every: Option<NonZeroU64>,
    /// What the written trace shows besides the time, instead of `[output] channels`: columns without their unit, as x,
    /// tilt_y_velocity, z_acceleration, force_y, moment_x, housing1_x, bearing2_force_y, balls_loaded, speed
    #[arg(long, value_name = "NAME", value_delimiter = ',', value_parser = channel_parser(), hide_possible_values = true)]
    channels: Vec<Channel>,
}

fn format_parser() -> impl TypedValueParser<Value = TableFormat> {
    let built = TableFormat::ALL.into_iter().filter(|one| one.is_built());
    named(built.map(|format| format.extension().into()))
}

fn channel_parser() -> impl TypedValueParser<Value = Channel> {
    let names = Channel::selectable().map(|channel| {
        // the help shows what the first bearing has
        PossibleValue::new(channel.name()).hide(channel.is_further())
    });
    named(names)
}

/// Parses one of some names, as a scenario has them.
fn named<T: DeserializeOwned + Clone + Send + Sync + 'static>(
    names: impl Iterator<Item = PossibleValue>,
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(names.collect::<Vec<_>>())
        .try_map(|word| serde_json::from_value(word.into()))
}

impl Written {
    /// Refuses columns that a shaft does not have.
    ///
    /// # Errors
    /// Which, and why.
    pub fn check(&self, rotor: &RotorDefinition) -> Result<(), String> {
        let mut missing = self.channels.iter().filter_map(|one| one.missing_of(rotor));
        missing.next().map_or(Ok(()), |words| Err(words.join("; ")))
    }

    /// Puts what is asked for in place of what the scenario says, also in what the summary tells.
    pub fn apply(&self, scenario: &mut Scenario) {
        let (output, echo) = (&mut scenario.output, &mut scenario.echo["output"]);
        if !self.formats.is_empty() {
            output.formats = each_once(self.formats.iter().copied());
            echo["formats"] = json!(output.formats);
        }
        if let Some(every) = self.every {
            output.every = Some(every);
            echo["every"] = json!(every);
        }
        if !self.channels.is_empty() {
            let channels = each_once(self.channels.iter().copied());
            echo["channels"] = json!(channels);
            output.channels = Some(channels);
        }
    }
}
