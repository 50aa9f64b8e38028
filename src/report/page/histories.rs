//! What is drawn over time.

use serde_json::Value;

use super::curve::{BUCKETS, Panel, curve};
use crate::analysis::Channel;
use crate::report::{Bucket, Decimator};
use crate::rotor::{FREEDOMS, Sample};

/// m → µm, rad → µrad.
const MICRO: f64 = 1e6;

/// A quantity of a sample over time; none where the sample does not know it.
#[derive(Debug, Clone)]
struct History {
    name: &'static str,
    unit: &'static str,
    value: Quantity,
    envelope: Decimator,
}

#[derive(Debug, Clone, Copy)]
enum Quantity {
    Of(Channel),
    Speed,
    LargestBallLoad,
    Loaded,
    Kinetic,
    Stored,
}

impl Quantity {
    fn of(self, sample: &Sample) -> Option<f64> {
        Some(match self {
            Self::Of(channel @ Channel::Displacement(_)) => MICRO * channel.of(sample)?,
            Self::Of(channel) => channel.of(sample)?,
            Self::Speed => sample.speed,
            Self::LargestBallLoad => sample.largest_ball_load,
            Self::Loaded => f64::from(sample.balls_loaded),
            Self::Kinetic => sample.energy?.kinetic,
            Self::Stored => sample.energy?.stored,
        })
    }
}

/// Every quantity that the page draws over time.
#[derive(Debug, Clone)]
pub(super) struct Histories {
    histories: Vec<History>,
}

impl Histories {
    /// For the first `freedoms` of x, y, z, θx, θy.
    pub fn new(freedoms: usize) -> Self {
        let channels = Channel::of_freedoms(freedoms.min(FREEDOMS));
        let moving = channels
            .into_iter()
            .map(|channel| (channel.name(), unit(channel), Quantity::Of(channel)));
        let others = [
            ("largest ball load", "N", Quantity::LargestBallLoad),
            ("loaded balls", "", Quantity::Loaded),
            ("speed", "rad/s", Quantity::Speed),
            ("kinetic energy", "J", Quantity::Kinetic),
            ("stored energy", "J", Quantity::Stored),
        ];
        let history = |(name, unit, value)| History {
            name,
            unit,
            value,
            envelope: Decimator::new(BUCKETS),
        };
        Self {
            histories: moving.chain(others).map(history).collect(),
        }
    }

    /// Takes one sample.
    pub fn sample(&mut self, sample: &Sample) {
        for history in &mut self.histories {
            if let Some(value) = history.value.of(sample) {
                history.envelope.push(sample.time, value);
            }
        }
    }

    /// One panel each, but for what is unknown and for what says nothing because it never changes.
    pub fn panels(&self) -> Vec<Value> {
        let told = self.histories.iter().filter(|history| history.tells());
        told.map(History::panel).collect()
    }
}

impl History {
    /// Displacements and forces always tell; anything else only where it changes.
    fn tells(&self) -> bool {
        let mut values = self.envelope.buckets();
        let Some(first) = values.next() else {
            return false;
        };
        let constant = |bucket: Bucket| bucket.low() == first.low() && bucket.high() == first.low();
        matches!(self.value, Quantity::Of(_)) || !(constant(first) && values.all(constant))
    }

    fn panel(&self) -> Value {
        let panel = Panel {
            name: self.name,
            unit: self.unit,
            over: ["time", "s"],
            shown: None,
            logarithmic: false,
        };
        let points = self.envelope.buckets().flat_map(distinct);
        panel.json(vec![curve(self.name, points)], Vec::new())
    }
}

/// The extremes of a bucket, once where it holds a single value.
fn distinct(Bucket { first, last }: Bucket) -> impl Iterator<Item = (f64, f64)> {
    std::iter::once(first).chain((first != last).then_some(last))
}

fn unit(channel: Channel) -> &'static str {
    match channel.unit() {
        "m" => "µm",
        "rad" => "µrad",
        other => other,
    }
}
