//! Lines at multiples of the shaft's frequency, by sums of their own.

use std::f64::consts::TAU;

/// Sums over whole revolutions that give the lines at the first multiples of the shaft's frequency.
///
/// ```text
/// y_p = Σ_t x_{p + Bt}   A_k = (s/N) |Σ_p y_p exp(−2πikp/B)|
/// ```
///
/// with B samples a revolution, N of them in all, s = 2 for lines that have an image at −f and 1 for others: what
/// the transform of all N samples has in its bins kN/B.
pub(super) struct OrderSums {
    /// Cosine and sine of every place of a revolution.
    places: Vec<[f64; 2]>,
    orders: usize,
}

impl OrderSums {
    /// For so many samples a revolution: the mean and orders up to the highest one, as far as the sampling
    /// resolves it.
    pub fn new(per_revolution: usize, highest: u32) -> Self {
        let place = |index: usize| {
            let (sin, cos) = (TAU * index as f64 / per_revolution as f64).sin_cos();
            [cos, sin]
        };
        Self {
            places: (0..per_revolution).map(place).collect(),
            orders: (highest as usize).min(per_revolution / 2) + 1,
        }
    }

    /// One-sided amplitudes of samples of whole revolutions, the mean first.
    pub fn amplitudes(&self, values: &[f64]) -> Vec<f64> {
        let Some(origin) = values.first() else {
            return vec![0.0; self.orders];
        };
        // less the first value, so that a mean that is large beside the motion cancels nothing
        let mut revolution = vec![0.0; self.places.len()];
        for own in values.chunks_exact(self.places.len()) {
            for (sum, value) in revolution.iter_mut().zip(own) {
                *sum += value - origin;
            }
        }
        let count = values.len() as f64;
        let amplitude = |order: usize| match order {
            0 => (origin + revolution.iter().sum::<f64>() / count).abs(),
            _ => self.line(order, &revolution) / count,
        };
        (0..self.orders).map(amplitude).collect()
    }

    /// s |Σ_p y_p exp(−2πikp/B)|
    fn line(&self, order: usize, revolution: &[f64]) -> f64 {
        let block = self.places.len();
        let (mut sum, mut place) = ([0.0; 2], 0);
        for value in revolution {
            let [cos, sin] = self.places[place];
            sum = [sum[0] + value * cos, sum[1] + value * sin];
            // no order is beyond half a revolution
            place += order;
            if place >= block {
                place -= block;
            }
        }
        let sides = if 2 * order < block { 2.0 } else { 1.0 };
        sides * sum[0].hypot(sum[1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::{Transform, Window};

    #[test]
    fn lines_are_those_of_the_whole_transform() {
        for (block, turns) in [(12, 5), (128, 19), (7, 3)] {
            let value = |n: usize| {
                let angle = TAU * n as f64 / block as f64;
                3.0 + (angle + 0.4).cos() + 0.1 * (2.0 * angle).sin() + 0.3 * (0.37 * angle).cos()
            };
            let values: Vec<f64> = (0..block * turns).map(value).collect();
            let found = OrderSums::new(block, 10).amplitudes(&values);
            assert_eq!(found.len(), (block / 2).min(10) + 1);
            let transform = Transform::new(values);
            for (order, amplitude) in found.into_iter().enumerate() {
                let expected = transform.amplitude(order * turns, Window::Rectangular);
                assert!(
                    (amplitude - expected).abs() < 1e-14,
                    "{block} {order}: {amplitude} {expected}"
                );
            }
        }
    }

    #[test]
    fn of_nothing_there_are_no_lines() {
        assert_eq!(OrderSums::new(8, 3).amplitudes(&[]), [0.0; 4]);
    }
}
