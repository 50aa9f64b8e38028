//! What a run observed of one bearing.

use serde::Serialize;

use super::{EventCount, EventKind, LifeHistory, LoadZone};
use crate::bearing::Clearance;
use crate::keys;

/// What a run observed of one bearing.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct BearingHistory {
    /// Clearance of a deep-groove bearing; none of an angular contact bearing.
    pub clearance: Option<Clearance>,
    /// Number of its balls; zero for a linear bearing, which knows none and of which nothing is
    /// observed.
    pub balls: usize,
    /// Events over the whole run, by kind: those of a preload only where there is one.
    #[serde(serialize_with = "keys::by_name")]
    pub events: Vec<(EventKind, EventCount)>,
    /// Loaded balls after the settle time; none without balls or samples.
    pub load_zone: Option<LoadZone>,
    /// Life that the loads consumed; none without a dynamic load rating or balls, or at rest.
    pub life: Option<LifeHistory>,
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
