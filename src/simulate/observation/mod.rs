//! What a run observes of its bearings beside the trace: events, load zone, life.

mod contact_watch;
mod event;
mod history;
mod life;
mod load_zone;

use std::io;

pub use event::{Event, EventCount, EventKind};
pub use history::BearingHistory;
pub use life::{ConsumedLife, LifeHistory};
pub use load_zone::{LoadZone, Spread};

use super::{Model, TraceSink, Watched};
use crate::bearing::{ContactBand, Support};
use crate::rotor::{BallContacts, Rotor, Sample};
use contact_watch::ContactWatch;
use event::EventCounts;
use life::LifeSums;
use load_zone::LoadZoneSums;

/// Watches all bearings of a rotor, sample by sample: the same samples give the same result.
#[derive(Debug)]
pub(super) struct Observation<'a> {
    contacts: BallContacts,
    bearings: Vec<BearingObserver<'a>>,
    /// Events since the sample before, in the order of time.
    found: Vec<Event>,
    settle: f64,
}

/// Watches one bearing.
#[derive(Debug)]
struct BearingObserver<'a> {
    support: &'a Support,
    /// Speed in rad/s and where contacts part at it.
    band: (f64, ContactBand),
    watch: ContactWatch,
    counts: EventCounts,
    zone: LoadZoneSums,
    life: Option<LifeSums>,
}

impl<'a> Observation<'a> {
    pub fn new(model: &Model, rotor: &'a Rotor) -> Self {
        let contacts = match model.analyses.watched {
            Watched::Balls => rotor.ball_contacts(),
            Watched::Forces => rotor.unwatched_balls(true),
            Watched::Nothing => rotor.unwatched_balls(false),
        };
        let observer = |(index, support)| {
            let speed = rotor.speed();
            BearingObserver::new(index, support, speed, model.settle)
        };
        Self {
            // a ball and its bearing can each do one thing between two samples
            found: Vec::with_capacity(contacts.bearings().map(|balls| balls.len() + 1).sum()),
            bearings: rotor.supports().iter().enumerate().map(observer).collect(),
            contacts,
            settle: model.settle,
        }
    }

    /// Where the rotor leaves what it observes of the balls.
    pub fn contacts(&mut self) -> &mut BallContacts {
        &mut self.contacts
    }

    /// Takes the sample whose balls stand in [`Observation::contacts`], and hands balls and events on.
    pub fn take(&mut self, sample: &Sample, sink: &mut dyn TraceSink) -> io::Result<()> {
        sink.balls(sample, &self.contacts)?;
        let settled = sample.time >= self.settle;
        self.found.clear();
        for (index, bearing) in self.bearings.iter_mut().enumerate() {
            bearing.take(index, sample, &self.contacts, settled, &mut self.found);
        }
        self.found.sort_unstable_by(Event::order);
        self.found.iter().try_for_each(|event| sink.event(event))
    }

    /// What was observed, bearing by bearing.
    pub fn finish(self) -> Vec<BearingHistory> {
        let history = |bearing: BearingObserver<'_>| BearingHistory {
            balls: bearing.support.known_balls(),
            events: bearing.counts.finish(),
            load_zone: bearing.zone.finish(),
            life: bearing.life.and_then(LifeSums::finish),
        };
        self.bearings.into_iter().map(history).collect()
    }
}

impl<'a> BearingObserver<'a> {
    fn new(index: usize, support: &'a Support, speed: f64, settle: f64) -> Self {
        let bearing = &support.definition().bearing;
        let (balls, preloaded) = (support.known_balls(), support.is_preloaded());
        let rated = bearing.dynamic_rating.filter(|_| balls > 0);
        Self {
            support,
            band: (speed, support.contact_band(speed)),
            watch: ContactWatch::new(index, balls, preloaded),
            counts: EventCounts::new(balls > 0, preloaded),
            zone: LoadZoneSums::default(),
            life: rated.map(|rating| LifeSums::new(&bearing.geometry, rating, settle)),
        }
    }

    fn take(
        &mut self,
        index: usize,
        sample: &Sample,
        contacts: &BallContacts,
        settled: bool,
        found: &mut Vec<Event>,
    ) {
        let balls = contacts.of_bearing(index);
        if balls.is_empty() {
            return;
        }
        if self.band.0 != sample.speed {
            self.band = (sample.speed, self.support.contact_band(sample.speed));
        }
        let already = found.len();
        let axial = contacts.axial_forces()[index];
        self.watch
            .take(sample.time, self.band.1, balls, axial, found);
        found[already..]
            .iter()
            .for_each(|event| self.counts.add(event));
        if settled {
            self.zone.take(balls, contacts.least_load());
        }
        if let Some(life) = &mut self.life {
            life.take(sample, balls);
        }
    }
}
