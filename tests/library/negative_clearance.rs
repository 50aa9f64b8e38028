//! Bearings whose balls are squeezed between the races without load, as tight fits and warm inner rings do.

use crate::bearing::{Bearing, ContactLaw, FreePosition, Geometry, GeometryError, MountedBearing};
use crate::physics::RaceControl;
use crate::scenario::{Format, parse};
use crate::tests::support::{assert_near, bearing, equilibrium, mounted};

/// 9 balls of 7.938 mm on 38.5 mm, both groove factors 0.52, steel of 207 GPa.
fn squeezed(clearance: f64) -> Bearing {
    let free = FreePosition::DiametralClearance(clearance);
    Bearing::of_steel(Geometry::new(9, 7.938e-3, 38.5e-3, free, 0.52, 0.52).expect("a bearing"))
}

/// −10 µm, without load and under 2000 N down, all but y held. The expected values are derivatives of the strain energy
/// `2/5 K_n Σ δ^(5/2)`, `δ = √((z + R_i (θx sin φ − θy cos φ))² + (A − P_d/2 + x cos φ + y sin φ)²) − A`, with K_n from the
/// elliptic integrals, computed apart with 30 digits (mpmath).
#[test]
fn the_stiffness_is_that_of_the_strain_energy() {
    for (load, y, diagonal) in [
        (
            0.0,
            0.0,
            [
                139.726595425e6,
                139.726595425e6,
                2.88822595859e6,
                543.997308378,
                543.997308378,
            ],
        ),
        (
            -2000.0,
            -16.1375576577e-6,
            [
                119.805748001e6,
                134.688074871e6,
                7.84631734747e6,
                1900.18263066,
                1055.52483746,
            ],
        ),
    ] {
        let found = equilibrium(
            &[mounted(squeezed(-10e-6))],
            [0.0, load, 0.0, 0.0, 0.0],
            [false, true, false, false, false],
        );
        let found = found.expect("the load is carried");
        assert_near("y", found.displacement[1], y, 1e-14);
        for (axis, expected) in diagonal.into_iter().enumerate() {
            let stiffness = found.stiffness[(axis, axis)];
            assert_near("K", stiffness / expected, 1.0, 1e-9);
        }
    }
}

#[test]
fn every_law_stands_centred_with_all_balls_loaded() {
    let laws = [
        ContactLaw::Hertz,
        ContactLaw::Linear,
        ContactLaw::Jones(RaceControl::Outer),
    ];
    for law in laws {
        let tight = MountedBearing {
            law,
            ..mounted(squeezed(-10e-6))
        };
        let found = equilibrium(&[tight], [0.0; 5], [true; 5]).expect("an equilibrium");
        for axis in 0..5 {
            assert_near("centred", found.displacement[axis], 0.0, 1e-15);
        }
        assert_near("K_x", found.stiffness[(0, 0)] / 139.726595425e6, 1.0, 1e-6);
    }
}

/// A clearance passes through zero without a jump, and a change is undone by its opposite.
#[test]
fn a_clearance_changes_sign_steadily() {
    let force = |clearance: f64| {
        let load = [0.0, -500.0, 0.0, 0.0, 0.0];
        let found = equilibrium(
            &[mounted(squeezed(clearance))],
            load,
            [true, true, false, false, false],
        );
        found.expect("the load is carried").displacement[1]
    };
    let [before, at, after] = [1e-9, 0.0, -1e-9].map(force);
    assert!((before - at).abs() < 2e-9 && (after - at).abs() < 2e-9);
    let made = squeezed(12e-6).geometry;
    let tight = made.with_clearance_change(-20e-6).expect("a squeeze");
    assert_near(
        "P_d",
        tight.diametral_clearance().expect("P_d"),
        -8e-6,
        1e-18,
    );
    assert_near("squeeze", tight.squeeze(), 4e-6, 1e-18);
    assert_eq!(tight.contact_angle(), 0.0);
    let back = tight.with_clearance_change(20e-6).expect("a clearance");
    assert_near("α0", back.contact_angle(), made.contact_angle(), 1e-12);
    assert_near("γ", back.gamma(), made.gamma(), 1e-15);
}

/// `A (1 − cos 15°)` is what an angular contact bearing gives up before its balls are squeezed.
#[test]
fn a_bearing_is_squeezed_where_its_angle_has_closed() {
    let made = bearing("7205C").geometry;
    let distance = made.groove_centre_distance();
    let closing = 2.0 * distance * (1.0 - 15f64.to_radians().cos());
    let tight = made
        .with_clearance_change(-closing - 10e-6)
        .expect("a squeeze");
    assert_near("squeeze", tight.squeeze(), 5e-6, 1e-16);
    assert_eq!([tight.contact_angle(), tight.free_axial()], [0.0, 0.0]);
    assert_eq!(tight.nominal_angle(), made.nominal_angle());
    let refused = made.with_clearance_change(-1e-3).expect_err("too tight");
    let GeometryError::ClearanceChange { smallest, .. } = refused else {
        panic!("{refused}");
    };
    assert_near("smallest", smallest, -closing - 0.2 * distance, 1e-15);
}

/// A fit of 15 µm takes more than the clearance of class CN: the bearing answers instead of refusing.
#[test]
fn a_tight_fit_is_answered() {
    let text = "[shaft]\nmass = \"5 kg\"\nfreedoms = \"radial\"\n[speed]\nconstant = \"3000 rpm\"\n\
        [[bearing]]\ncatalogue = \"6205\"\n[bearing.fit]\ninner_interference = \"15 um\"\n\
        inner_temperature = \"45 degC\"\nouter_temperature = \"35 degC\"\n[damping]\nratio = 0.02\n";
    let scenario = parse(text, "6205", Format::Toml).expect("a scenario");
    let bearing = scenario.question.rotor.bearings[0].bearing;
    let clearance = bearing.clearance().expect("a clearance").diametral;
    let change = bearing.fit.expect("a fit").clearance_change;
    assert!(clearance < 0.0);
    assert_near("P_d", clearance, 12.5e-6 + change, 1e-17);
}
