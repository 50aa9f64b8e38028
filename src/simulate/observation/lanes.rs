//! Takes samples whose bearings are seen side by side.

use std::io;

use super::{BearingObserver, Observation};
use crate::bearing::{SupportObservation, Vector5};
use crate::rotor::{Rotor, Sample, SampleLanes};
use crate::simulate::TraceSink;

impl Observation<'_> {
    /// What sees the rotor's samples side by side; none where they are to be looked at one by one.
    pub fn lanes<'b>(&self, rotor: &'b Rotor) -> Option<SampleLanes<'b>> {
        SampleLanes::new(rotor, &self.contacts)
    }

    /// Takes samples that follow each other, the first ones of those seen last, and hands samples, balls and
    /// events on; comes to what [`Observation::take`] comes to.
    pub fn take_side_by_side(
        &mut self,
        samples: &[Sample],
        seen: &SampleLanes<'_>,
        sink: &mut dyn TraceSink,
    ) -> io::Result<()> {
        let count = samples.len();
        let quiet = !self.watching || self.is_quiet(seen, count);
        let shown = sink.takes_balls();
        for (lane, sample) in samples.iter().enumerate() {
            sink.sample(sample)?;
            if shown || !quiet {
                seen.fill(lane, &mut self.contacts);
            }
            if shown {
                sink.balls(sample, &self.contacts)?;
            }
            if !quiet {
                self.watch(sample, sink)?;
            }
        }
        let Some(last) = samples.last().filter(|_| self.watching) else {
            return Ok(());
        };
        for (bearing, own) in self.bearings.iter_mut().zip(seen.bearings()) {
            if quiet {
                bearing.pass(last.time, own, count - 1);
            }
            bearing.weigh_side_by_side(samples, seen, own, self.settle);
        }
        Ok(())
    }

    /// Whether it is certain that nothing happens to any bearing while the shaft is at these displacements.
    pub fn is_certainly_quiet(
        &self,
        seen: &SampleLanes<'_>,
        displacements: impl Iterator<Item = Vector5> + Clone,
    ) -> bool {
        let mut bearings = self.bearings.iter().zip(seen.bearings());
        bearings.all(|(bearing, own)| {
            let lost = bearing.band.1.lost;
            let in_contact = |place| own.is_certainly_in_contact(&place, lost);
            let watch = bearing.watch.as_ref();
            watch.is_none_or(|watch| watch.is_at_work() && displacements.clone().all(in_contact))
        })
    }

    /// Goes on to a time at which nothing has happened, the first of the instants seen last.
    pub fn pass(&mut self, time: f64, seen: &SampleLanes<'_>) {
        for (bearing, own) in self.bearings.iter_mut().zip(seen.bearings()) {
            bearing.pass(time, own, 0);
        }
    }

    /// Whether nothing happens to any bearing in the first so many samples.
    fn is_quiet(&self, seen: &SampleLanes<'_>, count: usize) -> bool {
        let mut bearings = self.bearings.iter().zip(seen.bearings());
        bearings.all(|(bearing, own)| {
            let watch = bearing.watch.as_ref();
            watch.is_none_or(|watch| watch.is_quiet(bearing.band.1, own, count))
        })
    }
}

impl BearingObserver<'_> {
    /// Goes on to a time at which nothing has happened, that of one of the instants seen.
    fn pass(&mut self, time: f64, seen: &SupportObservation, lane: usize) {
        if let Some(watch) = &mut self.watch {
            watch.pass(time, self.band.1, seen, lane);
        }
    }

    /// As [`BearingObserver::weigh`], of the balls at the instants seen.
    fn weigh_side_by_side(
        &mut self,
        samples: &[Sample],
        all: &SampleLanes<'_>,
        seen: &SupportObservation,
        settle: f64,
    ) {
        let early = samples.partition_point(|sample| sample.time < settle);
        if let Some(zone) = &mut self.zone {
            let least = |lane: usize| all.least_load(lane);
            let lanes = early..samples.len();
            if lanes
                .clone()
                .all(|lane| seen.load_range(lane)[1] > least(lane))
            {
                zone.take_full(seen.count(), lanes.len());
            } else {
                lanes.for_each(|lane| zone.take(seen.loads(lane), least(lane)));
            }
        }
        if let Some(life) = &mut self.life {
            let unweighed = if self.parts.early_life { 0 } else { early };
            life.take_side_by_side(samples, unweighed, seen.powers());
        }
    }
}
