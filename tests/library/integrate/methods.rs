//! The integration methods on problems with known solutions.

use std::sync::atomic::AtomicBool;

use crate::integrate::{
    Counters, Grid, IntegrateError, Integration, Method, Scaling, Settings, States, System,
};
use nalgebra::DMatrix;

/// y' = cos(t) y, y(0) = 1: y = exp(sin t). The time enters, so a wrong node shows.
struct Swelling;

impl System for Swelling {
    fn states(&self) -> usize {
        1
    }

    fn derivative(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        rate[0] = time.cos() * state[0];
    }

    fn linearisation(&self, time: f64, _state: &[f64], jacobian: &mut DMatrix<f64>) {
        jacobian.fill(time.cos());
    }

    fn rate_by_time(&self, time: f64, state: &[f64], by_time: &mut [f64]) {
        by_time.fill(-time.sin() * state[0]);
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
    let mut integration = Integration::new(
        &Swelling,
        Scaling::identity(1),
        grid,
        settings(method, tolerance),
        &stop,
        &[1.0],
    );
    let mut states = States::new(1);
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
    // its interpolant has order seven and stands in the way of more
    let order = observed_order(Method::Dop853, 1e-4, 1e-12);
    assert!((7.0..9.5).contains(&order), "observed order {order}");
}

#[test]
fn verner76_has_order_seven_where_time_enters() {
    // its interpolant has order six
    let order = observed_order(Method::Verner76, 1e-5, 1e-10);
    assert!((6.0..8.5).contains(&order), "observed order {order}");
}

#[test]
fn dopri5_has_order_five_where_time_enters() {
    let order = observed_order(Method::Dopri5, 1e-5, 1e-10);
    assert!((4.5..6.0).contains(&order), "observed order {order}");
}

#[test]
fn rodas_has_order_four_where_time_enters() {
    let order = observed_order(Method::Rodas, 1e-4, 1e-8);
    assert!((3.6..5.0).contains(&order), "observed order {order}");
}

#[test]
fn exponential_collocation_has_order_six_where_time_enters() {
    // step sizes are rounded down, and the slope of J is no small part of this problem
    let order = observed_order(Method::Exponential, 1e-5, 1e-10);
    assert!((5.5..9.0).contains(&order), "observed order {order}");
}

/// Kaps' problem: a slope of −10⁶ beside a slow one; y = (exp(−2t), exp(−t)) whatever the slope.
///
/// Source: P. Kaps (1981), in Hairer & Wanner, *Solving Ordinary Differential Equations II*.
struct Kaps;

const STEEP: f64 = 1e6;

impl System for Kaps {
    fn states(&self) -> usize {
        2
    }

    fn derivative(&self, _time: f64, state: &[f64], rate: &mut [f64]) {
        let [y, z] = [state[0], state[1]];
        rate[0] = -(STEEP + 2.0) * y + STEEP * z * z;
        rate[1] = y - z - z * z;
    }

    fn linearisation(&self, _time: f64, state: &[f64], jacobian: &mut DMatrix<f64>) {
        let z = state[1];
        jacobian.copy_from_slice(&[-(STEEP + 2.0), 1.0, 2.0 * STEEP * z, -1.0 - 2.0 * z]);
    }

    fn rate_by_time(&self, _time: f64, _state: &[f64], by_time: &mut [f64]) {
        by_time.fill(0.0);
    }
}

#[test]
fn rodas_steps_over_a_stiff_slope() {
    let grid = Grid {
        interval: 0.01,
        count: 301,
    };
    let (stop, settings) = (AtomicBool::new(false), settings(Method::Rodas, 1e-7));
    let start = [1.0, 1.0];
    let mut integration =
        Integration::new(&Kaps, Scaling::identity(2), grid, settings, &stop, &start);
    let mut states = States::new(2);
    while integration.done() < grid.count {
        integration.advance(301, &mut states).expect("no trouble");
    }
    for (index, state) in states.iter().enumerate() {
        let [y, z] = [state[0], state[1]];
        let time = grid.time(index as u64);
        let slow = (z - (-time).exp()).abs();
        assert!(slow < 1e-7, "t = {time}: {slow:e}");
        // between steps the steep component is interpolated at a lower order: measured 1.7e-6
        let steep = (y - (-2.0 * time).exp()).abs();
        assert!(steep < 3e-6, "t = {time}: {steep:e}");
    }
    // an explicit method needs some million steps over these three seconds
    let steps = integration.counters().steps;
    assert!(steps < 300, "{steps} steps");
}

/// Three seconds of Kaps' problem by an explicit method: the integration, and how it ended.
fn kaps(
    method: Method,
    step_limit: u64,
    check: impl FnOnce(&Integration<'_>, Result<(), IntegrateError>),
) {
    let grid = Grid {
        interval: 0.01,
        count: 301,
    };
    let (stop, start) = (AtomicBool::new(false), [1.0, 1.0]);
    let settings = Settings {
        step_limit,
        ..settings(method, 1e-7)
    };
    let mut integration =
        Integration::new(&Kaps, Scaling::identity(2), grid, settings, &stop, &start);
    let mut result = Ok(());
    while result.is_ok() && integration.done() < grid.count {
        result = integration.advance(50, &mut States::new(2));
    }
    check(&integration, result);
}

/// Longest step that stability leaves; Dopri5 takes about half of it.
const STABLE: f64 = 6.5 / STEEP;

#[test]
fn explicit_methods_cross_a_stiff_slope_and_know_what_held_them() {
    for method in [Method::Dopri5, Method::Dop853] {
        kaps(method, 10_000_000, |integration, result| {
            result.expect("steps enough");
            let found = integration.stiffness().expect("stiffness");
            assert!((found.eigenvalue / STEEP - 1.0).abs() < 0.01, "{found:?}");
            assert!(
                found.step < STABLE && found.step > 0.2 * STABLE,
                "{found:?}"
            );
        });
    }
    kaps(Method::Rodas, 10_000_000, |integration, result| {
        result.expect("steps enough");
        assert_eq!(integration.stiffness(), None);
    });
}

#[test]
fn a_stiff_slope_ends_the_integration_early() {
    for method in [Method::Dopri5, Method::Dop853] {
        kaps(method, 100_000, |integration, result| {
            let Err(IntegrateError::Stiff {
                stiffness,
                needed,
                limit: 100_000,
            }) = result
            else {
                panic!("{method:?}: {result:?}");
            };
            // 3 s in stable steps
            assert!(
                (3.0 / STABLE..5.0 * 3.0 / STABLE).contains(&needed),
                "{needed:e}"
            );
            assert!(stiffness.time < 0.02, "{stiffness:?}");
            assert!(integration.counters().steps <= 2000);
        });
    }
}

/// y'' = −y from (1, 0), with a fault from a time on.
struct Swing {
    fault_from: f64,
}

impl System for Swing {
    fn states(&self) -> usize {
        2
    }

    fn derivative(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        rate[0] = state[1];
        rate[1] = -state[0];
        if time >= self.fault_from {
            rate[1] = f64::NAN;
        }
    }

    fn linearisation(&self, _time: f64, _state: &[f64], jacobian: &mut DMatrix<f64>) {
        jacobian.copy_from_slice(&[0.0, -1.0, 1.0, 0.0]);
    }

    fn rate_by_time(&self, _time: f64, _state: &[f64], by_time: &mut [f64]) {
        by_time.fill(0.0);
    }
}

const SOUND: Swing = Swing {
    fault_from: f64::INFINITY,
};

const TWENTY_SECONDS: Grid = Grid {
    interval: 0.01,
    count: 2001,
};

/// States, work and end of an integration in blocks of so many points.
fn integrate(
    system: &Swing,
    settings: Settings,
    points: usize,
    stop: &AtomicBool,
) -> (States, Counters, Result<(), IntegrateError>) {
    let (scaling, start) = (Scaling::identity(2), [1.0, 0.0]);
    let mut integration = Integration::new(system, scaling, TWENTY_SECONDS, settings, stop, &start);
    let mut states = States::new(2);
    let mut result = Ok(());
    while result.is_ok() && integration.done() < TWENTY_SECONDS.count {
        result = integration.advance(points, &mut states);
    }
    assert_eq!(states.len() as u64, integration.done());
    (states, integration.counters(), result)
}

const METHODS: [Method; 6] = [
    Method::Verner76,
    Method::Dopri5,
    Method::Dop853,
    Method::Rodas,
    Method::Exponential,
    Method::Auto,
];

#[test]
fn a_block_ends_without_a_trace() {
    let stop = AtomicBool::new(false);
    for method in METHODS {
        let run = |points| integrate(&SOUND, settings(method, 1e-7), points, &stop);
        let (whole, work, _) = run(5000);
        for points in [1, 7, 100] {
            let (cut, same_work, _) = run(points);
            assert_eq!(whole, cut, "{method:?}, {points} points");
            assert_eq!(work, same_work, "{method:?}, {points} points");
        }
    }
}

#[test]
fn blocks_end_where_one_long_block_passes() {
    let stop = AtomicBool::new(false);
    for method in METHODS {
        for points in [1, 7, 100, 5000] {
            let (states, _, result) = integrate(&SOUND, settings(method, 1e-10), points, &stop);
            result.expect("a smooth problem");
            assert_eq!(states.len(), 2001);
            for (index, state) in states.iter().enumerate() {
                let [place, speed] = [state[0], state[1]];
                let time = TWENTY_SECONDS.time(index as u64);
                let error = (place - time.cos()).abs().max((speed + time.sin()).abs());
                // the error aimed at over each of the twenty seconds
                assert!(
                    error < 2e-9,
                    "{method:?}, {points} points, t = {time}: {error:e}"
                );
            }
        }
    }
}

#[test]
fn work_is_counted() {
    let stop = AtomicBool::new(false);
    for (method, stages) in [
        (Method::Verner76, 9),
        (Method::Dopri5, 6),
        (Method::Dop853, 11),
    ] {
        let (_, work, _) = integrate(&SOUND, settings(method, 1e-8), 5000, &stop);
        let tried = work.steps + work.rejected;
        assert!(work.steps > 20 && work.rejected < work.steps, "{work:?}");
        // at least the stages of every step, at most six more for the step and its dense output
        assert!(work.evaluations >= stages * tried, "{method:?} {work:?}");
        assert!(
            work.evaluations <= (stages + 6) * tried + 2,
            "{method:?} {work:?}"
        );
        let (_, tighter, _) = integrate(&SOUND, settings(method, 1e-11), 5000, &stop);
        assert!(tighter.steps > work.steps && tighter.evaluations > work.evaluations);
    }
}

#[test]
fn a_derivative_of_nan_ends_the_integration_at_its_time() {
    let (stop, fault) = (AtomicBool::new(false), Swing { fault_from: 12.345 });
    for method in METHODS {
        let (states, _, result) = integrate(&fault, settings(method, 1e-8), 100, &stop);
        let Err(IntegrateError::NotFinite { time }) = result else {
            panic!("{method:?}: {result:?}");
        };
        assert!(
            time <= 12.345 && time > 11.0,
            "{method:?}: stopped at {time} s"
        );
        let last = TWENTY_SECONDS.time(states.len() as u64 - 1);
        assert!(
            last <= time + 1e-12 && time - last < 1.0,
            "{method:?}: {last} s of {time} s"
        );
        assert!(states.as_slice().iter().all(|value| value.is_finite()));
    }
}

/// y′ = y² from 1, which grows beyond all bounds as t comes to 1.
struct Exploding;

impl System for Exploding {
    fn states(&self) -> usize {
        1
    }

    fn derivative(&self, _time: f64, state: &[f64], rate: &mut [f64]) {
        rate[0] = state[0] * state[0];
    }

    fn linearisation(&self, _time: f64, state: &[f64], jacobian: &mut DMatrix<f64>) {
        jacobian.fill(2.0 * state[0]);
    }

    fn rate_by_time(&self, _time: f64, _state: &[f64], by_time: &mut [f64]) {
        by_time.fill(0.0);
    }
}

/// Steps fall without end as the pole comes near: none is too small to move time for more than a moment.
#[test]
fn a_step_too_small_to_move_time_is_an_error_at_once() {
    let stop = AtomicBool::new(false);
    for method in METHODS {
        let mut integration = Integration::new(
            &Exploding,
            Scaling::identity(1),
            TWENTY_SECONDS,
            settings(method, 1e-8),
            &stop,
            &[1.0],
        );
        let mut states = States::new(1);
        let error = integration.advance(2001, &mut states).unwrap_err();
        println!("{method:?}: {error}, {:?}", integration.counters());
        assert!((error.time() - 1.0).abs() < 1e-6, "{method:?}: {error}");
        let work = integration.counters();
        assert!(work.steps + work.rejected < 5000, "{method:?}: {work:?}");
        // the sample at the pole itself may still be found
        assert!((100..=101).contains(&states.len()), "{method:?}");
        if let IntegrateError::StepUnderflow { step, .. } = error {
            assert!((0.0..1e-9).contains(&step), "{method:?}: {step}");
            let text = error.to_string();
            assert!(
                text.contains("too small to move time at t = 1.0000"),
                "{text}"
            );
        }
    }
}

#[test]
fn the_limit_holds_for_all_blocks_together() {
    let stop = AtomicBool::new(false);
    for method in METHODS {
        // a linear system takes the exponential method, with which a choice left open begins, three steps in all
        let most = match method {
            Method::Auto | Method::Exponential => 1,
            _ => 15,
        };
        let limited = Settings {
            step_limit: most,
            ..settings(method, 1e-10)
        };
        let (states, work, result) = integrate(&SOUND, limited, 100, &stop);
        let Err(IntegrateError::StepLimit { time, limit }) = result else {
            panic!("{method:?}: {result:?}");
        };
        assert_eq!(limit, most);
        assert!(time > 0.0 && time < 20.0 && states.len() > 0);
        assert!(
            (most - 1..=most + 1).contains(&(work.steps + work.rejected)),
            "{method:?} {work:?}"
        );
    }
}

#[test]
fn a_set_flag_interrupts() {
    for method in METHODS {
        let stop = AtomicBool::new(true);
        let (states, _, result) = integrate(&SOUND, settings(method, 1e-8), 100, &stop);
        assert!(
            matches!(result, Err(IntegrateError::Interrupted { .. })),
            "{method:?}: {result:?}"
        );
        assert!(states.len() < 100);
    }
}

/// y″ = −y + p(t), p a push that begins at once at t = π/10 and ends at t = 1: known piece by piece.
struct Pushed;

const PUSH: [f64; 2] = [std::f64::consts::PI / 10.0, 1.0];

impl System for Pushed {
    fn states(&self) -> usize {
        2
    }

    fn derivative(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        let pushed = (PUSH[0]..PUSH[1]).contains(&time);
        rate[0] = state[1];
        rate[1] = f64::from(u8::from(pushed)) - state[0];
    }

    fn linearisation(&self, _time: f64, _state: &[f64], jacobian: &mut DMatrix<f64>) {
        jacobian.copy_from_slice(&[0.0, -1.0, 1.0, 0.0]);
    }

    fn rate_by_time(&self, _time: f64, _state: &[f64], by_time: &mut [f64]) {
        by_time.fill(0.0);
    }

    fn next_break(&self, after: f64) -> f64 {
        let later = PUSH.into_iter().find(|time| *time > after);
        later.unwrap_or(f64::INFINITY)
    }
}

/// A step ends at the very moment of a jump and sees nothing of what comes after it.
#[test]
fn a_force_that_jumps_at_a_break_costs_no_rejected_step() {
    let stop = AtomicBool::new(false);
    let grid = Grid {
        interval: 0.05,
        count: 61,
    };
    let answer = |time: f64, begin: f64| {
        if time > begin {
            1.0 - (time - begin).cos()
        } else {
            0.0
        }
    };
    for method in [Method::Verner76, Method::Exponential, Method::Auto] {
        let mut integration = Integration::new(
            &Pushed,
            Scaling::identity(2),
            grid,
            settings(method, 1e-9),
            &stop,
            &[0.0; 2],
        );
        let mut states = States::new(2);
        integration.advance(61, &mut states).expect("no trouble");
        for (index, state) in states.iter().enumerate() {
            let place = state[0];
            let time = grid.time(index as u64);
            let error = place - answer(time, PUSH[0]) + answer(time, PUSH[1]);
            assert!(error.abs() < 5e-9, "{method:?}, t = {time}: {error:e}");
        }
        let work = integration.counters();
        assert!(
            work.rejected <= 4 && work.steps < 400,
            "{method:?}: {work:?}"
        );
    }
}
