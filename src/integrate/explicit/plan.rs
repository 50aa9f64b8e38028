//! The size of a trial step, the variable that it is taken in, and the size of the next one by its error.

use super::crossing::Landing;
use super::stepper::ExplicitStepper;
use super::verner76::ORDER;
use crate::integrate::problem::STRETCH;

/// Error of a step in another variable, over its estimate: such steps are single, and where the estimate of one is too
/// good no neighbours make up for it.
const SINGLE_STEP: f64 = 3.0;
/// Most that a step may be longer than the one from a surface before it.
const AFTER_SURFACE: f64 = 4.0;

/// Where a trial step ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plan {
    /// Its size, s.
    pub size: f64,
    /// Time, s.
    pub end: f64,
    /// Whether the step is shorter than its error would allow.
    pub short: bool,
    /// Where it is to end on a surface.
    pub landing: Option<Landing>,
}

/// A change of the variable of a step, by which broken powers at its ends become smooth: which ends are singular, as
/// where the derivative begins to grow with a broken power of the distance past a surface, or comes down to it.
///
/// The step `t = t₀ + h φ(s)` runs over s from 0 to 1. What grows with the power n of the time from a singular end grows
/// with the power 2n of s: smooth for halves, as 3/2, and of twice the order for all others.
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
    pub fn is_none(self) -> bool {
        self == Self::default()
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

impl Plan {
    /// Whether a landing that is due at a time is the one of this step.
    pub fn lands_on(&self, due: f64) -> bool {
        self.landing.is_some_and(|landing| landing.time == due)
    }
}

impl ExplicitStepper {
    /// The next trial: up to the next landing, break or end, or as far as the error allows.
    pub(super) fn plan(&self, landing: Option<Landing>) -> Plan {
        let [from_surface, to_surface] = self.crossing.sizes;
        let most = if self.crossing.fresh {
            self.next_size.min(from_surface)
        } else {
            self.next_size
        };
        let last = match landing {
            Some(landing) if landing.ends => to_surface.min(most),
            _ => most,
        };
        let target = landing.map_or(self.limit, |landing| landing.time);
        if self.start + STRETCH * last >= target {
            return Plan {
                size: target - self.start,
                end: target,
                short: true,
                landing,
            };
        }
        // leaves room for the last step
        let room = target - self.start - last;
        let short = last < most && room < most;
        let size = if short { room } else { most };
        Plan {
            size,
            end: self.start + size,
            short,
            landing: None,
        }
    }

    /// Chooses the variable of the step.
    pub(super) fn substitute(&mut self, plan: &Plan) {
        self.substitution = Substitution {
            start: self.crossing.fresh,
            end: plan.landing.is_some_and(|landing| landing.ends),
        };
        let [_, slope] = self.substitution.at(0.0);
        for (stages, rate) in self.stages.iter_mut().zip(self.start_rate.chunks()) {
            stages[0] = rate.map(|rate| slope * rate);
        }
    }

    /// Factor of the error estimate.
    pub(super) fn error_factor(&self) -> f64 {
        if self.substitution.is_none() {
            1.0
        } else {
            SINGLE_STEP
        }
    }

    /// Power of the step size that the error falls with: in the variable that is squared it has half.
    fn error_power(&self) -> i32 {
        if self.substitution.is_none() {
            ORDER
        } else {
            (ORDER + 1) / 2
        }
    }

    /// Moves to the end of a good step.
    pub(super) fn accept(&mut self, plan: &Plan, error: f64) {
        let growth = self.control.accepted(error, self.error_power());
        let proposed = self.size * growth;
        if !self.substitution.is_none() {
            self.resize(proposed, !plan.short);
            if self.substitution.start && !plan.short {
                self.next_size = self.next_size.min(AFTER_SURFACE * self.size);
            }
        } else if plan.short {
            // the error of a step that was cut does not bound the next one
            self.next_size = proposed.max(self.next_size);
        } else {
            self.next_size = proposed;
        }
        self.time = plan.end;
    }

    /// Shortens the next trial.
    pub(super) fn reject(&mut self, error: f64) {
        self.counters.rejected += 1;
        self.fault |= !error.is_finite();
        let factor = self.control.rejected(error, self.error_power());
        if self.substitution.is_none() {
            self.next_size = self.size * factor;
        } else {
            self.resize(self.size * factor, true);
        }
    }

    /// Sizes the next step from or to a surface by the latest one.
    fn resize(&mut self, proposed: f64, free: bool) {
        let Substitution { start, end } = self.substitution;
        for (size, is) in self.crossing.sizes.iter_mut().zip([start, end]) {
            if is {
                *size = if free { proposed } else { size.max(proposed) };
            }
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
