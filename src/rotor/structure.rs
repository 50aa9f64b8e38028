//! The coordinates of a structure and the points that bearings, loads and sensors know it by.

use nalgebra::{DMatrix, DVector};

use super::coefficients::Coefficients;
use super::equilibrium::FREEDOM_NAMES;
use super::point::{Attachment, Point};
use super::static_search::Restoring;
use super::{FREEDOMS, RotorDefinition};
use crate::bearing::{BearingRotation, MountedBearing, Support, Vector5};

/// A generalised coordinate.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Coordinate {
    /// Name in messages.
    pub name: String,
    /// Whether it is an angle in rad; otherwise it is a displacement in m.
    pub tilts: bool,
}

impl Coordinate {
    /// Length that makes a displacement of it, m, by that of tilts.
    pub fn length(&self, arm: f64) -> f64 {
        if self.tilts { arm } else { 1.0 }
    }
}

/// What moves, and where bearings and loads act on it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Structure {
    /// Degrees of freedom first, behind them what is held.
    pub coordinates: Vec<Coordinate>,
    /// Number of degrees of freedom.
    pub dofs: usize,
    /// M of all coordinates; nothing couples degrees of freedom with what is held.
    pub mass: DMatrix<f64>,
    /// C of all that is damped but the shaft and the contacts.
    pub damping: DMatrix<f64>,
    /// K of all that is elastic but the bearings; nothing couples degrees of freedom with what is held.
    pub stiffness: Coefficients,
    /// The centre of mass of the shaft.
    pub shaft: Point,
    /// One of every bearing.
    pub attachments: Vec<Attachment>,
    /// Masses on the ground that bearings stand in.
    pub housings: Vec<HousingPoint>,
}

/// A housing that moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct HousingPoint {
    /// The bearing that stands in it, from 0.
    pub bearing: usize,
    /// Mass, kg.
    pub mass: f64,
    pub point: Point,
}

impl Structure {
    /// A rigid shaft whose bearings stand on the ground, with the mass or moment of inertia of each of its five
    /// coordinates, of which the first `dofs` move.
    pub fn rigid(masses: Vector5, dofs: usize, bearings: usize) -> Self {
        let coordinate = |axis: usize| Coordinate {
            name: FREEDOM_NAMES[axis].to_owned(),
            tilts: axis >= 3,
        };
        let nothing = DMatrix::zeros(FREEDOMS, FREEDOMS);
        Self {
            coordinates: (0..FREEDOMS).map(coordinate).collect(),
            dofs,
            mass: DMatrix::from_diagonal(&DVector::from_column_slice(&masses)),
            damping: nothing.clone(),
            stiffness: Coefficients::new(nothing, dofs),
            shaft: Point::RIGID_SHAFT,
            attachments: vec![Attachment::GROUNDED; bearings],
            housings: Vec::new(),
        }
    }

    /// That of a definition.
    pub fn of(definition: &RotorDefinition) -> Self {
        let shaft = &definition.shaft;
        let (mass, inertia) = (shaft.mass, shaft.inertia_transverse);
        let grounded = Self::rigid(
            [mass, mass, mass, inertia, inertia],
            shaft.freedoms.count(),
            definition.bearings.len(),
        );
        if definition
            .bearings
            .iter()
            .any(|bearing| bearing.housing.is_some())
        {
            grounded.on_housings(&definition.bearings)
        } else {
            grounded
        }
    }

    /// The same with those bearings on housings that have one. A housing moves along x and y, and along z where the shaft
    /// does; its displacement counts from where its own weight has put it.
    fn on_housings(self, bearings: &[MountedBearing]) -> Self {
        let (active, axes) = (self.dofs, self.dofs.min(3));
        let housings = bearings.iter().enumerate();
        let housings: Vec<_> = housings
            .filter_map(|(bearing, mounted)| Some((bearing, mounted.housing?)))
            .collect();
        let added = axes * housings.len();
        let size = FREEDOMS + added;
        // degrees of freedom of the shaft, those of the housings, and what is held of the shaft
        let shaft: [usize; 5] =
            std::array::from_fn(|axis| if axis < active { axis } else { axis + added });
        let mut coordinates = self.coordinates.clone();
        let [mut mass, mut damping, mut stiffness] =
            std::array::from_fn(|_| DMatrix::zeros(size, size));
        for (axis, index) in shaft.into_iter().enumerate() {
            mass[(index, index)] = self.mass[(axis, axis)];
        }
        let inner = Point::new(shaft);
        let mut structure = Self {
            dofs: active + added,
            shaft: inner,
            attachments: vec![Attachment { inner, outer: None }; bearings.len()],
            ..self
        };
        for (number, (bearing, housing)) in housings.into_iter().enumerate() {
            let first = active + axes * number;
            let mut indices = [usize::MAX; 5];
            for axis in 0..axes {
                let index = first + axis;
                indices[axis] = index;
                mass[(index, index)] = housing.mass;
                stiffness[(index, index)] = housing.stiffness[axis];
                damping[(index, index)] = housing.damping[axis];
                let coordinate = Coordinate {
                    name: format!(
                        "{} of the housing of bearing {}",
                        FREEDOM_NAMES[axis],
                        bearing + 1
                    ),
                    tilts: false,
                };
                coordinates.insert(index, coordinate);
            }
            let point = Point::new(indices);
            structure.attachments[bearing].outer = Some(point);
            structure.housings.push(HousingPoint {
                bearing,
                mass: housing.mass,
                point,
            });
        }
        Self {
            coordinates,
            stiffness: Coefficients::new(stiffness, active + added),
            mass,
            damping,
            ..structure
        }
    }

    /// Whether it is nothing but a rigid shaft on bearings that stand on the ground.
    pub fn is_rigid(&self) -> bool {
        let grounded = |attachment: &Attachment| *attachment == Attachment::GROUNDED;
        self.coordinates.len() == FREEDOMS
            && self.attachments.iter().all(grounded)
            && self.stiffness.entries().iter().all(|entry| *entry == 0.0)
    }

    /// Lengths that make displacements of all coordinates, m.
    pub fn lengths(&self, arm: f64) -> Vec<f64> {
        let coordinates = self.coordinates.iter();
        coordinates
            .map(|coordinate| coordinate.length(arm))
            .collect()
    }

    /// Force onto all that holds the structure, and its slope, with the cages where they start.
    pub fn restoring(
        &self,
        supports: &[Support],
        place: &[f64],
        speed: f64,
        arm: f64,
    ) -> Restoring {
        let size = self.coordinates.len();
        let mut force = DVector::zeros(size);
        let mut stiffness = self.stiffness.entries().clone();
        force.gemv(1.0, &stiffness, &DVector::from_column_slice(place), 0.0);
        let mut largest_share: f64 = 0.0;
        let rotation = BearingRotation::at_start(speed);
        for (support, attachment) in supports.iter().zip(&self.attachments) {
            let displacement = attachment.displacement(place, &[]);
            let (share, tangent) = support.force_and_stiffness(&displacement, &rotation);
            attachment.add_force(1.0, &share, force.as_mut_slice());
            attachment.add_stiffness(&tangent, &mut stiffness);
            for (axis, share) in share.iter().enumerate() {
                let length = if axis < 3 { 1.0 } else { arm };
                largest_share = largest_share.max((share / length).abs());
            }
        }
        Restoring {
            force,
            stiffness,
            largest_share,
        }
    }
}

#[cfg(test)]
#[path = "structure_tests.rs"]
mod tests;
