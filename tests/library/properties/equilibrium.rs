//! Static equilibrium of the bearing and of pairs, under any load.

use std::cell::Cell;

use crate::bearing::{Bearing, FreePosition, Geometry, MountedBearing, Vector5};
use crate::rotor::EquilibriumError;
use proptest::prelude::*;
use proptest::test_runner::{RngSeed, TestRunner};

use crate::tests::support::{
    assert_near, back_to_back_pair, bearing, equilibrium, mounted, without_clearance,
};

/// Twice the Newton steps that the hardest of the random cases takes, 21.
const MOST_NEWTON_STEPS: usize = 40;

/// Forces to 5 kN, moments to 20 N m; on a tenth of the axes none at all.
fn load() -> impl Strategy<Value = Vector5> {
    let force = || prop_oneof![9 => -5000.0..5000.0f64, 1 => Just(0.0)];
    let moment = || prop_oneof![9 => -20.0..20.0f64, 1 => Just(0.0)];
    [
        force().boxed(),
        force().boxed(),
        force().boxed(),
        moment().boxed(),
        moment().boxed(),
    ]
}

fn bearings() -> impl Strategy<Value = Vec<MountedBearing>> {
    prop_oneof![
        Just(vec![mounted(bearing("7205C"))]),
        Just(vec![mounted(bearing("6305"))]),
        Just(vec![mounted(with_clearance(20e-6))]),
        Just(back_to_back_pair()),
    ]
}

/// A 6305 with a diametral clearance in m.
fn with_clearance(clearance: f64) -> Bearing {
    let free = FreePosition::DiametralClearance(clearance);
    Bearing {
        geometry: Geometry::new(7, 11.5e-3, 43.5e-3, free, 0.52, 0.53).expect("a bearing"),
        ..bearing("6305")
    }
}

#[test]
fn every_load_finds_its_equilibrium_in_a_few_newton_steps() {
    let config = ProptestConfig {
        rng_seed: RngSeed::Fixed(3),
        failure_persistence: None,
        ..ProptestConfig::with_cases(2000)
    };
    let most_steps = Cell::new(0);
    let cases = (bearings(), load(), any::<[bool; 5]>());
    TestRunner::new(config)
        .run(&cases, |(bearings, load, free)| {
            let steps = check(&bearings, load, free)?;
            most_steps.set(steps.max(most_steps.get()));
            Ok(())
        })
        .unwrap_or_else(|failure| panic!("{failure}"));
    let most_steps = most_steps.get();
    println!("most Newton steps: {most_steps}");
    assert!(most_steps <= MOST_NEWTON_STEPS, "{most_steps} Newton steps");
}

/// Checks one case and returns its Newton steps. Groove centres that overshoot carry a load the
/// other way, so bearings of this size carry every load of this size.
fn check(
    bearings: &[MountedBearing],
    load: Vector5,
    free: [bool; 5],
) -> Result<usize, TestCaseError> {
    let found = equilibrium(bearings, load, free)
        .map_err(|error| TestCaseError::fail(error.to_string()))?;
    prop_assert!(found.residual <= 1e-9);
    let largest = found.force.iter().fold(1.0_f64, |a, b| a.max(b.abs()));
    for axis in 0..5 {
        if free[axis] {
            // the residual is relative to the forces in play, those of single bearings: a pair's
            // preload and the arm of moments may make them a hundred times the sum
            prop_assert!((found.force[axis] - load[axis]).abs() <= 1e-7 * largest);
        } else {
            prop_assert_eq!(found.displacement[axis], 0.0);
        }
    }
    Ok(found.newton_steps)
}

#[test]
fn a_thrust_that_no_ball_can_carry_is_refused_by_name() {
    let bearings = [mounted(with_clearance(20e-6))];
    let free = [false, false, true, false, false];
    let load = [0.0, 0.0, 1e9, 0.0, 0.0];
    let error = equilibrium(&bearings, load, free).expect_err("no ball is so stiff");
    let EquilibriumError::NotCarried { freedom, load, .. } = error else {
        panic!("{error}");
    };
    assert_eq!((freedom.as_str(), load), ("z", 1e9));
}

/// Once a panic: an unbalanced force of 1e-182 N, whose square is rounded to zero.
#[test]
fn a_residual_whose_square_underflows_is_no_residual() {
    let bearings = [mounted(with_clearance(20e-6))];
    let load = [1625.6567711927128, 0.0, 0.0, 0.0, 0.0];
    let found = equilibrium(&bearings, load, [true, false, true, true, false]).expect("carried");
    assert!(found.residual <= 1e-9);
}

#[test]
fn loads_too_small_to_square_have_an_answer() {
    for load in [1e-150, 1e-200, 1e-300, f64::MIN_POSITIVE, 5e-324] {
        for bearing in [bearing("7205C"), bearing("6305"), with_clearance(20e-6)] {
            // found or refused: what counts is that neither panics
            let answer = equilibrium(&[mounted(bearing)], [load; 5], [true; 5]);
            assert!(!matches!(answer, Err(EquilibriumError::NotFinite { .. })));
        }
    }
}

#[test]
fn a_load_of_nan_is_refused_by_the_name_of_its_freedom() {
    let load = [0.0, f64::NAN, 0.0, 0.0, 0.0];
    let error = equilibrium(&[mounted(bearing("7205C"))], load, [true; 5]).expect_err("NaN");
    assert!(
        matches!(&error, EquilibriumError::NotFinite { freedom, .. } if freedom == "y"),
        "{error}"
    );
}

/// From out of contact, K singular at the start: the inner ring falls through the clearance.
#[test]
fn with_clearance_the_lowest_balls_carry_the_load() {
    let clearance = 20e-6;
    let bearing = with_clearance(clearance);
    let first_ball = -std::f64::consts::FRAC_PI_2;
    let mounted = MountedBearing {
        first_ball,
        ..mounted(bearing)
    };
    let centred = -bearing.geometry.free_axial();
    let supports = crate::tests::support::supports(&[mounted]);
    let found = crate::rotor::StaticProblem {
        supports: &supports,
        load: [0.0, -1.0, 0.0, 0.0, 0.0],
        free: [true, true, false, false, false],
        start: [0.0, 0.0, centred, 0.0, 0.0],
        speed: 0.0,
    }
    .solve()
    .expect("the lowest ball carries it");
    // 1 N on the lowest ball alone: δ = (Q/K_n)^(2/3) = |y| − P_d/2
    let stiffness = bearing.load_deflection_constant().expect("a contact");
    let place = -0.5 * clearance - (1.0 / stiffness).cbrt().powi(2);
    assert_near("y", found.displacement[1], place, 1e-14);
}

/// Groove centres that stand side by side (A1 = 0) and a force Q = K_n δ^(3/2) on each ball: eight
/// times the load, four times the displacement. Angles do not change, so the law is exact.
#[test]
fn radial_displacement_grows_with_the_load_to_the_two_thirds() {
    let bearings = [mounted(without_clearance("6305"))];
    let radial = |load: f64| {
        let free = [true, true, false, false, false];
        equilibrium(&bearings, [load, 0.0, 0.0, 0.0, 0.0], free)
            .expect("carried")
            .displacement[0]
    };
    let (light, heavy) = (radial(100.0), radial(800.0));
    assert_near("ratio", heavy / light, 4.0, 1e-9);
}

#[test]
fn a_longer_thrust_pushes_further_and_stiffens() {
    let bearings = [mounted(bearing("7205C"))];
    let mut before = (0.0, 0.0);
    for thrust in [1.0, 10.0, 100.0, 1000.0, 10_000.0] {
        let found =
            equilibrium(&bearings, [0.0, 0.0, thrust, 0.0, 0.0], [true; 5]).expect("carried");
        let now = (found.displacement[2], found.stiffness[(2, 2)]);
        assert!(now.0 > before.0 && now.1 > before.1);
        before = now;
    }
}
