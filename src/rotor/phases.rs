//! Where shaft and cages point at an instant.

use wide::f64x2;

use super::Rotation;
use crate::bearing::Angle;

/// Sines and cosines of the shaft and of its cages.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Phases {
    /// cos ψ and sin ψ of the shaft.
    pub shaft: Angle,
    /// cos ψ_c and sin ψ_c of a cage that turns by `ratio` of the shaft's angle.
    pub cage: Angle,
    /// ψ_c/ψ.
    pub ratio: f64,
}

impl Phases {
    /// Both at once: side by side they cost hardly more than one. Right to the last digit or two up
    /// to angles of 1e8 rad.
    #[inline(always)]
    pub fn new(rotation: &Rotation, ratio: f64) -> Self {
        let (sin, cos) = f64x2::new([rotation.angle, ratio * rotation.angle]).sin_cos();
        let (sin, cos) = (sin.to_array(), cos.to_array());
        let pointer = |index: usize| Angle {
            cos: cos[index],
            sin: sin[index],
        };
        Self {
            shaft: pointer(0),
            cage: pointer(1),
            ratio,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sines_side_by_side_are_those_of_the_library() {
        for step in 0..200_000 {
            let angle = f64::from(step) * f64::from(step) * 2.3e-3 - 1e3;
            let rotation = Rotation {
                angle,
                speed: 0.0,
                acceleration: 0.0,
            };
            let phases = Phases::new(&rotation, 0.4);
            for (found, angle) in [(phases.shaft, angle), (phases.cage, 0.4 * angle)] {
                assert!((found.sin - angle.sin()).abs() < 4e-16, "sin {angle}");
                assert!((found.cos - angle.cos()).abs() < 4e-16, "cos {angle}");
            }
        }
    }
}
