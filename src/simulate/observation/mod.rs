//! What a run observes of its bearings beside the trace: events, load zone, life.

mod contact_watch;
mod event;
mod history;
mod life;
mod load_zone;
mod peak_loads;

use std::io;

pub use event::{Event, EventCount, EventKind};
pub use history::BearingHistory;
pub use life::{ConsumedLife, LifeHistory};
pub use load_zone::{LoadZone, Spread};

use super::{BallParts, Model, SimulateError, TraceSink, Watched};
use crate::bearing::{BallLoads, ContactBand, Support};
use crate::rotor::{BallContacts, Rotor, Sample};
use contact_watch::ContactWatch;
use event::EventCounts;
use life::LifeSums;
use load_zone::LoadZoneSums;
use peak_loads::PeakLoads;

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
    parts: BallParts,
    /// Speed in rad/s and where contacts part at it.
    band: (f64, ContactBand),
    watch: Option<ContactWatch>,
    peaks: PeakLoads,
    counts: EventCounts,
    zone: Option<LoadZoneSums>,
    life: Option<LifeSums>,
}

impl<'a> Observation<'a> {
    /// With the contact angles of the balls where somebody needs them, or a shoulder bounds them.
    pub fn new(model: &Model, rotor: &'a Rotor, angles: bool) -> Self {
        let Watched { forces, balls } = model.analyses.watched;
        let bounded = |support: &Support| support.definition().bearing.shoulder_angle.is_some();
        let contacts = match balls {
            Some(_) if angles || rotor.supports().iter().any(bounded) => rotor.ball_contacts(),
            Some(_) => rotor.ball_loads(),
            None => rotor.unwatched_balls(forces),
        };
        let parts = balls.unwrap_or(BallParts::LOADS);
        let observer = |(index, support)| {
            let speed = rotor.speed();
            BearingObserver::new(index, support, speed, model.settle, parts)
        };
        Self {
            // a ball and its bearing can each do one thing between two samples
            found: Vec::with_capacity(
                contacts
                    .bearings()
                    .iter()
                    .map(|balls| balls.balls() + 1)
                    .sum(),
            ),
            bearings: rotor.supports().iter().enumerate().map(observer).collect(),
            contacts,
            settle: model.settle,
        }
    }

    /// Whether contacts are watched, from the first sample on.
    pub fn is_of_contacts(&self) -> bool {
        self.bearings.iter().any(|bearing| bearing.watch.is_some())
    }

    /// Whether life is consumed from the first sample on.
    pub fn is_of_early_life(&self) -> bool {
        let mut bearings = self.bearings.iter();
        bearings.any(|bearing| bearing.parts.early_life && bearing.life.is_some())
    }

    /// What to know of how hard the balls were pressed in the run.
    ///
    /// # Errors
    /// [`SimulateError::BeyondContact`] where that is beyond any contact of a ball.
    pub fn peak_warnings(&self, rotor: &Rotor) -> Result<Vec<String>, SimulateError> {
        let states = rotor.bearing_states(rotor.highest_speed());
        let mut warnings = Vec::new();
        for (index, (bearing, state)) in self.bearings.iter().zip(states).enumerate() {
            warnings.extend(bearing.peaks.warnings(index + 1, bearing.support, &state)?);
        }
        Ok(warnings)
    }

    /// Where the rotor leaves what it observes of the balls.
    pub fn contacts(&mut self) -> &mut BallContacts {
        &mut self.contacts
    }

    /// Takes the sample whose balls stand in [`Observation::contacts`], and hands balls and events on.
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

    /// Takes the contacts alone of a state at a time, of a rotor whose speed is a function of time.
    pub fn take_contacts(
        &mut self,
        rotor: &Rotor,
        time: f64,
        state: &[f64],
        sink: &mut dyn TraceSink,
    ) -> io::Result<()> {
        rotor.observe_contacts(time, state, &mut self.contacts);
        self.watch([time, rotor.speed_profile().at(time).speed], sink)
    }

    /// Hands on what has happened since the sample before, at a time and a speed in s and rad/s.
    fn watch(&mut self, instant: [f64; 2], sink: &mut dyn TraceSink) -> io::Result<()> {
        self.found.clear();
        for (index, bearing) in self.bearings.iter_mut().enumerate() {
            let balls = &self.contacts.bearings()[index];
            bearing.peaks.take(instant[0], balls, bearing.support);
            bearing.watch(index, instant, &self.contacts, &mut self.found);
        }
        self.found.sort_unstable_by(Event::order);
        self.found.iter().try_for_each(|event| sink.event(event))
    }

    /// What was observed, bearing by bearing.
    pub fn finish(self) -> Vec<BearingHistory> {
        let history = |bearing: BearingObserver<'_>| BearingHistory {
            clearance: bearing.support.definition().bearing.clearance(),
            balls: bearing.support.known_balls(),
            events: bearing.counts.finish(),
            load_zone: bearing.zone.and_then(LoadZoneSums::finish),
            life: bearing.life.and_then(LifeSums::finish),
            estimated: bearing.support.definition().bearing.estimated,
        };
        self.bearings.into_iter().map(history).collect()
    }
}

impl<'a> BearingObserver<'a> {
    fn new(index: usize, support: &'a Support, speed: f64, settle: f64, parts: BallParts) -> Self {
        let bearing = &support.definition().bearing;
        let (balls, preloaded) = (support.known_balls(), support.is_preloaded());
        let rated = bearing.dynamic_rating.filter(|_| balls > 0 && parts.life);
        Self {
            support,
            parts,
            band: (speed, support.contact_band(speed)),
            watch: (balls > 0 && parts.events).then(|| ContactWatch::new(index, balls, preloaded)),
            peaks: PeakLoads::default(),
            counts: EventCounts::new(balls > 0, preloaded),
            zone: parts.load_zone.then(LoadZoneSums::default),
            life: rated.map(|rating| LifeSums::new(bearing, rating, settle)),
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
        found[already..]
            .iter()
            .for_each(|event| self.counts.add(event));
    }

    /// Adds up what the balls bear; one is loaded by more than `least` in N.
    fn weigh(&mut self, sample: &Sample, balls: &BallLoads, least: f64, settled: bool) {
        if balls.balls() == 0 {
            return;
        }
        if let Some(zone) = self.zone.as_mut().filter(|_| settled) {
            zone.take(&balls.load[0], least);
        }
        let lives = settled || self.parts.early_life;
        if let Some(life) = self.life.as_mut().filter(|_| lives) {
            life.take(sample, balls.life_powers);
        }
    }
}
