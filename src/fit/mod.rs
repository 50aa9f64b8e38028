//! From the measured to the model: how answers depend on quantities of a scenario, and which values of these explain what
//! was measured.
//!
//! All that is known of a scene is a function from values to the numbers of its answers, a [`Point`]. Slopes are differences of
//! two sizes ([`slopes`]), values come from least squares between bounds ([`Problem::fit`]).

mod answer;
mod kind;
mod problem;
mod question;
mod search;
mod slopes;
mod statistics;

use std::error::Error;

pub use answer::{Answer, NamedLine, Number, Wanted};
pub use kind::Kind;
pub use problem::{Observation, Problem, Unknown};
pub use question::Question;
pub use slopes::{Slope, slopes};
pub use statistics::{Fit, Minimum, Profile, Unidentified};

use crate::steady::Orbit;

/// The numbers of a scene at some values, and the motions that they are of.
#[derive(Debug, Clone, Default)]
pub struct Point {
    /// The numbers that are asked for.
    pub numbers: Vec<Number>,
    /// The motion of every question that has one, from which those of neighbours are found.
    pub orbits: Vec<Option<Orbit>>,
}

/// Why a scene has no numbers at some values.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NoAnswer {
    /// It was to stop.
    #[error("interrupted")]
    Stopped,
    /// There is no such scene, or its question has no answer.
    #[error("{0}")]
    Failed(String),
}

impl NoAnswer {
    fn failed(error: impl Error) -> Self {
        Self::Failed(error.to_string())
    }
}

/// How exactly the numbers of a scene are asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effort {
    /// As a search needs them that is far from its end.
    Coarse,
    /// To the tolerance of the scenario.
    Full,
    /// With the error of each, by themselves.
    Verified,
}

/// The numbers of a scene at some values, found from those of a neighbour.
pub type Scene<'a> = &'a (dyn Fn(&[f64], Option<&Point>, Effort) -> Result<Point, NoAnswer> + Sync);

/// On how many threads, and whether to stop.
#[derive(Debug, Clone, Copy)]
pub struct Work<'a> {
    /// Number of threads.
    pub threads: usize,
    /// Set to end it.
    pub stop: &'a std::sync::atomic::AtomicBool,
}

impl Work<'_> {
    /// Does so many tasks; what they answer in their order, none of those that were not begun.
    fn all<T: Send>(&self, count: usize, task: impl Fn(usize) -> T + Sync) -> Vec<Option<T>> {
        let mut done: Vec<Option<T>> = (0..count).map(|_| None).collect();
        let one = |number: u64, hand: &dyn Fn((u64, T)) -> bool| {
            hand((number, task(number as usize)));
        };
        let tasks = 0..count as u64;
        let kept =
            crate::study::many::work(tasks, self.threads, self.stop, one, |(number, found)| {
                done[number as usize] = Some(found);
                Ok::<_, std::convert::Infallible>(())
            });
        match kept {
            Ok(()) => done,
        }
    }
}
