//! What a run observes of its bearings besides the trace: events, load zone, life.

mod contact_watch;
mod event;
mod life;
mod load_zone;
mod peak_loads;

use std::io;

use serde::Serialize;

pub use event::{Event, EventCount, EventKind};
#[cfg(test)]
pub use life::ConsumedLife;
pub use life::LifeHistory;
pub use load_zone::{LoadZone, Spread};

use super::{Model, TraceSink};
use crate::bearing::{BallLoads, Clearance, ContactBand, Support};
use crate::keys;
use crate::rotor::{BallContacts, Rotor, Sample};
use contact_watch::ContactWatch;
use event::no_events;
use life::LifeSums;
use load_zone::LoadZoneSums;
pub use peak_loads::BeyondContact;
pub(crate) use peak_loads::PeakWatch;

/// What a run observed of one bearing.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct BearingHistory {
    /// Clearance of a deep-groove bearing; none of an angular contact bearing.
    pub clearance: Option<Clearance>,
    /// What rolls in it: `ball` or `roller`.
    #[serde(skip)]
    pub(crate) element: &'static str,
    /// Number of its balls; zero for a linear bearing, which knows none and of which nothing is
    /// observed.
    pub balls: usize,
    /// Events over the whole run, by kind: those of a preload only where there is one.
    #[serde(serialize_with = "keys::by_name")]
    pub events: Vec<(EventKind, EventCount)>,
    /// Loaded balls after the settle time; none without balls or samples.
    pub(crate) load_zone: Option<LoadZone>,
    /// Life that the loads consumed; none without a dynamic load rating or balls, or at rest.
    pub(crate) life: Option<LifeHistory>,
    /// Whether its internal geometry was estimated from a catalogue's ratings, and with it every number of its balls.
    pub estimated: bool,
}

impl BearingHistory {
    /// How often an event of a kind happened.
    pub fn events(&self, kind: EventKind) -> EventCount {
        let found = self.events.iter().find(|(of, _)| *of == kind);
        found.map_or_else(EventCount::default, |(_, count)| *count)
    }
}

/// Watches all bearings of a rotor, sample by sample: the same samples give the same result.
#[derive(Debug)]
pub(super) struct Observation<'a> {
    contacts: BallContacts,
    peaks: PeakWatch<'a>,
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
    watch: Option<ContactWatch>,
    counts: Vec<(EventKind, EventCount)>,
    /// None where it is left out.
    zone: Option<LoadZoneSums>,
    life: Option<LifeSums>,
}

impl<'a> Observation<'a> {
    /// With the contact angles of the balls where somebody needs them, or a shoulder bounds them.
    pub fn new(model: &Model, rotor: &'a Rotor, angles: bool) -> Self {
        let contacts = match angles {
            true => rotor.ball_contacts(),
            false => PeakWatch::contacts(rotor),
        };
        let observer =
            |(index, support)| BearingObserver::new(index, support, rotor.speed(), model);
        Self {
            // a ball and its bearing can each do one thing between two samples
            found: Vec::with_capacity(
                contacts
                    .bearings()
                    .iter()
                    .map(|balls| balls.balls() + 1)
                    .sum(),
            ),
            bearings: rotor.supports().enumerate().map(observer).collect(),
            contacts,
            peaks: PeakWatch::new(rotor),
            settle: model.settle,
        }
    }

    /// Whether contacts are watched, from the first sample on.
    pub fn is_of_contacts(&self) -> bool {
        self.bearings.iter().any(|bearing| bearing.watch.is_some())
    }

    /// What to know of how hard the balls were pressed in the run.
    ///
    /// # Errors
    /// [`BeyondContact`] where that is beyond any contact of a ball.
    pub fn peak_warnings(&self, rotor: &Rotor) -> Result<Vec<String>, BeyondContact> {
        self.peaks.warnings(rotor)
    }

    /// Takes the state of a sample for what nobody observes of balls that are not there.
    pub fn take_linear(&mut self, rotor: &Rotor, time: f64, state: &[f64]) {
        self.peaks.take_linear(rotor, time, state);
    }

    /// Where the rotor leaves what it observes of the balls.
    pub fn contacts(&mut self) -> &mut BallContacts {
        &mut self.contacts
    }

    /// Takes the sample whose balls are in [`Observation::contacts`], and hands balls and events on.
    pub fn take(&mut self, sample: &Sample, sink: &mut dyn TraceSink) -> io::Result<()> {
        sink.balls(sample, &self.contacts)?;
        self.watch([sample.time, sample.speed], sink)?;
        let settled = sample.time >= self.settle;
        let least = self.contacts.least_load();
        for (bearing, balls) in self.bearings.iter_mut().zip(self.contacts.bearings()) {
            bearing.weigh(sample, balls, least, settled);
        }
        Ok(())
    }

    /// Hands on what has happened since the sample before, at a time and a speed in s and rad/s.
    fn watch(&mut self, instant: [f64; 2], sink: &mut dyn TraceSink) -> io::Result<()> {
        self.found.clear();
        self.peaks.take(instant[0], &self.contacts);
        for (index, bearing) in self.bearings.iter_mut().enumerate() {
            bearing.watch(index, instant, &self.contacts, &mut self.found);
        }
        self.found.sort_unstable_by(Event::order);
        self.found.iter().try_for_each(|event| sink.event(event))
    }

    /// What was observed, bearing by bearing.
    pub fn finish(self) -> Vec<BearingHistory> {
        let history = |bearing: BearingObserver<'_>| BearingHistory {
            clearance: bearing.support.definition().bearing.clearance(),
            element: bearing.support.definition().bearing.geometry.element(),
            balls: bearing.support.known_balls(),
            events: bearing.counts,
            load_zone: bearing.zone.and_then(LoadZoneSums::finish),
            life: bearing.life.and_then(LifeSums::finish),
            estimated: bearing.support.definition().bearing.estimated,
        };
        self.bearings.into_iter().map(history).collect()
    }
}

impl<'a> BearingObserver<'a> {
    fn new(index: usize, support: &'a Support, speed: f64, model: &Model) -> Self {
        let bearing = &support.definition().bearing;
        let (balls, preloaded) = (support.known_balls(), support.is_preloaded());
        let watched = balls > 0 && !model.analyses.settled_only;
        let weighed = balls > 0 && model.analyses.loads;
        let life = weighed.then(|| LifeSums::new(bearing, model.settle));
        Self {
            support,
            band: (speed, support.contact_band(speed)),
            watch: watched.then(|| ContactWatch::new(index, balls, preloaded)),
            counts: no_events(balls > 0, preloaded),
            zone: weighed.then(|| LoadZoneSums::new(bearing.geometry.balls())),
            life: life.flatten(),
        }
    }

    /// Finds what has happened to the contacts since the sample before.
    fn watch(
        &mut self,
        index: usize,
        [time, speed]: [f64; 2],
        contacts: &BallContacts,
        found: &mut Vec<Event>,
    ) {
        let balls = &contacts.bearings()[index];
        let Some(watch) = &mut self.watch else {
            return;
        };
        if self.band.0 != speed {
            self.band = (speed, self.support.contact_band(speed));
        }
        let already = found.len();
        let axial = contacts.axial_forces()[index];
        watch.take(time, self.band.1, &balls.approach, axial, found);
        for event in &found[already..] {
            let mut counts = self.counts.iter_mut();
            if let Some((_, count)) = counts.find(|(kind, _)| *kind == event.kind) {
                count.add(event.time);
            }
        }
    }

    /// Adds up what the balls bear; one is loaded by more than `least` in N.
    fn weigh(&mut self, sample: &Sample, balls: &BallLoads, least: f64, settled: bool) {
        if let Some(zone) = self.zone.as_mut().filter(|_| settled) {
            zone.take(&balls.load[0], least);
        }
        if let Some(life) = &mut self.life {
            life.take(sample, balls);
        }
    }
}
