//! Static equilibrium of the bearing and of pairs, under any load.

use std::cell::Cell;

use jeffcott::bearing::equilibrium::EquilibriumError;
use jeffcott::bearing::{Bearing, FreePosition, Geometry, MountedBearing, Vector5};
use proptest::prelude::*;
use proptest::test_runner::{RngSeed, TestRunner};

use crate::support::{assert_near, back_to_back_pair, bearing, equilibrium, mounted};

/// More Newton steps than any of the random cases took.
const MOST_NEWTON_STEPS: usize = 60;

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
fn every_load_finds_its_equilibrium_or_the_freedom_that_gives_way() {
    let config = ProptestConfig {
        rng_seed: RngSeed::Fixed(3),
        failure_persistence: None,
        ..ProptestConfig::with_cases(2000)
    };
    let tally = Tally::default();
    let cases = (bearings(), load(), any::<[bool; 5]>());
    TestRunner::new(config)
        .run(&cases, |(bearings, load, free)| {
            check(&bearings, load, free, &tally)
        })
        .unwrap_or_else(|failure| panic!("{failure}"));
    println!("{tally:?}");
    assert!(tally.most_steps.get() <= MOST_NEWTON_STEPS, "{tally:?}");
    assert!(
        tally.found.get() > 1000 && tally.refused.get() > 100,
        "{tally:?}"
    );
}

/// What became of the random cases.
#[derive(Debug, Default)]
struct Tally {
    most_steps: Cell<usize>,
    found: Cell<usize>,
    refused: Cell<usize>,
}

fn check(
    bearings: &[MountedBearing],
    load: Vector5,
    free: [bool; 5],
    tally: &Tally,
) -> Result<(), TestCaseError> {
    match equilibrium(bearings, load, free) {
        Ok(equilibrium) => {
            tally.found.set(tally.found.get() + 1);
            let steps = equilibrium.newton_steps.max(tally.most_steps.get());
            tally.most_steps.set(steps);
            prop_assert!(equilibrium.residual <= 1e-9);
            let forces = equilibrium.force.iter();
            let largest = forces.fold(1.0_f64, |a, b| a.max(b.abs()));
            for axis in 0..5 {
                if free[axis] {
                    // the residual is relative to the forces in play of single bearings
                    let excess = equilibrium.force[axis] - load[axis];
                    prop_assert!(excess.abs() <= 1e-7 * largest);
                } else {
                    prop_assert_eq!(equilibrium.displacement[axis], 0.0);
                }
            }
        }
        Err(EquilibriumError::NotCarried {
            freedom, residual, ..
        }) => {
            tally.refused.set(tally.refused.get() + 1);
            prop_assert!(residual != 0.0 && residual.is_finite(), "{}", freedom);
            // a pair that faces both ways carries every load of this size
            prop_assert!(bearings.len() == 1);
        }
        Err(error) => return Err(TestCaseError::fail(error.to_string())),
    }
    Ok(())
}

#[test]
fn thrust_off_the_grooves_is_refused_by_the_name_of_its_freedom() {
    let load = [0.0, 0.0, -100.0, 0.0, 0.0];
    let error =
        equilibrium(&[mounted(bearing("7205C"))], load, [true; 5]).expect_err("nothing carries it");
    let EquilibriumError::NotCarried { freedom, load, .. } = error else {
        panic!("{error}");
    };
    assert_eq!((freedom, load), ("z", -100.0));
}

#[test]
fn a_load_that_is_not_a_number_is_refused_by_the_name_of_its_freedom() {
    let load = [0.0, f64::NAN, 0.0, 0.0, 0.0];
    let error = equilibrium(&[mounted(bearing("7205C"))], load, [true; 5]).expect_err("NaN");
    assert!(
        matches!(error, EquilibriumError::NotFinite { freedom: "y", .. }),
        "{error}"
    );
}

/// From out of contact, K singular at the start: the inner ring falls through the clearance.
#[test]
fn a_bearing_with_clearance_stands_where_its_lowest_balls_carry_the_load() {
    let clearance = 20e-6;
    let bearing = with_clearance(clearance);
    let first_ball = -std::f64::consts::FRAC_PI_2;
    let mounted = MountedBearing {
        first_ball,
        ..mounted(bearing)
    };
    let centred = -bearing.geometry.free_axial();
    let supports = crate::support::supports(&[mounted]);
    let found = jeffcott::bearing::equilibrium::StaticProblem {
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
    let bearings = [mounted(bearing("6305"))];
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
