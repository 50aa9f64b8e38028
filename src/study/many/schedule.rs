//! Which runs are made together, under which numbers, how long each is, and on how many threads.

use std::f64::consts::TAU;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError, mpsc};
use std::thread;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::analysis::SectionKind;
use crate::bearing::{ContactLaw, Support};
use crate::rotor::RotorDefinition;

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
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
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
        let schedule = *self;
        let runs = self.runs_of(chain..chain + 1);
        runs.map(move |number| schedule.turn(number))
    }

    /// The run of a number.
    pub fn turn(&self, number: u64) -> Turn {
        let length = self.length;
        let step = number % self.most_in_chain();
        let (offset, direction) = match self.sweep {
            None => (step, Direction::Alone),
            Some(Sweep::Down) => (length - 1 - step, Direction::Down),
            Some(_) if step >= length => (2 * length - 1 - step, Direction::Down),
            Some(_) => (step, Direction::Up),
        };
        Turn {
            number,
            point: self.chain_of(number) * length + offset,
            direction,
        }
    }
}

/// One of several parts that a study is made in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
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

    /// The chains of this part, one segment of all of them.
    pub fn chains(self, schedule: &Schedule) -> Range<u64> {
        let all = u128::from(schedule.chains());
        let count = u128::from(self.count.max(1));
        // no product of 64 bits each is beyond 128
        let bound = |part: u64| (all * u128::from(part) / count) as u64;
        bound(self.number.saturating_sub(1))..bound(self.number)
    }
}

/// Works on `tasks` on so many threads; `take` gets each result on the calling thread as it is ready, and ends the
/// work by an error.
///
/// A task is begun unless `stop` is set; it hands its results on one by one, and ends early where it is told that no
/// more are taken.
///
/// # Errors
/// What `take` answers.
pub fn work<R: Send, E>(
    tasks: impl Iterator<Item = u64> + Send,
    threads: usize,
    stop: &AtomicBool,
    task: impl Fn(u64, &dyn Fn(R) -> bool) + Sync,
    mut take: impl FnMut(R) -> Result<(), E>,
) -> Result<(), E> {
    let (tasks, ended) = (Mutex::new(tasks), AtomicBool::new(false));
    let (sender, results) = mpsc::sync_channel(2 * threads.max(1));
    thread::scope(|scope| {
        for _ in 0..threads.max(1) {
            let (sender, tasks, ended, task) = (sender.clone(), &tasks, &ended, &task);
            // a thread that panicked held nothing half done: what it guards is whole
            let next = || tasks.lock().unwrap_or_else(PoisonError::into_inner).next();
            scope.spawn(move || {
                let hand = |result| sender.send(result).is_ok() && !ended.load(Ordering::Relaxed);
                while !(stop.load(Ordering::Relaxed) || ended.load(Ordering::Relaxed)) {
                    let Some(number) = next() else { return };
                    task(number, &hand);
                }
            });
        }
        drop(sender);
        let mut outcome = Ok(());
        for result in results {
            if outcome.is_ok() {
                outcome = take(result);
                ended.store(outcome.is_err(), Ordering::Relaxed);
            }
        }
        outcome
    })
}

/// How long a run is in cycles at its own, constant speed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cycles {
    /// What counts as a cycle.
    pub of: SectionKind,
    /// Cycles that settle. Default: 0.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1_000_000_000))]
    pub settle: u32,
    /// Cycles after them.
    #[schemars(range(min = 1, max = 1_000_000_000), extend("examples" = [100]))]
    pub kept: u32,
}

/// Why a run has no cycles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum CyclesError {
    /// Its speed changes, or is zero.
    #[error(
        "cycles are counted at a constant speed above zero only; give the times by `[time]` of the base"
    )]
    Speed,
    /// No ball passes.
    #[error(
        "no rolling element passes here: the cage is held or all bearings are linear; count revolutions, or set \
         model.contact and model.cage"
    )]
    BallPass,
}

impl Cycles {
    /// Settle time and duration of a run of this shaft, s.
    ///
    /// ```text
    /// T = 2π/ω   T = 2π/(ω_c Z) for a pass of the first bearing's Z balls
    /// ```
    ///
    /// # Errors
    /// [`CyclesError`] where it has no such cycles.
    pub fn times(&self, rotor: &RotorDefinition) -> Result<[f64; 2], CyclesError> {
        let steady = rotor.speed_points.is_empty() && rotor.drive.is_none();
        if !steady || rotor.speed <= 0.0 {
            return Err(CyclesError::Speed);
        }
        let cycle = TAU / (rotor.speed * cycles_a_revolution(self.of, rotor)?);
        let cycles = [self.settle, self.settle.saturating_add(self.kept)];
        Ok(cycles.map(|count| f64::from(count) * cycle))
    }
}

/// Cycles of a kind in a revolution of a shaft.
///
/// # Errors
/// [`CyclesError::BallPass`] where no ball passes.
pub fn cycles_a_revolution(kind: SectionKind, rotor: &RotorDefinition) -> Result<f64, CyclesError> {
    if kind == SectionKind::Revolution {
        return Ok(1.0);
    }
    let supports = rotor.rolling_supports().unwrap_or_default();
    let passing = supports
        .iter()
        .find(|support| support.definition().law != ContactLaw::Linear);
    let passes = passing.map(Support::passes);
    passes
        .filter(|passes| *passes > 0.0)
        .ok_or(CyclesError::BallPass)
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
