//! Takes samples whose bearings are seen side by side.

use std::io;

use super::{BearingObserver, Observation};
use crate::bearing::SupportObservation;
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
        if !self.watching {
            return Ok(());
        }
        for (bearing, own) in self.bearings.iter_mut().zip(seen.bearings()) {
            if quiet {
                bearing.pass(samples, own);
            }
            for (lane, sample) in samples.iter().enumerate() {
                let settled = sample.time >= self.settle;
                bearing.weigh_lane(sample, own, lane, seen.least_load(lane), settled);
            }
        }
        Ok(())
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
    /// Goes on to the last of samples at which nothing happens.
    fn pass(&mut self, samples: &[Sample], seen: &SupportObservation) {
        if let (Some(watch), Some(last)) = (&mut self.watch, samples.last()) {
            watch.pass(last.time, self.band.1, seen, samples.len() - 1);
        }
    }

    /// As [`BearingObserver::weigh`], of the balls at one of the instants seen.
    fn weigh_lane(
        &mut self,
        sample: &Sample,
        seen: &SupportObservation,
        lane: usize,
        least: f64,
        settled: bool,
    ) {
        if let Some(zone) = self.zone.as_mut().filter(|_| settled) {
            if seen.load_range(lane)[1] > least {
                zone.take_full(seen.count());
            } else {
                zone.take(seen.loads(lane), least);
            }
        }
        let lives = settled || self.parts.early_life;
        if let Some(life) = self.life.as_mut().filter(|_| lives) {
            life.take(sample, seen.powers(lane));
        }
    }
}
