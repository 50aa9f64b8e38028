//! What the comparison of a column found.

use super::rule::Judgement;

/// A place of a column, as a rule the one where its values are furthest beyond, or closest to, what is
/// allowed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Worst {
    /// Row, from 1, the header not counted; of events and lines, their number.
    pub row: u64,
    /// Value of the first table's first column there: time in s or frequency in Hz.
    pub at: f64,
    /// Value in the first table.
    pub first: f64,
    /// Value in the second table.
    pub second: f64,
    /// |first − second|, of phases the shorter way round; infinite where only one is a number.
    pub difference: f64,
    /// Difference allowed there.
    pub allowed: f64,
}

impl Worst {
    fn excess(&self) -> f64 {
        self.difference - self.allowed
    }
}

/// What the comparison of a column found.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ColumnComparison {
    /// Name of the column; of events, their kind.
    pub name: String,
    /// The worst places, the worst first; none where nothing was compared, as with phases of nothing.
    pub places: Vec<Worst>,
    /// Number of rows beyond what is allowed.
    pub failures: u64,
    /// The relative tolerance that, without an absolute one, would let the column agree; infinite where
    /// none would.
    pub needed: f64,
    /// Most places that are kept.
    room: usize,
}

impl ColumnComparison {
    /// Nothing compared so far; keeps as many places as there is `room` for, at least one.
    pub(super) fn new(name: &str, room: usize) -> Self {
        Self {
            name: name.to_owned(),
            places: Vec::new(),
            failures: 0,
            needed: 0.0,
            room: room.max(1),
        }
    }

    /// Whether no row is beyond what is allowed.
    pub fn agrees(&self) -> bool {
        self.failures == 0
    }

    /// The worst place.
    pub fn worst(&self) -> Option<&Worst> {
        self.places.first()
    }

    /// Takes the judgement on a row.
    pub(super) fn take(&mut self, row: u64, at: f64, [first, second]: [f64; 2], of: Judgement) {
        let place = Worst {
            row,
            at,
            first,
            second,
            difference: of.difference,
            allowed: of.allowed,
        };
        self.needed = self.needed.max(of.needed);
        if place.excess() > 0.0 {
            self.failures += 1;
        }
        let after = |known: &Worst| known.excess() >= place.excess();
        let index = self.places.partition_point(after);
        if index < self.room {
            self.places.truncate(self.room - 1);
            self.places.insert(index, place);
        }
    }
}
