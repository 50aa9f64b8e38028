//! A shaft on a bearing with a spall.

use std::f64::consts::FRAC_PI_2;

use crate::bearing::{ContactDamping, Defect, MountedBearing, Surface};
use crate::integrate::{Method, Settings};
use crate::rotor::{Damping, Drive, Freedoms, Rotor, RotorDefinition, Sample};
use crate::simulate::{Model, Run};

use super::{fault, golden, with_defects};
use crate::tests::support::{
    Collector, assert_near, assert_printed, back_to_back_pair, constant, model, rotor, settings,
    shaft, simulate_into, try_run,
};

/// Sixty ball passes of the outer race, s.
const PASSES: f64 = 60.0 / 107.364_305_84;

/// The state there with the fault of 0.021 in at −90°: what these methods agree on.
const GOLDEN_SPALLED: [f64; 4] = [
    8.602_280_637e-8,
    -4.015_621_494e-6,
    -2.773_548_310e-4,
    -6.801_643_074e-3,
];

fn outer(thou: f64) -> Vec<Defect> {
    vec![fault(Surface::Outer, -FRAC_PI_2, thou)]
}

fn end(definition: RotorDefinition, method: Method, tolerance: f64) -> (Run, Sample) {
    let model = Model {
        integrator: Settings {
            method,
            ..settings(tolerance)
        },
        ..model(definition, PASSES, 60.0 / PASSES)
    };
    let (run, mut samples) = try_run(&model, 0.0);
    (run.expect("a run"), samples.pop().expect("the end"))
}

/// Displacement in µm and velocity in µm/s.
fn state(sample: &Sample) -> [f64; 4] {
    let ([x, y, ..], [v_x, v_y, ..]) = (sample.displacement, sample.velocity);
    [x, y, v_x, v_y]
}

#[test]
fn the_golden_run_without_a_fault_has_its_printed_digits() {
    let (_, end) = end(golden(Vec::new()), Method::Verner76, 1e-12);
    assert_near("t", end.time, PASSES, 1e-9);
    let [x, y, v_x, v_y] = state(&end);
    assert_printed("x", x, "6.5533730e-8");
    assert_printed("y", y, "-4.8118439e-6");
    // printed as −1.7636188e-5; a Runge–Kutta run of 2 million steps in 80 bits has −1.76361888e-5
    assert_near("v_x", v_x, -1.763_618_88e-5, 1e-13);
    assert_printed("v_y", v_y, "9.4344e-6");
}

#[test]
fn methods_of_every_kind_find_the_golden_run_with_the_fault() {
    let spalled = || golden(outer(21.0));
    let (_, healthy) = end(golden(Vec::new()), Method::Verner76, 1e-9);
    let (_, truth) = end(spalled(), Method::Verner76, 1e-12);
    for (method, tolerance) in [
        (Method::Dopri5, 1e-10),
        (Method::Verner76, 1e-9),
        (Method::Exponential, 1e-9),
    ] {
        let (_, end) = end(spalled(), method, tolerance);
        let apart = |left: &[f64], right: &[f64]| {
            let pairs = left.iter().zip(right);
            pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        };
        let [found, expected] = [&end, &truth].map(state);
        let [places, rates] = [0..2, 2..4].map(|part| apart(&found[part.clone()], &expected[part]));
        assert!(
            places < 3e-14 && rates < 1e-9,
            "{method:?}: {places:e} {rates:e}"
        );
    }
    for (value, printed) in state(&truth).into_iter().zip(GOLDEN_SPALLED) {
        assert_near("with the fault", value, printed, 1e-8 * printed.abs());
    }
    // the fault is felt
    assert!((state(&healthy)[1] - state(&truth)[1]).abs() > 1e-9);
}

#[test]
fn the_measured_error_keeps_to_its_tolerance_with_few_steps() {
    for tolerance in [1e-6, 1e-8] {
        for on in [Surface::Outer, Surface::Inner, Surface::Ball(2)] {
            let run = |defects| {
                let model = Model {
                    verify: true,
                    integrator: Settings {
                        method: Method::Auto,
                        ..settings(tolerance)
                    },
                    ..model(golden(defects), 0.2, 12_000.0)
                };
                try_run(&model, 0.0).0.expect("a run")
            };
            let [healthy, spalled] = [Vec::new(), vec![fault(on, -FRAC_PI_2, 21.0)]].map(run);
            let error = spalled.measured_error.expect("a measured error");
            assert!(
                error.relative < 3.0 * tolerance,
                "{on:?}: {:e}",
                error.relative
            );
            assert!(spalled.counters.evaluations < 3 * healthy.counters.evaluations);
        }
    }
}

/// The golden run with a spall and a cage that gains up to half a degree with each ball pass.
fn jittering(steps: &[f64]) -> RotorDefinition {
    let mut definition = golden(outer(21.0));
    definition.bearings[0].imperfections.cage_steps = steps.to_vec();
    definition
}

/// Steps of a cage, rad.
const CAGE_STEPS: [f64; 5] = [4e-3, -8e-3, 6e-3, 1e-3, -5e-3];

#[test]
fn methods_agree_on_a_cage_that_wanders() {
    let (_, even) = end(golden(outer(21.0)), Method::Verner76, 1e-10);
    let (_, truth) = end(jittering(&CAGE_STEPS), Method::Verner76, 1e-12);
    let (_, again) = end(jittering(&CAGE_STEPS), Method::Verner76, 1e-12);
    assert_eq!(truth, again);
    for method in [Method::Dopri5, Method::Exponential] {
        let (_, end) = end(jittering(&CAGE_STEPS), method, 1e-10);
        let apart = (state(&end)[1] - state(&truth)[1]).abs();
        assert!(apart < 1e-12, "{method:?}: {apart:e}");
    }
    assert!((state(&even)[1] - state(&truth)[1]).abs() > 1e-9);
    for tolerance in [1e-6, 1e-8] {
        let model = Model {
            verify: true,
            integrator: Settings {
                method: Method::Auto,
                ..settings(tolerance)
            },
            ..model(jittering(&CAGE_STEPS), 0.2, 12_000.0)
        };
        let run = try_run(&model, 0.0).0.expect("a run");
        let error = run.measured_error.expect("a measured error");
        assert!(error.relative < 3.0 * tolerance, "{:e}", error.relative);
    }
}

#[test]
fn no_motion_repeats_where_a_cage_wanders() {
    let rotor = Rotor::assemble(&jittering(&CAGE_STEPS)).expect("a rotor");
    let error = rotor.forcing().expect_err("no period");
    assert!(error.to_string().contains("cage_jitter"), "{error}");
    // a step of more than half the spacing would turn it backwards
    assert!(Rotor::assemble(&jittering(&[0.36])).is_err());
}

/// A pair of bearings, one of them with slots and a dent, contacts damped.
fn damaged_pair() -> Vec<MountedBearing> {
    let contact_damping = ContactDamping {
        inner: 0.5,
        outer: 0.3,
    };
    let mut pair = back_to_back_pair();
    let defects = [
        fault(Surface::Outer, -FRAC_PI_2, 21.0),
        fault(Surface::Inner, 0.4, 14.0),
        fault(Surface::Ball(5), 0.0, 14.0),
    ];
    pair[1] = with_defects(pair[1].clone(), defects.to_vec());
    for bearing in &mut pair {
        bearing.contact_damping = contact_damping;
    }
    pair
}

#[test]
fn the_account_of_energy_closes_over_defects() {
    let mut unbalanced = shaft(Freedoms::All);
    (unbalanced.eccentricity, unbalanced.gravity) = (10e-6, true);
    let prescribed = RotorDefinition {
        speed: 800.0,
        damping: Damping::Ratio(0.02),
        loads: constant([100.0, -200.0, 50.0, 0.2, -0.1]),
        ..rotor(unbalanced, damaged_pair())
    };
    let driven = RotorDefinition {
        drive: Some(Drive {
            torque: 2.0,
            no_load_speed: Some(900.0),
            load_torque: 0.1,
            friction: true,
            compliance: 0.0,
        }),
        ..prescribed.clone()
    };
    let mut undamped = prescribed.clone();
    for bearing in &mut undamped.bearings {
        bearing.contact_damping = ContactDamping::default();
    }
    for definition in [undamped, prescribed, driven] {
        let residual = |tolerance: f64| {
            let model = Model {
                energy: true,
                integrator: Settings {
                    method: Method::Verner76,
                    ..settings(tolerance)
                },
                ..model(definition.clone(), 0.02, 20_000.0)
            };
            let run = simulate_into(&model, &mut Collector::default()).expect("a run");
            run.energy.expect("an account").relative_residual
        };
        // the works of defects are small beside the energy of the motion that a tolerance refers to
        let [coarse, fine] = [1e-8, 1e-10].map(residual);
        assert!(coarse < 2e-6 && fine < 2e-8, "{coarse:e} {fine:e}");
    }
}

/// 151.48 µs for 0.021 in, and in proportion to the length.
#[test]
fn entry_and_impact_are_as_far_apart_as_kinematics_has_them() {
    let spalls = |defects| {
        let model = model(golden(defects), 0.01, 24_000.0);
        try_run(&model, 0.0).0.expect("a run").spalls
    };
    for (thou, known) in [(21.0, 151.48e-6), (14.0, 100.99e-6), (7.0, 50.49e-6)] {
        let found = spalls(outer(thou));
        assert_eq!(found.len(), 1, "{found:?}");
        assert_near("known", found[0].entry_to_impact, known, 1e-8);
    }
    assert_eq!(spalls(Vec::new()), []);
}
