//! The integration methods on problems with known solutions.

use std::sync::atomic::AtomicBool;

use jeffcott::integrate::{Grid, Integration, Method, Scaling, Settings, System};

/// y' = cos(t) y, y(0) = 1: y = exp(sin t). The time enters, so a wrong node shows.
struct Swelling;

impl System<1> for Swelling {
    fn derivative(&self, time: f64, state: &[f64; 1], rate: &mut [f64; 1]) {
        rate[0] = time.cos() * state[0];
    }
}

fn settings(method: Method, tolerance: f64) -> Settings {
    Settings {
        method,
        tolerance,
        step_limit: 10_000_000,
    }
}

/// Largest error on the grid and number of steps.
fn error_and_steps(method: Method, tolerance: f64) -> (f64, u64) {
    let grid = Grid {
        interval: 0.05,
        count: 401,
    };
    let stop = AtomicBool::new(false);
    let mut integration = Integration::<_, 1, 2>::new(
        &Swelling,
        Scaling::IDENTITY,
        grid,
        settings(method, tolerance),
        &stop,
        &[1.0],
    );
    let mut states = Vec::new();
    while integration.done() < grid.count {
        integration
            .advance(100, &mut states)
            .expect("a smooth problem");
    }
    assert_eq!(states.len(), 401);
    let error = states
        .iter()
        .enumerate()
        .map(|(k, state)| (state[0] - grid.time(k as u64).sin().exp()).abs())
        .fold(0.0, f64::max);
    (error, integration.counters().steps)
}

/// Slope of log error over log step, from two tolerances.
fn observed_order(method: Method, loose: f64, tight: f64) -> f64 {
    let (loose_error, loose_steps) = error_and_steps(method, loose);
    let (tight_error, tight_steps) = error_and_steps(method, tight);
    println!("{method:?} {loose_error:e} {loose_steps} {tight_error:e} {tight_steps}");
    (loose_error / tight_error).ln() / (tight_steps as f64 / loose_steps as f64).ln()
}

#[test]
fn dop853_has_order_eight_where_time_enters() {
    let order = observed_order(Method::Dop853, 1e-5, 1e-10);
    assert!((7.0..9.5).contains(&order), "observed order {order}");
}

#[test]
fn dopri5_has_order_five_where_time_enters() {
    let order = observed_order(Method::Dopri5, 1e-5, 1e-10);
    assert!((4.5..6.0).contains(&order), "observed order {order}");
}
