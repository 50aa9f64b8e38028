//! A walk as plain numbers, from which it goes on to the same bytes.

use super::linear::{LinearPart, Place};
use super::mean::Mean;
use super::nodes::POINTS;
use super::plan::Leg;
use super::renewal::Renewal;
use super::walk::Walk;
use crate::integrate::Counters;

/// Single numbers of a walk.
const SINGLE: usize = 18;

fn flag(set: bool) -> f64 {
    f64::from(u8::from(set))
}

impl<const N: usize> Walk<N> {
    /// Everything but the counters as numbers; what follows from them is left out.
    pub fn numbers(&self) -> Vec<f64> {
        let single: [f64; SINGLE] = [
            self.start,
            self.time,
            self.size,
            self.wish,
            self.limit,
            self.leg.end,
            self.leg.left,
            self.leg.size,
            self.leg.intervals,
            self.intervals,
            self.slow_size,
            self.linear.first as f64,
            flag(self.fresh),
            self.rate,
            self.since_rate,
            self.rate_size,
            flag(self.rejected),
            self.mean.steps,
        ];
        let known = self.propagators.numbers();
        let places = [&self.from, &self.to].into_iter();
        let vectors = places.flat_map(|place| [&place.coordinates, &place.deviation]);
        let vectors = vectors
            .chain([&self.mean.deviation])
            .chain(&self.slow)
            .chain(&self.linear.jacobian);
        let renewal = self.renewal.numbers();
        let single = single.iter().chain(&renewal).chain(&known);
        single.chain(vectors.flatten()).copied().collect()
    }

    /// The walk of numbers as by [`Walk::numbers`], with its counters; none of any others.
    pub fn restored(numbers: &[f64], counters: Counters, interval: f64) -> Option<Self> {
        let (single, numbers) = numbers.split_at_checked(SINGLE)?;
        let (&renewal, numbers) = numbers.split_first_chunk()?;
        let (known, vectors) = numbers.split_first_chunk()?;
        let vectors: &[[f64; N]] = match vectors.as_chunks() {
            (vectors, []) if vectors.len() == 5 + POINTS + N => vectors,
            _ => return None,
        };
        let [
            start,
            time,
            size,
            wish,
            limit,
            end,
            left,
            leg_size,
            leg_intervals,
            intervals,
            slow_size,
            first,
            fresh,
            rate,
            since_rate,
            rate_size,
            rejected,
            averaged,
        ] = *<&[f64; SINGLE]>::try_from(single).ok()?;
        let mut walk = Self::new(vectors[3], interval);
        walk.from = Place {
            coordinates: vectors[0],
            deviation: vectors[1],
        };
        walk.to = Place {
            coordinates: vectors[2],
            deviation: vectors[3],
        };
        walk.mean = Mean {
            deviation: vectors[4],
            steps: averaged,
        };
        walk.slow.copy_from_slice(&vectors[5..5 + POINTS]);
        let mut jacobian = [[0.0; N]; N];
        jacobian.copy_from_slice(&vectors[5 + POINTS..]);
        walk.linear = LinearPart::new(jacobian, (first as usize).min(N), walk.linear.level);
        (walk.start, walk.time, walk.size) = (start, time, size);
        (walk.wish, walk.limit, walk.intervals) = (wish, limit, intervals);
        walk.leg = Leg {
            end,
            left,
            size: leg_size,
            intervals: leg_intervals,
        };
        (walk.slow_size, walk.fresh) = (slow_size, fresh != 0.0);
        (walk.rate, walk.since_rate, walk.rate_size) = (rate, since_rate, rate_size);
        walk.renewal = Renewal::from_numbers(renewal);
        walk.rejected = rejected != 0.0;
        walk.propagators.restore(&walk.linear, known);
        walk.counters = counters;
        Some(walk)
    }
}
