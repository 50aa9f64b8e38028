//! A bearing of constant stiffness and damping, as books and other programs have it.

use nalgebra::SVector;

use super::FREEDOMS;
use super::point::{Attachment, about_origin};
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
    /// The housing that it stands in; without one it stands on the ground.
    pub housing: Option<Housing>,
}

/// A linear bearing between its points: `F = K u + C u̇` with u the displacement of the inner point from the outer one.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct AttachedLinear {
    /// As [`LinearBearing::place`].
    pub place: usize,
    pub attachment: Attachment,
    /// K by the motion of the points, arm included.
    pub stiffness: Matrix5,
    /// C likewise.
    pub damping: Matrix5,
    /// Distance of the inner point from the observed one along the shaft, m.
    arm: f64,
}

impl LinearBearing {
    /// Between points of which the inner one is `from_point` in m before it along the shaft, and itself `arm` behind the
    /// observed point.
    pub(super) fn attached(
        &self,
        attachment: Attachment,
        from_point: f64,
        arm: f64,
    ) -> AttachedLinear {
        // x + a θy, y − a θx
        let mut transform = Matrix5::identity();
        transform[(0, 4)] = from_point;
        transform[(1, 3)] = -from_point;
        let at_point = |values: Vector5, [xy, yx]: [f64; 2]| {
            let mut own = Matrix5::from_diagonal(&SVector::<f64, FREEDOMS>::from(values));
            (own[(0, 1)], own[(1, 0)]) = (xy, yx);
            transform.transpose() * own * transform
        };
        AttachedLinear {
            place: self.place,
            attachment,
            stiffness: at_point(self.stiffness, self.cross_stiffness),
            damping: at_point(self.damping, self.cross_damping),
            arm,
        }
    }
}

impl AttachedLinear {
    /// Force of the shaft onto it, moments about the observed point.
    pub fn force(&self, place: &[f64], rest: &[f64], velocity: &[f64]) -> Vector5 {
        let displacement = SVector::from(self.attachment.displacement(place, rest));
        let rate = SVector::from(self.attachment.rate(velocity));
        let force = self.stiffness * displacement + self.damping * rate;
        about_origin(&force.into(), self.arm)
    }
}
