//! When balls pass a place of a surface.

/// Passages of balls at a place: they happen at shaft angles ψ and cage angles ψ_c at which
///
/// ```text
/// offset + by_cage ψ_c + by_shaft ψ
/// ```
///
/// is a whole number of periods, all in rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Passing {
    /// Value at the start.
    pub offset: f64,
    /// Part that turns with the cage.
    pub by_cage: f64,
    /// Part that turns with the shaft.
    pub by_shaft: f64,
    /// From one passage to the next.
    pub period: f64,
    /// Radius that makes a distance of the angle, m.
    pub radius: f64,
}

impl Passing {
    /// Change by the angle of the shaft where the cage turns by a ratio of it.
    pub fn rate(&self, cage_ratio: f64) -> f64 {
        self.by_cage * cage_ratio + self.by_shaft
    }

    /// The first angle of the shaft beyond `after`, `later` passages on, where the cage turns by a ratio of it; none where no
    /// ball ever passes.
    pub fn next_angle(&self, after: f64, cage_ratio: f64, later: u32) -> Option<f64> {
        let rate = self.rate(cage_ratio);
        if rate == 0.0 {
            return None;
        }
        let (period, offset) = (self.period.copysign(rate), self.offset);
        let passed = ((offset + rate * after) / period).floor();
        Some(((passed + 1.0 + f64::from(later)) * period - offset) / rate)
    }

    /// How far balls are past the place, or before it, m, at angles of cage and shaft: continuous, with a simple zero at
    /// each passage.
    pub fn distance(&self, cage: f64, shaft: f64) -> f64 {
        let angle = self.offset + self.by_cage * cage + self.by_shaft * shaft;
        let scale = std::f64::consts::PI / self.period;
        (scale * angle).sin() * self.radius / scale
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passages_follow_each_other_forwards_and_backwards() {
        for by_shaft in [0.0, -1.0] {
            let passing = Passing {
                offset: 0.3,
                by_cage: 1.0,
                by_shaft,
                period: 0.7,
                radius: 0.02,
            };
            let (ratio, mut angle) = (0.4, 0.0);
            for _ in 0..50 {
                let next = passing.next_angle(angle, ratio, 0).expect("a passage");
                assert!(next > angle);
                let apart = passing.distance(ratio * next, next);
                assert!(apart.abs() < 1e-15, "{apart:e}");
                let further = passing.next_angle(next + 1e-9, ratio, 0).expect("another");
                let expected = 0.7 / passing.rate(ratio).abs();
                assert!((further - next - expected).abs() < 1e-12);
                angle = next + 1e-9;
            }
        }
    }
}
