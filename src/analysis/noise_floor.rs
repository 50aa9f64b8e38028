//! What is too small to be more than round-off.

use std::f64::consts::PI;

use super::Channel;

/// Part of the largest value of a family of quantities below which one of them is round-off: results of the same
/// scene on another machine, or by another order of operations, differ by about this much; a sensor resolves less: 32 bits
/// are 2e-10.
const ROUND_OFF: f64 = 1e-11;
/// Length by which tilts are compared with displacements and moments with forces, m: the order of the radius of a
/// bearing.
const ARM: f64 = 0.01;

/// Noise floor of the columns of a run or a record: amplitudes below it are round-off.
///
/// It is 1e-11 of the largest value, mean included, in the family of a quantity: displacements with tilts (through a
/// length of 10 mm), velocities, accelerations, forces with moments, and those of single bearings and elements. Velocities and accelerations of a shaft at rest
/// have a floor too: that of the displacements at half the sampling rate. A sensor is a family of its own. Energies, moments
/// of the drive, angles and counts have none.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct NoiseFloor {
    /// Largest displacement in m, velocity in m/s, acceleration in m/s², force in N, force of a bearing or element in N.
    largest: [f64; 5],
    /// Largest value of each sensor.
    measured: Vec<(Channel, f64)>,
}

impl NoiseFloor {
    /// Of columns with their largest magnitudes, `rate` samples a second; zero where that is unknown.
    pub fn new(columns: impl IntoIterator<Item = (Channel, f64)>, rate: f64) -> Self {
        let mut largest = [0.0_f64; 5];
        let mut measured = Vec::new();
        for (channel, magnitude) in columns {
            if let Some((family, length)) = family(channel) {
                largest[family] = largest[family].max(magnitude / length);
            } else if let Channel::Measured(_) = channel {
                measured.push((channel, magnitude));
            }
        }
        let highest = PI * rate;
        largest[1] = largest[1].max(highest * largest[0]);
        largest[2] = largest[2].max(highest * largest[1]);
        Self { largest, measured }
    }

    /// Amplitude below which a column shows round-off, in its unit.
    pub fn below(&self, channel: Channel) -> f64 {
        let largest = match family(channel) {
            Some((family, length)) => self.largest[family] * length,
            None => {
                let mut measured = self.measured.iter();
                let own = measured.find(|(known, _)| *known == channel);
                own.map_or(0.0, |(_, largest)| *largest)
            }
        };
        ROUND_OFF * largest
    }
}

/// Family of a quantity, and what one of its SI unit is in that of the family.
fn family(channel: Channel) -> Option<(usize, f64)> {
    let [angular, moment] = [1.0 / ARM, ARM];
    let (family, freedom, of_rotation) = match channel {
        Channel::Displacement(freedom) => (0, freedom, angular),
        Channel::Velocity(freedom) => (1, freedom, angular),
        Channel::Acceleration(freedom) => (2, freedom, angular),
        Channel::Force(freedom) => (3, freedom, moment),
        Channel::PartForce { freedom, .. } => (4, freedom, moment),
        _ => return None,
    };
    Some((family, if freedom < 3 { 1.0 } else { of_rotation }))
}

/// Distances in bins at which the noise around a line is looked at, and the part of its median that a line exceeds.
const AROUND: std::ops::RangeInclusive<usize> = 5..=40;
const ABOVE_MEDIAN: f64 = 6.0;

/// Whether a line of an amplitude at a bin is above the noise around it: six times its median.
///
/// The amplitude of Gaussian noise in a bin is Rayleigh distributed: it exceeds k medians with the probability `2^(−k²)`, or
/// `2^(−k²/1.5)` under the Hann window compared with a median without window, 6e-8 for k = 6.
pub(crate) fn is_above_noise(amplitudes: &[f64], bin: usize, amplitude: f64) -> bool {
    let median = noise_around(amplitudes, bin);
    median.is_none_or(|median| amplitude > ABOVE_MEDIAN * median)
}

/// Median of the amplitudes around a bin, if it has some.
pub(crate) fn noise_around(amplitudes: &[f64], bin: usize) -> Option<f64> {
    let below = AROUND.filter_map(|distance| bin.checked_sub(distance));
    let places = below.chain(AROUND.map(|distance| bin + distance));
    let mut around: Vec<f64> = places.filter_map(|k| amplitudes.get(k).copied()).collect();
    around.sort_by(f64::total_cmp);
    around.get(around.len() / 2).copied()
}

/// Largest magnitude of some values.
pub(crate) fn magnitude(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_family_has_one_floor() {
        let columns = [
            (Channel::Displacement(2), 20e-6),
            (Channel::Displacement(3), 1e-19),
            (Channel::Velocity(0), 0.0),
            (Channel::Force(2), 1000.0),
            (Channel::Force(4), 1e-13),
        ];
        let floor = NoiseFloor::new(columns, 10e3);
        let close = |value: f64, expected: f64| assert!((value / expected - 1.0).abs() < 1e-12);
        close(floor.below(Channel::Displacement(0)), 2e-16);
        close(floor.below(Channel::Displacement(4)), 2e-14);
        close(floor.below(Channel::Velocity(1)), 2e-16 * PI * 1e4);
        close(floor.below(Channel::Force(0)), 1e-8);
        close(floor.below(Channel::Force(3)), 1e-10);
        assert_eq!(floor.below(Channel::Energy(0)), 0.0);
    }
}
