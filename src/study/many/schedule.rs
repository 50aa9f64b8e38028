//! Which runs are made together, and under which numbers.

use std::ops::Range;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Order of runs that each go on from where their neighbour along the last axis ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Sweep {
    /// From its first value to its last.
    Up,
    /// From its last value to its first.
    Down,
    /// Up, and from there down again.
    Both,
}

/// Which way a run was come to along the last axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// By itself.
    Alone,
    /// From the value before.
    Up,
    /// From the value after.
    Down,
}

impl Direction {
    /// Name as in the files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Alone => "alone",
            Self::Up => "up",
            Self::Down => "down",
        }
    }
}

/// One run of a schedule.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Turn {
    /// Its number, from 0 on.
    pub number: u64,
    /// Which point of the plan it has the values of.
    pub point: u64,
    /// Which way it is come to.
    pub direction: Direction,
}

/// The runs of a study, grouped into chains, which are made as a whole: those of a sweep, within which each run
/// goes on from where the one before ended; otherwise every chain is one run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Schedule {
    points: u64,
    length: u64,
    sweep: Option<Sweep>,
}

impl Schedule {
    /// The schedule of so many points of a plan, whose last axis has `last` values.
    pub fn new(points: u64, last: u64, sweep: Option<Sweep>) -> Self {
        let length = sweep.map_or(1, |_| last.max(1));
        Self {
            points,
            length,
            sweep,
        }
    }

    /// Whether runs go on from where others ended.
    pub fn carries(&self) -> bool {
        self.sweep.is_some()
    }

    /// Number of chains.
    pub fn chains(&self) -> u64 {
        self.points.div_ceil(self.length)
    }

    /// Number of runs in a chain that is not cut short.
    fn most_in_chain(&self) -> u64 {
        match self.sweep {
            Some(Sweep::Both) => 2 * self.length,
            _ => self.length,
        }
    }

    /// Number of runs.
    pub fn runs(&self) -> u64 {
        match self.sweep {
            Some(Sweep::Both) => 2 * self.points,
            _ => self.points,
        }
    }

    /// The chain that a run is made in.
    pub fn chain_of(&self, number: u64) -> u64 {
        number / self.most_in_chain()
    }

    /// Numbers of the runs of some chains.
    pub fn runs_of(&self, chains: Range<u64>) -> Range<u64> {
        let first = |chain: u64| chain.saturating_mul(self.most_in_chain()).min(self.runs());
        first(chains.start)..first(chains.end)
    }

    /// The runs of a chain, in order.
    pub fn chain(&self, chain: u64) -> impl Iterator<Item = Turn> + use<> {
        let Self { length, sweep, .. } = *self;
        let runs = self.runs_of(chain..chain + 1);
        let first = runs.start;
        runs.map(move |number| {
            let place = number - first;
            let (offset, direction) = match sweep {
                None => (place, Direction::Alone),
                Some(Sweep::Down) => (length - 1 - place, Direction::Down),
                Some(_) if place >= length => (2 * length - 1 - place, Direction::Down),
                Some(_) => (place, Direction::Up),
            };
            Turn {
                number,
                point: chain * length + offset,
                direction,
            }
        })
    }
}

/// One of several parts that a study is made in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// Which part, from 1 on.
    pub number: u64,
    /// Of how many.
    pub count: u64,
}

impl Shard {
    /// The whole.
    pub const WHOLE: Self = Self {
        number: 1,
        count: 1,
    };

    /// The chains of this part, one stretch of all of them.
    pub fn chains(self, schedule: &Schedule) -> Range<u64> {
        let all = u128::from(schedule.chains());
        let count = u128::from(self.count.max(1));
        // no product of 64 bits each is beyond 128
        let bound = |part: u64| (all * u128::from(part) / count) as u64;
        bound(self.number.saturating_sub(1))..bound(self.number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chains_follow_the_sweep() {
        // a grid of 2 × 3, the last axis swept up and down
        let schedule = Schedule::new(6, 3, Some(Sweep::Both));
        assert_eq!((schedule.chains(), schedule.runs()), (2, 12));
        let points: Vec<u64> = schedule.chain(1).map(|turn| turn.point).collect();
        assert_eq!(points, [3, 4, 5, 5, 4, 3]);
        // the same grid, every run by itself
        let schedule = Schedule::new(6, 3, None);
        assert_eq!((schedule.chains(), schedule.runs_of(1..2)), (6, 1..2));
    }
}
