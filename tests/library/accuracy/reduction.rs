//! What is stated of the modes that were left out of a shaft that bends, and what it costs to know.

use std::path::Path;

use super::promise::apart;
use crate::integrate::Method;
use crate::scenario;
use crate::simulate::Model;
use crate::tests::support::try_run;

/// A shipped shaft that bends over its first instants.
fn shaft(name: &str, duration: f64) -> Model {
    let scenarios = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios");
    let file = scenarios.join(format!("{name}.toml"));
    let scenario = scenario::load(&file).unwrap_or_else(|error| panic!("{error}"));
    let mut model = scenario.model.expect("a motion");
    model.duration = duration;
    model.settle = 0.0;
    model.spectrum = None;
    model
}

#[test]
fn the_stated_error_is_that_of_the_modes_left_out() {
    for (name, duration) in [
        ("conveyor-shaft-6213", 0.1),
        ("overhung-rotor-6208", 0.05),
        ("flexible-spindle-7205c", 0.05),
    ] {
        let model = shaft(name, duration);
        let tight = |modes: usize| {
            let mut tight = model.clone();
            tight.rotor = tight.rotor.with_modes(modes);
            tight.integrator.method = Method::Exponential;
            tight.integrator.tolerance = 1e-10;
            tight.verify = false;
            try_run(&tight, 0.0).1
        };
        let mut verified = model.clone();
        verified.verify = true;
        let run = try_run(&verified, 0.0).0.expect("a run");
        let reduction = run.reduction.expect("a shaft that bends");
        let stated = reduction.error.expect("a verified run");
        let truth = apart(&model, &tight(reduction.modes), &tight(stated.modes));
        let ratio = stated.displacement / truth;
        assert!((1.0 / 3.0..3.0).contains(&ratio), "{name}: {ratio} times");
    }
}

/// The second pass has a tenth of the tolerance of the run, the one with more modes no more than its difference has.
#[test]
fn the_passes_that_measure_errors_take_at_most_seven_tenths() {
    let mut model = shaft("conveyor-shaft-6213", 0.4);
    model.verify = true;
    for method in [Method::Exponential, Method::Verner76] {
        model.integrator.method = method;
        let run = try_run(&model, 0.0).0.expect("a run");
        let share = run.share_of_verification().expect("a verified run");
        assert!(share < 0.7, "{method}: {share}");
        let finer = run.finer_counters.expect("a pass with more modes");
        assert!(
            finer.evaluations < run.counters.evaluations,
            "{method}: {finer:?}"
        );
    }
}
