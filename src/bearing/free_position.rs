//! Where the races of a ball bearing stand without load.

use super::{Geometry, GeometryError};

/// How the free position of the races is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FreePosition {
    /// Free contact angle α0 in rad (angular contact bearing).
    ContactAngle(f64),
    /// Diametral clearance P_d in m (deep-groove bearing): α0 = acos(1 − P_d/(2A)) at either end of the axial play. A
    /// negative one squeezes the balls between the races: α0 = 0, and the groove centres are A − P_d/2 apart.
    DiametralClearance(f64),
    /// Radial clearance in m of a literature model that knows no contact angle: the races are
    /// as with `DiametralClearance` of twice the value, the balls roll as at 0°.
    RadialClearance(f64),
}

/// Free contact angle α0 = acos(1 − P_d/(2A)) in rad, in the form that keeps its digits for small clearances, and the
/// squeeze of the balls in m under a negative clearance.
pub(super) fn position_of_clearance(
    clearance: f64,
    distance: f64,
) -> Result<[f64; 2], GeometryError> {
    // 1 − cos α0 = 2 sin²(α0/2)
    let largest = 4.0 * distance * (0.5 * Geometry::LARGEST_CONTACT_ANGLE).sin().powi(2);
    let smallest = -2.0 * distance * Geometry::LARGEST_SQUEEZE;
    if !(smallest..=largest).contains(&clearance) {
        return Err(GeometryError::Clearance {
            clearance,
            smallest,
            largest,
        });
    }
    let angle = 2.0 * (clearance.max(0.0) / (4.0 * distance)).sqrt().asin();
    Ok([angle, 0.5 * (-clearance).max(0.0)])
}
