//! Masses that move besides the shaft: housings, and what vibrates on them.

use std::fmt;

use super::coordinate::Coordinate;
use super::point::{Attachment, Place, Point};
use super::structure::Structure;
use super::{Rotor, RotorDefinition};
use crate::bearing::{Facing, Matrix5};

/// Housings are observed of so many bearings, the first ones.
pub const MOST_HOUSINGS: usize = 4;

/// A mass that moves besides the shaft, by the bearing that it belongs to, from 0, in the order of the scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Body {
    /// The housing of a bearing.
    Housing(usize),
    /// What vibrates on the housing of a bearing.
    Resonator(usize),
}

impl Body {
    /// All that are observed.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        let housings = (0..MOST_HOUSINGS).map(Self::Housing);
        housings.chain((0..MOST_HOUSINGS).map(Self::Resonator))
    }

    /// Name in columns: `housing1`, `resonator1`.
    pub(crate) fn name(self) -> String {
        match self {
            Self::Housing(bearing) => format!("housing{}", bearing + 1),
            Self::Resonator(bearing) => format!("resonator{}", bearing + 1),
        }
    }

    /// Whether it is observed.
    pub(crate) fn is_observed(self) -> bool {
        self.index() < 2 * MOST_HOUSINGS
    }

    /// Its place in the motions of a sample; beyond them where it is not observed.
    pub(crate) fn index(self) -> usize {
        match self {
            Self::Housing(bearing) if bearing < MOST_HOUSINGS => bearing,
            Self::Resonator(bearing) if bearing < MOST_HOUSINGS => MOST_HOUSINGS + bearing,
            _ => usize::MAX,
        }
    }
}

/// `housing of bearing 1`, `resonator on the housing of bearing 1`.
impl fmt::Display for Body {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Housing(bearing) => write!(f, "housing of bearing {}", bearing + 1),
            Self::Resonator(bearing) => {
                write!(f, "resonator on the housing of bearing {}", bearing + 1)
            }
        }
    }
}

/// Motion of a housing, or of what vibrates on it, at one instant.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BodyMotion {
    /// x, y, z from where weight has put it, m.
    pub displacement: [f64; 3],
    /// m/s.
    pub velocity: [f64; 3],
    /// m/s², where asked for.
    pub acceleration: Option<[f64; 3]>,
}

/// A mass that moves besides the shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct BodyPoint {
    pub body: Body,
    /// Mass, kg.
    pub mass: f64,
    pub point: Point,
}

impl Structure {
    /// Places housings and their resonators on the last of the degrees of freedom. They move along the first `axes` of x, y,
    /// z, as the shaft does; the displacement of a housing counts from where its own weight has put it.
    pub(super) fn add_bodies(&mut self, definition: &RotorDefinition, axes: usize) {
        let mut index = self.dofs - axes * definition.bodies().len();
        for (bearing, housing) in definition.housings() {
            let body = Body::Housing(bearing);
            let own = self.add_body(body, housing.mass, &mut index, axes);
            for (axis, own) in own.coordinates.into_iter().enumerate().take(axes) {
                self.matrices.stiffness[(own, own)] = housing.stiffness[axis];
                self.matrices.damping[(own, own)] = housing.damping[axis];
            }
            if let Some(resonator) = housing.resonator {
                let body = Body::Resonator(bearing);
                let point = self.add_body(body, resonator.mass, &mut index, axes);
                let [inner, outer] = [point, own].map(|point| Place { point, arm: 0.0 });
                let attachment = Attachment::new(inner, Some(outer), Facing::PlusZ, 0.0);
                let along = |value| Matrix5::from_diagonal(&[value, value, value, 0.0, 0.0].into());
                let matrices = &mut self.matrices;
                attachment.add_stiffness(&along(resonator.stiffness), &mut matrices.stiffness);
                attachment.add_stiffness(&along(resonator.damping), &mut matrices.damping);
            }
        }
    }

    /// Places a body on the degrees of freedom from `index` on.
    fn add_body(&mut self, body: Body, mass: f64, index: &mut usize, axes: usize) -> Point {
        let mut coordinates = [usize::MAX; 5];
        for (axis, own) in coordinates.iter_mut().enumerate().take(axes) {
            *own = *index;
            self.matrices.mass[(*index, *index)] = mass;
            self.coordinates[*index] = Coordinate::from_axis(axis, &format!(" of the {body}"));
            *index += 1;
        }
        let point = Point { coordinates };
        self.bodies.push(BodyPoint { body, mass, point });
        point
    }
}

impl Rotor {
    /// Indices of the degrees of freedom of housings and what vibrates on them.
    pub(crate) fn body_freedoms(&self) -> std::ops::Range<usize> {
        let bodies = self.structure.bodies.iter();
        let firsts = bodies.map(|body| body.point.coordinates[0]);
        firsts.min().unwrap_or(self.dofs())..self.dofs()
    }

    /// Motion of housings, and what vibrates on them, of the first bearings; none without any.
    pub(super) fn body_motions(&self, place: &[f64], velocity: &[f64]) -> Vec<BodyMotion> {
        if self.structure.bodies.is_empty() {
            return Vec::new();
        }
        let mut motions = vec![BodyMotion::default(); 2 * MOST_HOUSINGS];
        for own in &self.structure.bodies {
            if let Some(motion) = motions.get_mut(own.body.index()) {
                let [x, y, z, ..] = own.point.displacement(place, &[]);
                motion.displacement = [x, y, z];
                let [x, y, z, ..] = own.point.rate(velocity);
                motion.velocity = [x, y, z];
            }
        }
        motions
    }

    /// Writes their accelerations, taken from the derivative of a state.
    pub(super) fn accelerate_bodies(&self, rate: &[f64], motions: &mut [BodyMotion]) {
        let dofs = self.dofs();
        for own in &self.structure.bodies {
            if let Some(motion) = motions.get_mut(own.body.index()) {
                let [x, y, z, ..] = own.point.rate(&rate[dofs..2 * dofs]);
                motion.acceleration = Some([x, y, z]);
            }
        }
    }
}
