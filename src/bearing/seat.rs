//! How the outer ring of a mounted bearing is held axially.

use super::law::{Law, with_law};
use super::{BearingError, ForceLaw, Geometry, Matrix5, MountedBearing, Preload, Vector5};

/// Component z.
const AXIAL: usize = 2;

/// Axial seat of the outer ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Seat {
    /// Fixed, with the inner ring preset by this much in m.
    Fixed { offset: f64 },
    /// Floating, pressed by a soft spring: the axial force is `force` in N wherever the shaft is.
    Spring { force: f64, start: f64, reach: f64 },
}

impl Seat {
    /// The seat that gives the preload of a bearing, at standstill.
    pub fn new(definition: &MountedBearing, law: &Law) -> Result<Self, BearingError> {
        let geometry = &definition.bearing.geometry;
        let displacement = |force| with_law!(law, law => thrust_displacement(geometry, law, force));
        Ok(match definition.preload {
            Preload::AxialOffset(offset) => Self::Fixed { offset },
            Preload::Force(force) => Self::Fixed {
                offset: displacement(force)?,
            },
            Preload::Spring(force) => Self::Spring {
                force,
                start: displacement(force)?,
                reach: 0.25 * geometry.length_scale(),
            },
        })
    }

    /// Axial preset of the inner ring when the shaft is in its place, m.
    pub fn offset(&self) -> f64 {
        match *self {
            Self::Fixed { offset } => offset,
            Self::Spring { start, .. } => start,
        }
    }

    /// Displacement of the inner ring from the outer one; `shaft` is the imposed displacement, `tangent` the force of
    /// the ring and its stiffness at a displacement.
    pub fn settle(
        &self,
        shaft: &Vector5,
        tangent: impl Fn(&Vector5) -> (Vector5, Matrix5),
    ) -> Vector5 {
        // number by number: what was just written in parts is then not read as a whole
        let [x, y, z, tilt_x, tilt_y] = *shaft;
        match *self {
            Self::Fixed { offset } => [x, y, z + offset, tilt_x, tilt_y],
            Self::Spring {
                force,
                start,
                reach,
            } => {
                let mut place = [x, y, start, tilt_x, tilt_y];
                press(tangent, &mut place, force, reach);
                place
            }
        }
    }

    /// Derivative of the inner ring's displacement by the imposed displacement, seen from the cage;
    /// none where it is the identity. `stiffness` is that of the ring in its place.
    pub fn follows(&self, stiffness: impl FnOnce() -> Matrix5) -> Option<Matrix5> {
        if matches!(self, Self::Fixed { .. }) {
            return None;
        }
        let stiffness = stiffness();
        // the axial force stays: K_z q̇ = 0, so ż = −(K_zx ẋ + K_zy ẏ + …)/K_zz
        let mut follows = Matrix5::identity();
        let by_shaft = -stiffness.row(AXIAL) / stiffness[(AXIAL, AXIAL)];
        follows.set_row(AXIAL, &by_shaft);
        follows[(AXIAL, AXIAL)] = 0.0;
        Some(follows)
    }

    /// Energy in J of the spring with the inner ring at `place` under the imposed displacement.
    pub fn stored_energy(&self, shaft: &Vector5, place: &Vector5) -> f64 {
        match *self {
            Self::Fixed { .. } => 0.0,
            // the outer ring gives way by z_shaft − z
            Self::Spring { force, .. } => force * (shaft[AXIAL] - place[AXIAL]),
        }
    }

    /// Derivative of the force by the imposed displacement: a floating ring follows without resistance.
    pub fn condense(&self, stiffness: Matrix5) -> Matrix5 {
        match self {
            Self::Fixed { .. } => stiffness,
            Self::Spring { .. } => {
                // K − K_·z K_z·/K_zz
                let axial = stiffness[(AXIAL, AXIAL)];
                stiffness - stiffness.column(AXIAL) * stiffness.row(AXIAL) / axial
            }
        }
    }
}

/// Newton steps of a floating ring.
const STEP_LIMIT: usize = 60;

/// Moves `place` axially to where the ring carries `force`: Newton's method `z ← z + (F − F_z(z))/K_zz`, its step at most
/// `reach`.
fn press(
    tangent: impl Fn(&Vector5) -> (Vector5, Matrix5),
    place: &mut Vector5,
    force: f64,
    reach: f64,
) {
    for _ in 0..STEP_LIMIT {
        let (carried, stiffness) = tangent(place);
        // Δz = (F − F_z)/K_zz
        let step = ((force - carried[AXIAL]) / stiffness[(AXIAL, AXIAL)]).clamp(-reach, reach);
        // nothing bears and nothing resists: press on
        let next = place[AXIAL] + if step.is_nan() { reach } else { step };
        if (next - place[AXIAL]).abs() <= f64::EPSILON * reach {
            break;
        }
        place[AXIAL] = next;
    }
}

/// Axial displacement in m of a bearing at rest under a centred axial force in N, all balls alike: Newton in a bracket.
///
/// `F_z = Z F_a(A sin α0 + z, A cos α0)`
///
/// Source: Harris & Kotzalas, *Rolling Bearing Analysis*, 5th ed. (2007), eqs. 7.33–7.36.
///
/// # Errors
/// [`BearingError::Preload`] where no displacement up to the distance of the groove centres
/// gives the force.
fn thrust_displacement(
    geometry: &Geometry,
    law: &impl ForceLaw,
    force: f64,
) -> Result<f64, BearingError> {
    let unreachable = BearingError::Preload { preload: force };
    let (free_axial, distance) = (geometry.free_axial(), geometry.length_scale());
    let (mut low, mut high) = (-free_axial, distance);
    let balls = geometry.balls() as f64;
    // Z F_a − F and its slope
    let excess = |z: f64| {
        let (ball, tangent) = law.force_and_tangent(free_axial + z, geometry.free_radial(), 0.0);
        (balls * ball.axial - force, balls * tangent[0][0])
    };
    if !(force >= 0.0 && excess(high).0 >= 0.0) {
        return Err(unreachable);
    }
    let mut z = 0.1 * high;
    for _ in 0..200 {
        // the force rises with z: narrow the bracket
        let (residual, slope) = excess(z);
        if residual > 0.0 {
            high = z;
        } else {
            low = z;
        }
        // Newton's step where it stays inside, else the middle
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
