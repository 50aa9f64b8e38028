//! The numbers that are kept of every run.

use crate::analysis::{Channel, Kind, Motion, Spectrum, column_unit};
use crate::rotor::FREEDOMS;
use crate::simulate::{Analyses, BallParts, EventKind, Run, Watched};

/// Multiples of the shaft frequency whose lines are kept.
const ORDERS: [u32; 3] = [1, 2, 3];
/// Number of freedoms that are lengths.
const LENGTHS: usize = 3;

/// A number of a run: what it is called, what it rests on, and how it is found.
#[derive(Debug, Clone, PartialEq)]
pub struct NumberColumn {
    /// Name with its unit as a column of a table: `x_rms_m`.
    pub name: String,
    kind: NumberKind,
}

/// What a number is.
#[derive(Debug, Clone, Copy, PartialEq)]
enum NumberKind {
    Equilibrium(usize),
    Stiffness(usize),
    NaturalFrequency(usize),
    DampingRatio(usize),
    Mean(Channel),
    Rms(Channel),
    PeakToPeak(Channel),
    Order(usize, u32),
    Velocity(usize),
    Period,
    Drift,
    LargestBallLoad,
    FewestLoaded(usize),
    ContactLost(usize),
    Life(usize),
    MeasuredError,
    Evaluations,
}

/// The numbers of a run in the order of the columns; NaN where it has none.
pub type Numbers = Vec<f64>;

/// Columns for scenes of so many freedoms and bearings.
pub fn number_columns(freedoms: usize, bearings: usize) -> Vec<NumberColumn> {
    use NumberKind::{
        ContactLost, DampingRatio, Drift, Equilibrium, Evaluations, FewestLoaded, LargestBallLoad,
        Life, Mean, MeasuredError, NaturalFrequency, Order, PeakToPeak, Period, Rms, Stiffness,
        Velocity,
    };
    let freedoms = freedoms.min(FREEDOMS);
    let mut kinds: Vec<NumberKind> = (0..freedoms).map(Equilibrium).collect();
    kinds.extend((0..freedoms).map(Stiffness));
    kinds.extend((0..freedoms).flat_map(|mode| [NaturalFrequency(mode), DampingRatio(mode)]));
    let channels = Channel::of_freedoms(freedoms).into_iter();
    kinds.extend(channels.flat_map(|channel| [Mean(channel), Rms(channel), PeakToPeak(channel)]));
    let lines = |freedom| ORDERS.map(|order| Order(freedom, order));
    kinds.extend((0..freedoms).flat_map(lines));
    kinds.extend((0..freedoms.min(LENGTHS)).map(Velocity));
    kinds.extend([Period, Drift, LargestBallLoad]);
    let observed = |bearing| [FewestLoaded(bearing), ContactLost(bearing), Life(bearing)];
    kinds.extend((0..bearings).flat_map(observed));
    kinds.extend([MeasuredError, Evaluations]);
    let column = |kind: NumberKind| NumberColumn {
        name: kind.name(),
        kind,
    };
    kinds.into_iter().map(column).collect()
}

impl NumberKind {
    /// Name with the unit.
    fn name(self) -> String {
        let of = |channel: Channel, what: &str| {
            format!("{channel}_{what}_{}", column_unit(channel.unit()))
        };
        match self {
            Self::Equilibrium(freedom) => of(Channel::Displacement(freedom), "equilibrium"),
            Self::Stiffness(freedom) => {
                let (channel, force) = (Channel::Displacement(freedom), Channel::Force(freedom));
                let units = [force, channel].map(|channel| column_unit(channel.unit()));
                format!("stiffness_{channel}_{}", units.join("_"))
            }
            Self::NaturalFrequency(mode) => format!("natural_frequency_{}_Hz", mode + 1),
            Self::DampingRatio(mode) => format!("damping_ratio_{}", mode + 1),
            Self::Mean(channel) => of(channel, "mean"),
            Self::Rms(channel) => of(channel, "rms"),
            Self::PeakToPeak(channel) => of(channel, "peak_to_peak"),
            Self::Order(freedom, order) => {
                of(Channel::Displacement(freedom), &format!("order_{order}"))
            }
            Self::Velocity(freedom) => of(Channel::Velocity(freedom), "rms"),
            Self::Period => "period_cycles".to_owned(),
            Self::Drift => "drift".to_owned(),
            Self::LargestBallLoad => "largest_ball_load_N".to_owned(),
            Self::FewestLoaded(bearing) => format!("bearing_{}_fewest_loaded", bearing + 1),
            Self::ContactLost(bearing) => format!("bearing_{}_contact_lost", bearing + 1),
            Self::Life(bearing) => format!("bearing_{}_life_h", bearing + 1),
            Self::MeasuredError => "measured_error".to_owned(),
            Self::Evaluations => "evaluations".to_owned(),
        }
    }
}

impl NumberColumn {
    /// Order of the shaft whose line it is.
    pub fn order(&self) -> Option<u32> {
        match self.kind {
            NumberKind::Order(_, order) => Some(order),
            _ => None,
        }
    }

    /// Asks for what it rests on, beside lines of spectra.
    pub(super) fn ask(&self, analyses: &mut Analyses) {
        let (motion, parts) = (&mut analyses.motion, &mut analyses.parts);
        let watched = &mut analyses.watched;
        match self.kind {
            NumberKind::Mean(channel)
            | NumberKind::Rms(channel)
            | NumberKind::PeakToPeak(channel) => {
                *motion = true;
                if let Channel::Force(_) = channel {
                    parts.forces = true;
                    watched.forces = true;
                }
            }
            NumberKind::Velocity(_) => (*motion, parts.velocity) = (true, true),
            NumberKind::Period => (*motion, parts.kind) = (true, true),
            NumberKind::Drift => (*motion, parts.drift) = (true, true),
            NumberKind::LargestBallLoad => {
                loads(watched);
            }
            NumberKind::FewestLoaded(_) => loads(watched).load_zone = true,
            NumberKind::ContactLost(_) => loads(watched).events = true,
            NumberKind::Life(_) => loads(watched).life = true,
            NumberKind::Equilibrium(_)
            | NumberKind::Stiffness(_)
            | NumberKind::NaturalFrequency(_)
            | NumberKind::DampingRatio(_)
            | NumberKind::Order(..)
            | NumberKind::MeasuredError
            | NumberKind::Evaluations => {}
        }
    }

    /// Whether it is the measured error of a run.
    pub fn is_error(&self) -> bool {
        self.kind == NumberKind::MeasuredError
    }

    /// The number of a run; NaN where it has none.
    pub fn of(&self, run: &Run) -> f64 {
        self.found(run).unwrap_or(f64::NAN)
    }

    fn found(&self, run: &Run) -> Option<f64> {
        let motion = run.motion.as_ref();
        let moments = |channel: Channel| {
            let statistics = &motion?.statistics;
            let found = statistics.iter().find(|entry| entry.channel == channel);
            found.map(|entry| &entry.moments)
        };
        match self.kind {
            NumberKind::Equilibrium(freedom) => Some(run.equilibrium.displacement[freedom]),
            NumberKind::Stiffness(freedom) => Some(run.equilibrium.stiffness[freedom][freedom]),
            NumberKind::NaturalFrequency(mode) => {
                let modes = &run.equilibrium.natural_frequencies;
                modes.get(mode).map(|mode| mode.frequency)
            }
            NumberKind::DampingRatio(mode) => {
                let modes = &run.equilibrium.natural_frequencies;
                modes.get(mode).map(|mode| mode.damping_ratio)
            }
            NumberKind::Mean(channel) => moments(channel).map(|moments| moments.mean()),
            NumberKind::Rms(channel) => moments(channel).map(|moments| moments.rms()),
            NumberKind::PeakToPeak(channel) => {
                moments(channel).map(|moments| moments.peak_to_peak())
            }
            NumberKind::Order(freedom, order) => order_line(run.spectrum.as_ref()?, freedom, order),
            NumberKind::Velocity(freedom) => motion?
                .velocity
                .get(freedom)
                .copied()
                .flatten()
                .map(|level| level.rms),
            NumberKind::Period => motion.map(period),
            NumberKind::Drift => motion?.drift.map(|drift| drift.largest()),
            NumberKind::LargestBallLoad => run.largest_ball_load,
            NumberKind::FewestLoaded(bearing) => {
                let zone = run.bearings.get(bearing)?.load_zone?;
                Some(zone.balls.smallest)
            }
            NumberKind::ContactLost(bearing) => {
                let events = run.bearings.get(bearing)?;
                Some(events.events(EventKind::ContactLost).count as f64)
            }
            NumberKind::Life(bearing) => run.bearings.get(bearing)?.life?.after_settle.hours(),
            NumberKind::MeasuredError => run.measured_error.map(|error| error.relative),
            NumberKind::Evaluations => Some(run.counters.evaluations as f64),
        }
    }
}

/// What is made of the loads of the balls, which are looked at from now on.
fn loads(watched: &mut Watched) -> &mut BallParts {
    watched.balls.get_or_insert(BallParts::LOADS)
}

/// Amplitude at a multiple of the shaft frequency, where that is a bin.
fn order_line(spectrum: &Spectrum, freedom: usize, order: u32) -> Option<f64> {
    let bin = f64::from(order) * spectrum.shaft_frequency / spectrum.resolution;
    if spectrum.shaft_frequency <= 0.0 || (bin - bin.round()).abs() > 1e-6 {
        return None;
    }
    let entry = spectrum.channel(Channel::Displacement(freedom))?;
    entry.amplitude.get(bin.round() as usize).copied()
}

/// Cycles after which a motion repeats; 0 at rest, −2 of two frequencies, −1 irregular or unknown.
fn period(motion: &Motion) -> f64 {
    match motion.recognition.kind {
        Kind::Rest => 0.0,
        Kind::Periodic { cycles, .. } => cycles as f64,
        Kind::QuasiPeriodic { .. } => -2.0,
        _ => -1.0,
    }
}
