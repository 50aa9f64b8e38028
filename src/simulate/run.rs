//! The answer: everything about a run, and its samples where they are kept.

use std::collections::VecDeque;
use std::io;
use std::sync::atomic::AtomicBool;

use serde::Serialize;

use super::{
    BearingHistory, EnergyReport, Event, Maps, Model, Monitor, RunUp, SimulateError, SpallPassage,
    TableUse, TraceSink, VibrationSeverity, sampling, simulate,
};
use crate::analysis::{
    Channel, ChannelSpectrum, EstimateError, EstimatedSpectrum, Motion, Peak, Spectrum,
    SpectrumRequest, estimate,
};
use crate::bearing::BearingState;
use crate::integrate::{Counters, MethodUse};
use crate::keys;
use crate::physics::BallPass;
use crate::rotor::{BallContacts, FREEDOMS, NaturalFrequency, Rotor, Sample};

/// The static equilibrium that the run starts from, or is linearised about.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct StaticState {
    /// x, y, z in m and θx, θy in rad.
    #[serde(rename = "equilibrium", serialize_with = "keys::displacement")]
    pub displacement: [f64; FREEDOMS],
    /// ∂F/∂q of all bearings, rows and columns x, y, z, θx, θy.
    #[serde(serialize_with = "keys::rows")]
    pub stiffness: [[f64; FREEDOMS]; FREEDOMS],
    /// ∂F/∂q̇ of all that damps the shaft but the contacts, as the stiffness.
    #[serde(skip)]
    pub damping: [[f64; FREEDOMS]; FREEDOMS],
    /// Largest unbalanced force of the active freedoms relative to the load.
    pub residual: f64,
    /// Newton steps taken.
    pub newton_steps: usize,
    /// Natural frequencies, lowest first.
    pub natural_frequencies: Vec<NaturalFrequency>,
    /// Every bearing there, ball by ball, its cage where it starts; none of a linear one.
    #[serde(skip)]
    pub bearings: Vec<Option<BearingState>>,
}

/// Difference of the run from a second pass at a tenth of its tolerance, with the round-off that both share.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct MeasuredError {
    /// Largest difference of a displacement (tilts times their arm), and the round-off of one, m.
    #[serde(rename = "displacement_m")]
    pub displacement: f64,
    /// That difference relative to the motion recorded after the settle time: the largest distance of a displacement of the
    /// shaft from its mean, or the smallest motion that the tolerance resolves above round-off.
    pub relative: f64,
    /// Tolerance of the second pass.
    pub reference_tolerance: f64,
    /// Work of the second pass.
    #[serde(rename = "reference_counters")]
    pub counters: Counters,
}

/// An error of the reduction of a shaft that bends above this part of the motion is worth a warning.
const REDUCTION: f64 = 1e-2;

/// What is kept of a shaft that bends.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Reduction {
    /// Modes of bending between the points where something acts, in each plane.
    pub modes: usize,
    /// Degrees of freedom of shaft and housings together.
    pub degrees_of_freedom: usize,
    /// Its error, where the motion is verified.
    pub error: Option<ReductionError>,
}

impl Reduction {
    /// What to say of an error that is large beside the motion.
    pub(crate) fn warning(&self) -> Option<String> {
        let error = self.error.filter(|error| error.relative > REDUCTION)?;
        Some(format!(
            "with {} modes of bending in each plane the motion differs by {:.1e} of it: raise `modes` in [shaft]",
            error.modes, error.relative
        ))
    }
}

/// Difference of the motion from one with more modes of the shaft.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ReductionError {
    /// Largest difference of a displacement of the observed point (tilts times their arm), m.
    #[serde(rename = "displacement_m")]
    pub displacement: f64,
    /// That difference relative to the motion, as [`MeasuredError::relative`].
    pub relative: f64,
    /// Modes of the other motion in each plane.
    pub modes: usize,
}

impl MeasuredError {
    /// Share of the second pass in the evaluations of both.
    pub(crate) fn share_of_evaluations(&self, main: &Counters) -> f64 {
        let (own, main) = (self.counters.evaluations as f64, main.evaluations as f64);
        own / (own + main).max(1.0)
    }
}

/// Everything that a run answers, except the trace itself, which went to the sink.
///
/// It serialises with the keys of `summary.json`: lives, load zones, spalls and the zone of the vibration severity are
/// found there.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Run {
    /// Static equilibrium.
    #[serde(flatten)]
    pub equilibrium: StaticState,
    /// Ball-pass frequencies of each bearing, in the order of the scenario, at the speed after the
    /// settle time; at the highest speed where it changes there. Their lines are there in the simulation: its cages keep
    /// the ratio to the speed that the static equilibrium at t = 0 gives them.
    pub ball_pass: Vec<BallPass>,
    /// Ball-pass frequencies at the nominal contact angles without slip, as handbooks print them.
    pub nominal_ball_pass: Vec<BallPass>,
    /// Work done.
    pub counters: Counters,
    /// Which methods did it, where the choice was left open.
    #[serde(skip)]
    pub(crate) method_use: Option<MethodUse>,
    /// Size of the motion that was assumed before the run and found far too large, and the one that the run was started anew
    /// with, m.
    #[serde(skip)]
    pub(crate) corrected_scale: Option<[f64; 2]>,
    /// Number of samples written.
    pub samples: u64,
    /// What was observed of each bearing, in the order of the scenario.
    pub bearings: Vec<BearingHistory>,
    /// Largest load on a ball of any bearing after the settle time, N; none where no ball is observed.
    #[serde(rename = "largest_ball_load_N")]
    pub largest_ball_load: Option<f64>,
    /// Tables of the ball laws of each bearing, in the order of the scenario, where asked for.
    pub(crate) tables: Vec<Option<TableUse>>,
    /// Measured error, where asked for.
    #[serde(skip)]
    pub measured_error: Option<MeasuredError>,
    /// What is kept of a shaft that bends.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reduction: Option<Reduction>,
    /// Account of the energy, where asked for.
    pub energy: Option<EnergyReport>,
    /// Spectra, where asked for.
    #[serde(skip)]
    pub spectrum: Option<Spectrum>,
    /// Peaks of the spectra with their names.
    #[serde(skip)]
    pub peaks: Vec<Peak>,
    /// What the motion after the settle time is like, where asked for and at constant speed.
    #[serde(skip)]
    pub motion: Option<Motion>,
    /// Zone of ISO 20816-3, where the motion is known and the machine is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) vibration_severity: Option<VibrationSeverity>,
    /// The largest motion, where the speed changes.
    #[serde(skip)]
    pub run_up: Option<RunUp>,
    /// Waterfall and order tracks, where asked for.
    #[serde(skip)]
    pub maps: Option<Maps>,
    /// Spectra that were asked for besides, as far as the run was long enough; a warning names the
    /// others.
    #[serde(skip)]
    pub spectra: Vec<EstimatedSpectrum>,
    /// Spalls of the races with the time between entry and impact, where the speed is constant.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) spalls: Vec<SpallPassage>,
    /// What the reader of the results should know, each with its numbers.
    pub warnings: Vec<String>,
}

impl StaticState {
    /// What a rotor found before it moved.
    pub(crate) fn from_rotor(rotor: &Rotor) -> Self {
        let equilibrium = rotor.equilibrium();
        Self {
            displacement: equilibrium.displacement,
            stiffness: equilibrium.stiffness.transpose().into(),
            damping: rotor.damping_matrix(),
            residual: equilibrium.residual,
            newton_steps: equilibrium.newton_steps,
            natural_frequencies: rotor.natural_frequencies(),
            bearings: rotor
                .supports()
                .zip(rotor.bearing_states(rotor.speed()))
                .map(|(support, state)| (support.known_balls() > 0).then_some(state))
                .collect(),
        }
    }
}

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
        let values = self.samples.iter().map(|sample| channel.of(sample));
        Ok(values.map(|value| value.unwrap_or(f64::NAN)).collect())
    }

    /// Amplitudes and phases of a displacement or a force by its name, as `x` or `force_y`; none where the scene
    /// asks for no spectrum, the run was too short for one, or it has none of this column. Bin k is at k times
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
