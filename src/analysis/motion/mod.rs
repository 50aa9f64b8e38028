//! What a steady motion is like: statistics, points once per revolution and per ball pass, its period,
//! and whether it has settled.

mod closed_curve;
mod moments;
mod period;
mod section;
mod velocity_level;

#[cfg(test)]
pub use closed_curve::closed_curve;
pub use moments::{Drift, Moments};
pub use period::{Kind, LONGEST_PERIOD, Recognition, Series, recognise};
pub use section::{PoincarePoint, Section, SectionKind};

pub use velocity_level::{LevelRecorder, Rate, VelocityLevel, velocity_rate};

use std::collections::VecDeque;

use realfft::RealFftPlanner;
use serde::Serialize;

use super::{Channel, NoiseFloor};
use crate::keys;
use crate::rotor::{FREEDOMS, Freedoms, Sample};
use moments::{DriftRecorder, GrowthRecorder};
use section::{NODES, Node};

/// A motion below this part of the displacement is round-off.
const AT_REST: f64 = 1e-9;
/// A motion beyond it in m, or m/s, has no bounds: no shaft goes so far or so fast.
const BEYOND_BOUNDS: f64 = 1e6;
/// Samples that the orbit keeps: the last ones.
const ORBIT: usize = 8192;

/// What the recorder must know of the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionSettings {
    /// Number of freedoms that move.
    pub freedoms: Freedoms,
    /// Time from which on samples count, s.
    pub start: f64,
    /// Time of the last sample, s.
    pub end: f64,
    /// Samples a second.
    pub rate: f64,
    /// Lengths that make displacements of tilts, 1 for those that are lengths.
    pub levers: [f64; FREEDOMS],
    /// Sections, each with its cycles a revolution; none where the shaft does not turn.
    pub sections: Vec<(SectionKind, f64)>,
    /// What is described besides: motions of housings, forces of single bearings.
    pub parts: Vec<Channel>,
    /// Velocities of housings whose RMS is asked for.
    pub housing_velocities: Vec<Channel>,
    /// Time of a revolution, s; none where the shaft does not turn.
    pub revolution: Option<f64>,
    /// Ball passes a revolution of the bearings.
    pub passes: Vec<f64>,
    /// Band of the RMS velocities, Hz; none where they are left out.
    pub velocity_band: Option<[f64; 2]>,
    /// Whether the kind of the motion is recognised, by the points of the sections.
    pub kind: bool,
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

/// RMS velocity of one quantity.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ChannelLevel {
    /// The quantity.
    #[serde(serialize_with = "Channel::serialize_with_unit")]
    pub channel: Channel,
    /// Its RMS.
    #[serde(flatten)]
    pub level: VelocityLevel,
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
    /// Displacements and forces of the freedoms that move; forces where they are observed. Then displacements of the
    /// housings, and forces of each of several bearings.
    pub statistics: Vec<ChannelStatistics>,
    /// RMS velocity of the lengths that move, in their order.
    #[serde(rename = "velocity_rms", serialize_with = "keys::by_axis")]
    pub(crate) velocity: Vec<Option<VelocityLevel>>,
    /// RMS velocity of the housings along X and Y, bearing by bearing.
    #[serde(rename = "housing_velocity_rms", skip_serializing_if = "Vec::is_empty")]
    pub(crate) housing_velocity: Vec<ChannelLevel>,
    /// What kind of motion it is; unknown where not asked for.
    #[serde(flatten)]
    pub recognition: Recognition,
    /// How its statistics move; none at rest.
    #[serde(skip)]
    pub drift: Option<Drift>,
    /// Points of every section that was asked for.
    pub(crate) sections: Vec<Section>,
    /// Whether chance has a part in it.
    #[serde(skip)]
    pub random: bool,
    /// Samples a second.
    #[serde(skip)]
    pub rate: f64,
    /// x and y of the last samples, m.
    #[serde(skip)]
    pub orbit: Vec<[f64; 2]>,
}

impl Motion {
    /// Whether the motion has settled: it repeats, or its statistics hardly move; not where it grows beyond all bounds. Not known
    /// of an irregular or random one, whose statistics move by themselves, and of a record without a drift.
    pub fn has_settled(&self) -> Option<bool> {
        if self.recognition.kind == Kind::Diverging {
            return Some(false);
        }
        let drift = self.drift.as_ref()?;
        match self.recognition.kind {
            Kind::Irregular { .. } => None,
            _ if self.random => None,
            Kind::Periodic { .. } => Some(true),
            _ => Some(drift.is_settled()),
        }
    }
}

/// Takes samples at equal times and constant speed.
///
/// Its memory does not grow with their number.
pub struct MotionRecorder {
    settings: MotionSettings,
    statistics: Vec<ChannelStatistics>,
    rates: [Moments; FREEDOMS],
    velocity: Vec<LevelRecorder>,
    housing_velocity: Vec<(Channel, LevelRecorder)>,
    planner: RealFftPlanner<f64>,
    drift: DriftRecorder,
    growth: GrowthRecorder,
    sections: Vec<Section>,
    orbit: VecDeque<[f64; 2]>,
    times: Option<[f64; 2]>,
    /// The last samples, which points of sections are interpolated between, and how many there have been.
    last: ([Node; NODES], usize),
}

impl MotionRecorder {
    /// For one scene.
    pub fn new(settings: MotionSettings) -> Self {
        let channels = Channel::of_freedoms(settings.freedoms).into_iter();
        let statistics = channels.chain(settings.parts.iter().copied());
        let statistics = statistics.map(|channel| ChannelStatistics {
            channel,
            moments: Moments::default(),
        });
        let level = |band| LevelRecorder::new(settings.rate, band);
        let level = settings.velocity_band.map(level);
        let housings = settings.housing_velocities.iter();
        let housings = housings.filter_map(|channel| Some((*channel, level.clone()?)));
        let sections = settings.sections.iter();
        Self {
            statistics: statistics.collect(),
            rates: [Moments::default(); FREEDOMS],
            housing_velocity: housings.collect(),
            velocity: level.map_or_else(Vec::new, |level| vec![level; settings.freedoms.lengths()]),
            planner: RealFftPlanner::new(),
            drift: DriftRecorder::new(
                [settings.start, settings.end],
                settings.revolution,
                &settings.passes,
            ),
            growth: GrowthRecorder::new([settings.start, settings.end]),
            sections: sections
                .map(|(kind, order)| Section::new(*kind, *order))
                .collect(),
            orbit: VecDeque::new(),
            times: None,
            last: Default::default(),
            settings,
        }
    }

    /// Takes one sample; those before the start are dropped.
    pub fn record(&mut self, sample: &Sample) {
        if sample.time < self.settings.start {
            return;
        }
        let first = self.times.map_or(sample.time, |[first, _]| first);
        self.times = Some([first, sample.time]);
        for ChannelStatistics { channel, moments } in &mut self.statistics {
            if let Some(value) = channel.value(sample) {
                moments.take(value);
            }
        }
        if self.settings.kind {
            for (rate, value) in self.rates.iter_mut().zip(sample.velocity) {
                rate.take(value);
            }
            self.growth.record(sample);
        }
        for (level, value) in self.velocity.iter_mut().zip(sample.velocity) {
            level.take(value, &mut self.planner);
        }
        for (channel, level) in &mut self.housing_velocity {
            if let Some(value) = channel.value(sample) {
                level.take(value, &mut self.planner);
            }
        }
        self.drift.record(sample);
        if self.orbit.len() == ORBIT {
            self.orbit.pop_front();
        }
        let [x, y, ..] = sample.displacement;
        self.orbit.push_back([x, y]);
        self.record_sections(sample);
    }

    fn record_sections(&mut self, sample: &Sample) {
        let (nodes, taken) = &mut self.last;
        nodes.rotate_left(1);
        nodes[NODES - 1] = Node::from_sample(sample);
        *taken += 1;
        if *taken >= NODES {
            for section in &mut self.sections {
                section.record(nodes);
            }
        }
    }

    /// What the motion is like; none without samples.
    pub fn finish(mut self) -> Option<Motion> {
        let [start, end] = self.times?;
        let of_axis = |axis: usize| {
            let mut all = self.statistics.iter();
            let own = all.find(|own| own.channel == Channel::Displacement(axis));
            own.map_or(Moments::default(), |own| own.moments)
        };
        let displacement = self.largest(|axis| of_axis(axis).rms());
        let mean = self.largest(|axis| of_axis(axis).mean().abs());
        let resting = displacement <= AT_REST * mean;
        let bounded = self.is_bounded(|axis| [of_axis(axis), self.rates[axis]]);
        let at_once = |kind| Recognition {
            kind,
            distances: Vec::new(),
            curves: Vec::new(),
        };
        let diverges = !bounded || self.growth.is_exponential(&self.settings.levers);
        let recognition = if diverges {
            at_once(Kind::Diverging)
        } else if resting {
            at_once(Kind::Rest)
        } else if self.settings.kind {
            recognise(&self.series(displacement))
        } else {
            at_once(Kind::Unknown {
                points: 0,
                test: None,
            })
        };
        let drift = self.drift.finish(&self.settings.levers, displacement);
        let magnitudes = self.statistics.iter();
        let magnitudes = magnitudes.map(|each| (each.channel, each.moments.magnitude()));
        let floor = NoiseFloor::new(magnitudes, self.settings.rate);
        let mut statistics = self.statistics;
        for ChannelStatistics { channel, moments } in &mut statistics {
            *moments = moments.above(floor.below(*channel));
        }
        let velocity = self.velocity.into_iter();
        let planner = &mut self.planner;
        let housing_velocity = self.housing_velocity.into_iter();
        Some(Motion {
            random: false,
            start,
            end,
            statistics,
            velocity: velocity.map(|level| level.finish(planner)).collect(),
            housing_velocity: housing_velocity
                .filter_map(|(channel, level)| {
                    let level = level.finish(planner)?;
                    Some(ChannelLevel { channel, level })
                })
                .collect(),
            recognition,
            drift: drift.filter(|_| bounded && !resting),
            sections: self.sections.into_iter().map(Section::of_last).collect(),
            rate: self.settings.rate,
            orbit: self.orbit.into(),
        })
    }

    /// Largest of a number of every freedom that moves, as displacements or their rates: tilts by their lever.
    fn largest(&self, of_freedom: impl Fn(usize) -> f64) -> f64 {
        let axes = self.settings.freedoms.axes().iter();
        axes.map(|axis| self.settings.levers[*axis] * of_freedom(*axis))
            .fold(0.0, f64::max)
    }

    /// Whether all freedoms that move have finite displacements and rates, of a size that a shaft can have.
    fn is_bounded(&self, of_freedom: impl Fn(usize) -> [Moments; 2]) -> bool {
        let mut axes = self.settings.freedoms.axes().iter();
        axes.all(|axis| {
            let mut all = of_freedom(*axis).into_iter();
            // what is not a number is not below the bound either
            all.all(|own| own.mean().abs() < BEYOND_BOUNDS && own.rms() < BEYOND_BOUNDS)
        })
    }

    /// The sections' points in parts of the motion.
    fn series(&self, displacement: f64) -> Vec<Series> {
        let rate = self.largest(|axis| self.rates[axis].rms());
        let parts = |point: &PoincarePoint| -> Vec<f64> {
            let axes = self.settings.freedoms.axes().iter();
            axes.flat_map(|&axis| {
                let lever = self.settings.levers[axis];
                [
                    lever * point.displacement[axis] / displacement,
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
