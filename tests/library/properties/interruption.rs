//! Runs that end early say why, and keep what they have.

use std::sync::atomic::{AtomicBool, Ordering};

use crate::integrate::IntegrateError;
use crate::rotor::{CageMotion, Sample};
use crate::simulate::{Monitor, Sampling, SimulateError, TraceSink, simulate};

use crate::tests::support::{Collector, model, thrust_rotor, try_run};

#[test]
fn a_set_stop_flag_interrupts_at_the_first_step() {
    let stop = AtomicBool::new(true);
    let mut monitor = Monitor {
        stop: &stop,
        progress: &mut |_| {},
    };
    let model = model(thrust_rotor(), 1.0, 10_000.0);
    let error = simulate(&model, &mut Collector::default(), &mut monitor).expect_err("stopped");
    assert!(
        matches!(error, SimulateError::Integrate(IntegrateError::Interrupted { time }) if time < 0.01),
        "{error}"
    );
}

#[test]
fn a_stop_flag_set_under_way_keeps_the_samples_before_it() {
    let stop = AtomicBool::new(false);
    let mut monitor = Monitor {
        stop: &stop,
        progress: &mut |part| stop.store(part > 0.3, Ordering::Relaxed),
    };
    let model = model(thrust_rotor(), 1.0, 10_000.0);
    let mut sink = Collector::default();
    let error = simulate(&model, &mut sink, &mut monitor).expect_err("stopped");
    let SimulateError::Integrate(IntegrateError::Interrupted { time }) = error else {
        panic!("{error}");
    };
    assert!((0.3..0.5).contains(&time), "{time} s");
    let last = sink.samples.last().expect("samples").time;
    assert!(
        last <= time && time - last < 0.01,
        "last sample {last} s, stopped {time} s"
    );
}

#[test]
fn a_limit_on_steps_ends_the_run_with_the_samples_before_it() {
    let mut model = model(thrust_rotor(), 1.0, 10_000.0);
    model.rotor.shaft.eccentricity = 1e-6;
    model.integrator.step_limit = 500;
    let (result, samples) = try_run(&model, 0.0);
    let error = result.expect_err("too few steps");
    let SimulateError::Integrate(IntegrateError::StepLimit { time, limit: 500 }) = error else {
        panic!("{error}");
    };
    let last = samples.last().expect("samples").time;
    assert!(
        last > 0.0 && last <= time && time < 1.0,
        "last sample {last} s, limit at {time} s"
    );
    for (index, sample) in samples.iter().enumerate() {
        assert_eq!(sample.time, index as f64 * 1e-4, "no sample is left out");
    }
}

/// Takes three samples and then no more.
struct Full(usize);

impl TraceSink for Full {
    fn sample(&mut self, _sample: &Sample) -> std::io::Result<()> {
        self.0 += 1;
        if self.0 > 3 {
            return Err(std::io::Error::other("disk full"));
        }
        Ok(())
    }
}

#[test]
fn a_sink_that_refuses_a_sample_ends_the_run() {
    let model = model(thrust_rotor(), 1.0, 10_000.0);
    let error = crate::tests::support::simulate_into(&model, &mut Full(0)).expect_err("refused");
    assert!(matches!(error, SimulateError::Sink(_)), "{error}");
}

#[test]
fn a_standing_shaft_has_no_grid_of_angle() {
    let mut model = model(thrust_rotor(), 0.01, 10_000.0);
    model.rotor.speed = 0.0;
    model.rotor.cage = CageMotion::Rolling;
    model.sampling = Sampling::PerRevolution(128);
    let (result, samples) = try_run(&model, 0.0);
    assert!(matches!(result, Err(SimulateError::NoRevolution)));
    assert!(samples.is_empty());
    model.sampling = Sampling::Rate(10_000.0);
    assert_eq!(try_run(&model, 0.0).1.len(), 101);
}
