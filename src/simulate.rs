//! The stair: a [`Model`] goes in, a [`Run`] comes out. No files, no clock, no printing.

use crate::analysis::{Peak, Spectrum, Window};
use crate::integrate::{Counters, Settings};
use crate::physics::BallPass;
use crate::rotor::{FREEDOMS, NaturalFrequency, RotorDefinition, Sample};

/// How often the motion is sampled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sampling {
    /// Samples per shaft revolution: the grid is uniform in shaft angle.
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
    /// The same relative to the largest excursion from the static equilibrium.
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
    /// Ball-pass frequencies of each bearing, in the order of the scenario.
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
