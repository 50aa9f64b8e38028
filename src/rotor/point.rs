//! Points on the axes of shaft and housings, and the rings of bearings between them.

use nalgebra::{Complex, DMatrix};

use crate::bearing::{Matrix5, Vector5};

/// A point that moves by x, y, z in m and θx, θy in rad, each of them a coordinate of the structure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Point {
    /// Their indices; one beyond all coordinates of a component that does not move at all.
    pub coordinates: [usize; 5],
}

impl Point {
    /// The centre of mass of a rigid shaft.
    pub const RIGID_SHAFT: Self = Self {
        coordinates: [0, 1, 2, 3, 4],
    };
    /// The same of one whose z is held while its tilts move: what is held comes last.
    pub const WITHOUT_Z: Self = Self {
        coordinates: [0, 1, 4, 2, 3],
    };

    /// Which of the five components a coordinate is.
    pub fn axis_of(&self, coordinate: usize) -> Option<usize> {
        self.coordinates.iter().position(|own| *own == coordinate)
    }

    /// Displacement with the degrees of freedom at `dofs` and what is held at `rest`, the place of all coordinates.
    #[inline(always)]
    pub fn displacement(&self, dofs: &[f64], rest: &[f64]) -> Vector5 {
        self.coordinates.map(|index| match dofs.get(index) {
            Some(place) => *place,
            None => rest.get(index).copied().unwrap_or(0.0),
        })
    }

    /// Velocity, or another rate, from that of the degrees of freedom.
    #[inline(always)]
    pub fn rate(&self, rates: &[f64]) -> Vector5 {
        self.displacement(rates, &[])
    }

    /// Adds `factor` times a force and moments at the point to those on the degrees of freedom.
    #[inline(always)]
    pub fn add_force(&self, factor: f64, force: &Vector5, sum: &mut [f64]) {
        for (index, part) in self.coordinates.iter().zip(force) {
            if let Some(sum) = sum.get_mut(*index) {
                *sum += factor * part;
            }
        }
    }

    /// Adds the complex amplitudes of a force and moments at the point to those on the degrees of freedom.
    pub fn add_phasor(&self, force: &[Complex<f64>; 5], sum: &mut [Complex<f64>]) {
        for (index, part) in self.coordinates.iter().zip(force) {
            if let Some(sum) = sum.get_mut(*index) {
                *sum += part;
            }
        }
    }
}

/// A force and moments at a distance along the axis, about the origin of that distance: M_x − a P_y, M_y + a P_x.
#[inline(always)]
pub(super) fn about_origin(force: &Vector5, arm: f64) -> Vector5 {
    let [x, y, z, tilt_x, tilt_y] = *force;
    [x, y, z, tilt_x - arm * y, tilt_y + arm * x]
}

/// A place on the axis of the shaft that a point of it carries along.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    pub point: Point,
    /// Distance from the point, m.
    pub arm: f64,
}

impl Place {
    /// Adds a force and moments there to those on the degrees of freedom.
    #[inline(always)]
    pub fn add_force(&self, force: &Vector5, sum: &mut [f64]) {
        self.point
            .add_force(1.0, &about_origin(force, self.arm), sum);
    }
}

/// Where the rings of a bearing sit: the inner one at a point of the shaft, the outer one at a point of a housing, both
/// seen from the same origin on the axis, or fixed to the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Attachment {
    pub inner: Point,
    pub outer: Option<Point>,
}

impl Attachment {
    /// A bearing of a rigid shaft that stands on the ground.
    pub const GROUNDED: Self = Self {
        inner: Point::RIGID_SHAFT,
        outer: None,
    };

    /// Displacement of the inner ring's point from the outer one's, as by [`Point::displacement`].
    #[inline(always)]
    pub fn displacement(&self, dofs: &[f64], rest: &[f64]) -> Vector5 {
        let inner = self.inner.displacement(dofs, rest);
        match &self.outer {
            None => inner,
            Some(outer) => {
                let outer = outer.displacement(dofs, rest);
                std::array::from_fn(|axis| inner[axis] - outer[axis])
            }
        }
    }

    /// Rate of that displacement.
    #[inline(always)]
    pub fn rate(&self, rates: &[f64]) -> Vector5 {
        self.displacement(rates, &[])
    }

    /// Adds `factor` times a force that acts on the inner ring, and back on the outer one.
    #[inline(always)]
    pub fn add_force(&self, factor: f64, force: &Vector5, sum: &mut [f64]) {
        self.inner.add_force(factor, force, sum);
        if let Some(outer) = &self.outer {
            outer.add_force(-factor, force, sum);
        }
    }

    /// Adds Bᵀ K B of a bearing's own K, with B q the displacement of its rings.
    pub fn add_stiffness(&self, stiffness: &Matrix5, sum: &mut DMatrix<f64>) {
        for (row, row_sign, row_index) in self.entries() {
            for (column, column_sign, column_index) in self.entries() {
                if row_index < sum.nrows() && column_index < sum.ncols() {
                    sum[(row_index, column_index)] +=
                        row_sign * column_sign * stiffness[(row, column)];
                }
            }
        }
    }

    /// Largest displacement of the rings with every degree of freedom within an amplitude.
    pub fn reach(&self, amplitudes: &[f64]) -> Vector5 {
        let mut reach = [0.0; 5];
        for (axis, _, index) in self.entries() {
            reach[axis] += amplitudes.get(index).copied().unwrap_or(0.0);
        }
        reach
    }

    /// Entries of B: component, sign and coordinate.
    fn entries(&self) -> impl Iterator<Item = (usize, f64, usize)> {
        let points = [(1.0, Some(self.inner)), (-1.0, self.outer)];
        points.into_iter().flat_map(|(sign, point)| {
            let coordinates = point.into_iter().flat_map(|point| point.coordinates);
            coordinates
                .enumerate()
                .map(move |(axis, index)| (axis, sign, index))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_force_off_its_point_is_a_moment_as_well() {
        let place = Place {
            point: Point::RIGID_SHAFT,
            arm: 0.5,
        };
        let mut sum = [1.0; 5];
        place.add_force(&[3.0, -2.0, 4.0, 0.1, 0.2], &mut sum);
        assert_eq!(sum, [4.0, -1.0, 5.0, 2.1, 2.7]);
    }
}
