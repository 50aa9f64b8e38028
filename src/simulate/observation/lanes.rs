//! Takes samples whose bearings are seen side by side.

use std::io;

use super::{BearingObserver, ContactWatch, Observation};
use crate::bearing::{LANES, SupportObservation};
use crate::rotor::{BallContacts, Rotor, Sample, SampleLanes, SampleRows};
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
        let times = &rows.times()[instants];
        let needed_from = sink.starts_at();
        for (lane, time) in times.iter().enumerate() {
            let needed = *time >= needed_from;
            if needed || !quiet {
                let sample = seen.sample(rows, number, lane);
                let balls = |contacts: &mut BallContacts| seen.fill(number, lane, contacts);
                self.hand_on(&sample, balls, [needed, quiet], sink)?;
            }
        }
        for (bearing, own) in self.bearings.iter_mut().zip(seen.bearings()) {
            let least = seen.least_loads(number);
            bearing.count_loaded(times, least, (own, number), self.settle);
        }
        Ok(())
    }

    /// Whether nothing happens to any contact in all samples of `rows`, which were seen at once, while all balls are
    /// loaded, so that none of them is to be looked at by itself.
    pub fn is_plain(&self, rows: &SampleRows, seen: &SampleLanes<'_>) -> bool {
        let mut bearings = self.bearings.iter().zip(seen.bearings());
        bearings.all(|(bearing, own)| {
            let mut groups = rows.times().chunks(LANES).enumerate();
            groups.all(|(number, times)| {
                let least = seen.least_loads(number);
                bearing.is_plain(times.len(), least, (own, number))
            })
        })
    }

    /// Takes samples that are [plain](Observation::is_plain).
    pub fn take_plain(&mut self, rows: &SampleRows, seen: &SampleLanes<'_>) {
        let settled = rows.times().partition_point(|time| *time < self.settle);
        for (bearing, own) in self.bearings.iter_mut().zip(seen.bearings()) {
            if let Some(zone) = &mut bearing.zone {
                zone.take_full(own.count(), rows.len() - settled);
            }
        }
    }

    /// Adds up the life that all samples of `rows` consume, after they were taken.
    pub fn consume(&mut self, rows: &SampleRows, seen: &SampleLanes<'_>) {
        let settled = rows.times().partition_point(|time| *time < self.settle);
        for (bearing, own) in self.bearings.iter_mut().zip(seen.bearings()) {
            if let Some(life) = &mut bearing.life {
                let left_out = if bearing.parts.early_life { 0 } else { settled };
                life.take_rows(rows, left_out, own);
            }
        }
    }

    /// Hands on what the sink needs of a sample and the balls that are left by `balls`, and what has happened up to it.
    fn hand_on(
        &mut self,
        sample: &Sample,
        balls: impl Fn(&mut BallContacts),
        [needed, quiet]: [bool; 2],
        sink: &mut dyn TraceSink,
    ) -> io::Result<()> {
        let shown = needed && sink.takes_balls();
        if needed {
            sink.sample(sample)?;
        }
        if shown || !quiet {
            balls(&mut self.contacts);
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

    /// Goes on to a time at which nothing has happened, the first of the lanes of a number, seen last.
    pub fn pass(&mut self, time: f64, seen: &SampleLanes<'_>, number: usize) {
        for (bearing, own) in self.bearings.iter_mut().zip(seen.bearings()) {
            if let Some(watch) = &mut bearing.watch {
                watch.pass(time, bearing.band.1, own, number);
            }
        }
    }

    /// Whether nothing happens to any bearing in the first so many samples of the group seen last, that of a number.
    pub fn is_quiet(&self, seen: &SampleLanes<'_>, number: usize, count: usize) -> bool {
        let mut bearings = self.bearings.iter().zip(seen.bearings());
        let quiet = |(bearing, own): (&BearingObserver<'_>, _)| {
            let watch = bearing.watch.as_ref();
            watch.is_none_or(|watch| watch.is_quiet(bearing.band.1, own, number, count))
        };
        !self.watching || bearings.all(quiet)
    }
}

impl BearingObserver<'_> {
    /// Whether nothing happens in the first so many instants of a group seen, while at each every ball is loaded by
    /// more than so many N, where that is asked.
    fn is_plain(
        &self,
        count: usize,
        least: [f64; LANES],
        (seen, number): (&SupportObservation, usize),
    ) -> bool {
        let mut loads = seen.smallest_loads(number).iter().zip(least);
        let quiet = |watch: &ContactWatch| {
            let band = self.band.1;
            watch.is_plainly_quiet(band, seen, number, count)
        };
        self.watch.as_ref().is_none_or(quiet)
            && (self.zone.is_none() || loads.all(|(load, least)| *load > least))
    }

    /// Counts the balls that are loaded in a group of instants seen, at each by more than so many N.
    fn count_loaded(
        &mut self,
        times: &[f64],
        least: [f64; LANES],
        (seen, number): (&SupportObservation, usize),
        settle: f64,
    ) {
        let Some(zone) = &mut self.zone else {
            return;
        };
        let settled = times.partition_point(|time| *time < settle)..times.len();
        let smallest = seen.smallest_loads(number);
        if settled.clone().all(|lane| smallest[lane] > least[lane]) {
            zone.take_full(seen.count(), settled.len());
        } else {
            settled.for_each(|lane| zone.take(seen.loads(lane), least[lane]));
        }
    }
}
