//! Strong damping turns the problem stiff: explicit methods say so, and name the method that is not.

use crate::integrate::{IntegrateError, Method};
use crate::rotor::{Damping, RotorDefinition};
use crate::simulate::{Model, SimulateError};

use crate::tests::support::{model, thrust_rotor, try_run};

/// A 7205C under thrust, damped along x with an eigenvalue of −10⁶ 1/s and lightly elsewhere.
fn stiff(method: Method) -> Model {
    let mut rotor = RotorDefinition {
        damping: Damping::Coefficients([5e6, 5e3, 5e3, 0.0, 0.0]),
        ..thrust_rotor()
    };
    rotor.shaft.eccentricity = 10e-6;
    let mut model = model(rotor, 0.2, 20_000.0);
    model.integrator.method = method;
    model.integrator.tolerance = 1e-8;
    model
}

const RUNGE_KUTTA: [Method; 2] = [Method::Dopri5, Method::Dop853];
const EXPLICIT: [Method; 3] = [Method::Verner76, Method::Dopri5, Method::Dop853];

#[test]
fn a_run_that_stability_slowed_down_names_the_remedy() {
    let (implicit, reference) = try_run(&stiff(Method::Rodas), 0.0);
    let implicit = implicit.expect("it runs");
    assert!(implicit.warnings.is_empty(), "{:?}", implicit.warnings);
    for method in EXPLICIT {
        let (result, samples) = try_run(&stiff(method), 0.0);
        let run = result.expect("it runs");
        let text = run.warnings.join("\n");
        for part in [
            "stiff",
            "largest eigenvalue 1.0e6 1/s",
            "method = \"rodas\"",
        ] {
            assert!(text.contains(part), "{method:?}: {text}");
        }
        // the remedy is one: at half the steps or less, the same motion
        let (steps, fewer) = (run.counters.steps, implicit.counters.steps);
        assert!(2 * fewer < steps, "{method:?}: {fewer} of {steps} steps");
        for (sample, other) in samples.iter().zip(&reference) {
            let apart = (sample.displacement[1] - other.displacement[1]).abs();
            assert!(
                apart < 1e-13,
                "{method:?}, t = {}: {apart:e} m",
                sample.time
            );
        }
    }
}

#[test]
fn a_run_that_stability_keeps_from_its_end_is_told_so_early() {
    for method in RUNGE_KUTTA {
        let mut model = stiff(method);
        // 0.2 s take some 30 000 and 70 000 steps
        model.integrator.step_limit = 20_000;
        let (result, samples) = try_run(&model, 0.0);
        let error = result.expect_err("too many steps");
        let SimulateError::Integrate(IntegrateError::Stiff {
            stiffness,
            needed,
            limit,
        }) = &error
        else {
            panic!("{method:?}: {error}");
        };
        assert_eq!(*limit, 20_000);
        assert!((20e3..1e5).contains(needed), "{method:?}: {needed:e}");
        // after a thousand steps, not after twenty thousand
        assert!(stiffness.time < 0.02, "{method:?}: {error}");
        assert!((0.9e6..1.1e6).contains(&stiffness.eigenvalue), "{error}");
        let held = stiffness.step * stiffness.eigenvalue;
        assert!(
            (1.5..8.0).contains(&held),
            "{method:?}: step × eigenvalue = {held}"
        );
        assert!(
            error
                .to_string()
                .contains("method = \"rodas\" in [integrator]"),
            "{error}"
        );
        assert!(
            !samples.is_empty() && samples.len() < 1000,
            "{}",
            samples.len()
        );
    }
    let mut model = stiff(Method::Rodas);
    model.integrator.step_limit = 20_000;
    try_run(&model, 0.0).0.expect("the remedy is one");
}

#[test]
fn steps_that_run_out_before_anybody_looks_name_the_remedy_too() {
    for method in EXPLICIT {
        let mut model = stiff(method);
        model.integrator.step_limit = 700;
        let (result, _) = try_run(&model, 0.0);
        let error = result.expect_err("too few steps").to_string();
        assert!(
            error.contains("the problem is stiff"),
            "{method:?}: {error}"
        );
        assert!(error.contains("of the 700 that"), "{method:?}: {error}");
    }
}

#[test]
fn what_accuracy_asks_for_is_not_called_stiff() {
    for method in EXPLICIT {
        for tolerance in [1e-4, 1e-8, 1e-12] {
            let mut rotor = thrust_rotor();
            rotor.shaft.eccentricity = 10e-6;
            let mut model = model(rotor, 0.2, 20_000.0);
            model.integrator.method = method;
            model.integrator.tolerance = tolerance;
            let run = try_run(&model, 0.0).0.expect("it runs");
            assert!(
                run.warnings.is_empty(),
                "{method:?} {tolerance:e}: {:?}",
                run.warnings
            );
        }
        let mut limited = model(thrust_rotor(), 0.2, 20_000.0);
        limited.rotor.shaft.eccentricity = 10e-6;
        limited.integrator.method = method;
        limited.integrator.step_limit = 300;
        let error = try_run(&limited, 0.0).0.expect_err("too few steps");
        let plain = matches!(
            error,
            SimulateError::Integrate(IntegrateError::StepLimit { limit: 300, .. })
        );
        assert!(plain, "{method:?}: {error}");
    }
}
