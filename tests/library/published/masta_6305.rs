//! A commercial program's results for a 6305 (MASTA, as printed in the public repository
//! minzhun/ISO16281): Z = 7, D = 11.5 mm, d_m = 43.5 mm, f_i = 0.52, f_o = 0.53, E = 210 GPa,
//! ν = 0.3, first ball on the load line, diametral clearance 0.

use crate::bearing::{Bearing, Vector5};
use crate::physics::Material;

use crate::tests::support::{assert_near, assert_printed, equilibrium, mounted, without_clearance};

/// Displacement under a load, all freedoms free.
fn displacement(load: Vector5) -> Vector5 {
    let steel = Material {
        youngs_modulus: 210e9,
        ..Material::BEARING_STEEL
    };
    let bearing = Bearing {
        ring_material: steel,
        ball_material: steel,
        ..without_clearance("6305")
    };
    equilibrium(&[mounted(bearing)], load, [true; 5])
        .expect("the load is carried")
        .displacement
}

/// The program's contact constants are its own: 1e-5 of the displacement, one or two units of the
/// last digit printed.
const OTHER_CONSTANTS: f64 = 1e-5;

#[test]
fn radial_displacement_under_1000_newton() {
    let [x, ..] = displacement([1000.0, 0.0, 0.0, 0.0, 0.0]);
    assert_near("δr, µm", x * 1e6, 15.1101, OTHER_CONSTANTS * 15.1101);
}

#[test]
fn axial_displacement_under_1000_newton() {
    let [_, _, z, ..] = displacement([0.0, 0.0, 1000.0, 0.0, 0.0]);
    assert_near("δa, µm", z * 1e6, 133.5381, OTHER_CONSTANTS * 133.5381);
}

/// The program prints 3.6957 mrad; it takes d_m/2 as the arm of tilt and moment. With the radius
/// of the circle of inner groove centres as the arm the same case gives 3.6468 mrad.
#[test]
fn tilt_under_1000_newton_millimetre() {
    let [_, _, _, tilt_x, tilt_y] = displacement([0.0, 0.0, 0.0, 0.0, 1.0]);
    assert_printed("tilt, mrad", tilt_x.hypot(tilt_y) * 1e3, "3.6468");
}
