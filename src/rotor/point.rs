//! Points on the axes of shaft and housings, and what sits between two of them.

use nalgebra::{Complex, DMatrix};

use crate::bearing::{Facing, Matrix5, Vector5};

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
    /// The centre of mass of a rigid shaft whose z is held while its tilts move: what is held comes last.
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

/// A place on the axis that a point of it carries along: x + a θy, y − a θx, z, θx, θy at a distance a from the point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place {
    pub point: Point,
    /// Distance a from the point along Z, m.
    pub arm: f64,
}

impl Place {
    /// Displacement as by [`Point::displacement`].
    #[inline(always)]
    pub fn displacement(&self, dofs: &[f64], rest: &[f64]) -> Vector5 {
        carried(&self.point.displacement(dofs, rest), self.arm)
    }

    /// Adds `factor` times a force and moments there to those on the degrees of freedom.
    #[inline(always)]
    pub fn add_force(&self, factor: f64, force: &Vector5, sum: &mut [f64]) {
        self.point
            .add_force(factor, &about_origin(force, self.arm), sum);
    }

    /// Adds `factor` times a stiffness of forces here by displacements of another place to that of forces on coordinates by
    /// coordinates.
    fn add_stiffness(&self, factor: f64, stiffness: &Matrix5, by: &Self, sum: &mut DMatrix<f64>) {
        let mut carried = *stiffness;
        // displacements there by those of its point: θy moves along x, θx along −y
        for row in 0..5 {
            carried[(row, 3)] -= by.arm * stiffness[(row, 1)];
            carried[(row, 4)] += by.arm * stiffness[(row, 0)];
        }
        // forces here about the point
        for column in 0..5 {
            carried[(3, column)] -= self.arm * carried[(1, column)];
            carried[(4, column)] += self.arm * carried[(0, column)];
        }
        for (row, own) in self.point.coordinates.iter().enumerate() {
            for (column, other) in by.point.coordinates.iter().enumerate() {
                if let Some(sum) = sum.get_mut((*own, *other)) {
                    *sum += factor * carried[(row, column)];
                }
            }
        }
    }
}

/// Displacement at a distance along Z from a point that moves so.
#[inline(always)]
fn carried([x, y, z, tilt_x, tilt_y]: &Vector5, arm: f64) -> Vector5 {
    [x + tilt_y * arm, y - tilt_x * arm, *z, *tilt_x, *tilt_y]
}

/// A force and moments at a distance along Z, about the origin of that distance: M_x − a P_y, M_y + a P_x.
#[inline(always)]
fn about_origin([x, y, z, tilt_x, tilt_y]: &Vector5, arm: f64) -> Vector5 {
    [*x, *y, *z, tilt_x - arm * y, tilt_y + arm * x]
}

/// Where an element sits between a place of the shaft and one of a housing or the ground, and how it is turned: the map B
/// from the coordinates to the displacement of its inner place from its outer one, in its own orientation.
///
/// ```text
/// u = B q = S (u_inner − u_outer),   S = diag(1, 1, s, s, s)        forces on the coordinates: Bᵀ F
/// ```
///
/// with s = 1 of an element that looks towards +Z and −1 of one that looks towards −Z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Attachment {
    pub(super) inner: Place,
    /// On the ground where there is none.
    pub(super) outer: Option<Place>,
    /// s.
    facing: f64,
    /// Distance of the inner place from the observed point along the shaft, m.
    position: f64,
    /// Whether the inner place is one of the shaft, and not of a housing.
    pub(super) on_shaft: bool,
}

impl Attachment {
    /// Between a place of the shaft, so far from its observed point in m, and one of a housing or the ground.
    pub(super) fn new(inner: Place, outer: Option<Place>, facing: Facing, position: f64) -> Self {
        Self {
            inner,
            outer,
            facing: facing.sign(),
            position,
            on_shaft: true,
        }
    }

    /// Between a housing and the ground.
    pub(super) fn beside_shaft(housing: Place) -> Self {
        Self {
            on_shaft: false,
            ..Self::new(housing, None, Facing::PlusZ, 0.0)
        }
    }

    /// Of an element at a position in m from the centre of mass of a rigid shaft, whose displacement x, y, z, θx, θy are the
    /// coordinates.
    pub(crate) fn on_rigid_shaft(position: f64, facing: Facing) -> Self {
        let inner = Place {
            point: Point::RIGID_SHAFT,
            arm: position,
        };
        Self::new(inner, None, facing, position)
    }

    /// Displacement u with the degrees of freedom at `dofs` and what is held at `rest`.
    #[inline(always)]
    pub(crate) fn displacement(&self, dofs: &[f64], rest: &[f64]) -> Vector5 {
        let mut displacement = self.inner.displacement(dofs, rest);
        if let Some(outer) = &self.outer {
            let outer = outer.displacement(dofs, rest);
            displacement = std::array::from_fn(|axis| displacement[axis] - outer[axis]);
        }
        self.turned(&displacement)
    }

    /// Rate of that displacement.
    #[inline(always)]
    pub(super) fn rate(&self, rates: &[f64]) -> Vector5 {
        self.displacement(rates, &[])
    }

    /// Displacement u of an element between a rigid shaft whose centre of mass moves so, and the ground.
    #[inline(always)]
    pub(super) fn displacement_by_shaft(&self, shaft: &Vector5) -> Vector5 {
        self.turned(&carried(shaft, self.position))
    }

    /// Adds `factor` times a force that acts on the inner place, and back on the outer one.
    #[inline(always)]
    pub(crate) fn add_force(&self, factor: f64, force: &Vector5, sum: &mut [f64]) {
        let force = self.turned(force);
        self.inner.add_force(factor, &force, sum);
        if let Some(outer) = &self.outer {
            outer.add_force(-factor, &force, sum);
        }
    }

    /// A force on the inner place as one on the shaft, moments about its observed point.
    #[inline(always)]
    pub(super) fn about_observed(&self, force: &Vector5) -> Vector5 {
        about_origin(&self.turned(force), self.position)
    }

    /// A force on the inner place as one on the shaft, moments about the point that carries the inner place.
    pub(super) fn at_inner_point(&self, force: &Vector5) -> Vector5 {
        about_origin(&self.turned(force), self.inner.arm)
    }

    /// From the element's own orientation to that of the shaft, or back.
    #[inline(always)]
    fn turned(&self, [x, y, z, tilt_x, tilt_y]: &Vector5) -> Vector5 {
        let s = self.facing;
        [*x, *y, s * z, s * tilt_x, s * tilt_y]
    }

    /// Adds Bᵀ K B of an element's own K.
    pub(crate) fn add_stiffness(&self, stiffness: &Matrix5, sum: &mut DMatrix<f64>) {
        // S K S
        let turned = Matrix5::from_fn(|row, column| {
            let turn = |axis: usize| if axis < 2 { 1.0 } else { self.facing };
            turn(row) * stiffness[(row, column)] * turn(column)
        });
        self.inner.add_stiffness(1.0, &turned, &self.inner, sum);
        if let Some(outer) = &self.outer {
            outer.add_stiffness(1.0, &turned, outer, sum);
            self.inner.add_stiffness(-1.0, &turned, outer, sum);
            outer.add_stiffness(-1.0, &turned, &self.inner, sum);
        }
    }

    /// Coordinates that the displacement u depends on.
    pub(super) fn coordinates(&self) -> impl Iterator<Item = usize> {
        self.entries().map(|(_, _, coordinate)| coordinate)
    }

    /// Largest displacement u with every degree of freedom within an amplitude.
    pub(super) fn reach(&self, amplitudes: &[f64]) -> Vector5 {
        let mut reach = [0.0; 5];
        for (axis, part, index) in self.entries() {
            reach[axis] += part.abs() * amplitudes.get(index).copied().unwrap_or(0.0);
        }
        reach
    }

    /// Adds the largest forces on the coordinates where a force of the element is within a bound, whatever its direction.
    pub(super) fn add_force_bound(&self, bound: &Vector5, sum: &mut [f64]) {
        for (axis, part, index) in self.entries() {
            if let Some(sum) = sum.get_mut(index) {
                *sum += part.abs() * bound[axis];
            }
        }
    }

    /// Entries of B that are not zero: component, value and coordinate.
    fn entries(&self) -> impl Iterator<Item = (usize, f64, usize)> {
        let places = [(1.0, Some(self.inner)), (-1.0, self.outer)];
        let facing = self.facing;
        places.into_iter().flat_map(move |(sign, place)| {
            place.into_iter().flat_map(move |Place { point, arm }| {
                let [x, y, z, tilt_x, tilt_y] = point.coordinates;
                let entries = [
                    (0, 1.0, x),
                    (1, 1.0, y),
                    (2, facing, z),
                    (3, facing, tilt_x),
                    (4, facing, tilt_y),
                    (0, arm, tilt_y),
                    (1, -arm, tilt_x),
                ];
                let entries = entries.map(|(axis, part, index)| (axis, sign * part, index));
                entries.into_iter().filter(|(_, part, _)| *part != 0.0)
            })
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
        place.add_force(1.0, &[3.0, -2.0, 4.0, 0.1, 0.2], &mut sum);
        assert_eq!(sum, [4.0, -1.0, 5.0, 2.1, 2.7]);
    }

    #[test]
    fn stiffness_and_forces_are_those_of_one_map() {
        let mut attachment = Attachment::on_rigid_shaft(0.3, Facing::MinusZ);
        attachment.outer = Some(Place {
            point: Point {
                coordinates: [5, 6, 7, usize::MAX, usize::MAX],
            },
            arm: 0.0,
        });
        let stiffness = Matrix5::from_fn(|row, column| 1.0 + (3 * row + 5 * column) as f64);
        let place: Vec<f64> = (0..8).map(|index| 0.1 * f64::from(index) - 0.4).collect();
        let displacement = attachment.displacement(&place, &[]);
        let force = stiffness * nalgebra::SVector::from(displacement);
        let mut by_force = vec![0.0; 8];
        attachment.add_force(1.0, &force.into(), &mut by_force);
        let mut whole = DMatrix::zeros(8, 8);
        attachment.add_stiffness(&stiffness, &mut whole);
        let by_stiffness = whole * nalgebra::DVector::from_vec(place);
        for (found, expected) in by_stiffness.iter().zip(&by_force) {
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        }
    }
}
