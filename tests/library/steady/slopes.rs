//! Slopes of the state after a while by that at the start, where the shaft bends on few bearings.

use std::sync::atomic::AtomicBool;

use nalgebra::{DMatrix, DVector};

use super::{found, shipped};
use crate::integrate::{Prepared, Settings, System, variation};
use crate::rotor::Rotor;

/// A rotor of which nothing is known but its derivative and the slopes of that, so that the explicit pair integrates both.
struct Whole<'a>(&'a Rotor);

impl System for Whole<'_> {
    fn states(&self) -> usize {
        self.0.states()
    }

    fn derivative(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        self.0.derivative(time, state, rate);
    }

    fn linearisation(&self, time: f64, state: &[f64], jacobian: &mut DMatrix<f64>) {
        self.0.linearisation(time, state, jacobian);
    }

    fn rate_by_time(&self, time: f64, state: &[f64], by_time: &mut [f64]) {
        self.0.rate_by_time(time, state, by_time);
    }

    fn event_count(&self) -> usize {
        self.0.event_count()
    }

    fn events(&self, time: f64, state: &[f64], values: &mut [f64]) {
        self.0.events(time, state, values);
    }

    fn force_jump(&self, event: usize, time: f64, distance: f64, rate: &mut [f64]) {
        self.0.force_jump(event, time, distance, rate);
    }

    fn event_exponent(&self, event: usize) -> f64 {
        self.0.event_exponent(event)
    }
}

/// Slopes over a few ball passes, in units of the states, and the evaluations that they took: of the rotor at a tolerance, and
/// by the explicit pair at a far smaller one.
fn varied(name: &str, duration: f64, tolerance: f64) -> [(DMatrix<f64>, u64); 2] {
    let model = shipped(name);
    let rotor = Rotor::assemble(&model.rotor).expect("a rotor");
    let scaling = rotor.scaling(&rotor.motion_scale(1e-9));
    let varied = |system: &dyn System, tolerance: f64| {
        let settings = Settings {
            tolerance,
            ..model.integrator
        };
        let (stop, start) = (AtomicBool::new(false), rotor.start_state());
        let found = variation(
            system, &scaling, &settings, &stop, duration, &start, &mut None,
        );
        let mut found = found.expect("a motion");
        scaling.scale_jacobian(&mut found.slopes);
        (found.slopes, found.counters.evaluations)
    };
    [varied(&rotor, tolerance), varied(&Whole(&rotor), 1e-11)]
}

/// Balls that stay loaded, and such that lose and regain contact: the steps of the exponential method find the slopes that
/// the explicit pair finds at a far smaller tolerance, to their own, with far fewer evaluations.
#[test]
fn slopes_by_few_forces_are_those_of_the_whole_equations() {
    for (name, duration) in [
        ("flexible-spindle-7205c", 1e-3),
        ("overhung-rotor-6208", 4e-3),
    ] {
        for tolerance in [1e-5, 1e-8] {
            let [(found, few), (expected, many)] = varied(name, duration, tolerance);
            let error = (found - &expected).amax() / expected.amax();
            println!("{name} {tolerance:e}: {error:e}, {few} and {many} evaluations");
            assert!(error < 3.0 * tolerance, "{name} {tolerance:e}: {error:e}");
            assert!(few < many, "{few} and {many} evaluations");
        }
    }
}

/// What a motion over one period has found out serves one over the next: the same end and slopes to their tolerance, for no
/// more work.
#[test]
fn a_motion_goes_on_with_what_another_has_prepared() {
    let model = shipped("overhung-rotor-6208");
    let rotor = Rotor::assemble(&model.rotor).expect("a rotor");
    let scaling = rotor.scaling(&rotor.motion_scale(1e-9));
    let varied = |start: &[f64], prepared: &mut Option<Prepared>| {
        let (stop, settings) = (AtomicBool::new(false), model.integrator);
        let found = variation(&rotor, &scaling, &settings, &stop, 4e-3, start, prepared);
        let mut found = found.expect("a motion");
        scaling.scale_jacobian(&mut found.slopes);
        found
    };
    let mut prepared = None;
    let first = varied(&rotor.start_state(), &mut prepared);
    let second = varied(&first.end, &mut prepared);
    let anew = varied(&first.end, &mut None);
    let error = (&second.slopes - &anew.slopes).amax() / anew.slopes.amax();
    let ends = [&second, &anew].map(|found| DVector::from_vec(scaling.scaled(&found.end)));
    let apart = (&ends[0] - &ends[1]).amax();
    println!("{error:e}, {apart:e}");
    let tolerance = model.integrator.tolerance;
    assert!(error < 3.0 * tolerance && apart < 3.0 * tolerance);
    assert!(second.counters.evaluations < anew.counters.evaluations);
}

/// The bent spindle on preloaded sets of bearings, verified by a smaller tolerance and by more modes.
#[test]
fn the_motion_of_a_bent_spindle_takes_few_evaluations() {
    let steady = found(&shipped("flexible-spindle-7205c"));
    println!("{:?}", steady.counters);
    assert!(steady.is_stable() && steady.is_torus());
    assert!(steady.counters.evaluations < 60_000);
}
