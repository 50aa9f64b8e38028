//! Steps of equal size show the orders of the pair and of its interpolant.

use std::sync::atomic::AtomicBool;

use super::*;
use crate::integrate::{Method, Scaling, Settings, System};

/// q″ = −(1 + sin(t)/2) q³ + cos 2t, as (q, q′): time enters, and it is not linear.
struct Duffing;

impl System for Duffing {
    fn states(&self) -> usize {
        2
    }

    fn derivative(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        let stiffness = 1.0 + 0.5 * time.sin();
        rate[0] = state[1];
        rate[1] = (2.0 * time).cos() - stiffness * state[0].powi(3);
    }
}

const START: [f64; 2] = [1.0, 0.0];

/// The stepper after a time in so many equal steps.
fn stepped(steps: u32, time: f64) -> ExplicitStepper {
    stepped_by(Level::new(), steps, time)
}

/// That by a level of the processor.
fn stepped_by(level: Level, steps: u32, time: f64) -> ExplicitStepper {
    let stop = AtomicBool::new(false);
    let settings = Settings {
        method: Method::Verner76,
        tolerance: 1.0,
        step_limit: u64::MAX,
    };
    let problem = Problem {
        system: &Duffing,
        scaling: Scaling::identity(2),
        settings,
        stop: &stop,
        progress: None,
        end: 100.0,
        interval: 1.0,
    };
    let mut stepper = ExplicitStepper {
        level,
        ..ExplicitStepper::new(&problem, &Start::from_deviation(&START))
    };
    for step in 1..=steps {
        stepper.begin(&problem);
        stepper.size = time / f64::from(steps);
        let plan = stepper.plan(None);
        stepper.substitute(&plan);
        stepper.trial(&problem);
        stepper.time = time * f64::from(step) / f64::from(steps);
        stepper.finish(&problem);
    }
    stepper.extend(&problem);
    stepper
}

/// Deviation at a time within the latest step by the interpolant of the pair.
fn by_stages(stepper: &ExplicitStepper, time: f64) -> [f64; 2] {
    let mut deviation = Padded::zeros(2);
    stepper.by_stages(time, &mut deviation);
    [deviation[0], deviation[1]]
}

fn distance(left: &[f64], right: &[f64]) -> f64 {
    (left[0] - right[0]).abs().max((left[1] - right[1]).abs())
}

/// Slope of log error over log step, from an error and that at half the step.
fn order(coarse: f64, fine: f64) -> f64 {
    (coarse / fine).log2()
}

#[test]
fn every_width_of_registers_gives_the_same_bytes() {
    let slopes = |stepper: ExplicitStepper| {
        let all = stepper.stages.as_flattened().as_flattened();
        all.iter().map(|slope| slope.to_bits()).collect::<Vec<_>>()
    };
    assert_eq!(
        slopes(stepped(50, 4.0)),
        slopes(stepped_by(Level::baseline(), 50, 4.0))
    );
}

#[test]
fn equal_steps_converge_with_the_order_of_the_method() {
    let truth = stepped(4000, 4.0).to;
    let error = |steps| distance(&stepped(steps, 4.0).to, &truth);
    let observed = order(error(20), error(40));
    // one more where the error of the next order dominates
    let excess = observed - f64::from(ORDER);
    assert!((-0.6..1.6).contains(&excess), "observed {observed}");
}

/// Fall of the error within a first step as the step is halved.
fn order_within(size: f64, state: impl Fn(f64) -> [f64; 2]) -> f64 {
    let error = |size: f64| {
        let truth = stepped(200, 0.4 * size).to;
        distance(&state(size), &truth)
    };
    order(error(size), error(0.5 * size))
}

/// Of one step the error falls with the order of the interpolant plus one.
#[test]
fn states_within_a_step_have_the_order_of_the_interpolant() {
    let own = order_within(0.3, |size| by_stages(&stepped(1, size), 0.4 * size));
    let excess = own - 7.0;
    assert!((-0.6..1.6).contains(&excess), "{excess}");
}
