//! A run with its samples in memory.

use std::collections::VecDeque;
use std::io;
use std::sync::atomic::AtomicBool;

use super::{
    Event, MeasuredError, Model, Monitor, Run, SimulateError, TraceSink, sampling, simulate,
};
use crate::analysis::{
    Channel, ChannelSpectrum, EstimateError, EstimatedSpectrum, SpectrumRequest, estimate,
};
use crate::rotor::{BallContacts, Rotor, Sample};

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
    /// The events, likewise.
    pub events: Vec<Event>,
    /// The balls of all bearings at every sample, where asked for.
    pub balls: Vec<BallContacts>,
    /// The balls of all bearings at the last samples, where not all of them were asked for.
    pub(crate) last_balls: VecDeque<BallContacts>,
}

/// Samples at the end of a run of which the balls are kept in any case: what pages show in motion.
pub(crate) const LAST_BALLS: usize = 2048;

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
    pub(crate) fn from_model(model: &Model) -> Result<Self, SimulateError> {
        let stop = AtomicBool::new(false);
        let mut monitor = Monitor {
            stop: &stop,
            progress: &mut |_part| {},
        };
        Self::watched(model, false, &mut monitor)
    }

    /// Runs a model under a monitor and keeps all samples, and with `balls` all balls.
    ///
    /// # Errors
    /// [`SimulateError`].
    pub(crate) fn watched(
        model: &Model,
        balls: bool,
        monitor: &mut Monitor<'_>,
    ) -> Result<Self, SimulateError> {
        let mut keeper = Keeper {
            balls: balls.then(Vec::new),
            ..Keeper::default()
        };
        let run = simulate(model, &mut keeper, monitor)?;
        Ok(Self {
            run,
            samples: keeper.samples,
            events: keeper.events,
            balls: keeper.balls.unwrap_or_default(),
            last_balls: keeper.last_balls,
        })
    }

    /// Gives everything to a sink as the run did.
    ///
    /// # Errors
    /// What the sink answers.
    pub(crate) fn replay(&self, sink: &mut dyn TraceSink) -> io::Result<()> {
        let mut events = self.events.iter().peekable();
        let known = self.balls.len() + self.last_balls.len();
        let without = self.samples.len().saturating_sub(known);
        let mut balls = self.balls.iter().chain(&self.last_balls);
        for (index, sample) in self.samples.iter().enumerate() {
            sink.sample(sample)?;
            if index >= without
                && let Some(balls) = balls.next()
            {
                sink.balls(sample, balls)?;
            }
            while let Some(event) = events.next_if(|event| event.time <= sample.time) {
                sink.event(event)?;
            }
        }
        events.try_for_each(|event| sink.event(event))
    }

    /// Spectra of the samples that the run, which was one of `model`, was not asked for.
    ///
    /// # Errors
    /// [`SimulateError`] where the shaft cannot be assembled.
    pub(crate) fn estimated(
        &self,
        model: &Model,
        spectra: Vec<SpectrumRequest>,
    ) -> Result<Vec<Result<EstimatedSpectrum, EstimateError>>, SimulateError> {
        let model = Model {
            spectrum: None,
            spectra,
            ..model.clone()
        };
        let rotor = Rotor::assemble(&model.rotor)?;
        let Some(mut recording) = sampling::recording(&model, &rotor) else {
            return Ok(Vec::new());
        };
        let samples = self.samples.iter();
        samples.for_each(|sample| recording.record(sample));
        let requests = model.spectra.iter();
        Ok(requests.map(|one| estimate(&recording, one)).collect())
    }

    /// A column of the samples by its name in the files without the unit, SI units: `t`, `x`, `tilt_x`,
    /// `x_velocity`, `force_x`, `largest_ball_load` …; NaN where a value was not observed.
    ///
    /// # Errors
    /// [`UnknownColumn`] where no column is called so.
    pub fn column(&self, name: &str) -> Result<Vec<f64>, UnknownColumn> {
        let channel = named(name)?;
        let values = self.samples.iter().map(|sample| channel.value(sample));
        Ok(values.map(|value| value.unwrap_or(f64::NAN)).collect())
    }

    /// Amplitudes and phases of a displacement or a force by its name, as `x` or `force_y`; none where the scene
    /// asks for no spectrum, the run was too short for one, or it has none of this column. Bin k is at k times
    /// the `resolution` of [`Run::spectrum`].
    pub fn spectrum(&self, name: &str) -> Option<&ChannelSpectrum> {
        self.run.spectrum.as_ref()?.channel(named(name).ok()?)
    }

    /// Difference from a second pass at a tenth of the tolerance, or at ten times one below 1e-12; none where the scene asks for no such pass, or it
    /// failed, as a warning then says.
    pub fn error(&self) -> Option<&MeasuredError> {
        self.run.measured_error.as_ref()
    }
}

fn named(name: &str) -> Result<Channel, UnknownColumn> {
    let found = Channel::all().find(|channel| channel.name() == name);
    found.ok_or_else(|| UnknownColumn {
        name: name.to_owned(),
        known: Channel::all()
            .filter(|channel| !channel.is_further())
            .map(Channel::name)
            .collect(),
    })
}

/// Keeps all samples, events and, where asked for, balls.
#[derive(Default)]
struct Keeper {
    samples: Vec<Sample>,
    events: Vec<Event>,
    balls: Option<Vec<BallContacts>>,
    last_balls: VecDeque<BallContacts>,
}

impl TraceSink for Keeper {
    fn needs_acceleration(&self) -> bool {
        true
    }

    fn needs_contact_angles(&self) -> bool {
        self.balls.is_some()
    }

    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        self.samples.push(sample.clone());
        Ok(())
    }

    fn balls(&mut self, _sample: &Sample, balls: &BallContacts) -> io::Result<()> {
        match &mut self.balls {
            Some(kept) => kept.push(balls.clone()),
            None if self.last_balls.len() < LAST_BALLS => self.last_balls.push_back(balls.clone()),
            None => {
                if let Some(mut room) = self.last_balls.pop_front() {
                    room.clone_from(balls);
                    self.last_balls.push_back(room);
                }
            }
        }
        Ok(())
    }

    fn event(&mut self, event: &Event) -> io::Result<()> {
        self.events.push(*event);
        Ok(())
    }
}
