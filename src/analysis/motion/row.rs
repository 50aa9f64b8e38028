//! Samples of a motion, quantity by quantity.

use crate::rotor::{FREEDOMS, Sample};

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

    /// Takes a sample into a row that is not full.
    pub fn push(&mut self, sample: &Sample) {
        let (quantities, index) = (&mut *self.quantities, self.length);
        quantities[0][index] = sample.time;
        quantities[1][index] = sample.angle;
        for axis in 0..FREEDOMS {
            quantities[2 + axis][index] = sample.displacement[axis];
            quantities[2 + FREEDOMS + axis][index] = sample.velocity[axis];
            quantities[2 + 2 * FREEDOMS + axis][index] = sample.force_on_shaft[axis];
        }
        self.length += 1;
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
        for number in 0..200 {
            row.push(&sample(number));
            if row.is_full() {
                seen.extend_from_slice(row.times());
                row.go_on();
                assert_eq!(row.overlap(), OVERLAP);
                let (time, [displacement, velocity]) = row.at(OVERLAP - 1);
                let last = number as f64;
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
