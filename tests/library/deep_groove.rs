//! Deep-groove bearings: alike in both directions, in the middle of their axial play at z = 0.

use crate::bearing::{Bearing, ClearanceClass, Facing, Geometry, MountedBearing, Preload};
use crate::rotor::Equilibrium;
use crate::scenario::{Format, parse};
use crate::tests::support::{assert_near, bearing, equilibrium, mounted};

/// Two 6205, 60 mm either side of the centre of mass.
fn pair(facings: [Facing; 2], preload: Preload) -> Vec<MountedBearing> {
    let bearing = bearing("6205");
    let mount = |(position, facing)| MountedBearing {
        position,
        facing,
        preload,
        ..mounted(bearing)
    };
    [-0.06, 0.06].into_iter().zip(facings).map(mount).collect()
}

fn found(bearings: &[MountedBearing]) -> Equilibrium {
    let load = [0.0, -378.0, 30.0, 0.0, 0.5];
    equilibrium(bearings, load, [true; 5]).expect("the load is carried")
}

#[test]
fn without_preload_the_facing_changes_nothing() {
    use Facing::{MinusZ, PlusZ};
    let none = Preload::AxialOffset(0.0);
    let alike = found(&pair([PlusZ, PlusZ], none));
    for facings in [[PlusZ, MinusZ], [MinusZ, PlusZ], [MinusZ, MinusZ]] {
        let other = found(&pair(facings, none));
        for (one, another) in alike.displacement.iter().zip(other.displacement) {
            assert_near("displacement", another, *one, 1e-15);
        }
    }
}

#[test]
fn a_preload_takes_the_play_out_and_stiffens() {
    let free = found(&pair(
        [Facing::PlusZ, Facing::MinusZ],
        Preload::AxialOffset(0.0),
    ));
    let tight = found(&pair(
        [Facing::PlusZ, Facing::MinusZ],
        Preload::Force(200.0),
    ));
    assert!(tight.stiffness[(2, 2)] > 2.0 * free.stiffness[(2, 2)]);
    assert!(tight.stiffness[(0, 0)] > free.stiffness[(0, 0)]);
}

/// Pure thrust either way: the mirror image. The play ends where the free contact angle is reached,
/// at A sin α0 from the middle: under a light load the shaft stands a little beyond.
#[test]
fn thrust_either_way_is_the_mirror_image_and_ends_the_play() {
    let bearing = bearing("6205");
    let place = |force: f64| {
        let load = [0.0, 0.0, force, 0.0, 0.0];
        let found = equilibrium(
            &[mounted(bearing)],
            load,
            [false, false, true, false, false],
        );
        found.expect("the load is carried").displacement[2]
    };
    let end = end_of_play(&bearing.geometry);
    for force in [1e-3, 1.0, 500.0] {
        assert_near("mirrored", place(-force), -place(force), 1e-15);
    }
    assert!((place(1e-3) - end).abs() < 1e-3 * end);
    assert!(place(1e-3) > end && place(500.0) > place(1.0));
}

/// A sin α0 with cos α0 = 1 − P_d/(2A).
fn end_of_play(geometry: &Geometry) -> f64 {
    let (distance, clearance) = (
        geometry.groove_centre_distance(),
        geometry.diametral_clearance().expect("a clearance"),
    );
    let cos = 1.0 - clearance / (2.0 * distance);
    distance * (1.0 - cos * cos).sqrt()
}

#[test]
fn a_catalogue_bearing_has_the_clearance_of_its_class() {
    let of = |bearing: &Bearing| bearing.clearance().expect("a deep-groove bearing");
    let known = of(&bearing("6205"));
    assert_eq!(known.class, Some(ClearanceClass::CN));
    assert_near("P_d", known.diametral, 12.5e-6, 1e-18);
    assert!(bearing("7205C").clearance().is_none());
    for (keys, clearance, class) in [
        ("", 12.5e-6, Some(ClearanceClass::CN)),
        (
            "clearance_class = \"C3\"",
            20.5e-6,
            Some(ClearanceClass::C3),
        ),
        (
            "clearance_class = \"C3\"\nclearance_change = \"-5 um\"",
            15.5e-6,
            Some(ClearanceClass::C3),
        ),
        ("geometry = { diametral_clearance = \"7 um\" }", 7e-6, None),
        ("geometry = { radial_clearance = \"7 um\" }", 14e-6, None),
    ] {
        let text = format!(
            "[shaft]\nmass = \"1 kg\"\nfreedoms = \"radial\"\n[speed]\nconstant = \"100 rad/s\"\n\
             [[bearing]]\ncatalogue = \"6205\"\n{keys}\n[damping]\nratio = 0.02\n"
        );
        let scenario = parse(&text, "6205", Format::Toml).expect("a scenario");
        let found = of(&scenario.question.rotor.bearings[0].bearing);
        assert_near(keys, found.diametral, clearance, 1e-16);
        assert_eq!(found.class, class, "{keys}");
    }
}
