//! A generalised coordinate of a structure.

use super::equilibrium::FREEDOM_NAMES;

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
    pub fn from_axis(axis: usize, owner: &str) -> Self {
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
