//! What is made of the samples beside the spectra: the kind of a steady motion, maps of a run-up.

use std::f64::consts::TAU;

use super::Model;
use crate::analysis::{
    Channel, Motion, MotionParts, MotionRecorder, MotionSettings, OrderTracks, SectionKind,
    TrackRecorder, TrackedOrder, Waterfall, WaterfallRecorder,
};
use crate::integrate::Grid;
use crate::rotor::{FREEDOMS, Rotor, Sample};

/// Number of freedoms that are lengths.
const LENGTHS: usize = 3;
/// Shaft orders that are tracked.
const SHAFT_ORDERS: u32 = 3;
/// Shaft orders that a waterfall reaches up to at the highest speed.
const SHOWN_ORDERS: f64 = 10.0;
/// Multiples of the highest ball-pass frequency that it reaches up to.
const SHOWN_PASSES: f64 = 2.5;
/// Windows of a waterfall in the duration: fewest and most.
const WINDOWS: [f64; 2] = [8.0, 64.0];
/// Revolutions at the highest speed that tell its orders apart in a window, and windows that are left to a
/// short run for it.
const FEWEST_REVOLUTIONS: f64 = 4.0;
const LEAST_WINDOWS: f64 = 4.0;
/// Windows of the order tracks in the run, and their shortest and longest length in revolutions.
const TRACK_WINDOWS: f64 = 20.0;
const TRACK_REVOLUTIONS: [f64; 2] = [4.0, 16.0];

/// What is made of the samples beside the spectra; by default nothing.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Analyses {
    /// Statistics, sections, period and settling of the last whole revolutions after the settle time, where
    /// the speed is constant there.
    pub motion: bool,
    /// Which of these, where not all.
    pub parts: MotionParts,
    /// Waterfall and order tracks of the whole run.
    pub maps: bool,
    /// What is looked at of the bearings at every sample.
    pub watched: Watched,
    /// Which lines of the spectra are found.
    pub lines: SpectrumLines,
}

/// Which lines of the spectra of a run are found; by default all of them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum SpectrumLines {
    /// All of displacements and forces with their phases, and their peaks.
    #[default]
    All,
    /// Amplitudes of the displacements alone, up to an order of the shaft.
    UpTo(f64),
    /// Amplitudes of the displacements at the first so many multiples of the shaft's frequency; on a free grid of
    /// time, or under a window, all up to there.
    Orders(u32),
}

/// What is looked at of the bearings at every sample; what is not is missing in the samples. By default
/// everything.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Watched {
    /// The force on the shaft; known in any case where balls are looked at.
    pub forces: bool,
    /// Loads of every ball, and what rests on them; none: no ball is looked at.
    pub balls: Option<BallParts>,
}

/// What is made of the loads of the balls; by default everything.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BallParts {
    /// Contacts that part and meet.
    pub events: bool,
    /// How many balls are loaded, and over which arc.
    pub load_zone: bool,
    /// Life that the loads consume.
    pub life: bool,
    /// That before the settle time as well; without it the whole run counts from there on.
    pub early_life: bool,
}

impl BallParts {
    /// Everything.
    pub const ALL: Self = Self {
        events: true,
        load_zone: true,
        life: true,
        early_life: true,
    };

    /// The loads alone.
    pub const LOADS: Self = Self {
        events: false,
        load_zone: false,
        life: false,
        early_life: false,
    };
}

/// Everything.
impl Default for Watched {
    fn default() -> Self {
        Self {
            forces: true,
            balls: Some(BallParts::ALL),
        }
    }
}

/// Maps of a run whose speed changes.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Maps {
    /// Short-time spectra.
    pub waterfall: Waterfall,
    /// Orders of the shaft's angle.
    pub tracks: OrderTracks,
}

/// Takes the samples for what was asked for.
pub(super) struct Recorders {
    motion: Option<MotionRecorder>,
    maps: Option<(WaterfallRecorder, TrackRecorder)>,
}

impl Recorders {
    pub fn new(model: &Model, rotor: &Rotor, grid: &Grid) -> Self {
        let Analyses { motion, maps, .. } = model.analyses;
        let steady = rotor.steady_from(model.settle).filter(|_| motion);
        Self {
            motion: steady.map(|speed| MotionRecorder::new(settings(model, rotor, grid, speed))),
            maps: maps.then(|| maps_of(model, rotor, 1.0 / grid.interval)),
        }
    }

    /// Takes a sample.
    pub fn record(&mut self, sample: &Sample) {
        if let Some(motion) = &mut self.motion {
            motion.record(sample);
        }
        if let Some((waterfall, tracks)) = &mut self.maps {
            waterfall.record(sample);
            tracks.record(sample);
        }
    }

    pub fn finish(self) -> (Option<Motion>, Option<Maps>) {
        let maps = self.maps.map(|(waterfall, tracks)| Maps {
            waterfall: waterfall.finish(),
            tracks: tracks.finish(),
        });
        (self.motion.and_then(MotionRecorder::finish), maps)
    }
}

fn settings(model: &Model, rotor: &Rotor, grid: &Grid, speed: f64) -> MotionSettings {
    let scale = rotor.motion_scale(model.integrator.tolerance);
    let mut sections = Vec::new();
    let parts = model.analyses.parts;
    if speed > 0.0 {
        sections.push((SectionKind::Revolution, 1.0));
        let passing = rotor.ball_pass_orders().first().copied();
        sections.extend(passing.map(|[outer, _]| (SectionKind::BallPass, outer)));
    }
    let end = grid.time(grid.count - 1);
    MotionSettings {
        freedoms: rotor.active_freedoms(),
        start: whole_revolutions(model.settle, end, speed, grid.interval),
        end,
        rate: 1.0 / grid.interval,
        levers: std::array::from_fn::<_, FREEDOMS, _>(|axis| scale.lever(axis)),
        sections,
        parts,
    }
}

/// Where the last whole revolutions begin, behind the sample that they begin after: the end of one is
/// the begin of the next, and counts once.
fn whole_revolutions(settle: f64, end: f64, speed: f64, interval: f64) -> f64 {
    let revolutions = ((end - settle) * speed / TAU + 1e-9).floor();
    if revolutions < 1.0 {
        return settle;
    }
    end - revolutions * TAU / speed + 0.5 * interval
}

fn maps_of(model: &Model, rotor: &Rotor, rate: f64) -> (WaterfallRecorder, TrackRecorder) {
    let lengths = 0..rotor.active_freedoms().min(LENGTHS);
    let channels: Vec<Channel> = lengths.map(Channel::Displacement).collect();
    let passes = rotor.ball_pass_orders();
    let shaft = rotor.highest_speed() / TAU;
    let pass = passes.iter().map(|pass| pass[0]).fold(1.0, f64::max);
    let modes = rotor.natural_frequencies();
    let natural = modes.iter().map(|mode| mode.frequency).fold(0.0, f64::max);
    // a machine without known speeds shows all that the sampling has
    let wanted = [
        SHOWN_ORDERS * shaft,
        SHOWN_PASSES * pass * shaft,
        1.5 * natural,
    ];
    let limit = wanted.into_iter().fold(0.0, f64::max);
    let limit = if limit > 0.0 { limit } else { rate };
    let window = waterfall_window(model, rotor);
    let tracks = TrackRecorder::new(
        tracked(&passes),
        channels.clone(),
        track_window(model, rotor),
    );
    let waterfall = WaterfallRecorder::new(channels, rate, window, limit);
    (waterfall, tracks)
}

/// Within a window T a line that sweeps at a Hz/s moves by a T; it is sharpest where that is the
/// resolution 1/T, at T = 1/√a, here of twice the shaft's frequency: ball passes want a shorter one, the
/// shaft itself a longer one.
fn waterfall_window(model: &Model, rotor: &Rotor) -> f64 {
    let points: Vec<_> = rotor.speed_profile().points().collect();
    let sweeps = points.windows(2).map(|pair| {
        let change = (pair[1].speed - pair[0].speed).abs();
        2.0 * change / (pair[1].time - pair[0].time) / TAU
    });
    let fastest = sweeps.fold(0.0, f64::max);
    let [fewest, most] = WINDOWS;
    let sharpest = if fastest > 0.0 {
        fastest.sqrt().recip()
    } else {
        model.duration / fewest
    };
    let revolutions = match rotor.highest_speed() {
        0.0 => 0.0,
        highest => FEWEST_REVOLUTIONS * TAU / highest,
    };
    sharpest
        .clamp(model.duration / most, model.duration / fewest)
        .max(revolutions)
        .min(model.duration / LEAST_WINDOWS)
}

/// Revolutions of a window: those of the run over a number of windows.
fn track_window(model: &Model, rotor: &Rotor) -> f64 {
    let [shortest, longest] = TRACK_REVOLUTIONS;
    let angle = if rotor.is_driven() {
        0.5 * rotor.highest_speed() * model.duration
    } else {
        rotor.speed_profile().at(model.duration).angle
    };
    (angle / TAU / TRACK_WINDOWS)
        .round()
        .clamp(shortest, longest)
}

/// The first shaft orders, and the ball passes of every bearing at both races.
fn tracked(passes: &[[f64; 2]]) -> Vec<TrackedOrder> {
    let mut orders: Vec<TrackedOrder> = (1..=SHAFT_ORDERS)
        .map(|order| TrackedOrder {
            name: format!("{order}×"),
            order: f64::from(order),
        })
        .collect();
    for (index, pass) in passes.iter().enumerate() {
        if passes[..index].contains(pass) {
            continue;
        }
        let of = match index {
            0 => String::new(),
            _ => format!(" of bearing {}", index + 1),
        };
        let [outer, inner] = *pass;
        for (name, order) in [("BPFO", outer), ("BPFI", inner), ("2×BPFO", 2.0 * outer)] {
            orders.push(TrackedOrder {
                name: format!("{name}{of}"),
                order,
            });
        }
    }
    orders.retain(|order| order.order > 0.0);
    orders
}
