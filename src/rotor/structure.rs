//! The coordinates of a structure and the points that bearings, loads and sensors know it by.

use nalgebra::{DMatrix, DVector};

use super::equilibrium::FREEDOM_NAMES;
use super::flexible::Bending;
use super::linear_bearing::AttachedLinear;
use super::point::{Attachment, Place, Point};
use super::static_search::Restoring;
use super::{FREEDOMS, Freedoms, Load, PlaneUnbalance, RotorDefinition, ShaftError};
use crate::bearing::{BearingRotation, Support, Vector5};

/// A generalised coordinate.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Coordinate {
    /// Name in messages.
    pub name: String,
    pub kind: CoordinateKind,
}

/// What a coordinate measures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum CoordinateKind {
    /// A displacement in m.
    Displacement,
    /// An angle in rad.
    Tilt,
    /// The share of a mode shape, whose largest deflection for a share of one this is, m.
    Mode(f64),
}

impl Coordinate {
    /// x, y, z, θx or θy of a point, of which `owner` says which.
    pub fn of_axis(axis: usize, owner: &str) -> Self {
        Self {
            name: format!("{}{owner}", FREEDOM_NAMES[axis]),
            kind: if axis < 3 {
                CoordinateKind::Displacement
            } else {
                CoordinateKind::Tilt
            },
        }
    }

    /// What it moves, in words, whatever the direction.
    pub fn place(&self) -> String {
        let owner = self
            .name
            .split_once(" of ")
            .map_or("the shaft", |(_, owner)| owner);
        match self.kind {
            CoordinateKind::Displacement => format!("displacement of {owner}"),
            CoordinateKind::Tilt => format!("tilt of {owner}"),
            CoordinateKind::Mode(_) => self.name.split(" along ").take(1).collect(),
        }
    }

    /// Length that makes a displacement of it, m, by that of tilts.
    pub fn length(&self, arm: f64) -> f64 {
        match self.kind {
            CoordinateKind::Displacement => 1.0,
            CoordinateKind::Tilt => arm,
            CoordinateKind::Mode(deflection) => deflection,
        }
    }
}

/// An unbalance at a point of the shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct UnbalancedPoint {
    pub point: Point,
    pub unbalance: PlaneUnbalance,
}

/// What moves, and where bearings and loads act on it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Structure {
    /// Degrees of freedom first, behind them what is held, and last what has no mass and follows.
    pub coordinates: Vec<Coordinate>,
    /// Number of degrees of freedom.
    pub dofs: usize,
    /// M of all coordinates; nothing couples degrees of freedom with what is held.
    pub mass: DMatrix<f64>,
    /// C of all that is damped but the shaft and the contacts.
    pub damping: DMatrix<f64>,
    /// K of all that is elastic but the ball bearings; springs off the centre couple degrees of freedom with tilts that are
    /// held.
    pub stiffness: DMatrix<f64>,
    /// G: gyroscopic forces per speed and velocity.
    pub gyroscopic: DMatrix<f64>,
    /// The part of C that turns with the shaft.
    pub internal_damping: DMatrix<f64>,
    /// Forces per speed and displacement that follow from it.
    pub circulatory: DMatrix<f64>,
    /// The point of the shaft that is observed; of a rigid one its centre of mass, where everything acts.
    pub shaft: Point,
    /// Where each of the loads acts; accelerations of the base act on all masses.
    pub load_places: Vec<Place>,
    pub unbalances: Vec<UnbalancedPoint>,
    /// Coordinates of the shaft when it moves by one along x, y, z, or about X and Y through its observed point.
    pub rigid_motions: [DVector<f64>; FREEDOMS],
    /// Distance of each ball bearing from the observed point along the shaft, where its position is that of its point, m.
    pub arms: Vec<f64>,
    /// One of every ball bearing.
    pub attachments: Vec<Attachment>,
    /// The bearings of constant stiffness.
    pub linear: Vec<AttachedLinear>,
    /// Masses on the ground that bearings stand in.
    pub housings: Vec<HousingPoint>,
    /// Displacement of the last coordinates, which have no mass, by that of the degrees of freedom: `−K_ss⁻¹ K_sd`.
    pub followers: DMatrix<f64>,
    /// Where the shaft bends: all of it.
    pub bending: Option<Bending>,
}

/// A housing that moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct HousingPoint {
    /// The bearing that stands in it, from 0, in the order of the scene.
    pub bearing: usize,
    /// Mass, kg.
    pub mass: f64,
    pub point: Point,
}

impl Structure {
    /// A rigid shaft whose bearings stand on the ground, with its mass or moment of inertia along each of x, y, z, θx, θy.
    pub fn rigid(masses: Vector5, freedoms: Freedoms, bearings: usize) -> Self {
        let nothing = DMatrix::zeros(FREEDOMS, FREEDOMS);
        let shaft = match freedoms {
            Freedoms::Lateral => Point::WITHOUT_Z,
            _ => Point::RIGID_SHAFT,
        };
        let axis_of = |index| shaft.axis_of(index).unwrap_or(index);
        let unit = |axis: usize| {
            let own = shaft.coordinates[axis];
            DVector::from_fn(FREEDOMS, |row, _| f64::from(u8::from(row == own)))
        };
        let masses = DVector::from_fn(FREEDOMS, |row, _| masses[axis_of(row)]);
        Self {
            coordinates: (0..FREEDOMS)
                .map(|index| Coordinate::of_axis(axis_of(index), ""))
                .collect(),
            dofs: freedoms.axes().len(),
            mass: DMatrix::from_diagonal(&masses),
            damping: nothing.clone(),
            stiffness: nothing.clone(),
            gyroscopic: nothing.clone(),
            internal_damping: nothing.clone(),
            circulatory: nothing,
            shaft,
            load_places: Vec::new(),
            unbalances: Vec::new(),
            rigid_motions: std::array::from_fn(unit),
            arms: vec![0.0; bearings],
            attachments: vec![
                Attachment {
                    inner: shaft,
                    outer: None
                };
                bearings
            ],
            linear: Vec::new(),
            housings: Vec::new(),
            followers: DMatrix::zeros(0, 0),
            bending: None,
        }
    }

    /// That of a definition.
    ///
    /// # Errors
    /// [`ShaftError`] where a shaft that bends cannot be built.
    pub fn of(definition: &RotorDefinition) -> Result<Self, ShaftError> {
        let grounded = match &definition.flexible {
            Some(flexible) => Self::bending(flexible, definition)?,
            None => Self::of_rigid(definition),
        };
        let axes = definition.shaft.freedoms.lengths();
        let (structure, massless) = grounded.with_massless_last();
        let mut structure = structure
            .on_housings(definition, axes)
            .with_linear_bearings();
        if massless > 0 {
            structure.followers = structure
                .followers_of(massless)
                .ok_or(ShaftError::Singular {
                    points: structure.coordinates.len() - massless,
                })?;
        }
        Ok(structure)
    }

    /// The same with K and C of its linear bearings in those of the whole.
    fn with_linear_bearings(mut self) -> Self {
        for bearing in &self.linear {
            let attachment = &bearing.attachment;
            attachment.add_stiffness(&bearing.stiffness, &mut self.stiffness);
            attachment.add_stiffness(&bearing.damping, &mut self.damping);
        }
        self
    }

    /// That of a definition whose shaft is rigid.
    fn of_rigid(definition: &RotorDefinition) -> Self {
        let shaft = &definition.shaft;
        let (mass, inertia) = (shaft.mass, shaft.inertia_transverse);
        let mut structure = Self::rigid(
            [mass, mass, mass, inertia, inertia],
            shaft.freedoms,
            definition.bearings.len(),
        );
        let [.., tilt_x, tilt_y] = structure.shaft.coordinates;
        structure.gyroscopic[(tilt_x, tilt_y)] = shaft.inertia_polar;
        structure.gyroscopic[(tilt_y, tilt_x)] = -shaft.inertia_polar;
        let place = |load: &Load| Place {
            point: structure.shaft,
            arm: load.position,
        };
        structure.load_places = definition.loads.iter().map(place).collect();
        structure.unbalances = vec![UnbalancedPoint {
            point: structure.shaft,
            unbalance: shaft.whole_unbalance(),
        }];
        let linear = definition.linear_bearings.iter();
        let grounded = Attachment {
            inner: structure.shaft,
            outer: None,
        };
        let attached = linear.map(|own| own.attached(grounded, own.position, 0.0));
        structure.linear = attached.collect();
        structure
    }

    /// The same with those bearings on housings that have one. A housing moves along the first `axes` of x, y, z, as the
    /// shaft does; its displacement counts from where its own weight has put it.
    fn on_housings(self, definition: &RotorDefinition, axes: usize) -> Self {
        let first = self.dofs;
        let (housings, balls) = (definition.housings(), definition.ball_places());
        let mut structure = self.with_room_for(axes * housings.len());
        for (number, (bearing, housing)) in housings.into_iter().enumerate() {
            let mut coordinates = [usize::MAX; 5];
            for (axis, own) in coordinates.iter_mut().enumerate().take(axes) {
                let index = first + axes * number + axis;
                *own = index;
                structure.mass[(index, index)] = housing.mass;
                structure.stiffness[(index, index)] = housing.stiffness[axis];
                structure.damping[(index, index)] = housing.damping[axis];
                let owner = format!(" of the housing of bearing {}", bearing + 1);
                structure.coordinates[index] = Coordinate::of_axis(axis, &owner);
            }
            let point = Point { coordinates };
            let attachment = match balls.iter().position(|place| *place == bearing) {
                Some(ball) => Some(&mut structure.attachments[ball]),
                None => {
                    let mut linear = structure.linear.iter_mut();
                    linear
                        .find(|own| own.place == bearing)
                        .map(|own| &mut own.attachment)
                }
            };
            if let Some(attachment) = attachment {
                attachment.outer = Some(point);
            }
            structure.housings.push(HousingPoint {
                bearing,
                mass: housing.mass,
                point,
            });
        }
        structure
    }

    /// The same with more degrees of freedom, behind its own, that nothing belongs to yet.
    fn with_room_for(mut self, added: usize) -> Self {
        let dofs = self.dofs;
        let index = |old: usize| if old < dofs { old } else { old + added };
        for matrix in self.matrices_mut() {
            let taller = matrix.clone().insert_rows(dofs, added, 0.0);
            *matrix = taller.insert_columns(dofs, added, 0.0);
        }
        for deflections in self.bending.iter_mut().flat_map(|own| &mut own.deflections) {
            *deflections = deflections.clone().insert_columns(dofs, added, 0.0);
        }
        for motion in &mut self.rigid_motions {
            *motion = motion.clone().insert_rows(dofs, added, 0.0);
        }
        for (first, second, _) in self.bending.iter_mut().flat_map(|own| &mut own.planes) {
            (*first, *second) = (index(*first), index(*second));
        }
        for point in self.points_mut() {
            point.coordinates = point.coordinates.map(index);
        }
        let room = Coordinate::of_axis(0, "");
        self.coordinates
            .splice(dofs..dofs, std::iter::repeat_n(room, added));
        Self {
            dofs: dofs + added,
            ..self
        }
    }

    /// The same with the degrees of freedom of a shaft that bends that have no mass behind all others, and how many these
    /// are.
    fn with_massless_last(mut self) -> (Self, usize) {
        let bends = self.bending.is_some();
        let massless =
            |index: &usize| bends && *index < self.dofs && self.mass[(*index, *index)] == 0.0;
        let (last, first): (Vec<_>, Vec<_>) = (0..self.coordinates.len()).partition(massless);
        if last.is_empty() {
            return (self, 0);
        }
        let order = [first, last.clone()].concat();
        let mut places = vec![0; order.len()];
        for (place, old) in order.iter().enumerate() {
            places[*old] = place;
        }
        for matrix in self.matrices_mut() {
            *matrix = matrix.select_rows(&order).select_columns(&order);
        }
        if let Some(bending) = &mut self.bending {
            for deflections in &mut bending.deflections {
                *deflections = deflections.select_columns(&order);
            }
            for (first, second, _) in &mut bending.planes {
                (*first, *second) = (places[*first], places[*second]);
            }
        }
        for motion in &mut self.rigid_motions {
            *motion = motion.select_rows(&order);
        }
        for point in self.points_mut() {
            point.coordinates = point.coordinates.map(|old| places[old]);
        }
        let mut coordinates = std::mem::take(&mut self.coordinates);
        self.coordinates = order
            .iter()
            .map(|old| std::mem::replace(&mut coordinates[*old], Coordinate::of_axis(0, "")))
            .collect();
        self.dofs -= last.len();
        (self, last.len())
    }

    /// [`Structure::followers`] of the last coordinates; none where nothing holds them.
    fn followers_of(&self, count: usize) -> Option<DMatrix<f64>> {
        let first = self.coordinates.len() - count;
        let own = self.stiffness.view((first, first), (count, count));
        let moved = self.stiffness.view((first, 0), (count, self.dofs));
        own.into_owned().lu().solve(&-moved)
    }

    /// A stiffness of all coordinates as it meets the degrees of freedom, with the massless ones following.
    pub fn condensed(&self, mut stiffness: DMatrix<f64>) -> DMatrix<f64> {
        let (count, dofs) = (self.followers.nrows(), self.dofs);
        if count > 0 {
            let first = self.coordinates.len() - count;
            let by_followers = stiffness.view((0, first), (dofs, count)) * &self.followers;
            let mut own = stiffness.view_mut((0, 0), (dofs, dofs));
            own += by_followers;
        }
        stiffness
    }

    /// Constant forces on all coordinates as they act on the degrees of freedom.
    pub fn carried(&self, mut forces: Vec<f64>) -> Vec<f64> {
        let count = self.followers.nrows();
        let on_followers = forces.split_off(forces.len() - count);
        forces.truncate(self.dofs);
        if count > 0 {
            // −K_ds K_ss⁻¹ f_s
            let first = self.coordinates.len() - count;
            let own = self.stiffness.view((first, first), (count, count));
            let moved = own
                .into_owned()
                .lu()
                .solve(&DVector::from_vec(on_followers));
            let held = self.stiffness.view((0, first), (self.dofs, count));
            let carried = held * moved.unwrap_or_else(|| DVector::zeros(count));
            forces
                .iter_mut()
                .zip(&carried)
                .for_each(|(sum, part)| *sum -= part);
        }
        forces
    }

    /// Checks that nothing acts on massless coordinates but springs and constant loads; `damping` is C.
    ///
    /// # Errors
    /// [`ShaftError::Followers`] names all coordinates where something does.
    pub fn check_followers(
        &self,
        definition: &RotorDefinition,
        damping: &DMatrix<f64>,
    ) -> Result<(), ShaftError> {
        let mut acts: Vec<f64> = damping.column_iter().map(|column| column.amax()).collect();
        for UnbalancedPoint { point, unbalance } in &self.unbalances {
            let force = unbalance.phasor(1.0).map(|part| part.norm());
            point.add_force(1.0, &force, &mut acts);
        }
        for (load, place) in definition.loads.iter().zip(&self.load_places) {
            if !load.acts_on_mass() {
                let varying = load.kind.main_vibration().amplitude.map(f64::abs);
                let force = load.kind.static_part().map(f64::abs);
                place.point.add_force(1.0, &varying, &mut acts);
                place.point.add_force(1.0, &force, &mut acts);
            }
        }
        let first = self.coordinates.len() - self.followers.nrows();
        let names = self.coordinates.iter().zip(acts).skip(first);
        let names = names.filter(|(_, acts)| *acts != 0.0);
        let names: Vec<_> = names.map(|(own, _)| own.name.as_str()).collect();
        match names.is_empty() {
            true => Ok(()),
            false => Err(ShaftError::Followers(names.join(", "))),
        }
    }

    fn matrices_mut(&mut self) -> [&mut DMatrix<f64>; 6] {
        [
            &mut self.mass,
            &mut self.damping,
            &mut self.stiffness,
            &mut self.gyroscopic,
            &mut self.internal_damping,
            &mut self.circulatory,
        ]
    }

    /// All points of the shaft.
    fn points_mut(&mut self) -> impl Iterator<Item = &mut Point> {
        let linear = self.linear.iter_mut().map(|own| &mut own.attachment);
        let attachments = self.attachments.iter_mut().chain(linear);
        let attachments = attachments.map(|own| &mut own.inner);
        let unbalances = self.unbalances.iter_mut().map(|own| &mut own.point);
        let loads = self.load_places.iter_mut().map(|own| &mut own.point);
        attachments
            .chain(unbalances)
            .chain(loads)
            .chain([&mut self.shaft])
    }

    /// M t of a unit translation t of shaft and housings along an axis, kg.
    pub fn inertia_along(&self, axis: usize) -> DVector<f64> {
        let mut forces = self.shaft_inertia_along(axis);
        for HousingPoint { mass, point, .. } in &self.housings {
            let unit = std::array::from_fn(|own| f64::from(u8::from(own == axis)));
            point.add_force(*mass, &unit, forces.as_mut_slice());
        }
        forces
    }

    /// The same of the shaft alone.
    pub fn shaft_inertia_along(&self, axis: usize) -> DVector<f64> {
        &self.mass * &self.rigid_motions[axis]
    }

    /// Whether it is nothing but a rigid shaft on bearings that stand on the ground.
    pub fn is_rigid(&self) -> bool {
        let grounded = |attachment: &Attachment| *attachment == Attachment::GROUNDED;
        self.coordinates.len() == FREEDOMS
            && self.attachments.iter().all(grounded)
            && self.stiffness.iter().all(|entry| *entry == 0.0)
    }

    /// Coordinates of the plane of x with those of the plane of y that a forward whirl has a quarter turn behind, times a
    /// sign.
    pub fn planes(&self) -> Vec<(usize, usize, f64)> {
        match &self.bending {
            Some(bending) => bending.planes.clone(),
            None => {
                let [x, y, _, tilt_x, tilt_y] = self.shaft.coordinates;
                vec![(x, y, 1.0), (tilt_x, tilt_y, 1.0)]
            }
        }
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
        let mut stiffness = self.stiffness.clone();
        force.gemv(1.0, &stiffness, &DVector::from_column_slice(place), 0.0);
        let mut largest_share: f64 = 0.0;
        let rotation = BearingRotation::at_start(speed);
        for (support, attachment) in supports.iter().zip(&self.attachments) {
            let displacement = attachment.displacement(place, &[]);
            let tangent = support.tangent(&displacement, &rotation);
            attachment.add_force(1.0, &tangent.force, force.as_mut_slice());
            attachment.add_stiffness(&tangent.stiffness, &mut stiffness);
            for (axis, share) in tangent.force.iter().enumerate() {
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
