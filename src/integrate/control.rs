//! How large the next step is to be.

/// Part of the step that the error estimate would allow: where balls lose contact, larger ones are
/// rejected too often.
pub(super) const SAFETY: f64 = 0.8;
/// Least change of the size from one trial to the next.
const SHRINK: f64 = 0.2;
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
    /// Part of the step that the error estimate would allow.
    safety: f64,
    /// Largest change of the size from one trial to the next.
    grow: f64,
    /// Whether the latest trial was rejected.
    rejected: bool,
}

impl Control {
    /// With a part of the step that the error estimate would allow, and the largest change of the size.
    pub fn new(safety: f64, grow: f64) -> Self {
        Self {
            safety,
            grow,
            rejected: false,
        }
    }

    /// Factor after a good step; none above one directly after a bad one.
    pub fn accepted(&mut self, error: f64, power: i32) -> f64 {
        let growth = self.growth(error.max(LEAST_ERROR), power);
        let most = if self.rejected { 1.0 } else { self.grow };
        self.rejected = false;
        growth.clamp(SHRINK, most)
    }

    /// Takes note of a bad step whose error says nothing of the next size.
    pub fn note_rejected(&mut self) {
        self.rejected = true;
    }

    /// Factor after a bad step, whose error may be no number.
    pub fn rejected(&mut self, error: f64, power: i32) -> f64 {
        self.rejected = true;
        let growth = self.growth(error, power);
        if growth >= SHRINK { growth } else { SHRINK }
    }

    fn growth(&self, error: f64, power: i32) -> f64 {
        self.safety * error.powf(-1.0 / f64::from(power))
    }
}
