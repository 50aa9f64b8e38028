//! Which methods carried a run, and what each was found to cost.

use crate::integrate::{Counters, Method};

/// What one of the methods did.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// The method.
    pub method: Method,
    /// Simulated time that it carried the run over, s.
    pub covered: f64,
    /// Its work.
    pub counters: Counters,
    /// What it cost per simulated second where it was looked at last, or what was expected of it before the
    /// first step where another method was begun with for that, s: at prices of one server, so that only ratios are
    /// of use. None where nothing is known.
    pub rate: Option<f64>,
}

/// A time at which another method took over.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MethodChange {
    /// s.
    pub time: f64,
    /// The method from there on.
    pub method: Method,
}

/// Which methods carried a run under [`Method::Auto`].
#[derive(Debug, Clone, PartialEq)]
pub struct MethodUse {
    /// All that could be chosen.
    pub stretches: Vec<Stretch>,
    /// Where the method changed; the first at the start of the run.
    pub changes: Vec<MethodChange>,
}

impl MethodUse {
    /// The method that carried most of the run.
    pub fn main(&self) -> Option<&Stretch> {
        let mut stretches = self.stretches.iter();
        let first = stretches.next()?;
        Some(stretches.fold(first, |most, other| {
            if other.covered > most.covered {
                other
            } else {
                most
            }
        }))
    }
}
