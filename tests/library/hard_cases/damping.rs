//! None, too much, and far too much damping.

use crate::integrate::IntegrateError;
use crate::rotor::Rotor;
use crate::simulate::{Sampling, SimulateError};

use super::{THRUST, error, model, run, work};
use crate::tests::support::{Collector, simulate_into};

/// Where the overdamped shaft is let go, m beside its equilibrium.
const START: f64 = 1e-6;
const STIFF_DAMPER: &str =
    r#"coefficients = { x = "5e6 N s/m", y = "5e6 N s/m", z = "5e6 N s/m" }"#;

/// Without damping the start never dies; overdamped, the film of time scales is wide.
#[test]
fn damping_ratio_of_zero_and_of_five() {
    let (undamped, swing) = run(&THRUST.replace("0.02", "0"));
    let (overdamped, crawl) = run(&THRUST.replace("0.02", "5"));
    assert!(error(&undamped) < 1e-6 && error(&overdamped) < 1e-6);
    assert!(
        swing.reach[0] > crawl.reach[0] && crawl.reach[0] < 60e-9,
        "{crawl:?}"
    );
    assert!(
        overdamped.counters.steps < 60_000,
        "{:?}",
        overdamped.counters
    );
}

/// Closed form of `ẍ + 2ζΩ ẋ + Ω² x = 0` beyond critical damping, from rest at 1.
fn creep(natural: f64, damping: f64, time: f64) -> f64 {
    // roots of λ² + dλ + Ω²; the small one without cancellation
    let fast = -0.5 * (damping + (damping * damping - 4.0 * natural * natural).sqrt());
    let slow = natural * natural / fast;
    (fast * (slow * time).exp() - slow * (fast * time).exp()) / (fast - slow)
}

/// 5 kg in a damper of 5e6 N s/m: one eigenvalue at −1e6 1/s, the other at −43 1/s. The fast one is
/// over within microseconds, yet it limits the steps of an explicit method to them for ever: stability,
/// not accuracy. An implicit method goes by accuracy alone.
#[test]
fn a_damper_with_an_eigenvalue_near_minus_a_million() {
    let scene = |method: &str| {
        let mut model = model(
            &THRUST
                .replace("ratio = 0.02", STIFF_DAMPER)
                .replace(
                    "tolerance = 1e-8",
                    &format!("method = \"{method}\"\ntolerance = 1e-6"),
                )
                .replace("eccentricity = \"10 um\"", "")
                .replace(
                    "catalogue = \"7205C\"",
                    "catalogue = \"7205C\"\ncontact = \"linear\"",
                ),
        );
        model.rotor.initial.displacement[0] = Some(START);
        model.verify = false;
        model.sampling = Sampling::Rate(1000.0);
        model
    };
    let implicit = scene("rodas");
    let rotor = Rotor::assemble(&implicit.rotor).expect("a rotor");
    let natural = (rotor.equilibrium().stiffness[(0, 0)] / 5.0).sqrt();
    let (run, samples) = crate::tests::support::try_run(&implicit, 0.0);
    let run = run.expect("an implicit method can");
    for sample in &samples {
        let expected = START * creep(natural, 1e6, sample.time);
        // the tolerance of 1e-6 of the start
        let error = (sample.displacement[0] - expected).abs();
        assert!(error < 1e-6 * START, "{error:e} m at {} s", sample.time);
    }
    println!("implicit: {:?}", run.counters);
    assert!(work(&run) < 100, "{:?}", run.counters);
    for method in ["dopri5", "dop853"] {
        let mut explicit = scene(method);
        let patient = simulate_into(&explicit, &mut Collector::default()).expect("it ends");
        println!("{method}: {:?}", patient.counters);
        assert!(work(&patient) > 200 * work(&run), "{:?}", patient.counters);
        let told = patient.warnings.iter().any(|text| text.contains("rodas"));
        assert!(told, "{:?}", patient.warnings);
        explicit.integrator.step_limit = 5000;
        let (result, samples) = crate::tests::support::try_run(&explicit, 0.0);
        let error = result.expect_err("far too many steps");
        let SimulateError::Integrate(IntegrateError::Stiff { stiffness, .. }) = &error else {
            panic!("{error}");
        };
        println!("{error}");
        assert!(error.to_string().contains("rodas"), "{error}");
        assert!(
            (stiffness.eigenvalue.abs() / 1e6 - 1.0).abs() < 0.01,
            "{error}"
        );
        assert!(samples.len() <= 1 + (1000.0 * stiffness.time) as usize);
    }
}

/// Hunt–Crossley damping of 12 balls' contacts so strong that the fastest eigenvalue is beyond −1e6 1/s,
/// and unlike a damper on the shaft it changes with every ball load. The slow motion beside it creeps:
/// an explicit method spends its steps on a transient that has died within microseconds.
#[test]
fn contact_damping_with_an_eigenvalue_beyond_minus_a_million() {
    let scene = |method: &str, tolerance: f64| {
        let contact = "contact = { inner = \"5000 s/m\", outer = \"5000 s/m\" }";
        let mut model = model(
            &THRUST
                .replace("ratio = 0.02", contact)
                .replace(
                    "tolerance = 1e-8",
                    &format!("method = \"{method}\"\ntolerance = {tolerance:e}"),
                )
                .replace("\"0.1 s\"", "\"0.02 s\""),
        );
        model.rotor.initial.displacement[0] = Some(START);
        model.verify = false;
        model.sampling = Sampling::Rate(10_000.0);
        model
    };
    let implicit = scene("rodas", 1e-7);
    let rotor = Rotor::assemble(&implicit.rotor).expect("a rotor");
    let (slopes, _) = crate::tests::support::linearisation(&rotor, 0.0, &rotor.start_state());
    let eigenvalues = slopes.complex_eigenvalues();
    let fastest = eigenvalues.iter().map(|value| value.re).fold(0.0, f64::min);
    assert!(fastest < -1e6, "{fastest:e}");
    let (run, found) = crate::tests::support::try_run(&implicit, 0.0);
    let run = run.expect("an implicit method can");
    let (patient, expected) = crate::tests::support::try_run(&scene("dop853", 1e-9), 0.0);
    let patient = patient.expect("an explicit method can, slowly");
    println!("{fastest:e}: {:?} {:?}", run.counters, patient.counters);
    for (found, expected) in found.iter().zip(&expected) {
        for axis in 0..3 {
            let error = (found.displacement[axis] - expected.displacement[axis]).abs();
            // ten tolerances of the start
            assert!(error < 1e-6 * START, "{error:e} m at {} s", found.time);
        }
    }
    assert!(work(&run) < work(&patient) / 20, "{:?}", run.counters);
}
