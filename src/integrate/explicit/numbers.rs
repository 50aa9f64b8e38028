//! A walk as plain numbers, and from them.

use super::crossing::{self, Crossing};
use super::substitution::Substitution;
use super::walk::Walk;
use crate::integrate::Counters;
use crate::integrate::control::Control;

/// Single numbers of a walk.
const SINGLE: usize = 11;

fn flag(set: bool) -> f64 {
    f64::from(u8::from(set))
}

impl<const N: usize> Walk<N> {
    /// Everything but the counters as numbers.
    pub fn numbers(&self) -> Vec<f64> {
        let single = [
            self.start,
            self.time,
            self.size,
            self.next_size,
            self.limit,
            self.size_before,
            flag(self.extended),
            flag(self.quintic),
            flag(self.control.was_rejected()),
            flag(self.substitution.start),
            flag(self.substitution.end),
        ];
        let crossing = self.crossing.numbers();
        let single = single.into_iter().chain(crossing);
        let vectors = [
            &self.from,
            &self.to,
            &self.jerk,
            &self.end_rate,
            &self.rate_before,
        ];
        let vectors = vectors.into_iter().chain(&self.stages).flatten();
        single.chain(vectors.copied()).collect()
    }

    /// The walk of numbers as by [`Walk::numbers`], with its counters; none of any others.
    pub fn restored(numbers: &[f64], counters: Counters) -> Option<Self> {
        let (single, numbers) = numbers.split_at_checked(SINGLE)?;
        let (crossing, vectors) = numbers.split_at_checked(crossing::NUMBERS)?;
        let vectors: &[[f64; N]] = match vectors.as_chunks() {
            (vectors, []) => vectors,
            _ => return None,
        };
        let [
            start,
            time,
            size,
            next_size,
            limit,
            size_before,
            extended,
            quintic,
            rejected,
            singular_start,
            singular_end,
        ] = *<&[f64; SINGLE]>::try_from(single).ok()?;
        let [from, to, jerk, end_rate, rate_before, stages @ ..] = vectors else {
            return None;
        };
        Some(Self {
            level: fearless_simd::Level::new(),
            start,
            time,
            size,
            next_size,
            limit,
            from: *from,
            to: *to,
            stages: stages.try_into().ok()?,
            substitution: Substitution {
                start: singular_start != 0.0,
                end: singular_end != 0.0,
            },
            end_rate: *end_rate,
            crossing: Crossing::restored(crossing)?,
            ended: false,
            extended: extended != 0.0,
            quintic: quintic != 0.0,
            jerk: *jerk,
            size_before,
            rate_before: *rate_before,
            control: Control::after(rejected != 0.0),
            fault: false,
            counters,
        })
    }
}
