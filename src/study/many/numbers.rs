//! The numbers that are kept of every run.

use std::sync::Arc;

use crate::analysis::{Channel, Kind, Moments, Motion, Spectrum, column_unit};
use crate::rotor::FREEDOMS;
use crate::simulate::{Analyses, EventKind, MotionAnalysis, Run};

/// Multiples of the shaft frequency whose lines are kept.
const ORDERS: [u32; 3] = [1, 2, 3];
/// Number of freedoms that are lengths.
const LENGTHS: usize = 3;
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

/// How a number is found in a run; none where it has none.
type Value = Arc<dyn Fn(&Run) -> Option<f64> + Send + Sync>;

/// A number of a run: what it is called, what it rests on, and how it is found.
#[derive(Clone)]
pub struct NumberColumn {
    /// Name with its unit as a column of a table: `x_rms_m`.
    pub name: String,
    /// Order of the shaft whose line it is.
    pub order: Option<u32>,
    /// Asks for what it rests on, beside lines of spectra.
    pub(super) ask: fn(&mut Analyses),
    value: Value,
}

impl std::fmt::Debug for NumberColumn {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_tuple("NumberColumn").field(&self.name).finish()
    }
}

impl NumberColumn {
    /// Whether it is the measured error of a run.
    pub fn is_error(&self) -> bool {
        self.name == MEASURED_ERROR
    }

    /// The number of a run; NaN where it has none.
    pub fn of(&self, run: &Run) -> f64 {
        (self.value)(run).unwrap_or(f64::NAN)
    }
}

/// Columns as they are put together.
#[derive(Default)]
struct Columns(Vec<NumberColumn>);

impl Columns {
    fn add(
        &mut self,
        name: impl Into<String>,
        ask: fn(&mut Analyses),
        value: impl Fn(&Run) -> Option<f64> + Send + Sync + 'static,
    ) {
        self.0.push(NumberColumn {
            name: name.into(),
            order: None,
            ask,
            value: Arc::new(value),
        });
    }

    /// Mean, RMS and range of a channel.
    fn add_moments(&mut self, channel: Channel) {
        for (what, moment) in MOMENTS {
            self.add(of(channel, what), STATISTICS, move |run| {
                let mut statistics = run.motion.as_ref()?.statistics.iter();
                let found = statistics.find(|entry| entry.channel == channel);
                found.map(|entry| moment(&entry.moments))
            });
        }
    }

    /// Amplitude of a displacement at a multiple of the shaft frequency.
    fn add_line(&mut self, freedom: usize, order: u32) {
        let name = of(Channel::Displacement(freedom), &format!("order_{order}"));
        self.add(name, NOTHING, move |run| {
            order_line(run.spectrum.as_ref()?, freedom, order)
        });
        if let Some(added) = self.0.last_mut() {
            added.order = Some(order);
        }
    }

    /// What is observed of a bearing.
    fn add_bearing(&mut self, bearing: usize) {
        let name = |what: &str| format!("bearing_{}_{what}", bearing + 1);
        let zone = move |run: &Run| Some(run.bearings.get(bearing)?.load_zone?.balls.smallest);
        let lost = move |run: &Run| {
            let history = run.bearings.get(bearing)?;
            Some(history.events(EventKind::ContactLost).count as f64)
        };
        let life = move |run: &Run| run.bearings.get(bearing)?.life?.after_settle.hours();
        self.add(name("fewest_loaded"), NOTHING, zone);
        self.add(
            name("contact_lost"),
            |asked| asked.settled_only = false,
            lost,
        );
        self.add(name("life_h"), NOTHING, life);
        let modified = move |run: &Run| run.bearings.get(bearing)?.life?.modified?.hours;
        self.add(name("modified_life_h"), NOTHING, modified);
    }
}

/// Of a number that every run has.
const NOTHING: fn(&mut Analyses) = |_| {};
/// Of a number of the motion after the settle time.
const STATISTICS: fn(&mut Analyses) = |asked| asked.motion = asked.motion.with_statistics();

/// `x_rms_m`.
fn of(channel: Channel, what: &str) -> String {
    format!("{channel}_{what}_{}", column_unit(channel.unit()))
}

/// Columns for scenes of so many freedoms and bearings.
pub fn number_columns(freedoms: usize, bearings: usize) -> Vec<NumberColumn> {
    let freedoms = freedoms.min(FREEDOMS);
    let mut columns = Columns::default();
    for freedom in 0..freedoms {
        let name = of(Channel::Displacement(freedom), "equilibrium");
        columns.add(name, NOTHING, move |run| {
            Some(run.equilibrium.displacement[freedom])
        });
    }
    for freedom in 0..freedoms {
        let (channel, force) = (Channel::Displacement(freedom), Channel::Force(freedom));
        let units = [force, channel].map(|channel| column_unit(channel.unit()));
        let name = format!("stiffness_{channel}_{}", units.join("_"));
        columns.add(name, NOTHING, move |run| {
            Some(run.equilibrium.stiffness[freedom][freedom])
        });
    }
    for mode in 0..freedoms {
        let found = move |run: &Run| run.equilibrium.natural_frequencies.get(mode).copied();
        let name = format!("natural_frequency_{}_Hz", mode + 1);
        columns.add(name, NOTHING, move |run| Some(found(run)?.frequency));
        let name = format!("damping_ratio_{}", mode + 1);
        columns.add(name, NOTHING, move |run| Some(found(run)?.damping_ratio));
    }
    let channels = Channel::of_freedoms(freedoms).into_iter();
    channels.for_each(|channel| columns.add_moments(channel));
    for freedom in 0..freedoms {
        ORDERS
            .into_iter()
            .for_each(|order| columns.add_line(freedom, order));
    }
    for freedom in 0..freedoms.min(LENGTHS) {
        let name = of(Channel::Velocity(freedom), "rms");
        let level = move |run: &Run| {
            let level = run.motion.as_ref()?.velocity.get(freedom)?.as_ref();
            level.map(|level| level.rms)
        };
        columns.add(name, STATISTICS, level);
    }
    let kind = |asked: &mut Analyses| asked.motion = MotionAnalysis::Kind;
    columns.add("period_cycles", kind, |run| run.motion.as_ref().map(period));
    columns.add("drift", STATISTICS, |run| {
        let drift = run.motion.as_ref()?.drift.as_ref();
        drift.map(|drift| drift.largest())
    });
    columns.add("largest_ball_load_N", NOTHING, |run| run.largest_ball_load);
    (0..bearings).for_each(|bearing| columns.add_bearing(bearing));
    columns.add(MEASURED_ERROR, NOTHING, |run| {
        let error = run.measured_error.as_ref();
        error.map(|error| error.relative)
    });
    columns.add("evaluations", NOTHING, |run| {
        Some(run.counters.evaluations as f64)
    });
    columns.0
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
