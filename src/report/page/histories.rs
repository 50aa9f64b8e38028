//! What is drawn over time.

use serde_json::Value;

use super::curve::{BUCKETS, Panel, curve};
use crate::analysis::Channel;
use crate::report::terminal::MICRO;
use crate::report::{Bucket, Decimator};
use crate::rotor::Sample;

/// A column of the samples over time.
#[derive(Debug, Clone)]
struct History {
    channel: Channel,
    envelope: Decimator,
}

/// What is drawn beside displacements and forces, with its name on the page.
const FURTHER: [(Channel, &str); 5] = [
    (Channel::LargestBallLoad, "largest ball load"),
    (Channel::BallsLoaded, "loaded balls"),
    (Channel::Speed, "speed"),
    (Channel::KINETIC_ENERGY, "kinetic energy"),
    (Channel::STORED_ENERGY, "stored energy"),
];

/// Every quantity that the page draws over time.
#[derive(Debug, Clone)]
pub(super) struct Histories {
    histories: Vec<History>,
}

impl Histories {
    /// For the first `freedoms` of x, y, z, θx, θy.
    pub fn new(freedoms: usize) -> Self {
        let moving = Channel::of_freedoms(freedoms).into_iter();
        let further = FURTHER.iter().map(|(channel, _)| *channel);
        let history = |channel| History {
            channel,
            envelope: Decimator::new(BUCKETS),
        };
        Self {
            histories: moving.chain(further).map(history).collect(),
        }
    }

    /// Takes one sample.
    pub fn sample(&mut self, sample: &Sample) {
        for history in &mut self.histories {
            if let Some(value) = history.channel.of(sample) {
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
        self.channel.freedom().is_some() || !(constant(first) && values.all(constant))
    }

    fn panel(&self) -> Value {
        let named = FURTHER.iter().find(|(channel, _)| *channel == self.channel);
        let name = named.map_or(self.channel.name(), |(_, name)| name);
        let (scale, unit) = match self.channel.unit() {
            "m" => (MICRO, "µm"),
            "rad" => (MICRO, "µrad"),
            unit => (1.0, unit),
        };
        let panel = Panel {
            name,
            unit,
            over: ["time", "s"],
            shown: None,
            logarithmic: false,
        };
        let points = self.envelope.buckets().flat_map(distinct);
        let points = points.map(|(time, value)| (time, scale * value));
        panel.json(vec![curve(name, points)], Vec::new())
    }
}

/// The extremes of a bucket, once where it holds a single value.
fn distinct(Bucket { first, last }: Bucket) -> impl Iterator<Item = (f64, f64)> {
    std::iter::once(first).chain((first != last).then_some(last))
}
