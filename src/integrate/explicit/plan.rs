//! How far a trial step goes, and what its error says of the next one.

use super::landing::Landing;
use super::pair::ExplicitPair;
use super::stepper::ExplicitStepper;
use super::substitution::Substitution;
use crate::integrate::problem::STRETCH;

/// Error of a step from or to a surface, over its estimate: measured. Such steps stand alone, and one whose
/// estimate is too good has no neighbours to make up for it.
const DOUBT: f64 = 3.0;
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

impl Plan {
    /// Whether a landing that is due at a time is the one of this step.
    pub fn lands_on(&self, due: f64) -> bool {
        self.landing.is_some_and(|landing| landing.time == due)
    }
}

impl<P: ExplicitPair> ExplicitStepper<P> {
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
    pub(super) fn doubt(&self) -> f64 {
        if self.substitution.is_none() {
            1.0
        } else {
            DOUBT
        }
    }

    /// Power of the step size that the error falls with: in the variable that is squared it has half.
    fn error_power(&self) -> i32 {
        if self.substitution.is_none() {
            P::ERROR_POWER
        } else {
            (P::ERROR_POWER + 1) / 2
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
            // a step that was cut tells little of how long the next may be
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

    /// What a step from or to a surface says of the next one.
    fn resize(&mut self, proposed: f64, free: bool) {
        let Substitution { start, end } = self.substitution;
        for (size, is) in self.crossing.sizes.iter_mut().zip([start, end]) {
            if is {
                *size = if free { proposed } else { size.max(proposed) };
            }
        }
    }
}
