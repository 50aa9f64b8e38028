//! Takes samples whose bearings are seen side by side.

use std::io;

use super::{BearingObserver, Observation};
use crate::bearing::{LANES, SupportObservation};
use crate::rotor::{Rotor, Sample, SampleLanes, SampleRows};
use crate::simulate::TraceSink;

impl Observation<'_> {
    /// What sees the rotor's samples side by side; none where they are to be looked at one by one.
    pub fn lanes<'b>(&self, rotor: &'b Rotor) -> Option<SampleLanes<'b>> {
        SampleLanes::new(rotor, &self.contacts)
    }

    /// Takes the samples of the lanes of a number in `rows`, those seen last, and hands events, and the samples and
    /// balls that the sink needs, on; comes to what [`Observation::take`] comes to. Where they are
    /// [quiet](Observation::is_quiet), nothing is made of the contacts: they are still those of the sample before.
    pub fn take_side_by_side(
        &mut self,
        rows: &SampleRows,
        number: usize,
        quiet: bool,
        seen: &SampleLanes<'_>,
        sink: &mut dyn TraceSink,
    ) -> io::Result<()> {
        let instants = LANES * number..rows.len().min(LANES * (number + 1));
        let [times, angles] = [rows.times(), rows.angles()].map(|row| &row[instants.clone()]);
        let needed_from = sink.starts_at();
        for (lane, time) in times.iter().enumerate() {
            let needed = *time >= needed_from;
            if needed || !quiet {
                let sample = seen.sample(rows, number, lane);
                self.hand_on(&sample, (seen, lane), [needed, quiet], sink)?;
            }
        }
        if self.watching {
            for (bearing, own) in self.bearings.iter_mut().zip(seen.bearings()) {
                bearing.weigh_side_by_side([times, angles], seen.least_loads(), own, self.settle);
            }
        }
        Ok(())
    }

    /// Hands on what the sink needs of a sample in a lane, and what has happened up to it.
    fn hand_on(
        &mut self,
        sample: &Sample,
        (seen, lane): (&SampleLanes<'_>, usize),
        [needed, quiet]: [bool; 2],
        sink: &mut dyn TraceSink,
    ) -> io::Result<()> {
        let shown = needed && sink.takes_balls();
        if needed {
            sink.sample(sample)?;
        }
        if shown || !quiet {
            seen.fill(lane, &mut self.contacts);
        }
        if shown {
            sink.balls(sample, &self.contacts)?;
        }
        match quiet {
            true => Ok(()),
            false => self.watch(sample, sink),
        }
    }

    /// Whether it is certain that nothing happens to any bearing while the shaft is at the displacements in `rows`.
    pub fn is_certainly_quiet(&self, seen: &SampleLanes<'_>, rows: &SampleRows) -> bool {
        let mut bearings = self.bearings.iter().zip(seen.bearings());
        bearings.all(|(bearing, own)| {
            let lost = bearing.band.1.lost;
            let mut numbers = 0..rows.len().div_ceil(LANES);
            let watch = bearing.watch.as_ref();
            watch.is_none_or(|watch| {
                watch.is_at_work()
                    && numbers.all(|number| {
                        own.is_certainly_in_contact(rows.displacement_lanes(number), lost)
                    })
            })
        })
    }

    /// Goes on to a time at which nothing has happened, the first of the instants seen last.
    pub fn pass(&mut self, time: f64, seen: &SampleLanes<'_>) {
        for (bearing, own) in self.bearings.iter_mut().zip(seen.bearings()) {
            if let Some(watch) = &mut bearing.watch {
                watch.pass(time, bearing.band.1, own);
            }
        }
    }

    /// Whether nothing happens to any bearing in the first so many of the samples seen last.
    pub fn is_quiet(&self, seen: &SampleLanes<'_>, count: usize) -> bool {
        let mut bearings = self.bearings.iter().zip(seen.bearings());
        let quiet = |(bearing, own): (&BearingObserver<'_>, _)| {
            let watch = bearing.watch.as_ref();
            watch.is_none_or(|watch| watch.is_quiet(bearing.band.1, own, count))
        };
        !self.watching || bearings.all(quiet)
    }
}

impl BearingObserver<'_> {
    /// As [`BearingObserver::weigh`], of the balls at the instants seen, at times and angles of the shaft; at each a
    /// ball is loaded by more than so many N.
    fn weigh_side_by_side(
        &mut self,
        [times, angles]: [&[f64]; 2],
        least: [f64; LANES],
        seen: &SupportObservation,
        settle: f64,
    ) {
        let early = times.partition_point(|time| *time < settle);
        if let Some(zone) = &mut self.zone {
            let lanes = early..times.len();
            if lanes
                .clone()
                .all(|lane| seen.smallest_loads()[lane] > least[lane])
            {
                zone.take_full(seen.count(), lanes.len());
            } else {
                lanes.for_each(|lane| zone.take(seen.loads(lane), least[lane]));
            }
        }
        if let Some(life) = &mut self.life {
            let unweighed = if self.parts.early_life { 0 } else { early };
            life.take_side_by_side([times, angles], unweighed, seen);
        }
    }
}
