//! How large the next step is to be.

/// Part of the step that the error estimate would allow: where balls lose contact, larger ones are
/// rejected too often.
const SAFETY: f64 = 0.8;
/// Least and largest change of the size from one trial to the next.
const SHRINK: f64 = 0.2;
const GROW: f64 = 6.0;
/// Power of the step size that the error over a surface falls with, inverse.
const CROSSING_POWER: f64 = 0.4;
/// Least error that counts: growth is limited anyway.
const LEAST_ERROR: f64 = 1e-12;

/// Factors of the step size from errors, where an error of one is just allowed and the error falls
/// with a power of the size.
///
/// A part proportional to the change of the error, as K. Gustafsson proposes (*ACM Trans. Math. Softw.*
/// 17 (1991) 533–554), was tried at 0.1 to 0.4 of the exponent: evaluations to a given error moved by
/// less than their scatter, on smooth motion and with balls that lose contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Control {
    /// Whether the latest trial was rejected.
    rejected: bool,
}

impl Control {
    pub const NEW: Self = Self { rejected: false };

    /// As it is after a trial that was rejected or not.
    pub fn after(rejected: bool) -> Self {
        Self { rejected }
    }

    /// Whether the latest trial was rejected.
    pub fn was_rejected(&self) -> bool {
        self.rejected
    }

    /// Factor after a good step; none above one directly after a bad one.
    pub fn accepted(&mut self, error: f64, power: i32) -> f64 {
        let growth = growth(error.max(LEAST_ERROR), power);
        let most = if self.rejected { 1.0 } else { GROW };
        self.rejected = false;
        growth.clamp(SHRINK, most)
    }

    /// As [`Control::accepted`], but exactly one for an error from the first of two on up to the second: where
    /// sizes stay, the next step then need not wait for what this error is.
    pub fn kept_or_accepted(&mut self, error: f64, [least, most]: [f64; 2], power: i32) -> f64 {
        if error >= least && error <= most {
            self.rejected = false;
            1.0
        } else {
            self.accepted(error, power)
        }
    }

    /// Factor after a step whose error for what it goes over is too large.
    pub fn crossed(&mut self, error: f64) -> f64 {
        self.rejected = true;
        error.powf(-CROSSING_POWER).max(SHRINK)
    }

    /// Factor after a bad step, whose error may be no number.
    pub fn rejected(&mut self, error: f64, power: i32) -> f64 {
        self.rejected = true;
        let growth = growth(error, power);
        if growth >= SHRINK { growth } else { SHRINK }
    }
}

/// The errors that lead to factors between two, the lower one first.
pub(super) const fn errors([shrink, grow]: [f64; 2], power: i32) -> [f64; 2] {
    let mut errors = [1.0; 2];
    let mut step = 0;
    while step < power {
        errors = [errors[0] * SAFETY / grow, errors[1] * SAFETY / shrink];
        step += 1;
    }
    errors
}

fn growth(error: f64, power: i32) -> f64 {
    SAFETY * error.powf(-1.0 / f64::from(power))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_stay_where_their_factors_are_about_one() {
        let (about, power) = ([0.95, 1.2], 9);
        let kept = errors(about, power);
        for step in 1..1000 {
            let error = 1e-3 * f64::from(step);
            let [mut plain, mut keeping] = [Control::NEW; 2];
            let factor = plain.accepted(error, power);
            let found = keeping.kept_or_accepted(error, kept, power);
            if (about[0]..=about[1]).contains(&factor) {
                assert_eq!(found, 1.0, "{error}");
            } else {
                assert_eq!(found, factor, "{error}");
            }
        }
        let mut control = Control::after(true);
        control.kept_or_accepted(0.1, kept, power);
        assert!(!control.was_rejected());
    }
}
