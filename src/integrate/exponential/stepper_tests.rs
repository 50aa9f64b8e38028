//! How a step begins.

use std::sync::atomic::AtomicBool;

use super::*;
use crate::integrate::{Method, Scaling, Settings, System};

/// Nothing moves.
struct Still;

impl System for Still {
    fn states(&self) -> usize {
        1
    }

    fn derivative(&self, _time: f64, _state: &[f64], rate: &mut [f64]) {
        rate[0] = 0.0;
    }
}

/// A stepper whose latest step, of one second, saw a remainder that grows by one a second from 1/3 on.
fn after_a_step() -> ExponentialStepper {
    let stop = AtomicBool::new(false);
    let settings = Settings {
        method: Method::Exponential,
        tolerance: 1.0,
        step_limit: u64::MAX,
    };
    let problem = Problem {
        system: &Still,
        scaling: Scaling::identity(1),
        settings,
        stop: &stop,
        progress: None,
        end: 1.0,
        interval: 1.0,
    };
    let mut stepper = ExponentialStepper::new(&problem, &Start::from_deviation(&[0.0]));
    stepper.remainder_size = 1.0;
    stepper.remainder[0] = NODES.part.map(|part| [1.0 / 3.0 + part, 0.0, 0.0, 0.0]);
    stepper
}

/// Up to [`GROW`] the remainder is carried on by its polynomial. Far beyond, as behind a step that was cut
/// next to a sample, the polynomial is round-off: what is guessed there is off by the change of the remainder and
/// no more.
#[test]
fn a_guess_is_never_further_off_than_the_remainder_changes() {
    for ratio in [0.1, 1.0, 4.0, GROW, 1.01 * GROW, 100.0, 1e4, 1e8] {
        let mut stepper = after_a_step();
        stepper.span.size = ratio;
        stepper.guess();
        for (part, guess) in NODES.part.iter().zip(stepper.sweeps.remainder[0]) {
            let change = ratio * part;
            let off = (guess[0] - (4.0 / 3.0 + change)).abs();
            let allowed = if ratio <= GROW { 1e-3 } else { change };
            assert!(
                off <= allowed + 1e-9,
                "{ratio} times as far, at {part}: {off:e}"
            );
        }
    }
}

/// Without a step before, the remainder is taken as it is at the start.
#[test]
fn a_first_guess_stays_where_it_is() {
    let mut stepper = after_a_step();
    (stepper.remainder_size, stepper.span.size) = (0.0, 1.0);
    stepper.guess();
    let guesses = stepper.sweeps.remainder[0].map(|guess| guess[0]);
    assert_eq!(guesses, [4.0 / 3.0; POINTS]);
}
