//! Roller bearings, lamina by lamina after ISO/TS 16281: statics and a motion of an independent implementation (E = 206 GPa, ν =
//! 0.3, 40 laminae, rigid rings), Sjövall's integrals, and Hamrock's line contacts.

use crate::bearing::{
    Bearing, BearingRotation, Geometry, Matrix5, MountedBearing, Oil, Profile, RaceFilms,
    RollerKind, Rollers, Support, Vector5,
};
use crate::integrate::Method;
use crate::physics::Material;
use crate::rotor::{
    CageMotion, Damping, Equilibrium, Freedoms, InitialPosition, InitialState, RotorDefinition,
};
use crate::simulate::Model;

use crate::tests::support::{
    assert_near, assert_printed, constant, equilibrium, model, mounted, rotor, samples, shaft,
    supports,
};

const MILLI: f64 = 1e-3;
const MICRO: f64 = 1e-6;

/// Number, diameter, length and pitch diameter in mm.
type Size = (usize, f64, f64, f64);

/// A bearing of steel with E = 206 GPa; angle in degrees, clearance in µm.
pub fn roller_bearing(
    kind: RollerKind,
    (count, diameter, length, pitch): Size,
    angle: f64,
    clearance: f64,
    profile: Profile,
    laminae: usize,
) -> Bearing {
    let rollers = Rollers {
        kind,
        length: MILLI * length,
        profile,
        laminae,
        clearance: MICRO * clearance,
    };
    let angle = f64::to_radians(angle);
    let geometry = Geometry::of_rollers(count, MILLI * diameter, MILLI * pitch, angle, rollers)
        .expect("rollers");
    let steel = Material {
        youngs_modulus: 206e9,
        ..Material::BEARING_STEEL
    };
    Bearing {
        ring_material: steel,
        ball_material: steel,
        ..Bearing::of_steel(geometry)
    }
}

/// Six rollers 9 × 13.6 mm with 10 µm of clearance.
fn six(profile: Profile) -> MountedBearing {
    let kind = RollerKind::Cylindrical;
    mounted(roller_bearing(
        kind,
        (6, 9.0, 13.6, 43.5),
        0.0,
        10.0,
        profile,
        40,
    ))
}

/// Thirteen rollers 7.5 × 8 mm without clearance.
pub fn thirteen(profile: Profile, laminae: usize) -> MountedBearing {
    let kind = RollerKind::Cylindrical;
    mounted(roller_bearing(
        kind,
        (13, 7.5, 8.0, 46.0),
        0.0,
        0.0,
        profile,
        laminae,
    ))
}

/// Seventeen tapered rollers at 14°.
pub fn tapered() -> MountedBearing {
    let (kind, profile) = (RollerKind::Tapered, Profile::Logarithmic);
    mounted(roller_bearing(
        kind,
        (17, 7.9, 11.0, 51.0),
        14.0,
        0.0,
        profile,
        40,
    ))
}

/// Two rows of fifteen barrels at 9° with 20 µm of clearance.
pub fn spherical() -> MountedBearing {
    let profile = Profile::Barrel {
        roller_radius: 33.2e-3,
        race_radius: 34e-3,
    };
    let kind = RollerKind::Spherical;
    mounted(roller_bearing(
        kind,
        (15, 14.0, 13.0, 72.0),
        9.0,
        20.0,
        profile,
        40,
    ))
}

const RADIAL: [bool; 5] = [true, true, false, false, false];
const TRANSLATIONAL: [bool; 5] = [true, true, true, false, false];

/// Equilibrium under a load, and the stiffness of the bearing with all freedoms there.
fn loaded(bearing: &MountedBearing, load: Vector5, free: [bool; 5]) -> (Equilibrium, Matrix5) {
    let found = equilibrium(std::slice::from_ref(bearing), load, free).expect("an equilibrium");
    let support = &supports(std::slice::from_ref(bearing))[0];
    let tangent = support.tangent(&found.displacement, &BearingRotation::at_start(0.0));
    (found, tangent.stiffness)
}

/// Asserts a value to a millionth of the expected one.
#[track_caller]
fn agrees(name: &str, value: f64, expected: f64) {
    assert_near(name, value, expected, 1e-6 * expected.abs());
}

#[test]
fn six_cylindrical_rollers() {
    let load = [1000.0, 0.0, 0.0, 0.0, 0.0];
    // the roller on the load line bears all
    let (flat, stiffness) = loaded(
        &six(Profile::Flat),
        load,
        [true, false, false, false, false],
    );
    agrees("x", flat.displacement[0], 9.932438e-6);
    agrees("K_x", stiffness[(0, 0)], 225.26612e6);
    let bearing = six(Profile::Logarithmic);
    let (crowned, stiffness) = loaded(&bearing, load, RADIAL);
    agrees("x", crowned.displacement[0], 12.404854e-6);
    let named = [226.4632e6, 110.0693e6, 0.0, 257.5614, 2059.9783];
    for (axis, expected) in named.into_iter().enumerate() {
        agrees("K", stiffness[(axis, axis)], expected);
    }
}

#[test]
fn thirteen_cylindrical_rollers() {
    let load = [1000.0, 0.0, 0.0, 0.0, 0.0];
    for (profile, expected) in [
        (Profile::Flat, [2.665137e-6, 416.90586e6, 427.43348e6]),
        (
            Profile::Logarithmic,
            [4.859326e-6, 313.13352e6, 214.84621e6],
        ),
    ] {
        let (found, stiffness) = loaded(&thirteen(profile, 40), load, RADIAL);
        agrees("x", found.displacement[0], expected[0]);
        agrees("K_x", stiffness[(0, 0)], expected[1]);
        agrees("K_y", stiffness[(1, 1)], expected[2]);
    }
}

#[test]
fn cylindrical_rollers_tilted_by_a_moment() {
    let load = [1000.0, 0.0, 0.0, 0.0, 2.0];
    let free = [true, true, false, true, true];
    let (found, stiffness) = loaded(&thirteen(Profile::Logarithmic, 40), load, free);
    agrees("x", found.displacement[0], 2.8759304e-6);
    agrees("θy", found.displacement[4], 2.73591489e-3);
    agrees("K_x", stiffness[(0, 0)], 326.03518e6);
    agrees("K_θy", stiffness[(4, 4)], 1343.1257);
}

#[test]
fn tapered_rollers_under_thrust_and_combined_load() {
    let bearing = tapered();
    let (found, stiffness) = loaded(&bearing, [0.0, 0.0, 3000.0, 0.0, 0.0], TRANSLATIONAL);
    agrees("z", found.displacement[2], 30.1017006e-6);
    let named = [
        1190.6731e6,
        1190.6731e6,
        148.03508e6,
        55_866.233,
        55_866.233,
    ];
    for (axis, expected) in named.into_iter().enumerate() {
        agrees("K", stiffness[(axis, axis)], expected);
    }
    let (found, _) = loaded(&bearing, [1500.0, -2500.0, 4000.0, 0.0, 0.0], TRANSLATIONAL);
    for (axis, expected) in [1.17386563e-6, -1.95714033e-6, 36.3896106e-6]
        .into_iter()
        .enumerate()
    {
        agrees("displacement", found.displacement[axis], expected);
    }
    assert_printed("M_x", found.force[3], "-15.8947");
    assert_printed("M_y", found.force[4], "-9.5368");
}

#[test]
fn spherical_rollers_of_two_rows() {
    let (found, stiffness) = loaded(&spherical(), [0.0, -10e3, 0.0, 0.0, 0.0], TRANSLATIONAL);
    assert_near("x", found.displacement[0], 0.1966e-6, 5e-13);
    agrees("y", found.displacement[1], -26.8488521e-6);
    assert_near("z", found.displacement[2], 0.0, 1e-15);
    agrees("K_x", stiffness[(0, 0)], 390.59049e6);
    agrees("K_y", stiffness[(1, 1)], 1049.6222e6);
    agrees("K_z", stiffness[(2, 2)], 36.128644e6);
    // the outer race is a sphere
    assert_eq!([stiffness[(3, 3)], stiffness[(4, 4)]], [0.0; 2]);
}

/// J_r(0.5) = 0.2447986 of Sjövall for line contact: Q_max = F/(Z J_r cos α) of many rollers without clearance.
#[test]
fn sjovalls_integral_of_half_the_ring() {
    let size = (180, 0.7, 1.2, 46.0);
    let kind = RollerKind::Cylindrical;
    let bearing = mounted(roller_bearing(kind, size, 0.0, 0.0, Profile::Flat, 30));
    let (found, _) = loaded(&bearing, [1000.0, 0.0, 0.0, 0.0, 0.0], RADIAL);
    let support = &supports(&[bearing])[0];
    let state = support.state(&found.displacement, 0.0, 0.0, CageMotion::Frozen);
    let largest = state
        .balls
        .iter()
        .map(|line| line.inner.load)
        .fold(0.0, f64::max);
    assert_near("Q_max Z/F", 180.0 * largest / 1000.0, 1.0 / 0.2447986, 2e-4);
}

/// L10r with C 31.5 kN under 1 kN on one roller, at rest and from the loads of a run, slice by slice.
#[test]
fn life_of_six_cylindrical_rollers() {
    let mut bearing = six(Profile::Flat);
    bearing.bearing.dynamic_rating = Some(31_500.0);
    let load = [1000.0, 0.0, 0.0, 0.0, 0.0];
    let (found, _) = loaded(&bearing, load, [true, false, false, false, false]);
    let support = &supports(std::slice::from_ref(&bearing))[0];
    let state = support.state(&found.displacement, 0.0, 0.0, CageMotion::Frozen);
    assert_printed("L10r", state.life.expect("a life"), "160603");
    let lives = state.rating_lives.expect("lives");
    // P = F_r
    let basic = 31.5f64.powf(10.0 / 3.0);
    assert_near("L10", lives.basic.expect("L10"), basic, 1e-9 * basic);
    let mut loads = support.room_for_loads(false);
    let rotation = BearingRotation::at_start(0.0);
    support.force_and_loads(&found.displacement, &rotation, &mut loads);
    let rating = bearing.bearing.rating_life().expect("a rating");
    assert_printed(
        "L10r",
        rating.life(loads.rated_loads()).expect("a life"),
        "160603",
    );
}

/// A mass under unbalance and a load on rollers that go round, from 3 µm below the middle.
fn falling(method: Method) -> Model {
    let mut shaft = shaft(Freedoms::Radial);
    shaft.eccentricity = 8e-6;
    let definition = RotorDefinition {
        speed: 300.0,
        damping: Damping::Coefficients([400.0, 400.0, 0.0, 0.0, 0.0]),
        loads: constant([0.0, -500.0, 0.0, 0.0, 0.0]),
        cage: CageMotion::Rolling,
        initial: InitialState {
            from: InitialPosition::Origin,
            displacement: [None, Some(-3e-6), None, None, None],
            ..InitialState::default()
        },
        ..rotor(shaft, vec![thirteen(Profile::Flat, 30)])
    };
    let mut model = model(definition, 0.05, 20_000.0);
    model.integrator.method = method;
    model.integrator.tolerance = 1e-11;
    model
}

#[test]
fn a_shaft_falls_onto_flat_rollers() {
    let last = samples(&falling(Method::Verner76), 0.05 - 1e-9);
    let place = last.last().expect("a sample").displacement;
    // to 1e-8 of the motion, which is 3 µm
    assert_near("x", place[0], 2.05589870e-8, 3e-14);
    assert_near("y", place[1], -1.63237867e-6, 3e-14);
}

#[test]
fn hamrocks_pressures_and_films_of_a_line_contact() {
    let steel = Material {
        youngs_modulus: 210e9,
        ..Material::BEARING_STEEL
    };
    let kind = RollerKind::Cylindrical;
    let bearing = Bearing {
        ring_material: steel,
        ball_material: steel,
        ..roller_bearing(kind, (20, 8.0, 8.0, 77.5), 0.0, 0.0, Profile::Flat, 30)
    };
    let support = Support::new(&mounted(bearing), 0.0).expect("a support");
    for (race, [half_width, pressure]) in [[88.97e-6, 1431.0e6], [98.69e-6, 1290.2e6]]
        .into_iter()
        .enumerate()
    {
        let strip = support.contacts().ellipse(race, 1600.0);
        assert_near("b", strip.semi_minor, half_width, 5e-9);
        assert_near("p", strip.peak_pressure, pressure, 5e4);
    }
    let oil = Oil {
        viscosity: 0.01,
        pressure_viscosity: 2e-8,
    };
    let films = RaceFilms::of_rollers(&bearing, 8e-3, &oil).expect("films");
    let [inner, outer] = films.thickness([1600.0; 2], 837.0);
    assert_near("h_min", inner.minimum, 0.3912e-6, 5e-11);
    assert_near("h_min", outer.minimum, 0.4280e-6, 5e-11);
    // 2.922 R_x U^0.692 G^0.470 W^−0.166 by hand
    assert_near("h_c", inner.central, 0.4187e-6, 5e-11);
}
