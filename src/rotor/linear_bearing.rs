//! A bearing of constant stiffness and damping, as books and other programs have it.

use nalgebra::DMatrix;

use super::FREEDOMS;
use super::point::{Attachment, Point};
use crate::bearing::{Matrix5, Vector5};

/// Springs and dampers between a place of the shaft and the ground.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LinearBearing {
    /// Position along the shaft, m.
    pub position: f64,
    /// Along x, y, z in N/m and about X and Y in N m/rad.
    pub stiffness: Vector5,
    /// Along x, y, z in N s/m and about X and Y in N m s/rad.
    pub damping: Vector5,
}

impl LinearBearing {
    /// Adds it to the matrices of a structure, `arm` in m behind a point of it along the shaft.
    pub(super) fn add(
        &self,
        point: Point,
        arm: f64,
        stiffness: &mut DMatrix<f64>,
        damping: &mut DMatrix<f64>,
    ) {
        let attachment = Attachment {
            inner: point,
            outer: None,
        };
        // x + a θy, y − a θx
        let mut transform = Matrix5::identity();
        transform[(0, 4)] = arm;
        transform[(1, 3)] = -arm;
        for (values, sum) in [(self.stiffness, stiffness), (self.damping, damping)] {
            let own = Matrix5::from_diagonal(&nalgebra::SVector::<f64, FREEDOMS>::from(values));
            attachment.add_stiffness(&(transform.transpose() * own * transform), sum);
        }
    }
}
