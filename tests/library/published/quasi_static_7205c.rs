//! 7205C at rest: numbers of separate implementations of the same equations (Jones 1960, Harris &
//! Kotzalas), which agree to the digits shown. E = 207 GPa, ν = 0.3, curvature at the nominal
//! contact angle. Tolerances are half a unit of the last digit shown.

use crate::bearing::{Bearing, BearingError, MountedBearing};

use crate::tests::support::{
    MICROMETRE, assert_near, assert_printed, bearing, equilibrium, half_last_digit, mounted,
    supports,
};

/// N/m^1.5 in N/mm^1.5.
const PER_MILLIMETRE: f64 = 31_622.776_601_683_795;

const THRUST_ALONE: [bool; 5] = [false, false, true, false, false];

#[test]
fn contact_constants() -> Result<(), BearingError> {
    let bearing: Bearing = bearing("7205C");
    let (inner, outer) = (bearing.inner_contact()?, bearing.outer_contact()?);
    assert_printed("κ_i", inner.ellipticity(), "9.311379");
    assert_printed("κ_o", outer.ellipticity(), "5.735153");
    assert_printed("K_i", inner.stiffness() / PER_MILLIMETRE, "805214.87");
    assert_printed("K_o", outer.stiffness() / PER_MILLIMETRE, "744380.04");
    let series = bearing.load_deflection_constant()?;
    assert_printed("K_n", series / PER_MILLIMETRE, "273580.37");
    let geometry = &bearing.geometry;
    assert_printed("A", geometry.groove_centre_distance() * 1e3, "0.396900");
    assert_printed("R_i", geometry.inner_groove_radius() * 1e3, "19.403350");
    Ok(())
}

/// F_z N, α deg, δz µm, K_zz N/µm, K_xx N/µm, K_θxθx N m/rad, K_xθy N/rad.
const PURE_THRUST: [[&str; 7]; 2] = [
    [
        "200",
        "16.78823",
        "12.93681",
        "26.0396",
        "134.4104",
        "4901.82",
        "-7.81760e5",
    ],
    [
        "1000",
        "19.35927",
        "31.97643",
        "59.2163",
        "213.4804",
        "11147.2",
        "-1.430096e6",
    ],
];

#[test]
fn pure_thrust_displacement_angle_and_stiffness() {
    for [thrust, angle, z, k_zz, k_xx, k_tilt, k_cross] in PURE_THRUST {
        let thrust: f64 = thrust.parse().expect("a number");
        let bearings = [mounted(bearing("7205C"))];
        let load = [0.0, 0.0, thrust, 0.0, 0.0];
        let found = equilibrium(&bearings, load, THRUST_ALONE).expect("thrust is carried");
        let k = found.stiffness;
        assert_printed("δz", found.displacement[2] / MICROMETRE, z);
        assert_printed("K_zz", k[(2, 2)] * MICROMETRE, k_zz);
        assert_printed("K_xx", k[(0, 0)] * MICROMETRE, k_xx);
        assert_printed("K_yy", k[(1, 1)] * MICROMETRE, k_xx);
        assert_printed("K_θxθx", k[(3, 3)], k_tilt);
        assert_printed("K_θyθy", k[(4, 4)], k_tilt);
        // a unit, not half of one: the closed form gives −7.817594e5 at 200 N, shown as …60
        let expected = k_cross.parse().expect("a number");
        let tolerance = 2.0 * half_last_digit(k_cross);
        assert_near("K_xθy", k[(0, 4)], expected, tolerance);
        for ball in contacts(&bearings, &found.displacement) {
            assert_printed("α", ball.1, angle);
            let load = thrust / 12.0 / ball.1.to_radians().sin();
            assert_near("Q", ball.0, load, 1e-9 * load);
        }
        // symmetry of the ring of equal balls, to round-off of the largest entries
        let arm = bearings[0].bearing.geometry.inner_groove_radius();
        let largest = k[(0, 0)];
        assert_near("K_yθx", k[(1, 3)], -k[(0, 4)], 1e-12 * largest * arm);
        for row in 0..5 {
            for column in 0..5 {
                let (low, high) = (row.min(column), row.max(column));
                if low == high || matches!((low, high), (0, 4) | (1, 3)) {
                    continue;
                }
                let lever = |axis: usize| if axis < 3 { 1.0 } else { arm };
                let unit = largest * lever(row) * lever(column);
                assert_near("zero by symmetry", k[(row, column)], 0.0, 1e-13 * unit);
            }
        }
    }
}

/// Loads in N and contact angles in degrees of all balls.
fn contacts(bearings: &[MountedBearing], displacement: &[f64; 5]) -> Vec<(f64, f64)> {
    crate::tests::support::contacts(&supports(bearings)[0], displacement, 0.0)
        .iter()
        .map(|ball| (ball.load_inner, ball.angle_inner.to_degrees()))
        .collect()
}

/// F_z = 1000 N, F_y = 300 N, first ball at φ = 90°: δz µm, δy µm, θx µrad, Q max, Q min in N,
/// α min, α max in degrees.
fn check_combined(free: [bool; 5], row: [&str; 7]) {
    let bearings = [MountedBearing {
        first_ball: std::f64::consts::FRAC_PI_2,
        ..mounted(bearing("7205C"))
    }];
    let load = [0.0, 300.0, 1000.0, 0.0, 0.0];
    let found = equilibrium(&bearings, load, free).expect("the load is carried");
    let balls = contacts(&bearings, &found.displacement);
    let largest = |of: fn(&(f64, f64)) -> f64| balls.iter().map(of).fold(f64::MIN, f64::max);
    let smallest = |of: fn(&(f64, f64)) -> f64| balls.iter().map(of).fold(f64::MAX, f64::min);
    let [z, y, tilt, q_max, q_min, angle_min, angle_max] = row;
    assert_printed("δz", found.displacement[2] / MICROMETRE, z);
    assert_printed("δy", found.displacement[1] / MICROMETRE, y);
    assert_printed("θx", found.displacement[3] * 1e6, tilt);
    assert_printed("Q max", largest(|ball| ball.0), q_max);
    assert_printed("Q min", smallest(|ball| ball.0), q_min);
    assert_printed("α min", smallest(|ball| ball.1), angle_min);
    assert_printed("α max", largest(|ball| ball.1), angle_max);
}

#[test]
fn combined_load_with_tilts_held() {
    check_combined(
        [true, true, true, false, false],
        [
            "31.91915", "1.407417", "0", "305.3900", "199.6266", "19.2861", "19.4176",
        ],
    );
}

#[test]
fn combined_load_with_tilts_free() {
    check_combined(
        [true; 5],
        [
            "31.16328",
            "9.434734",
            "-1209.806",
            "321.4015",
            "224.4053",
            "15.7000",
            "22.8224",
        ],
    );
}
