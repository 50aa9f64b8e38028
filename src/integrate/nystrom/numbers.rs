//! A walk as plain numbers, and from them.

use super::row::Row;
use super::stand::Stand;
use super::walk::{PAST, Walk};
use crate::integrate::Counters;
use crate::integrate::control::Control;

/// Stands of a walk.
const STANDS: usize = 2 + PAST;
/// Single numbers of a walk.
const SINGLE: usize = 5 + STANDS;

impl<const N: usize> Walk<N> {
    /// Everything but the counters as numbers.
    pub fn numbers(&self) -> Vec<f64> {
        let single = [
            self.size,
            self.next_size,
            self.limit,
            self.known as f64,
            f64::from(u8::from(self.control.was_rejected())),
        ];
        let stands = || [&self.from, &self.to].into_iter().chain(&self.past);
        let times = stands().map(|stand| stand.time);
        let vectors = stands().flat_map(|stand| [stand.state, *stand.push]);
        single
            .into_iter()
            .chain(times)
            .chain(vectors.flatten())
            .collect()
    }

    /// The walk of numbers as by [`Walk::numbers`], with its counters; none of any others.
    pub fn restored(numbers: &[f64], counters: Counters) -> Option<Self> {
        let (single, vectors) = numbers.split_at_checked(SINGLE)?;
        let vectors: &[[f64; N]] = match vectors.as_chunks() {
            (vectors, []) => vectors,
            _ => return None,
        };
        let [size, next_size, limit, known, rejected, times @ ..] =
            *<&[f64; SINGLE]>::try_from(single).ok()?;
        let vectors = <&[[f64; N]; 2 * STANDS]>::try_from(vectors).ok()?;
        let stand = |index: usize| Stand {
            time: times[index],
            state: vectors[2 * index],
            push: Row::from(vectors[2 * index + 1]),
        };
        Some(Self {
            from: stand(0),
            to: stand(1),
            past: std::array::from_fn(|index| stand(2 + index)),
            known: (known as usize).min(PAST),
            size,
            next_size,
            limit,
            control: Control::after(rejected != 0.0),
            counters,
            ..Self::new([0.0; N])
        })
    }
}
