//! 7205C at speed: ball inertia, outer race control, and oil films.
//!
//! Source: independent implementations of the same equations (Jones–Harris ball equilibrium,
//! Hamrock–Dowson films as a force law), which agree to the digits printed. E = 207 GPa, ν = 0.3,
//! ρ = 7800 kg/m³, race constants at the nominal contact angle; F_z = 1000 N.

use crate::bearing::{BallContact, ContactLaw, MountedBearing, Oil, Support};
use crate::physics::RaceControl;
use crate::rotor::{Equilibrium, StaticProblem};

use crate::tests::support::{bearing, contacts, mounted};

const OUTER_CONTROL: ContactLaw = ContactLaw::Jones(RaceControl::Outer);
const OIL: Oil = Oil {
    viscosity: 0.04,
    pressure_viscosity: 2.2e-8,
};

/// Equilibrium under 1000 N of thrust, radial displacements and tilts held at zero, and ball 0.
fn under_thrust(law: ContactLaw, oil: Option<Oil>, speed: f64) -> (Equilibrium, BallContact) {
    let definition = MountedBearing {
        law,
        oil,
        ..mounted(bearing("7205C"))
    };
    let supports = [Support::new(&definition, speed).expect("a bearing that can be mounted")];
    let equilibrium = StaticProblem {
        supports: &supports,
        load: [0.0, 0.0, 1000.0, 0.0, 0.0],
        free: [false, false, true, false, false],
        start: [0.0; 5],
        speed,
    }
    .solve()
    .expect("an equilibrium");
    let balls = contacts(&supports[0], &equilibrium.displacement, speed);
    (equilibrium, balls[0])
}

/// Whether a value agrees with a printed one within half a unit of its last digit.
#[track_caller]
fn agrees(name: &str, value: f64, printed: f64, unit: f64) {
    let difference = (value - printed).abs();
    assert!(
        difference <= 0.5001 * unit,
        "{name}: {value}, printed {printed}"
    );
}

/// α_i, α_o in degrees, Q_i, Q_o in N, δz in µm, K_xx, K_zz in N/µm.
fn check_row(speed: f64, row: [f64; 7]) {
    let (equilibrium, ball) = under_thrust(OUTER_CONTROL, None, speed);
    agrees("α_i", ball.angle_inner.to_degrees(), row[0], 1e-5);
    agrees("α_o", ball.angle_outer.to_degrees(), row[1], 1e-5);
    agrees("Q_i", ball.load_inner, row[2], 1e-4);
    agrees("Q_o", ball.load_outer, row[3], 1e-4);
    agrees("δz", 1e6 * equilibrium.displacement[2], row[4], 1e-5);
    agrees("K_xx", 1e-6 * equilibrium.stiffness[(0, 0)], row[5], 1e-4);
    agrees("K_zz", 1e-6 * equilibrium.stiffness[(2, 2)], row[6], 1e-4);
}

#[test]
fn row_of_500_rad_per_second() {
    check_row(
        500.0,
        [
            19.45580, 19.28689, 250.1905, 251.6949, 31.94279, 213.3435, 59.1584,
        ],
    );
}

#[test]
fn row_of_1000_rad_per_second() {
    check_row(
        1000.0,
        [
            19.74569, 19.06724, 246.6608, 252.6792, 31.83103, 212.5985, 58.9186,
        ],
    );
}

#[test]
fn film_lowers_the_contact_angle_as_a_preload_does() {
    let (equilibrium, ball) = under_thrust(ContactLaw::Hertz, Some(OIL), 1000.0);
    agrees("δz", 1e6 * equilibrium.displacement[2], 26.893679, 1e-6);
    agrees("Q", ball.load_inner, 260.182616, 1e-6);
    agrees("α", ball.angle_inner.to_degrees(), 18.680334, 1e-6);
    agrees(
        "K_zz",
        1e-6 * equilibrium.stiffness[(2, 2)],
        55.652314,
        1e-6,
    );
}

#[test]
fn without_speed_inertia_changes_nothing() {
    let (hertz, _) = under_thrust(ContactLaw::Hertz, None, 0.0);
    let (jones, ball) = under_thrust(OUTER_CONTROL, None, 0.0);
    assert!((hertz.displacement[2] - jones.displacement[2]).abs() < 1e-15);
    assert!((hertz.stiffness - jones.stiffness).amax() < 1e-9 * hertz.stiffness.amax());
    assert!((ball.angle_inner - ball.angle_outer).abs() < 1e-12);
}

#[test]
fn a_hybrid_bearing_is_less_moved_by_speed() {
    let mut hybrid = bearing("7205C");
    hybrid.ball_material = crate::physics::Material {
        youngs_modulus: 310e9,
        poisson_ratio: 0.26,
        density: 3200.0,
    };
    let spread = |bearing| {
        let definition = MountedBearing {
            law: OUTER_CONTROL,
            ..mounted(bearing)
        };
        let supports = [Support::new(&definition, 2000.0).expect("a sound bearing")];
        let place = [0.0, 0.0, 32e-6, 0.0, 0.0];
        let balls = contacts(&supports[0], &place, 2000.0);
        balls[0].load_outer - balls[0].load_inner
    };
    let (steel, ceramic) = (spread(bearing("7205C")), spread(hybrid));
    // the difference of the loads is the centrifugal force, which goes with the density
    assert!(
        (ceramic / steel - 3200.0 / 7800.0).abs() < 0.02,
        "{ceramic} against {steel}"
    );
}
