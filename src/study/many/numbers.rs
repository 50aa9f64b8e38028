//! The numbers that are kept of every run.

use crate::analysis::{Channel, Kind, Motion, Spectrum};
use crate::rotor::FREEDOMS;
use crate::simulate::{EventKind, Run};

/// Multiples of the shaft frequency whose lines are kept.
const ORDERS: [u32; 3] = [1, 2, 3];

/// A number of a run: what it is, its unit, and how it is found.
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
    let freedoms = freedoms.min(FREEDOMS);
    let mut columns = Vec::new();
    let mut add = |name: String, kind| columns.push(NumberColumn { name, kind });
    let unit = |channel: Channel| channel.unit().replace(' ', "_");
    for freedom in 0..freedoms {
        let channel = Channel::Displacement(freedom);
        add(
            format!("{channel}_equilibrium_{}", unit(channel)),
            NumberKind::Equilibrium(freedom),
        );
    }
    for freedom in 0..freedoms {
        let (channel, force) = (Channel::Displacement(freedom), Channel::Force(freedom));
        let name = format!("stiffness_{channel}_{}_{}", unit(force), unit(channel));
        add(name, NumberKind::Stiffness(freedom));
    }
    for mode in 0..freedoms {
        let number = mode + 1;
        add(
            format!("natural_frequency_{number}_Hz"),
            NumberKind::NaturalFrequency(mode),
        );
        add(
            format!("damping_ratio_{number}"),
            NumberKind::DampingRatio(mode),
        );
    }
    for channel in Channel::of_freedoms(freedoms) {
        let unit = unit(channel);
        for (name, kind) in [
            ("mean", NumberKind::Mean(channel)),
            ("rms", NumberKind::Rms(channel)),
            ("peak_to_peak", NumberKind::PeakToPeak(channel)),
        ] {
            add(format!("{channel}_{name}_{unit}"), kind);
        }
    }
    for freedom in 0..freedoms {
        let channel = Channel::Displacement(freedom);
        for order in ORDERS {
            let name = format!("{channel}_order_{order}_{}", unit(channel));
            add(name, NumberKind::Order(freedom, order));
        }
    }
    for freedom in 0..freedoms.min(3) {
        let channel = Channel::Displacement(freedom);
        add(
            format!("{channel}_velocity_rms_m_s"),
            NumberKind::Velocity(freedom),
        );
    }
    add("period_cycles".to_owned(), NumberKind::Period);
    add("drift".to_owned(), NumberKind::Drift);
    add(
        "largest_ball_load_N".to_owned(),
        NumberKind::LargestBallLoad,
    );
    for bearing in 0..bearings {
        let number = bearing + 1;
        for (name, kind) in [
            ("fewest_loaded", NumberKind::FewestLoaded(bearing)),
            ("contact_lost", NumberKind::ContactLost(bearing)),
            ("life_h", NumberKind::Life(bearing)),
        ] {
            add(format!("bearing_{number}_{name}"), kind);
        }
    }
    add("measured_error".to_owned(), NumberKind::MeasuredError);
    add("evaluations".to_owned(), NumberKind::Evaluations);
    columns
}

impl NumberColumn {
    /// Order of the shaft whose line it is.
    pub fn order(&self) -> Option<u32> {
        match self.kind {
            NumberKind::Order(_, order) => Some(order),
            _ => None,
        }
    }

    /// Whether the motion after the settle time tells it.
    pub fn rests_on_motion(&self) -> bool {
        matches!(
            self.kind,
            NumberKind::Mean(_)
                | NumberKind::Rms(_)
                | NumberKind::PeakToPeak(_)
                | NumberKind::Velocity(_)
                | NumberKind::Period
                | NumberKind::Drift
        )
    }

    /// Whether the velocities in the band of the standards tell it.
    pub fn rests_on_velocity(&self) -> bool {
        matches!(self.kind, NumberKind::Velocity(_))
    }

    /// Whether it says how the motion settles.
    pub fn rests_on_drift(&self) -> bool {
        self.kind == NumberKind::Drift
    }

    /// Whether the kind of the motion tells it.
    pub fn rests_on_kind(&self) -> bool {
        self.kind == NumberKind::Period
    }

    /// Whether contacts that part and meet tell it.
    pub fn rests_on_events(&self) -> bool {
        matches!(self.kind, NumberKind::ContactLost(_))
    }

    /// Whether the balls that are loaded tell it.
    pub fn rests_on_load_zone(&self) -> bool {
        matches!(self.kind, NumberKind::FewestLoaded(_))
    }

    /// Whether the life that the loads consume tells it.
    pub fn rests_on_life(&self) -> bool {
        matches!(self.kind, NumberKind::Life(_))
    }

    /// Whether the forces of the bearings tell it.
    pub fn rests_on_forces(&self) -> bool {
        let channel = match self.kind {
            NumberKind::Mean(channel)
            | NumberKind::Rms(channel)
            | NumberKind::PeakToPeak(channel) => channel,
            _ => return false,
        };
        matches!(channel, Channel::Force(_))
    }

    /// Whether the balls tell it.
    pub fn rests_on_balls(&self) -> bool {
        matches!(
            self.kind,
            NumberKind::LargestBallLoad
                | NumberKind::FewestLoaded(_)
                | NumberKind::ContactLost(_)
                | NumberKind::Life(_)
        )
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
