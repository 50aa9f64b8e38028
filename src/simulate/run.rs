//! The answer: everything about a run except its trace.

use serde::Serialize;

use super::BearingHistory;
use super::EnergyReport;
use super::Maps;
use super::TableUse;
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
    /// Largest unbalanced force of the kept freedoms relative to the load.
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
    /// The same relative to the motion: the largest excursion from the static equilibrium, or the
    /// smallest motion that the tolerance resolves above round-off.
    pub relative: f64,
    /// Tolerance of the second pass.
    pub reference_tolerance: f64,
    /// Work of the second pass.
    #[serde(rename = "reference_counters")]
    pub counters: Counters,
}

impl MeasuredError {
    /// Share of the second pass in the evaluations of both.
    pub(crate) fn share_of_evaluations(&self, main: &Counters) -> f64 {
        let (own, main) = (self.counters.evaluations as f64, main.evaluations as f64);
        own / (own + main).max(1.0)
    }
}

/// Everything that a run answers, except the trace itself, which went to the sink.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Run {
    /// Static equilibrium.
    #[serde(flatten)]
    pub equilibrium: StaticState,
    /// Ball-pass frequencies of each bearing, in the order of the scenario, at the speed after the
    /// settle time; at the highest speed where it changes there.
    pub ball_pass: Vec<BallPass>,
    /// The same at the mean operating contact angle of the static equilibrium; none without spectra.
    ///
    /// The simulated cages keep the nominal angle: simulated lines stand at [`Run::ball_pass`], those of a
    /// bearing whose cage follows its balls here.
    pub operating_ball_pass: Vec<BallPass>,
    /// Work done.
    pub counters: Counters,
    /// Which methods did it, where the choice was left open.
    #[serde(skip)]
    pub(crate) method_use: Option<MethodUse>,
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
    /// Waterfall and order tracks, where asked for.
    #[serde(skip)]
    pub maps: Option<Maps>,
    /// Spectra that were asked for besides, as far as the run was long enough; a warning names the
    /// others.
    #[serde(skip)]
    pub spectra: Vec<EstimatedSpectrum>,
    /// What the reader of the results should know, each with its numbers.
    pub warnings: Vec<String>,
}

impl StaticState {
    /// What a rotor found before it moved.
    pub(crate) fn of(rotor: &Rotor) -> Self {
        let equilibrium = rotor.equilibrium();
        let stiffness = &equilibrium.stiffness;
        Self {
            displacement: equilibrium.displacement,
            stiffness: std::array::from_fn(|row| {
                std::array::from_fn(|column| stiffness[(row, column)])
            }),
            damping: rotor.damping_matrix(),
            residual: equilibrium.residual,
            newton_steps: equilibrium.newton_steps,
            natural_frequencies: rotor.natural_frequencies(),
            bearings: rotor
                .supports()
                .iter()
                .zip(rotor.bearing_states(rotor.speed()))
                .map(|(support, state)| (support.known_balls() > 0).then_some(state))
                .collect(),
        }
    }
}
