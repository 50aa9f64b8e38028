//! The stair: a [`Model`] goes in, a [`Run`] comes out. No files, no clock, no printing.

use std::sync::atomic::AtomicBool;

use nalgebra::Const;

use crate::analysis::{Analysis, Peak, Recorder, Spectrum, Window, causes};
use crate::integrate::{Counters, Grid, IntegrateError, Integration, Scaling, Settings, Square};
use crate::physics::BallPass;
use crate::rotor::{
    FREEDOMS, MotionScale, NaturalFrequency, Rotor, RotorDefinition, RotorError, Sample,
};

/// How often the motion is sampled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sampling {
    /// Samples per shaft revolution, at the highest speed where it varies: the grid is uniform in
    /// time, and at constant speed in shaft angle.
    PerRevolution(u32),
    /// Samples per second.
    Rate(f64),
}

/// A complete, checked question: what to simulate, how exactly, and what to keep.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    /// Shaft, bearings, loads, speed and start.
    pub rotor: RotorDefinition,
    /// Simulated time, s.
    pub duration: f64,
    /// Time at the start that the spectra leave out, s.
    pub settle: f64,
    /// Sampling of trace and spectra.
    pub sampling: Sampling,
    /// Method and tolerance.
    pub integrator: Settings,
    /// Whether a second, tighter pass measures the error of the first.
    pub verify: bool,
    /// Window of the spectra; `None` leaves the spectra out, and memory is flat in the duration.
    pub spectrum: Option<Window>,
}

/// The static equilibrium that the run starts from, or is linearised about.
#[derive(Debug, Clone, PartialEq)]
pub struct StaticState {
    /// x, y, z in m and θx, θy in rad.
    pub displacement: [f64; FREEDOMS],
    /// ∂F/∂q of all bearings, rows and columns x, y, z, θx, θy.
    pub stiffness: [[f64; FREEDOMS]; FREEDOMS],
    /// Largest unbalanced force of the kept freedoms relative to the load.
    pub residual: f64,
    /// Newton steps taken.
    pub newton_steps: usize,
    /// Natural frequencies, lowest first.
    pub natural_frequencies: Vec<NaturalFrequency>,
}

/// Difference of the run from a second pass at a tenth of its tolerance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeasuredError {
    /// Largest difference of a displacement (tilts times their arm), m.
    pub displacement: f64,
    /// The same relative to the motion: the largest excursion from the static equilibrium, or the
    /// smallest motion that the tolerance resolves above round-off.
    pub relative: f64,
    /// Tolerance of the second pass.
    pub reference_tolerance: f64,
    /// Work of the second pass.
    pub counters: Counters,
}

/// Everything that a run answers, except the trace itself, which went to the sink.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Static equilibrium.
    pub equilibrium: StaticState,
    /// Ball-pass frequencies of each bearing, in the order of the scenario, at the speed after the
    /// settle time; at the highest speed where it changes there.
    pub ball_pass: Vec<BallPass>,
    /// Work done.
    pub counters: Counters,
    /// Number of samples written.
    pub samples: u64,
    /// Measured error, where asked for.
    pub measured_error: Option<MeasuredError>,
    /// Spectra, where asked for.
    pub spectrum: Option<Spectrum>,
    /// Peaks of the spectra with their names.
    pub peaks: Vec<Peak>,
    /// What the reader of the results should know, each with its numbers.
    pub warnings: Vec<String>,
}

/// Takes the samples of a run one by one, in the order of time.
pub trait TraceSink {
    /// Takes one sample.
    ///
    /// # Errors
    /// Whatever keeps the sink from taking it; the run ends there.
    fn sample(&mut self, sample: &Sample) -> std::io::Result<()>;
}

/// How a run is watched and stopped from outside.
pub struct Monitor<'a> {
    /// Set to end the run at its next step.
    pub stop: &'a AtomicBool,
    /// Called now and then with the part of the run that is done, 0 … 1.
    pub progress: &'a mut dyn FnMut(f64),
}

/// Why a run failed.
#[derive(Debug, thiserror::Error)]
pub enum SimulateError {
    /// The rotor cannot be assembled.
    #[error(transparent)]
    Rotor(#[from] RotorError),
    /// The integration cannot go on.
    #[error(transparent)]
    Integrate(#[from] IntegrateError),
    /// The sink refused a sample.
    #[error("the trace cannot be written: {0}")]
    Sink(#[from] std::io::Error),
    /// No uniform grid of angle exists for a shaft that stands.
    #[error("the shaft does not turn: give samples per second instead of samples per revolution")]
    NoRevolution,
}

/// Samples that are integrated, checked and written at a time.
const BLOCK: usize = 1024;

/// Runs a model: every sample goes to `sink`, everything else is returned.
///
/// # Errors
/// [`SimulateError`]; the samples before the failure have gone to the sink.
pub fn simulate(
    model: &Model,
    sink: &mut dyn TraceSink,
    monitor: &mut Monitor<'_>,
) -> Result<Run, SimulateError> {
    let rotor = Rotor::assemble(&model.rotor)?;
    // N states of the kept freedoms, and M = N + 1 with the time
    match rotor.kept() {
        2 => run::<4, 5>(model, &rotor, sink, monitor),
        3 => run::<6, 7>(model, &rotor, sink, monitor),
        _ => run::<10, 11>(model, &rotor, sink, monitor),
    }
}

fn run<const N: usize, const M: usize>(
    model: &Model,
    rotor: &Rotor,
    sink: &mut dyn TraceSink,
    monitor: &mut Monitor<'_>,
) -> Result<Run, SimulateError>
where
    Const<N>: Square,
{
    let scale = rotor.motion_scale(reference_settings(model).tolerance);
    let grid = grid(model, rotor)?;
    let mut recorder = model.spectrum.map(|_| recorder(model, rotor));
    let start = |settings| {
        let (scaling, state) = (scaling(rotor, &scale), initial_state(rotor));
        Integration::<_, N, M>::new(rotor, scaling, grid, settings, monitor.stop, &state)
    };
    let mut main = start(model.integrator);
    let mut reference = model
        .verify
        .then(|| Reference::new(start(reference_settings(model))));
    let mut states = Vec::with_capacity(BLOCK);
    while main.done() < grid.count {
        let first = main.done();
        states.clear();
        let result = main.advance(BLOCK, &mut states);
        if let Some(reference) = &mut reference {
            reference.compare(&states, rotor, &scale);
        }
        for (index, state) in states.iter().enumerate() {
            let sample = rotor.sample(grid.time(first + index as u64), state);
            sink.sample(&sample)?;
            if let Some(recorder) = &mut recorder {
                recorder.record(&sample);
            }
        }
        result?;
        (monitor.progress)(main.done() as f64 / grid.count as f64);
    }
    let measured_error = reference.and_then(|reference| reference.measured(model, &scale));
    let analysis = recorder.zip(model.spectrum).and_then(|(recorder, window)| {
        let natural: Vec<f64> = rotor
            .natural_frequencies()
            .iter()
            .map(|mode| mode.frequency)
            .collect();
        recorder.finish(
            window,
            &causes(
                shaft_frequency(model, rotor),
                &spectral_ball_pass(model, rotor),
                &natural,
            ),
        )
    });
    let (spectrum, peaks) = match analysis {
        Some(Analysis { spectrum, peaks }) => (Some(spectrum), peaks),
        None => (None, Vec::new()),
    };
    Ok(Run {
        equilibrium: static_state(rotor),
        ball_pass: ball_pass(rotor, reported_speed(model, rotor)),
        counters: main.counters(),
        samples: grid.count,
        warnings: warnings(model, rotor, measured_error.as_ref()),
        measured_error,
        spectrum,
        peaks,
    })
}

/// The sample times: the first at 0, the last not after the duration.
fn grid(model: &Model, rotor: &Rotor) -> Result<Grid, SimulateError> {
    let highest = rotor.speed_profile().highest();
    let interval = match model.sampling {
        Sampling::Rate(rate) => 1.0 / rate,
        Sampling::PerRevolution(_) if highest == 0.0 => {
            return Err(SimulateError::NoRevolution);
        }
        Sampling::PerRevolution(samples) => std::f64::consts::TAU / (highest * f64::from(samples)),
    };
    // a duration of whole intervals keeps its last sample in spite of round-off
    let intervals = (model.duration / interval * (1.0 + 4.0 * f64::EPSILON)).floor();
    Ok(Grid {
        interval,
        count: intervals as u64 + 1,
    })
}

/// On a grid of shaft angle where the speed is steady after the settle time at its highest, and so
/// makes a whole number of samples a revolution; else on a free grid of time.
fn recorder(model: &Model, rotor: &Rotor) -> Recorder {
    let (kept, shaft) = (rotor.kept(), shaft_frequency(model, rotor));
    let highest = rotor.speed_profile().highest() / std::f64::consts::TAU;
    match model.sampling {
        Sampling::PerRevolution(samples) if shaft == highest => {
            Recorder::on_angle_grid(kept, model.settle, shaft, samples)
        }
        Sampling::PerRevolution(samples) => {
            let rate = highest * f64::from(samples);
            Recorder::on_time_grid(kept, model.settle, shaft, rate)
        }
        Sampling::Rate(rate) => Recorder::on_time_grid(kept, model.settle, shaft, rate),
    }
}

/// Frequency of the shaft in the spectra, Hz; zero where it changes after the settle time.
fn shaft_frequency(model: &Model, rotor: &Rotor) -> f64 {
    let steady = rotor.speed_profile().steady_from(model.settle);
    steady.unwrap_or(0.0) / std::f64::consts::TAU
}

/// The speed of the spectra; the highest one where it changes after the settle time, rad/s.
fn reported_speed(model: &Model, rotor: &Rotor) -> f64 {
    let profile = rotor.speed_profile();
    let steady = profile.steady_from(model.settle);
    steady.unwrap_or_else(|| profile.highest())
}

fn ball_pass(rotor: &Rotor, speed: f64) -> Vec<BallPass> {
    let supports = rotor.supports().iter();
    supports.map(|support| support.ball_pass(speed)).collect()
}

/// Ball passes that make lines: none where the speed changes.
fn spectral_ball_pass(model: &Model, rotor: &Rotor) -> Vec<BallPass> {
    let steady = rotor.speed_profile().steady_from(model.settle);
    steady.map_or_else(Vec::new, |speed| ball_pass(rotor, speed))
}

fn scaling<const N: usize>(rotor: &Rotor, scale: &MotionScale) -> Scaling<N> {
    let place = &rotor.equilibrium().displacement;
    Scaling {
        origin: std::array::from_fn(|index| if index < N / 2 { place[index] } else { 0.0 }),
        scale: rotor.state_scale(scale),
        time: 1.0 / scale.frequency,
    }
}

fn initial_state<const N: usize>(rotor: &Rotor) -> [f64; N] {
    let [displacement, velocity] = rotor.initial_state();
    std::array::from_fn(|index| {
        if index < N / 2 {
            displacement[index]
        } else {
            velocity[index - N / 2]
        }
    })
}

fn static_state(rotor: &Rotor) -> StaticState {
    let equilibrium = rotor.equilibrium();
    let stiffness = &equilibrium.stiffness;
    StaticState {
        displacement: equilibrium.displacement,
        stiffness: std::array::from_fn(|row| {
            std::array::from_fn(|column| stiffness[(row, column)])
        }),
        residual: equilibrium.residual,
        newton_steps: equilibrium.newton_steps,
        natural_frequencies: rotor.natural_frequencies(),
    }
}

/// Factor between the tolerances of the two passes.
const REFERENCE_FACTOR: f64 = 0.1;
/// Below this tolerance the second pass is the looser one: round-off allows none that is tighter.
const TIGHTEST_WITH_REFERENCE: f64 = 1e-12;

fn reference_settings(model: &Model) -> Settings {
    let tolerance = model.integrator.tolerance;
    let factor = if tolerance >= TIGHTEST_WITH_REFERENCE {
        REFERENCE_FACTOR
    } else {
        1.0 / REFERENCE_FACTOR
    };
    Settings {
        tolerance: tolerance * factor,
        ..model.integrator
    }
}

/// The second pass, and how far the first is from it.
struct Reference<'a, const N: usize, const M: usize> {
    integration: Integration<'a, Rotor, N, M>,
    states: Vec<[f64; N]>,
    difference: f64,
    excursion: f64,
    failed: bool,
}

impl<'a, const N: usize, const M: usize> Reference<'a, N, M>
where
    Const<N>: Square,
{
    fn new(integration: Integration<'a, Rotor, N, M>) -> Self {
        Self {
            integration,
            states: Vec::new(),
            difference: 0.0,
            excursion: 0.0,
            failed: false,
        }
    }

    /// Goes on over as many samples as `states` has and compares displacements.
    fn compare(&mut self, states: &[[f64; N]], rotor: &Rotor, scale: &MotionScale) {
        if self.failed {
            return;
        }
        self.states.clear();
        self.failed = self
            .integration
            .advance(states.len(), &mut self.states)
            .is_err();
        let place = &rotor.equilibrium().displacement;
        for (state, reference) in states.iter().zip(&self.states) {
            for axis in 0..N / 2 {
                let lever = scale.lever(axis);
                self.difference = self
                    .difference
                    .max(lever * (state[axis] - reference[axis]).abs());
                self.excursion = self
                    .excursion
                    .max(lever * (reference[axis] - place[axis]).abs());
            }
        }
    }

    fn measured(&self, model: &Model, scale: &MotionScale) -> Option<MeasuredError> {
        let relative = self.difference / self.excursion.max(scale.length);
        (!self.failed).then(|| MeasuredError {
            displacement: self.difference,
            relative,
            reference_tolerance: reference_settings(model).tolerance,
            counters: self.integration.counters(),
        })
    }
}

/// A measured error above this many tolerances is worth a warning.
const PROMISE: f64 = 10.0;

fn warnings(model: &Model, rotor: &Rotor, error: Option<&MeasuredError>) -> Vec<String> {
    let mut warnings = Vec::new();
    let profile = rotor.speed_profile();
    if model.spectrum.is_some() && profile.steady_from(model.settle).is_none() {
        warnings.push(format!(
            "the speed changes after the settle time of {} s: lines of shaft and bearings smear in \
             the spectra, which have no orders, and no peak is named after them; ball-pass \
             frequencies are those at the highest speed, {} rad/s",
            model.settle,
            profile.highest()
        ));
    }
    let tolerance = model.integrator.tolerance;
    match error {
        Some(error) if error.relative > PROMISE * tolerance => warnings.push(format!(
            "the measured error is {:.1e} of the motion, more than {PROMISE} × the tolerance \
             {tolerance:.0e}: the motion may be irregular or rest on contact changes; trust \
             statistics rather than the single trace",
            error.relative
        )),
        None if model.verify => warnings.push(
            "the second pass that measures the error failed; the error of this run is unknown"
                .to_owned(),
        ),
        _ => {}
    }
    warnings
}
