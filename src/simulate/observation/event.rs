//! What happens to a bearing at an instant.

use std::cmp::Ordering;
use std::fmt;

use serde::Serialize;

use crate::keys;

/// Kind of an event.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum EventKind {
    /// A ball leaves the inner race: it falls below `bearing::ContactBand::lost`.
    ContactLost,
    /// A ball meets the inner race again: it rises above `bearing::ContactBand::regained`.
    ContactRegained,
    /// A preloaded bearing bears nothing axially any more: no ball touches the inner race, or the
    /// axial force has turned against the preload.
    PreloadLost,
    /// A preloaded bearing bears axially again.
    PreloadRegained,
}

impl EventKind {
    /// All kinds.
    pub const ALL: [Self; 4] = [
        Self::ContactLost,
        Self::ContactRegained,
        Self::PreloadLost,
        Self::PreloadRegained,
    ];

    /// Name in the files: `contact_lost` ….
    pub const fn name(self) -> &'static str {
        match self {
            Self::ContactLost => "contact_lost",
            Self::ContactRegained => "contact_regained",
            Self::PreloadLost => "preload_lost",
            Self::PreloadRegained => "preload_regained",
        }
    }
}

impl fmt::Display for EventKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// Something that happens to a bearing at an instant.
///
/// Events are found by comparing neighbouring samples. The time is that at which the approach of
/// ball and race (for the axial force of a preload: the force), taken as linear between both
/// samples, reaches its limit: off by at most an eighth of the square of the sampling interval times
/// the acceleration over the speed of the approach. What comes and goes between two samples is
/// missed.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Event {
    /// Time, s.
    pub time: f64,
    /// What happened.
    pub kind: EventKind,
    /// Index of the bearing, from 0.
    pub bearing: usize,
    /// Index of the ball, from 0; none where it happens to the bearing as a whole.
    pub ball: Option<usize>,
}

impl Event {
    /// By time; what happens at once by bearing, then ball by ball, then the bearing as a whole.
    pub(super) fn order(&self, other: &Self) -> Ordering {
        let place = |event: &Self| (event.bearing, event.ball.unwrap_or(usize::MAX));
        let by_time = self.time.total_cmp(&other.time);
        by_time.then_with(|| place(self).cmp(&place(other)))
    }
}

/// How often something happened.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct EventCount {
    /// Number of times.
    pub count: u64,
    /// First and last time, s; none where it never happened.
    #[serde(flatten, serialize_with = "keys::span")]
    pub span: Option<[f64; 2]>,
}

impl EventCount {
    pub(super) fn add(&mut self, time: f64) {
        self.count += 1;
        let [first, last] = self.span.unwrap_or([time; 2]);
        self.span = Some([first.min(time), last.max(time)]);
    }
}

/// No event yet of one bearing, by the kinds that can happen: contacts count only where balls are known, the preload only
/// where there is one as well.
pub(super) fn no_events(balls: bool, preloaded: bool) -> Vec<(EventKind, EventCount)> {
    let possible = match (balls, preloaded) {
        (false, _) => &EventKind::ALL[..0],
        (true, false) => &EventKind::ALL[..2],
        (true, true) => &EventKind::ALL[..],
    };
    let kinds = possible.iter();
    kinds.map(|&kind| (kind, EventCount::default())).collect()
}
