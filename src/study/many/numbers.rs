//! The numbers that are kept of every run.

use std::sync::Arc;

use crate::analysis::{Channel, Kind, Moments, Motion, Spectrum};
use crate::keys::diagonal_columns;
use crate::quasi_static::QuasiStatic;
use crate::rotor::RotorDefinition;
use crate::simulate::{Analyses, EventKind, MotionAnalysis, Run};
use crate::table::Column;

/// Multiples of the shaft frequency whose lines are kept.
const ORDERS: [(u32, &str); 3] = [(1, "order_1"), (2, "order_2"), (3, "order_3")];
/// Name of the number that is kept of every run.
const MEASURED_ERROR: &str = "measured_error";

/// A moment of a channel.
type Moment = fn(&Moments) -> f64;

/// Moments of a channel that are kept.
const MOMENTS: [(&str, Moment); 3] = [
    ("mean", Moments::mean),
    ("rms", Moments::rms),
    ("peak_to_peak", Moments::peak_to_peak),
];

/// Finds something in a result.
type Find<Result, Found> = Arc<dyn Fn(&Result) -> Found + Send + Sync>;

/// How a number is found in a run, which may have none, or in the answer to a static question.
#[derive(Clone)]
enum Value {
    Run(Find<Run, Option<f64>>),
    Answer(Find<QuasiStatic, f64>),
}

/// A number of a run: what it is called, what it rests on, and how it is found.
#[derive(Clone)]
pub struct NumberColumn {
    /// Its column in the table of runs: `x_rms_m`.
    pub column: Column,
    /// Order of the shaft whose line it is.
    pub order: Option<u32>,
    /// Whether it is kept only where it is asked for.
    pub on_request: bool,
    /// Asks for what it rests on, besides lines of spectra.
    pub(super) ask: fn(&mut Analyses),
    value: Value,
}

impl std::fmt::Debug for NumberColumn {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_tuple("NumberColumn").field(&self.column).finish()
    }
}

impl NumberColumn {
    /// Whether it is the measured error of a run.
    pub fn is_error(&self) -> bool {
        self.column.quantity == MEASURED_ERROR
    }

    /// A number of the answer to a static question.
    pub(super) fn from_answer(
        column: Column,
        value: impl Fn(&QuasiStatic) -> f64 + Send + Sync + 'static,
    ) -> Self {
        Self {
            value: Value::Answer(Arc::new(value)),
            ..number(column, NO_ANALYSIS, |_| None)
        }
    }

    /// The number of a run; NaN where it has none.
    pub fn in_run(&self, run: &Run) -> f64 {
        match &self.value {
            Value::Run(value) => value(run).unwrap_or(f64::NAN),
            Value::Answer(_) => f64::NAN,
        }
    }

    /// The number of an answer to a static question; NaN where it has none.
    pub fn in_answer(&self, answer: &QuasiStatic) -> f64 {
        match &self.value {
            Value::Run(_) => f64::NAN,
            Value::Answer(value) => value(answer),
        }
    }
}

fn number(
    column: Column,
    ask: fn(&mut Analyses),
    value: impl Fn(&Run) -> Option<f64> + Send + Sync + 'static,
) -> NumberColumn {
    NumberColumn {
        column,
        order: None,
        on_request: false,
        ask,
        value: Value::Run(Arc::new(value)),
    }
}

/// Mean, RMS and range of a channel, which are those of a column that is recorded.
fn moments([channel, recorded]: [Channel; 2]) -> [NumberColumn; MOMENTS.len()] {
    MOMENTS.map(|(what, moment)| {
        number(channel.measure(what), STATISTICS, move |run| {
            let mut statistics = run.motion.as_ref()?.statistics.iter();
            let found = statistics.find(|entry| entry.channel == recorded);
            found.map(|entry| moment(&entry.moments))
        })
    })
}

/// Amplitude of a channel, which is that of a column that is recorded, at a multiple of the shaft frequency; of forces on
/// request.
fn line([channel, recorded]: [Channel; 2], (order, name): (u32, &'static str)) -> NumberColumn {
    let amplitude = move |run: &Run| order_line(run.spectrum.as_ref()?, recorded, order);
    let ask = if channel.is_force() {
        FORCE_LINES
    } else {
        NO_ANALYSIS
    };
    NumberColumn {
        order: Some(order),
        on_request: channel.is_force(),
        ..number(channel.measure(name), ask, amplitude)
    }
}

/// RMS velocity of a housing.
fn housing_velocity(channel: Channel) -> NumberColumn {
    number(channel.measure("rms"), VELOCITIES, move |run| {
        let mut levels = run.motion.as_ref()?.housing_velocity.iter();
        let found = levels.find(|entry| entry.channel == channel);
        found.map(|entry| entry.level.rms)
    })
}

/// Numbers of housings and of single bearings, whose forces along freedoms that move are recorded where there are several.
fn part_columns(rotor: &RotorDefinition) -> Vec<NumberColumn> {
    let mut columns = Vec::new();
    let mut parts: Vec<_> = Channel::of_parts(rotor)
        .into_iter()
        .map(|own| [own; 2])
        .collect();
    if rotor.part_count() == 1 {
        let axes = rotor.shaft.freedoms.axes().iter();
        let only = |freedom| Channel::of_part(rotor, 0, freedom);
        parts.extend(axes.map(|freedom| [only(*freedom), Channel::Force(*freedom)]));
    }
    for part in parts {
        let is_total = part[0] != part[1];
        columns.extend(moments(part).map(|column| NumberColumn {
            on_request: is_total,
            ..column
        }));
        columns.extend(ORDERS.map(|order| line(part, order)));
    }
    let bodies = Channel::of_bodies(rotor, 2);
    let velocities = bodies.filter(|channel| channel.is_housing_velocity());
    columns.extend(velocities.map(housing_velocity));
    columns
}

/// What is observed of a bearing.
fn bearing_columns(bearing: usize) -> [NumberColumn; 4] {
    let own = |what: &str, unit| Column::number(format!("bearing_{}_{what}", bearing + 1), unit);
    let zone = move |run: &Run| Some(run.bearings.get(bearing)?.load_zone?.balls.smallest);
    let lost = move |run: &Run| {
        let history = run.bearings.get(bearing)?;
        Some(history.events(EventKind::ContactLost).count as f64)
    };
    let life = move |run: &Run| run.bearings.get(bearing)?.life?.after_settle.hours();
    let modified = move |run: &Run| run.bearings.get(bearing)?.life?.modified?.hours;
    [
        number(own("fewest_loaded", ""), LOADS, zone),
        number(own("contact_lost", ""), WHOLE_MOTION, lost),
        number(own("life", "h"), LOADS, life),
        number(own("modified_life", "h"), LOADS, modified),
    ]
}

/// Of a number that every run has.
const NO_ANALYSIS: fn(&mut Analyses) = |_| {};
/// Of a number of the motion after the settle time.
const STATISTICS: fn(&mut Analyses) = |asked| asked.motion = asked.motion.with_statistics();

/// Of an RMS velocity.
const VELOCITIES: fn(&mut Analyses) = |asked| {
    STATISTICS(asked);
    asked.velocities = true;
};

/// Of a number of the loads of the balls.
const LOADS: fn(&mut Analyses) = |asked| asked.loads = true;

/// Of a line of a force.
const FORCE_LINES: fn(&mut Analyses) = |asked| asked.force_lines = true;

/// Of a number of the whole motion.
const WHOLE_MOTION: fn(&mut Analyses) = |asked| asked.settled_only = false;

/// Columns for scenes like that of a rotor.
pub fn number_columns(rotor: &RotorDefinition) -> Vec<NumberColumn> {
    let (freedoms, bearings) = (rotor.shaft.freedoms, rotor.bearings.len());
    let mut columns = Vec::new();
    for &freedom in freedoms.axes() {
        let column = Channel::Displacement(freedom).measure("equilibrium");
        columns.push(number(column, NO_ANALYSIS, move |run| {
            Some(run.equilibrium.displacement[freedom])
        }));
    }
    for &freedom in freedoms.axes() {
        let column = diagonal_columns()[freedom].clone();
        columns.push(number(column, NO_ANALYSIS, move |run| {
            Some(run.equilibrium.stiffness[freedom][freedom])
        }));
    }
    for mode in 0..freedoms.axes().len() {
        let found = move |run: &Run| run.equilibrium.natural_frequencies.get(mode).copied();
        let frequency = move |run: &Run| Some(found(run)?.frequency);
        let own = |what: &str, unit| Column::number(format!("{what}_{}", mode + 1), unit);
        columns.push(number(
            own("natural_frequency", "Hz"),
            NO_ANALYSIS,
            frequency,
        ));
        let ratio = move |run: &Run| Some(found(run)?.damping_ratio);
        columns.push(number(own("damping_ratio", ""), NO_ANALYSIS, ratio));
    }
    let channels = Channel::of_freedoms(freedoms)
        .into_iter()
        .map(|own| [own; 2]);
    columns.extend(channels.clone().flat_map(moments));
    for channel in channels {
        columns.extend(ORDERS.map(|order| line(channel, order)));
    }
    for freedom in 0..freedoms.lengths() {
        let column = Channel::Velocity(freedom).measure("rms");
        columns.push(number(column, VELOCITIES, move |run| {
            let level = run.motion.as_ref()?.velocity.get(freedom)?.as_ref();
            level.map(|level| level.rms)
        }));
    }
    let kind = |asked: &mut Analyses| asked.motion = MotionAnalysis::Kind;
    let cycles = |run: &Run| run.motion.as_ref().map(period);
    let drift = |run: &Run| Some(run.motion.as_ref()?.drift.as_ref()?.largest());
    let load = |run: &Run| run.largest_ball_load;
    columns.extend([
        number(Column::number("period_cycles", ""), kind, cycles),
        number(Column::number("drift", ""), STATISTICS, drift),
        number(Channel::LargestBallLoad.column(), NO_ANALYSIS, load),
    ]);
    columns.extend(part_columns(rotor));
    columns.extend((0..bearings).flat_map(bearing_columns));
    let error = |run: &Run| Some(run.measured_error.as_ref()?.relative);
    let evaluations = |run: &Run| Some(run.counters.evaluations as f64);
    columns.extend([
        number(Column::number(MEASURED_ERROR, ""), NO_ANALYSIS, error),
        number(Column::number("evaluations", ""), NO_ANALYSIS, evaluations),
    ]);
    columns
}

/// Amplitude at a multiple of the shaft frequency, where that is a bin.
fn order_line(spectrum: &Spectrum, channel: Channel, order: u32) -> Option<f64> {
    let bin = f64::from(order) * spectrum.shaft_frequency / spectrum.resolution;
    if spectrum.shaft_frequency <= 0.0 || (bin - bin.round()).abs() > 1e-6 {
        return None;
    }
    let entry = spectrum.channel(channel)?;
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
