//! The answer: everything about a run but its samples.

use serde::Serialize;

use super::{BearingHistory, EnergyReport, Maps, RunUp, SpallPassage, TableUse, VibrationSeverity};
use crate::analysis::{EstimatedSpectrum, Motion, Peak, Spectrum};
use crate::bearing::BearingState;
use crate::integrate::{Counters, MethodUse};
use crate::keys;
use crate::physics::BallPass;
use crate::rotor::{FREEDOMS, NaturalFrequency, Rotor};

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
    /// Frequency up to which they are those of a shaft that bends, Hz, and not of its reduction.
    #[serde(
        rename = "natural_frequencies_up_to_Hz",
        skip_serializing_if = "Option::is_none"
    )]
    pub natural_up_to: Option<f64>,
    /// Every bearing there, ball by ball, its cage where it starts; none of a linear one.
    #[serde(skip)]
    pub bearings: Vec<Option<BearingState>>,
}

/// Difference of the run from a second pass at a tenth of its tolerance, or at ten times one below 1e-12, with the round-off that both share.
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

/// A tolerance below this part of it is finer than it has use for.
const FINE: f64 = 1e-2;

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
    /// A tolerance of the integration that its error has use for, where `tolerance` is decades finer.
    pub(crate) fn sufficient_tolerance(&self, tolerance: f64) -> Option<f64> {
        let relative = self.error?.relative;
        (tolerance < FINE * relative).then(|| 10_f64.powf((0.1 * relative).log10().floor()))
    }

    /// What to say of an error that is large compared with the motion.
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
    /// Work of the pass with more modes that measures its error.
    #[serde(skip)]
    pub(crate) finer_counters: Option<Counters>,
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

impl Run {
    /// Share of the passes that measure errors in the evaluations of all, where there are any.
    pub(crate) fn share_of_verification(&self) -> Option<f64> {
        let reference = self.measured_error.map(|error| error.counters);
        let passes = reference.into_iter().chain(self.finer_counters);
        let evaluations: u64 = passes.map(|counters| counters.evaluations).sum();
        let all = evaluations + self.counters.evaluations;
        (evaluations > 0).then(|| evaluations as f64 / all as f64)
    }
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
            natural_up_to: rotor.natural_up_to(),
            bearings: rotor
                .supports()
                .zip(rotor.bearing_states(rotor.speed()))
                .map(|(support, state)| (support.known_balls() > 0).then_some(state))
                .collect(),
        }
    }
}
