//! What is kept of one run, and where the next one of its chain starts.

use std::f64::consts::TAU;
use std::io;

use serde::{Deserialize, Serialize};

use super::KeptTrace;
use super::schedule::Direction;
use crate::analysis::Channel;
use crate::bearing::Support;
use crate::rotor::{InitialPosition, InitialState, Sample};
use crate::simulate::{Model, TraceSink};

/// One run of a study: the row that all its tables, figures and statistics are made of.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RunRecord {
    /// Its number, from 0 on.
    pub run: u64,
    /// Which way it was come to.
    pub direction: Direction,
    /// Values of the axes, SI units.
    pub values: Vec<f64>,
    /// What came of it, or why nothing did.
    pub outcome: Result<Outcome, String>,
}

/// What came of a run.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Outcome {
    /// Its numbers in the order of the columns; NaN where it has none.
    #[serde(with = "any_number")]
    pub numbers: Vec<f64>,
    /// Amplitudes of the displacements, m and rad, at frequencies in Hz; empty where none are kept.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub spectrum: Vec<Line>,
    /// Peaks of these spectra between the bins; empty where none are kept.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub peaks: Vec<KeptPeak>,
    /// Positions of the shaft; empty where none are kept.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub points: Vec<Point>,
    /// Stiffness of every bearing that has one of its own; empty where it is not kept.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub stiffness: Vec<BearingStiffness>,
    /// Every bearing all around; empty but for the answer to a static question.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub around: Vec<Place>,
    /// What its trace is known by, where it is kept.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub trace: Option<TraceSeal>,
    /// What a reader should know of it, each with its numbers.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<String>,
}

/// Numbers as JSON, which has none that is missing or infinite: `null` and a word stand for these.
mod any_number {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    #[derive(Serialize, Deserialize)]
    #[serde(untagged)]
    enum Number {
        Finite(f64),
        Missing(()),
        Infinite(String),
    }

    pub fn serialize<S: Serializer>(numbers: &[f64], to: S) -> Result<S::Ok, S::Error> {
        to.collect_seq(numbers.iter().map(|number| match number {
            missing if missing.is_nan() => Number::Missing(()),
            infinite if infinite.is_infinite() => Number::Infinite(infinite.to_string()),
            finite => Number::Finite(*finite),
        }))
    }

    pub fn deserialize<'a, D: Deserializer<'a>>(from: D) -> Result<Vec<f64>, D::Error> {
        let numbers = Vec::<Number>::deserialize(from)?.into_iter();
        let numbers = numbers.map(|number| match number {
            Number::Finite(finite) => finite,
            Number::Missing(()) => f64::NAN,
            Number::Infinite(word) => word.parse().unwrap_or(f64::NAN),
        });
        Ok(numbers.collect())
    }
}

/// What is at one azimuth around a bearing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Place {
    /// Number of the bearing, from 1 on.
    #[serde(rename = "b")]
    pub bearing: usize,
    /// Number of the row of balls or rollers, from 1 on.
    #[serde(rename = "r")]
    pub row: usize,
    /// Number of the azimuth in its row, from 1 on.
    #[serde(rename = "p")]
    pub position: usize,
    /// Its numbers in the order of their columns.
    #[serde(rename = "n", with = "any_number")]
    pub numbers: Vec<f64>,
}

/// What the trace of a run is known by wherever it goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct TraceSeal {
    /// Number of bytes.
    pub bytes: u64,
    /// CRC-32 over them.
    pub checksum: u32,
}

/// Amplitudes at one frequency.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Line {
    /// Frequency, Hz.
    #[serde(rename = "f")]
    pub frequency: f64,
    /// Frequency over that of the shaft, where it turns.
    #[serde(rename = "o")]
    pub order: Option<f64>,
    /// Amplitude of every displacement that moves.
    #[serde(rename = "a")]
    pub amplitudes: Vec<f64>,
}

/// A peak of the spectrum of a displacement.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct KeptPeak {
    /// The displacement.
    #[serde(rename = "c")]
    pub channel: Channel,
    /// Frequency between the bins, Hz.
    #[serde(rename = "f")]
    pub frequency: f64,
    /// Frequency over that of the shaft, where it turns.
    #[serde(rename = "o")]
    pub order: Option<f64>,
    /// Amplitude, m or rad.
    #[serde(rename = "a")]
    pub amplitude: f64,
    /// What causes it, where that is known.
    #[serde(rename = "n")]
    pub name: Option<String>,
}

/// How stiffly one bearing holds the shaft at the static equilibrium, and its part of the damping.
///
/// The entries [`BearingStiffness::ENTRIES`]: those that do not depend on which way the bearing faces, and that
/// a bearing without tilts has.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BearingStiffness {
    /// Number of the bearing, from 1 on.
    pub bearing: usize,
    /// Speed of the shaft there, rad/s.
    pub speed: f64,
    /// K, N/m.
    pub stiffness: [f64; 5],
    /// Part of C in the proportion of the stiffness, entry by entry, N s/m: what damps the shaft belongs to
    /// no bearing by itself.
    pub damping: [f64; 5],
}

impl BearingStiffness {
    /// Names, rows and columns of the entries, x before y before z.
    pub const ENTRIES: [(&str, (usize, usize)); 5] = [
        ("xx", (0, 0)),
        ("xy", (0, 1)),
        ("yx", (1, 0)),
        ("yy", (1, 1)),
        ("zz", (2, 2)),
    ];
}

/// Position of the shaft at one instant.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// Time, s.
    #[serde(rename = "t")]
    pub time: f64,
    /// Displacements that move, m and rad.
    #[serde(rename = "x")]
    pub displacement: Vec<f64>,
}

/// Where the next run of a chain starts.
///
/// The shaft has its angle at the start again. With unbalance it ends at a whole revolution, and the balls
/// are where the cages have brought them; without, it ends where a ball has come to the position of another,
/// and the balls are where they began.
#[derive(Debug, Clone)]
pub(super) struct Carried {
    sample: Sample,
    /// Azimuths of ball 0 of every bearing, rad.
    first_balls: Vec<f64>,
}

impl Carried {
    /// Lets a motion start there.
    pub(super) fn start(&self, model: &mut Model) {
        let rotor = &mut model.rotor;
        rotor.initial = InitialState {
            from: InitialPosition::Equilibrium,
            displacement: self.sample.displacement.map(Some),
            velocity: self.sample.velocity.map(Some),
        };
        for (bearing, azimuth) in rotor.bearings.iter_mut().zip(&self.first_balls) {
            bearing.first_ball = *azimuth;
        }
    }
}

/// What is taken of the samples of a run.
pub(super) struct RunSink {
    pub(super) end: Option<End>,
    pub(super) trace: Option<Box<dyn KeptTrace>>,
}

impl RunSink {
    /// Of a run that another one follows, or none.
    pub(super) fn new(model: &Model, followed: bool, trace: Option<Box<dyn KeptTrace>>) -> Self {
        Self {
            end: followed.then(|| End::new(model)),
            trace,
        }
    }
}

impl TraceSink for RunSink {
    fn starts_at(&self) -> f64 {
        match (&self.trace, &self.end) {
            (None, None) => f64::INFINITY,
            (None, Some(end)) => end.start,
            (Some(_), _) => 0.0,
        }
    }

    fn needs_acceleration(&self) -> bool {
        let trace = self.trace.as_ref();
        trace.is_some_and(|trace| trace.needs_acceleration())
    }

    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        if let Some(end) = &mut self.end {
            end.take(sample);
        }
        match &mut self.trace {
            Some(trace) => trace.sample(sample),
            None => Ok(()),
        }
    }
}

/// Finds the sample nearest to the end of the last cycle.
pub(super) struct End {
    /// Turns of the shaft after which the scene is as it was.
    cycle: f64,
    /// Time before which the last cycle cannot end, s.
    start: f64,
    /// Angle of the sample before.
    before: Option<f64>,
    whole: Option<Sample>,
}

impl End {
    fn new(model: &Model) -> Self {
        let cycle = cycle(model);
        let speed = model.rotor.speed.abs();
        let steady = model.rotor.speed_points.is_empty() && model.rotor.drive.is_none();
        let last = match steady && speed > 0.0 {
            // a cycle ends in every one, and the grid may end a little earlier
            true => model.duration - 2.0 * TAU * cycle / speed,
            false => 0.0,
        };
        Self {
            cycle,
            start: last.max(0.0),
            before: None,
            whole: None,
        }
    }

    /// The first sample is at the end of no cycle.
    fn take(&mut self, sample: &Sample) {
        let cycles = sample.angle / (TAU * self.cycle);
        let since = |before| (sample.angle - before) / (TAU * self.cycle);
        let since = self.before.map_or(1.0, since);
        if (cycles - cycles.round()).abs() <= 0.5 * since {
            self.whole = Some(sample.without_bearings());
        }
        self.before = Some(sample.angle);
    }

    /// Where the next run of a chain starts.
    pub(super) fn carried(&self, model: &Model) -> Option<Carried> {
        let sample = self.whole.clone()?;
        let rotor = &model.rotor;
        let turned = match rotor.shaft.is_unbalanced() {
            true => sample.angle,
            false => 0.0,
        };
        // it has run, so that it can be built
        let supports = rotor.rolling_supports().ok()?;
        let bearings = rotor.bearings.iter().zip(supports);
        let first_balls = bearings.map(|(bearing, support)| {
            (bearing.first_ball + support.cage_ratio() * turned).rem_euclid(TAU)
        });
        Some(Carried {
            sample,
            first_balls: first_balls.collect(),
        })
    }
}

/// Turns of the shaft after which unbalance or, without one, the balls of the first bearing are where they
/// were.
fn cycle(model: &Model) -> f64 {
    let rotor = &model.rotor;
    let supports = rotor.rolling_supports().unwrap_or_default();
    let passes = supports.first().map(Support::passes);
    match passes.filter(|passes| *passes > 0.0 && !rotor.shaft.is_unbalanced()) {
        Some(passes) => passes.recip(),
        None => 1.0,
    }
}
