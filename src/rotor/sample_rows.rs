//! Samples of the shaft, quantity by quantity.

use super::{FREEDOMS, Sample};
use crate::bearing::{LANES, Vector5};

/// One number of every sample.
pub(super) type SampleRow = [f64; SampleRows::MOST];

/// Samples that follow each other, quantity by quantity: what is worked out of many of them runs over numbers that
/// lie side by side.
///
/// The quantities are those of [`Sample`]; how many balls are loaded, energies and the moments of a drive are not
/// among them.
#[derive(Debug, Clone)]
#[repr(C, align(32))]
pub(crate) struct SampleRows {
    pub(super) time: SampleRow,
    pub(super) angle: SampleRow,
    pub(super) speed: SampleRow,
    pub(super) displacement: [SampleRow; FREEDOMS],
    pub(super) velocity: [SampleRow; FREEDOMS],
    pub(super) force_on_shaft: [SampleRow; FREEDOMS],
    pub(super) largest_ball_load: SampleRow,
    pub(super) length: usize,
}

impl SampleRows {
    /// Most samples: a whole number of lanes.
    pub const MOST: usize = 16 * LANES;

    /// Without samples.
    pub fn new() -> Box<Self> {
        Box::new(Self {
            time: [0.0; Self::MOST],
            angle: [0.0; Self::MOST],
            speed: [0.0; Self::MOST],
            displacement: [[0.0; Self::MOST]; FREEDOMS],
            velocity: [[0.0; Self::MOST]; FREEDOMS],
            force_on_shaft: [[0.0; Self::MOST]; FREEDOMS],
            largest_ball_load: [0.0; Self::MOST],
            length: 0,
        })
    }

    /// Forgets all samples.
    pub fn clear(&mut self) {
        self.length = 0;
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.length
    }

    /// Adds a sample; one more than there is room for is left out.
    pub fn push(&mut self, sample: &Sample) {
        let index = self.length;
        if index == Self::MOST {
            return;
        }
        self.time[index] = sample.time;
        self.angle[index] = sample.angle;
        self.speed[index] = sample.speed;
        for axis in 0..FREEDOMS {
            self.displacement[axis][index] = sample.displacement[axis];
            self.velocity[axis][index] = sample.velocity[axis];
            self.force_on_shaft[axis][index] = sample.force_on_shaft[axis];
        }
        self.largest_ball_load[index] = sample.largest_ball_load;
        self.length += 1;
    }

    /// One of the samples; what is not among the quantities is zero or none.
    pub fn sample(&self, index: usize) -> Sample {
        Sample {
            time: self.time[index],
            angle: self.angle[index],
            speed: self.speed[index],
            displacement: self.displacement_at(index),
            velocity: self.velocity.each_ref().map(|row| row[index]),
            force_on_shaft: self.force_on_shaft.each_ref().map(|row| row[index]),
            largest_ball_load: self.largest_ball_load[index],
            balls_loaded: 0,
            energy: None,
            drive: None,
        }
    }

    /// Where the shaft is in the samples of the lanes of a number, axis by axis; lanes that are left over hold the
    /// last sample.
    pub fn displacement_lanes(&self, number: usize) -> [&[f64; LANES]; FREEDOMS] {
        let [x, y, z, tilt_x, tilt_y] = &self.displacement;
        [
            &x.as_chunks().0[number],
            &y.as_chunks().0[number],
            &z.as_chunks().0[number],
            &tilt_x.as_chunks().0[number],
            &tilt_y.as_chunks().0[number],
        ]
    }

    /// Where the shaft is in one of the samples.
    pub fn displacement_at(&self, index: usize) -> Vector5 {
        self.displacement.each_ref().map(|row| row[index])
    }

    /// As [`Sample::time`].
    pub fn times(&self) -> &[f64] {
        &self.time[..self.length]
    }

    /// As [`Sample::angle`].
    pub fn angles(&self) -> &[f64] {
        &self.angle[..self.length]
    }

    /// Along one axis, as [`Sample::displacement`].
    pub fn displacements(&self, axis: usize) -> &[f64] {
        &self.displacement[axis][..self.length]
    }

    /// Along one axis, as [`Sample::velocity`].
    pub fn velocities(&self, axis: usize) -> &[f64] {
        &self.velocity[axis][..self.length]
    }

    /// Along one axis, as [`Sample::force_on_shaft`].
    pub fn forces(&self, axis: usize) -> &[f64] {
        &self.force_on_shaft[axis][..self.length]
    }

    /// As [`Sample::largest_ball_load`].
    pub fn largest_ball_loads(&self) -> &[f64] {
        &self.largest_ball_load[..self.length]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_come_out_as_they_went_in() {
        let sample = |number: usize| {
            let part = number as f64;
            Sample {
                time: part,
                angle: 2.0 * part,
                speed: 3.0 * part,
                displacement: [1.0, 2.0, 3.0, 4.0, 5.0].map(|axis| axis * part),
                velocity: [6.0, 7.0, 8.0, 9.0, 10.0].map(|axis| axis * part),
                force_on_shaft: [11.0, 12.0, 13.0, 14.0, 15.0].map(|axis| axis * part),
                largest_ball_load: 16.0 * part,
                balls_loaded: 0,
                energy: None,
                drive: None,
            }
        };
        let mut rows = SampleRows::new();
        (0..SampleRows::MOST + 2).for_each(|number| rows.push(&sample(number)));
        assert_eq!(rows.len(), SampleRows::MOST);
        for number in 0..SampleRows::MOST {
            assert_eq!(rows.sample(number), sample(number));
        }
        let last = SampleRows::MOST - 1;
        assert_eq!(rows.forces(4)[last], sample(last).force_on_shaft[4]);
        rows.clear();
        assert!(rows.times().is_empty());
    }
}
