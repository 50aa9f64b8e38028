//! Springs and dampers of constant coefficients, as books and other programs have bearings.

use nalgebra::SVector;

use crate::bearing::{Matrix5, Vector5};

/// Springs and dampers, `F = K u + C u̇`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LinearLaw {
    /// K: along x, y, z in N/m and about X and Y in N m/rad.
    pub stiffness: Matrix5,
    /// C: along x, y, z in N s/m and about X and Y in N m s/rad.
    pub damping: Matrix5,
}

impl LinearLaw {
    /// Of values along x, y, z and about X and Y, and of those across: xy, the force along X by a motion along Y, and yx.
    pub fn new(stiffness: (Vector5, [f64; 2]), damping: (Vector5, [f64; 2])) -> Self {
        let [stiffness, damping] = [stiffness, damping].map(|(along, [xy, yx])| {
            let mut own = Matrix5::from_diagonal(&along.into());
            (own[(0, 1)], own[(1, 0)]) = (xy, yx);
            own
        });
        Self { stiffness, damping }
    }

    /// Force of the shaft onto it at a displacement and its rate.
    pub(super) fn force(&self, displacement: &Vector5, rate: &Vector5) -> Vector5 {
        let [displacement, rate] = [displacement, rate].map(|own| SVector::from(*own));
        (self.stiffness * displacement + self.damping * rate).into()
    }

    /// Whether its stiffness is not symmetric, as that of a film.
    pub(super) fn crosses(&self) -> bool {
        self.stiffness != self.stiffness.transpose()
    }
}
