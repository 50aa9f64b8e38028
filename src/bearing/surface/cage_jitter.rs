//! How the balls of a cage wander about where they would nominally be.

use std::f64::consts::TAU;

/// A cage that gains or loses some angle with every ball pass.
///
/// At the nominal cage angle χ, n = ⌊χ/s⌋ spacings s of the balls on from the start, the cage is at
///
/// ```text
/// χ + Σ_(k<n) Δ_k + Δ_n S(χ/s − n)        S(u) = u³ (10 − 15 u + 6 u²)
/// ```
///
/// in rad: its angle, speed and acceleration are continuous, and from one ball pass to the next it is a polynomial.
#[derive(Debug, Clone, PartialEq)]
pub struct CageJitter {
    steps: Vec<f64>,
    /// Sums of the steps before each, and of all.
    sums: Vec<f64>,
    /// s, rad.
    spacing: f64,
}

impl CageJitter {
    /// Jitter of a cage with so many balls that gains these angles Δ, rad, one with every ball pass, and then again; none where there
    /// are no steps.
    pub fn new(steps: &[f64], balls: usize) -> Option<Self> {
        if steps.is_empty() {
            return None;
        }
        let mut sums = vec![0.0; steps.len() + 1];
        for (index, step) in steps.iter().enumerate() {
            sums[index + 1] = sums[index] + step;
        }
        Some(Self {
            steps: steps.to_vec(),
            sums,
            spacing: TAU / balls as f64,
        })
    }

    /// How far the cage is ahead at a nominal angle, rad, and the slope of that.
    pub fn at(&self, angle: f64) -> [f64; 2] {
        let passes = angle / self.spacing;
        let whole = passes.floor();
        let part = passes - whole;
        let count = self.steps.len();
        let number = whole.rem_euclid(count as f64) as usize % count;
        let rounds = (whole / count as f64).floor();
        let step = self.steps[number];
        let square = part * part;
        let smooth = square * part * (10.0 + part * (6.0 * part - 15.0));
        let slope = 30.0 * square * (1.0 - part) * (1.0 - part);
        let before = rounds * self.sums[count] + self.sums[number];
        [before + step * smooth, step * slope / self.spacing]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cage_wanders_smoothly_and_takes_every_step() {
        let steps = [0.01, -0.02, 0.005];
        let jitter = CageJitter::new(&steps, 9).expect("steps");
        let mut sum = 0.0;
        for pass in 0..7 {
            let angle = f64::from(pass) * jitter.spacing;
            let [ahead, slope] = jitter.at(angle + 1e-12);
            assert!((ahead - sum).abs() < 1e-12 && slope.abs() < 1e-9);
            for part in [0.1, 0.5, 0.83] {
                let angle = angle + part * jitter.spacing;
                let [ahead, behind] = [1e-6, -1e-6].map(|step| jitter.at(angle + step)[0]);
                let [_, slope] = jitter.at(angle);
                assert!((slope - (ahead - behind) / 2e-6).abs() < 1e-8);
                // the steepest slope of S times that of the largest step
                assert!(slope.abs() <= 1.875 * 0.02 / jitter.spacing);
            }
            sum += steps[pass as usize % 3];
        }
        assert_eq!(CageJitter::new(&[], 9), None);
    }
}
