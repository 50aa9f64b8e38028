//! Event surfaces that a step is about to cross, seen before it is tried: a landing then costs no trial.

use super::pair::ExplicitPair;
use super::stepper::ExplicitStepper;
use crate::integrate::chunks::Padded;
use crate::integrate::problem::Problem;

/// Steps without a landing after which none is looked out for: a trial finds it. Where crossings are let pass, to look
/// out for them costs time for nothing.
const SELDOM: f64 = 8.0;

impl<P: ExplicitPair> ExplicitStepper<P> {
    /// Plans landings where the step to come crosses surfaces that spoil it, as far as displacement, velocity and
    /// acceleration at its start tell.
    pub(super) fn foresee(&mut self, problem: &Problem<'_>) {
        let often = self.start - self.crossing.landed < SELDOM * self.next_size;
        let system = problem.system;
        if !often || !system.is_second_order() || self.crossing.next_landing().is_some() {
            return;
        }
        let plan = self.plan(None);
        let mut deviation = std::mem::take(&mut self.argument);
        self.carry_on(plan.end, &mut deviation);
        let crossing = &mut self.crossing;
        problem.write_state(&deviation, &mut crossing.state);
        self.argument = deviation;
        if !crossing.looks_ahead(system, plan.end) {
            return;
        }
        let [start, end] = &mut crossing.ends;
        problem.write_state(&self.from, &mut crossing.state);
        system.events(self.start, &crossing.state, start);
        end.copy_from_slice(&crossing.ahead.values);
        if self.does_any_count(problem, &plan) {
            self.plan_landings(problem, plan.size, Self::carry_on);
        }
    }

    /// Deviation at a time after the start of the step to come, as if its acceleration went on as of late; velocities
    /// as if it stayed.
    fn carry_on(&self, time: f64, deviation: &mut Padded) {
        let (after, dofs) = (time - self.start, self.from.len() / 2);
        for dof in 0..dofs {
            let velocity = self.from[dofs + dof];
            let acceleration = self.start_rate[dofs + dof];
            let before = self.rate_before[dofs + dof];
            let jerk = if before.is_finite() {
                (acceleration - before) / self.size_before
            } else {
                0.0
            };
            let curved = acceleration + after * jerk / 3.0;
            deviation[dof] = self.from[dof] + after * (velocity + 0.5 * after * curved);
            deviation[dofs + dof] = velocity + after * acceleration;
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use super::super::landing::Landing;
    use super::super::verner76::Verner76;
    use super::*;
    use crate::integrate::stepper::Start;
    use crate::integrate::{Method, Scaling, Settings, System};

    /// A ball that falls on elastic ground.
    struct Falling;

    impl System for Falling {
        fn states(&self) -> usize {
            2
        }

        fn derivative(&self, _time: f64, state: &[f64], rate: &mut [f64]) {
            rate[0] = state[1];
            rate[1] = 1e3 * (-state[0]).max(0.0).powf(1.5) - 1.0;
        }

        fn event_count(&self) -> usize {
            1
        }

        fn events(&self, _time: f64, state: &[f64], values: &mut [f64]) {
            values[0] = -state[0];
        }

        fn force_jump(&self, _event: usize, _time: f64, distance: f64, rate: &mut [f64]) {
            rate.copy_from_slice(&[0.0, 1e3 * distance.powf(1.5)]);
        }

        fn is_second_order(&self) -> bool {
            true
        }
    }

    /// The landing that is foreseen from a height of one, at rest, by a step of a size.
    fn foreseen(size: f64, latest_landing: f64) -> Option<Landing> {
        let (stop, scaling) = (AtomicBool::new(false), Scaling::identity(2));
        let settings = Settings {
            method: Method::Verner76,
            tolerance: 1e-6,
            step_limit: u64::MAX,
        };
        let problem = Problem {
            system: &Falling,
            scaling: &scaling,
            settings: &settings,
            stop: &stop,
            end: 100.0,
            slack: 1e-9,
        };
        let mut stepper =
            ExplicitStepper::<Verner76>::new(&problem, &Start::in_deviation(&[1.0, 0.0], size));
        stepper.begin(&problem);
        stepper.crossing.landed = latest_landing;
        stepper.foresee(&problem);
        stepper.crossing.next_landing()
    }

    /// y = 1 − t²/2 comes to the ground at √2.
    #[test]
    fn a_fall_is_foreseen_where_one_was_of_late_and_the_step_reaches_the_ground() {
        let landing = foreseen(1.6, 0.0).expect("a landing");
        let off = landing.time - std::f64::consts::SQRT_2;
        assert!(off.abs() < 1e-8 && !landing.ends, "{landing:?}");
        assert_eq!(foreseen(1.4, 0.0), None);
        assert_eq!(foreseen(1.6, -100.0), None);
    }
}
