//! The library's Dop853 on a system that depends on time, beside the one here that is made of it.

use std::f64::consts::TAU;
use std::sync::atomic::AtomicBool;

use crate::integrate::{Grid, Integration, Scaling, States, System};
use nalgebra::{DMatrix, Vector2};
use ode_solvers::dop_shared::{IntegrationError, Stats};

use crate::tests::support::settings;

/// `x'' + 2ζ x' + x = r² cos(r t)`: a Jeffcott rotor under its unbalance, scaled.
#[derive(Clone, Copy)]
struct Jeffcott;

const RATIO: f64 = 0.05;
const SPEED: f64 = 0.8;
const END: f64 = 20.0 * TAU / SPEED;

/// Steady whirl X cos(rt − φ), X = r²/√((1 − r²)² + (2ζr)²).
fn exact(time: f64) -> [f64; 2] {
    let (cosine, sine) = (1.0 - SPEED * SPEED, 2.0 * RATIO * SPEED);
    let amplitude = SPEED * SPEED / cosine.hypot(sine);
    let angle = SPEED * time - sine.atan2(cosine);
    [amplitude * angle.cos(), -SPEED * amplitude * angle.sin()]
}

fn rate(time: f64, [x, v]: [f64; 2]) -> [f64; 2] {
    [
        v,
        SPEED * SPEED * (SPEED * time).cos() - 2.0 * RATIO * v - x,
    ]
}

impl ode_solvers::System<f64, Vector2<f64>> for Jeffcott {
    fn system(&self, time: f64, state: &Vector2<f64>, slope: &mut Vector2<f64>) {
        *slope = rate(time, [state[0], state[1]]).into();
    }
}

impl System for Jeffcott {
    fn states(&self) -> usize {
        2
    }

    fn derivative(&self, time: f64, state: &[f64], slope: &mut [f64]) {
        slope.copy_from_slice(&rate(time, [state[0], state[1]]));
    }

    fn linearisation(&self, _time: f64, _state: &[f64], jacobian: &mut DMatrix<f64>) {
        jacobian.copy_from_slice(&[0.0, -1.0, 1.0, -2.0 * RATIO]);
    }

    fn rate_by_time(&self, time: f64, _state: &[f64], by_time: &mut [f64]) {
        let change = -SPEED * SPEED * SPEED * (SPEED * time).sin();
        by_time.copy_from_slice(&[0.0, change]);
    }
}

fn library(tolerance: f64) -> Result<Stats, IntegrationError> {
    let start = Vector2::from(exact(0.0));
    ode_solvers::Dop853::new(Jeffcott, 0.0, END, END, start, tolerance, tolerance).integrate()
}

/// Error at the end of twenty revolutions.
fn our_error(tolerance: f64) -> f64 {
    let stop = AtomicBool::new(false);
    let grid = Grid {
        interval: END,
        count: 2,
    };
    // a quarter of the tolerance is allowed in a step
    let (scaling, settings) = (Scaling::identity(2), settings(4.0 * tolerance));
    let mut integration = Integration::new(&Jeffcott, scaling, grid, settings, &stop, &exact(0.0));
    let mut states = States::new(2);
    integration.advance(2, &mut states).expect("smooth");
    (states.last().expect("two states")[0] - exact(END)[0]).abs()
}

/// ode_solvers 0.6 evaluates the last stage of Dop853 at the start of a step instead of its end. Where
/// time enters, as by unbalance, it gives up at every tolerance for a stiffness that is not there.
/// Time carried as one more state restores the method.
#[test]
fn a_method_that_is_wrong_where_time_enters() {
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        let error = our_error(tolerance);
        println!("{tolerance:e}: {error:e}");
        assert!(error < 20.0 * tolerance, "{error:e}");
        assert!(matches!(
            library(tolerance),
            Err(IntegrationError::StiffnessDetected { .. })
        ));
    }
}
