//! Takes the samples of a steady motion and says what it is like.

use std::collections::VecDeque;

use serde::Serialize;

use super::moments::{Drift, DriftRecorder, Moments, VelocityLevel, velocity_level};
use super::period::{Kind, Recognition, Series, recognise};
use super::section::{NODES, PoincarePoint, Section, SectionKind};
use crate::analysis::{Channel, NoiseFloor};
use crate::keys;
use crate::rotor::{FREEDOMS, Sample};

/// Number of freedoms that are lengths.
const LENGTHS: usize = 3;
/// A motion below this part of the displacement is round-off.
const REST: f64 = 1e-9;
/// Samples that the orbit keeps: the last ones.
const ORBIT: usize = 8192;

/// Samples that statistics and sections are taken of at a time.
const BLOCK: usize = 64;

/// Most samples that room is made for before they come.
const FORESEEN: usize = 1 << 16;

/// What the recorder must know of the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionSettings {
    /// Number of freedoms that move.
    pub freedoms: usize,
    /// Time from which on samples count, s.
    pub start: f64,
    /// Time of the last sample, s.
    pub end: f64,
    /// Samples a second.
    pub rate: f64,
    /// Lengths that make displacements of tilts, 1 for those that are lengths.
    pub levers: [f64; FREEDOMS],
    /// Sections, each with its cycles a revolution; none where the shaft stands.
    pub sections: Vec<(SectionKind, f64)>,
    /// What is found out; of the sections those that it [has](MotionParts::has).
    pub parts: MotionParts,
}

/// Statistics of one quantity.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ChannelStatistics {
    /// The quantity.
    #[serde(serialize_with = "Channel::serialize_with_unit")]
    pub channel: Channel,
    /// Its moments.
    #[serde(flatten)]
    pub moments: Moments,
}

/// What a steady motion is like.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Motion {
    /// First sample, s.
    #[serde(rename = "start_s")]
    pub start: f64,
    /// Last sample, s.
    #[serde(rename = "end_s")]
    pub end: f64,
    /// Displacements and forces of the freedoms that move; forces where asked for.
    pub statistics: Vec<ChannelStatistics>,
    /// RMS velocity of the lengths that move, in their order, where asked for.
    #[serde(rename = "velocity_rms", serialize_with = "keys::by_axis")]
    pub velocity: Vec<Option<VelocityLevel>>,
    /// What kind of motion it is; unknown where not asked for.
    #[serde(flatten)]
    pub recognition: Recognition,
    /// How its statistics move, where asked for; none at rest.
    #[serde(skip)]
    pub drift: Option<Drift>,
    /// Points of every section that is looked at.
    pub sections: Vec<Section>,
    /// Samples a second.
    #[serde(skip)]
    pub rate: f64,
    /// x and y of the last samples, m, where asked for.
    #[serde(skip)]
    pub orbit: Vec<[f64; 2]>,
}

/// Takes samples at equal times and constant speed.
///
/// Beside three velocities a sample its memory grows with the sections' points only.
#[derive(Debug, Clone)]
pub struct MotionRecorder {
    settings: MotionSettings,
    freedoms: usize,
    statistics: Vec<ChannelStatistics>,
    rates: [Moments; FREEDOMS],
    velocity: Vec<Vec<f64>>,
    drift: Option<DriftRecorder>,
    sections: Vec<Section>,
    orbit: VecDeque<[f64; 2]>,
    times: Option<[f64; 2]>,
    /// Samples that are still to be taken, behind the last ones of the block before.
    block: Vec<Sample>,
    /// Number of those of the block before.
    taken: usize,
    /// One quantity of the samples that are taken.
    values: Vec<f64>,
}

impl MotionRecorder {
    /// For one scene.
    pub fn new(settings: MotionSettings) -> Self {
        let freedoms = settings.freedoms.min(FREEDOMS);
        let parts = settings.parts;
        let forces = if parts.forces { freedoms } else { 0 };
        let displacements = (0..freedoms).map(Channel::Displacement);
        let channels = displacements.chain((0..forces).map(Channel::Force));
        let sections = settings.sections.iter();
        let lengths = if parts.velocity {
            freedoms.min(LENGTHS)
        } else {
            0
        };
        let expected = (settings.end - settings.start) * settings.rate + 2.0;
        let room = (expected as usize).min(FORESEEN);
        Self {
            freedoms,
            statistics: channels
                .map(|channel| ChannelStatistics {
                    channel,
                    moments: Moments::default(),
                })
                .collect(),
            rates: [Moments::default(); FREEDOMS],
            velocity: (0..lengths).map(|_| Vec::with_capacity(room)).collect(),
            drift: parts
                .drift
                .then(|| DriftRecorder::new(settings.start, settings.end)),
            sections: sections
                .filter(|(kind, _)| parts.has(*kind))
                .map(|(kind, order)| Section::new(*kind, *order))
                .collect(),
            orbit: VecDeque::new(),
            times: None,
            block: Vec::with_capacity(NODES - 1 + BLOCK),
            taken: 0,
            values: Vec::with_capacity(NODES - 1 + BLOCK),
            settings,
        }
    }

    /// Takes one sample; those before the start are dropped.
    pub fn record(&mut self, sample: &Sample) {
        if sample.time < self.settings.start {
            return;
        }
        self.block.push(*sample);
        if self.block.len() == NODES - 1 + BLOCK {
            self.take_block();
        }
    }

    /// Takes the samples that are still to be taken.
    fn take_block(&mut self) {
        let parts = self.settings.parts;
        for section in &mut self.sections {
            section.record(&self.block, self.taken);
        }
        let fresh = &self.block[self.taken..];
        if let [Some(first), Some(last)] = [fresh.first(), fresh.last()] {
            let first = self.times.map_or(first.time, |[first, _]| first);
            self.times = Some([first, last.time]);
        }
        let values = &mut self.values;
        for ChannelStatistics { channel, moments } in &mut self.statistics {
            values.clear();
            values.extend(fresh.iter().filter_map(|sample| channel.of(sample)));
            moments.take(values);
        }
        if parts.kind {
            for (axis, rate) in self.rates[..self.freedoms].iter_mut().enumerate() {
                values.clear();
                values.extend(fresh.iter().map(|sample| sample.velocity[axis]));
                rate.take(values);
            }
        }
        for (axis, kept) in self.velocity.iter_mut().enumerate() {
            kept.extend(fresh.iter().map(|sample| sample.velocity[axis]));
        }
        if let Some(drift) = &mut self.drift {
            fresh.iter().for_each(|sample| drift.record(sample));
        }
        if parts.orbit {
            let places = fresh.iter().map(|sample| sample.displacement);
            self.orbit.extend(places.map(|[x, y, ..]| [x, y]));
            let beyond = self.orbit.len().saturating_sub(ORBIT);
            self.orbit.drain(..beyond);
        }
        let done = self.block.len().saturating_sub(NODES - 1);
        self.block.drain(..done);
        self.taken = self.block.len();
    }

    /// What the motion is like; none without samples.
    pub fn finish(mut self) -> Option<Motion> {
        self.take_block();
        let [start, end] = self.times?;
        let [place, rate] = self.scales();
        let resting = place <= REST * self.largest_mean();
        let at_once = |kind| Recognition {
            kind,
            distances: Vec::new(),
            curves: Vec::new(),
        };
        let recognition = if resting {
            at_once(Kind::Rest)
        } else if self.settings.parts.kind {
            recognise(&self.series(place, rate))
        } else {
            at_once(Kind::Unknown {
                points: 0,
                test: None,
            })
        };
        let drift = self.drift.as_ref();
        let drift = drift.and_then(|drift| drift.finish(&self.settings.levers, place));
        let magnitudes = self.statistics.iter();
        let magnitudes = magnitudes.map(|each| (each.channel, each.moments.magnitude()));
        let floor = NoiseFloor::of(magnitudes, self.settings.rate);
        let mut statistics = self.statistics;
        for ChannelStatistics { channel, moments } in &mut statistics {
            *moments = moments.above(floor.below(*channel));
        }
        let velocity = self.velocity.into_iter();
        Some(Motion {
            start,
            end,
            statistics,
            velocity: velocity
                .map(|values| velocity_level(values, self.settings.rate))
                .collect(),
            recognition,
            drift: drift.filter(|_| !resting),
            sections: self.sections,
            rate: self.settings.rate,
            orbit: self.orbit.into(),
        })
    }

    /// RMS of the displacements, and of their rates, of the freedom where they are largest, m and m/s.
    fn scales(&self) -> [f64; 2] {
        let levers = &self.settings.levers[..self.freedoms];
        let largest = |rms: &dyn Fn(usize) -> f64| {
            let sizes = levers
                .iter()
                .enumerate()
                .map(|(axis, lever)| lever * rms(axis));
            sizes.fold(0.0, f64::max)
        };
        [
            largest(&|axis| self.statistics[axis].moments.rms()),
            largest(&|axis| self.rates[axis].rms()),
        ]
    }

    /// Largest mean displacement, m.
    fn largest_mean(&self) -> f64 {
        let levers = self.settings.levers.iter();
        let means = levers.zip(&self.statistics[..self.freedoms]);
        means
            .map(|(lever, each)| lever * each.moments.mean().abs())
            .fold(0.0, f64::max)
    }

    /// The sections' points in parts of the motion.
    fn series(&self, place: f64, rate: f64) -> Vec<Series> {
        let parts = |point: &PoincarePoint| -> Vec<f64> {
            let axes = 0..self.freedoms;
            axes.flat_map(|axis| {
                let lever = self.settings.levers[axis];
                [
                    lever * point.displacement[axis] / place,
                    lever * point.velocity[axis] / rate,
                ]
            })
            .collect()
        };
        let series = self.sections.iter().map(|section| Series {
            kind: section.kind,
            order: section.order,
            points: section.points.iter().map(parts).collect(),
        });
        series.collect()
    }
}

/// What is found out of a steady motion beside the moments of its displacements; by default everything.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MotionParts {
    /// Moments of the bearing forces.
    pub forces: bool,
    /// RMS velocities in the band of the standards.
    pub velocity: bool,
    /// How the statistics move.
    pub drift: bool,
    /// Its kind, which rests on the points of all sections.
    pub kind: bool,
    /// The points of one section, where its kind is not asked for.
    pub section: Option<SectionKind>,
    /// x and y of the last samples.
    pub orbit: bool,
}

impl MotionParts {
    /// Everything.
    pub const ALL: Self = Self {
        forces: true,
        velocity: true,
        drift: true,
        kind: true,
        section: None,
        orbit: true,
    };

    /// The moments of the displacements alone.
    pub const DISPLACEMENTS: Self = Self {
        forces: false,
        velocity: false,
        drift: false,
        kind: false,
        section: None,
        orbit: false,
    };

    /// Whether the points of a section are looked for.
    pub fn has(&self, section: SectionKind) -> bool {
        self.kind || self.section == Some(section)
    }
}

impl Default for MotionParts {
    fn default() -> Self {
        Self::ALL
    }
}
