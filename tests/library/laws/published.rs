//! Reference numbers of the 7205C, computed by independent implementations of the same equations
//! which agree to the digits shown: E = 207 GPa, ν = 0.3, ρ = 7800 kg/m³, race constants at the
//! nominal contact angle. Tolerances are half a unit of the last digit.

use crate::bearing::{
    Ball, BallLaw, Bearing, ForceLaw, FreePosition, Geometry, HertzFilmLaw, JonesLaw, RaceFilms,
};
use crate::physics::{Material, RaceControl};

use super::{OIL, bearing_7205c, displacement_under_thrust};

fn assert_printed(name: &str, value: f64, printed: f64, digits: i32) {
    let half = 0.5001 * 10f64.powi(-digits);
    assert!(
        (value - printed).abs() <= half,
        "{name}: {value} instead of {printed}"
    );
}

struct Row {
    speed: f64,
    angle_inner: f64,
    angle_outer: f64,
    load_inner: f64,
    load_outer: f64,
    displacement: f64,
    centrifugal: f64,
    gyroscopic: f64,
    radial_stiffness: f64,
    axial_stiffness: f64,
}

/// F_z = 1000 N, x = y = 0, no tilt, outer race control, no film.
#[test]
fn thrust_at_speed() {
    let rows = [
        Row {
            speed: 500.0,
            angle_inner: 19.45580,
            angle_outer: 19.28689,
            load_inner: 250.1905,
            load_outer: 251.6949,
            displacement: 31.94279,
            centrifugal: 1.59503,
            gyroscopic: 0.836405,
            radial_stiffness: 213.3435,
            axial_stiffness: 59.1584,
        },
        Row {
            speed: 1000.0,
            angle_inner: 19.74569,
            angle_outer: 19.06724,
            load_inner: 246.6608,
            load_outer: 252.6792,
            displacement: 31.83103,
            centrifugal: 6.38608,
            gyroscopic: 3.312036,
            radial_stiffness: 212.5985,
            axial_stiffness: 58.9186,
        },
    ];
    let bearing = bearing_7205c();
    let law = JonesLaw::new(&bearing, RaceControl::Outer).unwrap();
    for row in rows {
        let z = displacement_under_thrust(&law, &bearing, 1000.0, row.speed);
        let geometry = &bearing.geometry;
        let place = (geometry.free_axial() + z, geometry.free_radial());
        let state = law
            .state(&Ball::at(place.0, place.1), row.speed)
            .expect("a law with inertia");
        let (_, tangent) = law.force_and_tangent(place.0, place.1, row.speed);
        let contact = state.contact;
        let balls = geometry.balls() as f64;
        assert_printed("δz µm", z * 1e6, row.displacement, 5);
        assert_printed(
            "α_i °",
            contact.angle_inner.to_degrees(),
            row.angle_inner,
            5,
        );
        assert_printed(
            "α_o °",
            contact.angle_outer.to_degrees(),
            row.angle_outer,
            5,
        );
        assert_printed("Q_i N", contact.load_inner, row.load_inner, 4);
        assert_printed("Q_o N", contact.load_outer, row.load_outer, 4);
        assert_printed("F_c N", state.centrifugal_force, row.centrifugal, 5);
        assert_printed("M_g N mm", state.gyroscopic_moment * 1e3, row.gyroscopic, 6);
        // centred: K_xx = Z/2 ∂F_r/∂A2, K_zz = Z ∂F_a/∂A1
        assert_printed(
            "K_xx N/µm",
            balls / 2.0 * tangent[1][1] * 1e-6,
            row.radial_stiffness,
            4,
        );
        assert_printed(
            "K_zz N/µm",
            balls * tangent[0][0] * 1e-6,
            row.axial_stiffness,
            4,
        );
    }
}

/// 50 000 rpm, 2670 N thrust: the case of a public program that recomputes the curvature at the
/// loaded angle and so differs in the fifth digit (604.0509, 768.8183 N, 26.23256°, 18.60540°).
/// The reversed sign of the gyroscopic moment would give α_o = 21.8°.
#[test]
fn high_speed_case_of_a_public_program() {
    let material = Material {
        youngs_modulus: 199.948e9,
        poisson_ratio: 0.25,
        density: 7750.37,
    };
    let angle = FreePosition::ContactAngle(20f64.to_radians());
    let bearing = Bearing {
        ring_material: material,
        ball_material: material,
        ..Bearing::of_steel(Geometry::new(10, 7.938e-3, 38.5e-3, angle, 0.56, 0.52).unwrap())
    };
    let speed = 50_000.0 * std::f64::consts::TAU / 60.0;
    let law = JonesLaw::new(&bearing, RaceControl::Outer).unwrap();
    let z = displacement_under_thrust(&law, &bearing, 2670.0, speed);
    let geometry = &bearing.geometry;
    let contact = law.contact(
        &Ball::at(geometry.free_axial() + z, geometry.free_radial()),
        speed,
    );
    assert_printed("Q_i N", contact.load_inner, 603.9922, 4);
    assert_printed("Q_o N", contact.load_outer, 768.7591, 4);
    assert_printed("α_i °", contact.angle_inner.to_degrees(), 26.23531, 5);
    assert_printed("α_o °", contact.angle_outer.to_degrees(), 18.60676, 5);
}

/// Hertz with film as force law, F_z = 1000 N, 1000 rad/s.
#[test]
fn thrust_on_an_oil_film() {
    let bearing = bearing_7205c();
    let law = HertzFilmLaw::with_film(&bearing, OIL, 1000.0).unwrap();
    let z = displacement_under_thrust(&law, &bearing, 1000.0, 1000.0);
    let geometry = &bearing.geometry;
    let (axial, radial) = (geometry.free_axial() + z, geometry.free_radial());
    let contact = law.contact(&Ball::at(axial, radial), 1000.0);
    let (_, tangent) = law.force_and_tangent(axial, radial, 1000.0);
    assert_printed("δz µm", z * 1e6, 26.893679, 6);
    assert_printed("Q N", contact.load_inner, 260.182616, 6);
    assert_printed("α °", contact.angle_inner.to_degrees(), 18.680334, 6);
    assert_printed("K_zz N/µm", 12.0 * tangent[0][0] * 1e-6, 55.652314, 6);
}

/// Central and minimum film thickness at Q = 251.39 N: speed, inner h_c, h_min, outer h_c, h_min.
#[test]
fn film_thickness() {
    let rows = [
        [1000.0, 0.8562, 0.7001, 1.0237, 0.8293],
        [500.0, 0.5381, 0.4370, 0.6434, 0.5176],
    ];
    let bearing = bearing_7205c();
    let films = RaceFilms::new(&bearing, &bearing.point_contacts().unwrap(), &OIL).unwrap();
    for [
        speed,
        inner_central,
        inner_minimum,
        outer_central,
        outer_minimum,
    ] in rows
    {
        let [inner, outer] = films.thickness([251.39, 251.39], speed);
        assert_printed("inner h_c µm", inner.central * 1e6, inner_central, 4);
        assert_printed("inner h_min µm", inner.minimum * 1e6, inner_minimum, 4);
        assert_printed("outer h_c µm", outer.central * 1e6, outer_central, 4);
        assert_printed("outer h_min µm", outer.minimum * 1e6, outer_minimum, 4);
    }
}
