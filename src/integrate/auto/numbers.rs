//! A walk as plain numbers, from which it goes on to the same bytes.

use super::cost::{WAYS, Way};
use super::selector::{Mark, Selector};
use super::walk::AutoWalk;
use crate::integrate::Counters;
use crate::integrate::explicit::Walk;
use crate::integrate::exponential::ExponentialWalk;
use crate::integrate::nystrom;

/// The number that stands for no method.
const NONE: f64 = -1.0;

fn flag(set: bool) -> f64 {
    f64::from(u8::from(set))
}

/// Numbers in their order, taken one after the other.
struct Take<'a>(&'a [f64]);

impl<'a> Take<'a> {
    fn one(&mut self) -> Option<f64> {
        self.several().map(|[number]| number)
    }

    fn several<const COUNT: usize>(&mut self) -> Option<[f64; COUNT]> {
        let (taken, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(*taken)
    }

    /// A list with its length before it.
    fn list(&mut self) -> Option<&'a [f64]> {
        let length = self.one()? as usize;
        let (taken, rest) = self.0.split_at_checked(length)?;
        self.0 = rest;
        Some(taken)
    }

    fn way(&mut self) -> Option<Way> {
        let number = self.one()?;
        let known = |way: &Way| *way as usize as f64 == number;
        WAYS.into_iter().find(known)
    }

    fn way_or_none(&mut self) -> Option<Option<Way>> {
        if self.0.first() == Some(&NONE) {
            return self.one().map(|_| None);
        }
        self.way().map(Some)
    }

    fn counters(&mut self) -> Option<Counters> {
        let [steps, rejected, evaluations] = self.several()?.map(|count| count as u64);
        Some(Counters {
            steps,
            rejected,
            evaluations,
        })
    }

    fn mark(&mut self) -> Option<Mark> {
        let [time, spent, steps] = self.several()?;
        Some(Mark {
            time,
            spent,
            steps: steps as u64,
        })
    }
}

fn of_counters(counters: Counters) -> [f64; 3] {
    [counters.steps, counters.rejected, counters.evaluations].map(|count| count as f64)
}

fn of_mark(mark: Mark) -> [f64; 3] {
    [mark.time, mark.spent, mark.steps as f64]
}

impl Selector {
    fn put(&self, numbers: &mut Vec<f64>) {
        let against = self.against.map_or(NONE, |way| way as usize as f64);
        numbers.extend([self.way as usize as f64, against]);
        numbers.extend(of_mark(self.began));
        numbers.extend(of_mark(self.window));
        numbers.extend(self.rates);
        numbers.extend(self.failures);
        numbers.extend([flag(self.open), self.next_trial]);
        numbers.extend([self.linear_part, self.assumed, self.disproved].map(flag));
    }

    fn restored(take: &mut Take<'_>) -> Option<Self> {
        Some(Self {
            way: take.way()?,
            against: take.way_or_none()?,
            began: take.mark()?,
            window: take.mark()?,
            rates: take.several()?,
            failures: take.several()?,
            open: take.one()? != 0.0,
            next_trial: take.one()?,
            linear_part: take.one()? != 0.0,
            assumed: take.one()? != 0.0,
            disproved: take.one()? != 0.0,
        })
    }
}

impl<const N: usize> AutoWalk<N> {
    /// Everything as numbers.
    pub fn numbers(&self) -> Vec<f64> {
        let mut numbers = Vec::new();
        self.selector.put(&mut numbers);
        for done in self.done {
            numbers.extend(of_counters(done));
        }
        numbers.extend(self.covered);
        numbers.extend([self.explicit_size, flag(self.contacts_change)]);
        let changes = self.changes.iter();
        let changes = changes.flat_map(|&(time, way)| [time, way as usize as f64]);
        for list in [
            changes.collect(),
            self.explicit.numbers(),
            self.nystrom.numbers(),
            self.exponential.numbers(),
        ] {
            numbers.push(list.len() as f64);
            numbers.extend(list);
        }
        numbers.extend(of_counters(self.explicit.counters()));
        numbers.extend(of_counters(self.nystrom.counters()));
        numbers.extend(of_counters(self.exponential.counters()));
        numbers
    }

    /// The walk of numbers as by [`AutoWalk::numbers`]; none of any others.
    pub fn restored(numbers: &[f64], interval: f64) -> Option<Self> {
        let mut take = Take(numbers);
        let selector = Selector::restored(&mut take)?;
        let mut done = [Counters::default(); WAYS.len()];
        for done in &mut done {
            *done = take.counters()?;
        }
        let (covered, explicit_size) = (take.several()?, take.one()?);
        let contacts_change = take.one()? != 0.0;
        let mut list = || take.list();
        let (changes, walks) = (list()?, [list()?, list()?, list()?]);
        let counters = [take.counters()?, take.counters()?, take.counters()?];
        take.0.is_empty().then_some(())?;
        Some(Self {
            explicit: Walk::restored(walks[0], counters[0])?,
            nystrom: nystrom::Walk::restored(walks[1], counters[1])?,
            exponential: ExponentialWalk::restored(walks[2], counters[2], interval)?,
            selector,
            done,
            covered,
            explicit_size,
            contacts_change,
            changes: changes_of(changes)?,
            beforehand: None,
        })
    }
}

fn changes_of(numbers: &[f64]) -> Option<Vec<(f64, Way)>> {
    let (pairs, []) = numbers.as_chunks::<2>() else {
        return None;
    };
    let pairs = pairs.iter();
    pairs
        .map(|[time, way]| Some((*time, Take(&[*way]).way()?)))
        .collect()
}
