//! Finds where balls leave and meet the inner race, and where a preload is lost.

use super::{Event, EventKind};
use crate::bearing::ContactBand;

/// Watches the contacts of one bearing from sample to sample.
#[derive(Debug)]
pub(super) struct ContactWatch {
    bearing: usize,
    /// None before the first sample.
    before: Option<Instant>,
    balls: Vec<BallWatch>,
    preload: Option<PreloadWatch>,
}

/// What all balls of a bearing have in common at a sample.
#[derive(Debug, Clone, Copy)]
struct Instant {
    time: f64,
    band: ContactBand,
}

/// A ball at the sample before.
#[derive(Debug, Clone, Copy, Default)]
struct BallWatch {
    in_contact: bool,
    approach: f64,
}

/// A preload at the sample before.
#[derive(Debug, Clone, Copy, Default)]
struct PreloadWatch {
    held: bool,
    touching: bool,
    axial_force: f64,
}

impl ContactWatch {
    pub fn new(bearing: usize, balls: usize, preloaded: bool) -> Self {
        Self {
            bearing,
            before: None,
            balls: vec![BallWatch::default(); balls],
            preload: preloaded.then(PreloadWatch::default),
        }
    }

    /// Takes a sample; what happened since the one before is added to `found`, ball by ball.
    pub fn take(
        &mut self,
        time: f64,
        band: ContactBand,
        approaches: &[f64],
        axial_force: f64,
        found: &mut Vec<Event>,
    ) {
        let now = Instant { time, band };
        let already = found.len();
        match self.before.replace(now) {
            None => self.start(band, approaches, axial_force),
            Some(before) => {
                self.watch_balls([before, now], approaches, found);
                self.watch_preload([before, now], axial_force, already, found);
            }
        }
    }

    /// At the first sample nothing has happened yet.
    fn start(&mut self, band: ContactBand, approaches: &[f64], axial_force: f64) {
        for (watch, &approach) in self.balls.iter_mut().zip(approaches) {
            watch.in_contact = approach >= band.lost;
            watch.approach = approach;
        }
        let touching = self.touches();
        if let Some(preload) = &mut self.preload {
            *preload = PreloadWatch {
                held: touching && axial_force > 0.0,
                touching,
                axial_force,
            };
        }
    }

    /// Whether any ball is in contact.
    fn touches(&self) -> bool {
        self.balls.iter().any(|ball| ball.in_contact)
    }

    fn watch_balls(&mut self, span: [Instant; 2], approaches: &[f64], found: &mut Vec<Event>) {
        for (index, (watch, &approach)) in self.balls.iter_mut().zip(approaches).enumerate() {
            let (limit, kind) = if watch.in_contact {
                (span.map(|at| at.band.lost), EventKind::ContactLost)
            } else {
                (span.map(|at| at.band.regained), EventKind::ContactRegained)
            };
            let above = [watch.approach - limit[0], approach - limit[1]];
            watch.approach = approach;
            if (above[1] >= 0.0) != watch.in_contact {
                watch.in_contact = !watch.in_contact;
                found.push(Event {
                    time: crossing(span, above),
                    kind,
                    bearing: self.bearing,
                    ball: Some(index),
                });
            }
        }
    }

    /// `found` holds this bearing's balls from index `already` on.
    fn watch_preload(
        &mut self,
        span: [Instant; 2],
        axial_force: f64,
        already: usize,
        found: &mut Vec<Event>,
    ) {
        let touching = self.touches();
        let Some(preload) = &mut self.preload else {
            return;
        };
        let before = std::mem::replace(
            preload,
            PreloadWatch {
                held: touching && axial_force > preload.limit(span[1].band.load),
                touching,
                axial_force,
            },
        );
        if preload.held == before.held {
            return;
        }
        let balls = found[already..].iter().map(|event| event.time);
        let limit = before.limit(span[1].band.load);
        let time = match (before.touching, touching) {
            (true, true) => crossing(span, [before.axial_force - limit, axial_force - limit]),
            // the first ball comes back, or the last one leaves
            (false, true) => balls.fold(span[1].time, f64::min),
            _ => balls.fold(span[0].time, f64::max),
        };
        let kind = match preload.held {
            true => EventKind::PreloadRegained,
            false => EventKind::PreloadLost,
        };
        found.push(Event {
            time,
            kind,
            bearing: self.bearing,
            ball: None,
        });
    }
}

impl PreloadWatch {
    /// Axial force at which a held preload is lost, and a lost one regained, N: as little against it
    /// as a ball in contact bears at `least`, so that round-off about zero makes no events.
    fn limit(&self, least: f64) -> f64 {
        if self.held { -least } else { 0.0 }
    }
}

/// When a value that is linear between two samples passes zero, s.
fn crossing([before, now]: [Instant; 2], [from, to]: [f64; 2]) -> f64 {
    // 0 ≤ share ≤ 1, as the signs differ
    let share = from / (from - to);
    before.time + share.clamp(0.0, 1.0) * (now.time - before.time)
}
