//! A change of variable within a step, by which broken powers at its ends become smooth.

/// Which ends of a step are singular: at a surface that a contact force starts from, or comes down to.
///
/// The step `t = t₀ + h φ(s)` runs over s from 0 to 1. A derivative that grows with the power 3/2 of
/// the time from a singular end is then smooth in s:
///
/// ```text
/// singular   φ(s)
/// neither    s
/// start      s²
/// end        1 − (1 − s)²
/// both       3 s² − 2 s³
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Substitution {
    pub start: bool,
    pub end: bool,
}

impl Substitution {
    pub const NONE: Self = Self {
        start: false,
        end: false,
    };

    pub fn is_none(self) -> bool {
        self == Self::NONE
    }

    /// φ and its slope.
    #[inline]
    pub fn at(self, s: f64) -> [f64; 2] {
        match (self.start, self.end) {
            (false, false) => [s, 1.0],
            (true, false) => [s * s, 2.0 * s],
            (false, true) => [s * (2.0 - s), 2.0 * (1.0 - s)],
            (true, true) => [s * s * (3.0 - 2.0 * s), 6.0 * s * (1.0 - s)],
        }
    }

    /// The s at a part φ of the step.
    pub fn inverse(self, part: f64) -> f64 {
        let part = part.clamp(0.0, 1.0);
        match (self.start, self.end) {
            (false, false) => part,
            (true, false) => part.sqrt(),
            (false, true) => 1.0 - (1.0 - part).sqrt(),
            // 3 s² − 2 s³ = φ by s = 1/2 − sin(arcsin(1 − 2φ)/3)
            (true, true) => 0.5 - ((1.0 - 2.0 * part).asin() / 3.0).sin(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_and_slopes_fit_each_other() {
        for (start, end) in [(false, false), (true, false), (false, true), (true, true)] {
            let change = Substitution { start, end };
            for step in 0..=100 {
                let s = f64::from(step) / 100.0;
                let [part, slope] = change.at(s);
                assert!((change.inverse(part) - s).abs() < 1e-7, "{change:?} {s}");
                let by_difference = (change.at(s + 1e-6)[0] - change.at(s - 1e-6)[0]) / 2e-6;
                assert!((slope - by_difference).abs() < 1e-9, "{change:?} {s}");
            }
            assert_eq!(change.at(0.0)[0], 0.0);
            assert_eq!(change.at(1.0)[0], 1.0);
            assert_eq!(change.at(0.0)[1] == 0.0, start);
            assert_eq!(change.at(1.0)[1] == 0.0, end);
        }
    }
}
