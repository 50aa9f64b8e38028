//! Laws of one ball: published numbers, physics that must hold everywhere, hard cases.

mod balance;
mod derivatives;
mod lift_off;
mod limits;
mod published;
mod random;

use crate::bearing::{BallLaw, Bearing, Oil, catalogue};

/// The oil of the reference rows: η0 = 0.04 Pa s, α_p = 22 1/GPa.
const OIL: Oil = Oil {
    viscosity: 0.04,
    pressure_viscosity: 2.2e-8,
};

fn bearing_7205c() -> Bearing {
    catalogue::find("7205C").unwrap().bearing().unwrap()
}

/// Axial displacement in m at which all balls of a centred bearing together carry `thrust` in N.
fn displacement_under_thrust(
    law: &impl BallLaw,
    bearing: &Bearing,
    thrust: f64,
    speed: f64,
) -> f64 {
    let geometry = &bearing.geometry;
    let balls = geometry.balls() as f64;
    let mut z = 1e-3 * geometry.ball_diameter();
    for _ in 0..50 {
        let (force, tangent) =
            law.force_and_tangent(geometry.free_axial() + z, geometry.free_radial(), speed);
        let step = (thrust / balls - force.axial) / tangent[0][0];
        z += step;
        if step.abs() < 1e-16 {
            break;
        }
    }
    z
}
