//! Steps of equal size show the orders of the pairs, of their interpolants and of the quintic.

use std::sync::atomic::AtomicBool;

use super::*;
use crate::integrate::explicit::Verner76;
use crate::integrate::explicit::quintic::{self, Quintic};
use crate::integrate::{Method, Settings};

/// q″ = −(1 + sin(t)/2) q³ + cos 2t, as (q, q′): time enters, and it is not linear.
struct Duffing;

impl System<2> for Duffing {
    fn derivative(&self, time: f64, [place, speed]: &[f64; 2], rate: &mut [f64; 2]) {
        let stiffness = 1.0 + 0.5 * time.sin();
        *rate = [*speed, (2.0 * time).cos() - stiffness * place.powi(3)];
    }

    fn is_second_order(&self) -> bool {
        true
    }
}

const START: [f64; 2] = [1.0, 0.0];

/// The walk over a time in so many equal steps.
fn walked<P: Pair>(steps: u32, time: f64) -> Walk<2> {
    walked_by::<P>(Level::new(), steps, time)
}

/// The same by a level of the processor.
fn walked_by<P: Pair>(level: Level, steps: u32, time: f64) -> Walk<2> {
    let (stop, scaling) = (AtomicBool::new(false), Scaling::IDENTITY);
    let settings = Settings {
        method: Method::Verner76,
        tolerance: 1.0,
        step_limit: u64::MAX,
    };
    let course = Course {
        system: &Duffing,
        scaling: &scaling,
        settings: &settings,
        stop: &stop,
        end: 100.0,
        slack: 1e-9,
    };
    let mut walk = Walk {
        level,
        ..Walk::new(0.0, START, 0.0, Counters::default())
    };
    for step in 1..=steps {
        walk.begin::<P, _>(&course);
        walk.size = time / f64::from(steps);
        walk.trial::<P, _>(&course);
        walk.time = time * f64::from(step) / f64::from(steps);
        walk.finish::<P, _>(&course);
    }
    walk.extend::<P, _>(&course);
    walk
}

fn distance([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    (a - c).abs().max((b - d).abs())
}

/// Slope of log error over log step, from an error and that at half the step.
fn order(coarse: f64, fine: f64) -> f64 {
    (coarse / fine).log2()
}

#[test]
fn every_width_of_registers_gives_the_same_bytes() {
    let slopes = |walk: Walk<2>| walk.stages.map(|stage| stage.map(f64::to_bits));
    assert_eq!(
        slopes(walked::<Verner76>(50, 4.0)),
        slopes(walked_by::<Verner76>(Level::baseline(), 50, 4.0))
    );
}

fn steps_have_order<P: Pair>(steps: u32) {
    let truth = walked::<Verner76>(4000, 4.0).to;
    let error = |steps| distance(walked::<P>(steps, 4.0).to, truth);
    let observed = order(error(steps), error(2 * steps));
    // one more where the error of the next order dominates
    let excess = observed - f64::from(P::ORDER);
    assert!((-0.6..1.6).contains(&excess), "observed {observed}");
}

#[test]
fn equal_steps_converge_with_the_order_of_the_method() {
    steps_have_order::<Verner76>(20);
}

/// Fall of the error within a first step as the step is halved.
fn order_within(size: f64, state: impl Fn(f64) -> [f64; 2]) -> f64 {
    let error = |size: f64| {
        let truth = walked::<Verner76>(200, 0.4 * size).to;
        distance(state(size), truth)
    };
    order(error(size), error(0.5 * size))
}

/// Of one step the error falls with the order of the interpolant plus one.
#[test]
fn states_within_a_step_have_the_order_of_the_interpolant() {
    fn own<P: Pair>(size: f64) -> f64 {
        order_within(size, |size| walked::<P>(1, size).by_stages::<P>(0.4 * size))
    }
    let excess = own::<Verner76>(0.3) - 7.0;
    assert!((-0.6..1.6).contains(&excess), "{excess}");
}

#[test]
fn the_velocity_of_the_quintic_has_order_four_and_gains_one_within_a_step() {
    let observed = order_within(0.2, |size| {
        walked::<Verner76>(1, size).by_quintic(0.4 * size, Verner76::LAST)
    });
    assert!((observed - 5.0).abs() < 0.8, "{observed}");
}

/// Its error shows in the jump of q‴ from step to step.
#[test]
fn the_quintic_knows_its_error() {
    const STEEPEST: f64 = 0.276_393_2;
    for steps in [40, 80] {
        let size = 4.0 / f64::from(steps);
        let before = walked::<Verner76>(steps - 1, 4.0 - size);
        let walk = walked::<Verner76>(steps, 4.0);
        let [start, end] = walk.ends(0, Verner76::LAST);
        let jerk = Quintic::new(size, start, end).jerks()[0] / size.powi(3);
        let [place, velocity] = quintic::errors(jerk - before.jerk[0], size, size);
        let off = |part: f64, index: usize| {
            let time = walk.start + part * size;
            let own = walk.by_stages::<Verner76>(time);
            (walk.by_quintic(time, Verner76::LAST)[index] - own[index]).abs()
        };
        for ratio in [place / off(0.5, 0), velocity / off(STEEPEST, 1)] {
            assert!((0.5..2.0).contains(&ratio), "{steps} steps: {ratio}");
        }
    }
}
