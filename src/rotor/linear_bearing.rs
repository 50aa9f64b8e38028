//! A bearing of constant stiffness and damping, as books and other programs have it.

use nalgebra::SVector;

use super::FREEDOMS;
use crate::bearing::{Housing, Matrix5, Vector5};

/// Springs and dampers between a place of the shaft and a housing or the ground.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LinearBearing {
    /// Its place among all bearings of the shaft, from 0.
    pub place: usize,
    /// Position along the shaft, m.
    pub position: f64,
    /// Along x, y, z in N/m and about X and Y in N m/rad.
    pub stiffness: Vector5,
    /// Along x, y, z in N s/m and about X and Y in N m s/rad.
    pub damping: Vector5,
    /// k_xy and k_yx in N/m: the force along the first axis by a displacement along the second.
    pub cross_stiffness: [f64; 2],
    /// c_xy and c_yx in N s/m likewise.
    pub cross_damping: [f64; 2],
    /// The housing that it sits in; without one it sits on the ground.
    pub housing: Option<Housing>,
}

/// A linear bearing as an element, `F = K u + C u̇`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct LinearElement {
    pub stiffness: Matrix5,
    pub damping: Matrix5,
}

impl LinearBearing {
    /// Its coefficients as matrices.
    pub(super) fn element(&self) -> LinearElement {
        let matrix = |values: Vector5, [xy, yx]: [f64; 2]| {
            let mut own = Matrix5::from_diagonal(&SVector::<f64, FREEDOMS>::from(values));
            (own[(0, 1)], own[(1, 0)]) = (xy, yx);
            own
        };
        LinearElement {
            stiffness: matrix(self.stiffness, self.cross_stiffness),
            damping: matrix(self.damping, self.cross_damping),
        }
    }
}

impl LinearElement {
    /// Force of the shaft onto it at a displacement and its rate.
    pub fn force(&self, displacement: &Vector5, rate: &Vector5) -> Vector5 {
        let [displacement, rate] = [displacement, rate].map(|own| SVector::from(*own));
        (self.stiffness * displacement + self.damping * rate).into()
    }

    /// Whether its stiffness is not symmetric, as that of a film.
    pub fn crosses(&self) -> bool {
        self.stiffness != self.stiffness.transpose()
    }
}
