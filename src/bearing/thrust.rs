//! Pure thrust on one bearing: the axial displacement that gives a preload.

use super::{BearingError, ForceLaw, Geometry};

/// Axial displacement in m of a bearing under a centred axial force in N at a shaft speed in rad/s, all balls alike:
/// Newton in a bracket.
///
/// `F_z = Z F_a(A sin α0 + z, A cos α0)`
///
/// Source: Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), eqs. 7.33–7.36.
///
/// # Errors
/// [`BearingError::Preload`] where no displacement up to the distance of the groove centres
/// gives the force.
pub(super) fn thrust_displacement(
    geometry: &Geometry,
    law: &impl ForceLaw,
    force: f64,
    speed: f64,
) -> Result<f64, BearingError> {
    let unreachable = BearingError::Preload { preload: force };
    let (free_axial, distance) = (geometry.free_axial(), geometry.groove_centre_distance());
    let (mut low, mut high) = (-free_axial, distance);
    let balls = geometry.balls() as f64;
    let excess = |z: f64| {
        let (ball, tangent) = law.force_and_tangent(free_axial + z, geometry.free_radial(), speed);
        (balls * ball.axial - force, balls * tangent[0][0])
    };
    if !(force >= 0.0 && excess(high).0 >= 0.0) {
        return Err(unreachable);
    }
    let mut z = 0.1 * high;
    for _ in 0..200 {
        let (residual, slope) = excess(z);
        if residual > 0.0 {
            high = z;
        } else {
            low = z;
        }
        let newton = z - residual / slope;
        let next = if newton > low && newton < high {
            newton
        } else {
            0.5 * (low + high)
        };
        if (next - z).abs() <= f64::EPSILON * distance {
            return Ok(next);
        }
        z = next;
    }
    Err(unreachable)
}
