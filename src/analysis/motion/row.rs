//! Samples of a motion, quantity by quantity.

use crate::rotor::{FREEDOMS, Sample, SampleRows};

/// Samples of the row before that stand in front of a row.
pub(super) const OVERLAP: usize = 3;
/// Samples that a row takes behind them.
const TAKEN: usize = 64;
/// Most samples of a row.
pub(super) const MOST: usize = OVERLAP + TAKEN;
/// Time, angle, displacements, velocities and forces.
const QUANTITIES: usize = 2 + 3 * FREEDOMS;

/// Samples that follow each other, quantity by quantity, so that sums run over numbers that lie side by side.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Row {
    quantities: Box<[[f64; MOST]; QUANTITIES]>,
    /// Samples of the row before among them.
    overlap: usize,
    length: usize,
}

impl Row {
    pub fn new() -> Self {
        Self {
            quantities: Box::new([[0.0; MOST]; QUANTITIES]),
            overlap: 0,
            length: 0,
        }
    }

    /// Takes a sample, where it is not full.
    pub fn push(&mut self, sample: &Sample) {
        if self.is_full() {
            return;
        }
        let Sample {
            displacement,
            velocity,
            force_on_shaft,
            ..
        } = sample;
        let vectors = displacement.iter().chain(velocity).chain(force_on_shaft);
        let values = [&sample.time, &sample.angle].into_iter().chain(vectors);
        for (quantity, value) in self.quantities.iter_mut().zip(values) {
            quantity[self.length] = *value;
        }
        self.length += 1;
    }

    /// Takes samples from a number on until it is full; answers how many of them.
    pub fn take(&mut self, rows: &SampleRows, from: usize) -> usize {
        let taken = (rows.len() - from).min(MOST - self.length);
        let place = self.length;
        let mut write = |quantity: usize, values: &[f64]| {
            self.quantities[quantity][place..place + taken]
                .copy_from_slice(&values[from..from + taken]);
        };
        write(0, rows.times());
        write(1, rows.angles());
        for axis in 0..FREEDOMS {
            write(2 + axis, rows.displacements(axis));
            write(2 + FREEDOMS + axis, rows.velocities(axis));
            write(2 + 2 * FREEDOMS + axis, rows.forces(axis));
        }
        self.length += taken;
        taken
    }

    pub fn is_full(&self) -> bool {
        self.length == MOST
    }

    /// Leaves the last samples in front of the next row.
    pub fn go_on(&mut self) {
        let kept = self.length.min(OVERLAP);
        for quantity in self.quantities.iter_mut() {
            quantity.copy_within(self.length - kept..self.length, 0);
        }
        (self.overlap, self.length) = (kept, kept);
    }

    /// Samples of the row before among those of [`Row::angles`] and [`Row::at`].
    pub fn overlap(&self) -> usize {
        self.overlap
    }

    /// With those of the row before.
    pub fn angles(&self) -> &[f64] {
        &self.quantities[1][..self.length]
    }

    /// Time, displacements and velocities of one of the samples.
    pub fn at(&self, index: usize) -> (f64, [[f64; FREEDOMS]; 2]) {
        let value = |quantity: usize| self.quantities[quantity][index];
        let vector = |first: usize| std::array::from_fn(|axis| value(first + axis));
        (value(0), [vector(2), vector(2 + FREEDOMS)])
    }

    pub fn times(&self) -> &[f64] {
        self.fresh(0)
    }

    pub fn displacements(&self, axis: usize) -> &[f64] {
        self.fresh(2 + axis)
    }

    pub fn velocities(&self, axis: usize) -> &[f64] {
        self.fresh(2 + FREEDOMS + axis)
    }

    pub fn forces(&self, axis: usize) -> &[f64] {
        self.fresh(2 + 2 * FREEDOMS + axis)
    }

    /// Without those of the row before.
    fn fresh(&self, quantity: usize) -> &[f64] {
        &self.quantities[quantity][self.overlap..self.length]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(number: usize) -> Sample {
        let part = number as f64;
        Sample {
            time: part,
            angle: 2.0 * part,
            speed: 2.0,
            displacement: [3.0 * part; FREEDOMS],
            velocity: [4.0 * part; FREEDOMS],
            force_on_shaft: [5.0 * part; FREEDOMS],
            largest_ball_load: 0.0,
            balls_loaded: 0,
            energy: None,
            drive: None,
        }
    }

    #[test]
    fn every_sample_is_fresh_once_and_the_last_ones_stay_in_front() {
        let mut row = Row::new();
        let mut seen = Vec::new();
        let (mut samples, mut number) = (SampleRows::new(), 0);
        while number < 200 {
            // now one, now a few of them, now more than there is room for
            let count = [1, 7, 60][number % 3].min(200 - number);
            samples.clear();
            (number..number + count).for_each(|number| samples.push(&sample(number)));
            if count == 1 {
                row.push(&sample(number));
                number += 1;
            } else {
                number += row.take(&samples, 0);
            }
            if row.is_full() {
                seen.extend_from_slice(row.times());
                row.go_on();
                assert_eq!(row.overlap(), OVERLAP);
                let (time, [displacement, velocity]) = row.at(OVERLAP - 1);
                let last = (number - 1) as f64;
                assert_eq!((time, row.angles()[OVERLAP - 1]), (last, 2.0 * last));
                assert_eq!((displacement[4], velocity[0]), (3.0 * last, 4.0 * last));
            }
        }
        seen.extend_from_slice(row.times());
        let expected: Vec<f64> = (0..200).map(f64::from).collect();
        assert_eq!(seen, expected);
        let last = row.times().len() - 1;
        let found = [row.displacements(1), row.velocities(2), row.forces(3)];
        assert_eq!(found.map(|values| values[last]), [597.0, 796.0, 995.0]);
    }

    #[test]
    fn a_row_of_few_samples_leaves_them_all() {
        let mut row = Row::new();
        row.push(&sample(7));
        row.go_on();
        assert_eq!((row.overlap(), row.times().len()), (1, 0));
        assert_eq!(row.at(0).0, 7.0);
    }
}
