//! How an integration gets on, for who watches it from another thread.

use std::sync::atomic::{AtomicU64, Ordering};

use super::Counters;

/// Where an integration stands; it takes note at every trial of a step.
#[derive(Debug, Default)]
pub struct Pace {
    /// Bits of the time, s.
    time: AtomicU64,
    steps: AtomicU64,
    rejected: AtomicU64,
    evaluations: AtomicU64,
}

impl Pace {
    /// Takes note of a time in s and of the work done up to it.
    pub(super) fn note(&self, time: f64, counters: &Counters) {
        self.time.store(time.to_bits(), Ordering::Relaxed);
        self.steps.store(counters.steps, Ordering::Relaxed);
        self.rejected.store(counters.rejected, Ordering::Relaxed);
        self.evaluations
            .store(counters.evaluations, Ordering::Relaxed);
    }

    /// The time it has come to, s, and the work done up to there; the numbers may be a step apart.
    pub fn now(&self) -> (f64, Counters) {
        let counters = Counters {
            steps: self.steps.load(Ordering::Relaxed),
            rejected: self.rejected.load(Ordering::Relaxed),
            evaluations: self.evaluations.load(Ordering::Relaxed),
        };
        (f64::from_bits(self.time.load(Ordering::Relaxed)), counters)
    }
}
