//! How large the next step is to be.

/// Part of the step that the error estimate would allow.
const SAFETY: f64 = 0.9;
/// Least and largest change of the size from one trial to the next.
const SHRINK: f64 = 0.2;
const GROW: f64 = 6.0;
/// Least error that counts: growth is limited anyway.
const LEAST_ERROR: f64 = 1e-12;
/// Weight of the error of the step before, in parts of the exponent.
const MEMORY: f64 = 0.2;

/// Proposes step sizes from errors, where an error of one is just allowed.
///
/// Source: K. Gustafsson, "Control theoretic techniques for stepsize selection in explicit
/// Runge–Kutta methods", *ACM Trans. Math. Softw.* 17 (1991) 533–554.
#[derive(Debug, Clone, Copy)]
pub(super) struct Control {
    /// Error of the latest accepted step.
    before: f64,
    /// Whether the latest trial was rejected.
    rejected: bool,
}

impl Control {
    pub const NEW: Self = Self {
        before: 1.0,
        rejected: false,
    };

    /// Factor of the step size after a good step of an error; `power` is that of the step size which
    /// the error falls with.
    pub fn accepted(&mut self, error: f64, power: i32) -> f64 {
        let error = error.max(LEAST_ERROR);
        let exponent = 1.0 / f64::from(power);
        let growth = SAFETY * error.powf(-exponent) * (self.before / error).powf(MEMORY * exponent);
        let most = if self.rejected { 1.0 } else { GROW };
        *self = Self {
            before: error,
            rejected: false,
        };
        growth.clamp(SHRINK, most)
    }

    /// Factor of the step size after a bad step; the error may be no number.
    pub fn rejected(&mut self, error: f64, power: i32) -> f64 {
        self.rejected = true;
        let growth = SAFETY * error.powf(-1.0 / f64::from(power));
        // neither a number nor a bound comes from a trial that was not finite
        if growth >= SHRINK { growth.min(1.0) } else { SHRINK }
    }
}
