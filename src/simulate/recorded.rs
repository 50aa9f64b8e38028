//! A run together with its samples.

use std::io;
use std::sync::atomic::AtomicBool;

use super::{MeasuredError, Model, Monitor, Run, SimulateError, TraceSink, simulate};
use crate::analysis::{Channel, ChannelSpectrum};
use crate::rotor::Sample;

/// A run together with its samples, all of them in memory.
///
/// Whoever wants the samples as they come, to stop a run or to follow its progress, calls [`simulate`] with a
/// [`TraceSink`] and a [`Monitor`].
#[derive(Debug, Clone, PartialEq)]
pub struct RecordedRun {
    /// Everything but the samples.
    pub run: Run,
    /// The samples, in the order of time.
    pub samples: Vec<Sample>,
}

/// A name that is that of no column.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("no column is called `{name}`; the columns are {}", known.join(", "))]
pub struct UnknownColumn {
    /// The name as given.
    pub name: String,
    /// All names.
    pub known: Vec<&'static str>,
}

impl RecordedRun {
    /// Runs a model from its start to its end and keeps all samples.
    ///
    /// # Errors
    /// [`SimulateError`].
    pub(crate) fn of(model: &Model) -> Result<Self, SimulateError> {
        let mut samples = Samples(Vec::new());
        let stop = AtomicBool::new(false);
        let mut monitor = Monitor {
            stop: &stop,
            progress: &mut |_part| {},
        };
        let run = simulate(model, &mut samples, &mut monitor)?;
        let Samples(samples) = samples;
        Ok(Self { run, samples })
    }

    /// A column of the samples by its name in the files without the unit, SI units: `t`, `x`, `tilt_x`,
    /// `x_velocity`, `force_x`, `largest_ball_load` …; NaN where a value was not observed.
    ///
    /// # Errors
    /// [`UnknownColumn`] where no column is called so.
    pub fn column(&self, name: &str) -> Result<Vec<f64>, UnknownColumn> {
        let channel = named(name)?;
        let values = self.samples.iter().map(|sample| channel.of(sample));
        Ok(values.map(|value| value.unwrap_or(f64::NAN)).collect())
    }

    /// Amplitudes and phases of a displacement or a force by its name, as `x` or `force_y`; none where the scene
    /// asks for no spectrum, the run was too short for one, or it has none of this column. Bin k stands at k times
    /// the `resolution` of [`Run::spectrum`].
    pub fn spectrum(&self, name: &str) -> Option<&ChannelSpectrum> {
        self.run.spectrum.as_ref()?.channel(named(name).ok()?)
    }

    /// Difference from a second pass at a tenth of the tolerance; none where the scene asks for no such pass, or it
    /// failed, as a warning then says.
    pub fn error(&self) -> Option<&MeasuredError> {
        self.run.measured_error.as_ref()
    }
}

fn named(name: &str) -> Result<Channel, UnknownColumn> {
    let found = Channel::all().find(|channel| channel.name() == name);
    found.ok_or_else(|| UnknownColumn {
        name: name.to_owned(),
        known: Channel::all().map(Channel::name).collect(),
    })
}

/// Keeps all samples.
struct Samples(Vec<Sample>);

impl TraceSink for Samples {
    fn needs_acceleration(&self) -> bool {
        true
    }

    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        self.0.push(*sample);
        Ok(())
    }
}
