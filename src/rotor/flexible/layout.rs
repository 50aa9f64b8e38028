//! A reduced plane laid out twice, for x and y, as the coordinates of a structure.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};

use super::hub::Hub;
use super::mesh::FlexibleShaft;
use super::reduction::ReducedShaft;
use super::shaft_error::ShaftError;
use crate::rotor::coordinate::{Coordinate, CoordinateKind};
use crate::rotor::matrices::Matrices;
use crate::rotor::point::{Place, Point};
use crate::rotor::structure::Structure;
use crate::rotor::{FREEDOMS, RotorDefinition};

/// Frequency of the modes that are kept over that of the highest excitation.
const HEADROOM: f64 = 3.0;
/// Fewest modes of a plane where their number follows from the excitation.
const LEAST_MODES: usize = 4;
/// Most of them.
const MOST_MODES: usize = 20;

/// Order of the coordinates: x and θy of each point and the modes of their plane, then y, θx and modes of the other plane,
/// so that the matrices of the shaft consist of blocks, and last z of all points.
#[derive(Debug, Clone, Copy)]
struct Layout {
    points: usize,
    modes: usize,
    axial: bool,
}

impl Layout {
    /// Number of coordinates of a plane.
    fn plane_size(&self) -> usize {
        2 * self.points + self.modes
    }

    fn size(&self) -> usize {
        self.z() + 1
    }

    fn dofs(&self) -> usize {
        self.size() - usize::from(!self.axial)
    }

    fn z(&self) -> usize {
        2 * self.plane_size()
    }

    fn point(&self, number: usize) -> Point {
        let (first, second) = (2 * number, self.plane_size() + 2 * number);
        Point {
            coordinates: [first, second, self.z(), second + 1, first + 1],
        }
    }

    /// Each deflection, slope and mode of the plane of x and θy with that of the plane of y and −θx, and the sign of the
    /// latter.
    fn planes(&self) -> Vec<(usize, usize, f64)> {
        let sign = |index: usize| match index < 2 * self.points && index % 2 == 1 {
            true => -1.0,
            false => 1.0,
        };
        let second = self.plane_size();
        let first = 0..second;
        first.map(|own| (own, second + own, sign(own))).collect()
    }

    /// A symmetric matrix of a plane for both.
    fn both(&self, plane: &DMatrix<f64>) -> DMatrix<f64> {
        let mut whole = DMatrix::zeros(self.size(), self.size());
        for (row, second_row, row_sign) in self.planes() {
            for (column, second_column, column_sign) in self.planes() {
                let entry = plane[(row, column)];
                whole[(row, column)] = entry;
                whole[(second_row, second_column)] = row_sign * column_sign * entry;
            }
        }
        whole
    }

    /// The forces `a (−v, u)` of a matrix a of a plane, with u and v the coordinates of the first and the second plane.
    fn across(&self, plane: &DMatrix<f64>) -> DMatrix<f64> {
        let mut whole = DMatrix::zeros(self.size(), self.size());
        for (row, second_row, row_sign) in self.planes() {
            for (column, second_column, column_sign) in self.planes() {
                let entry = plane[(row, column)];
                whole[(row, second_column)] -= column_sign * entry;
                whole[(second_row, column)] += row_sign * entry;
            }
        }
        whole
    }
}

/// A shaft that bends, as it was before its reduction.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::rotor) struct Bending {
    /// Positions of all nodes from the left end, m.
    pub nodes: Vec<f64>,
    /// Number of modes between the points, in each plane.
    pub modes: usize,
    /// Angular frequency of the lowest mode between the points that is left out, rad/s.
    pub left_out: Option<f64>,
    /// Coordinates of both planes, as by [`Structure::planes`].
    pub planes: Vec<(usize, usize, f64)>,
    /// Deflections of the nodes by all coordinates: along x, and along y.
    pub deflections: [DMatrix<f64>; 2],
    /// The points that are kept, the observed one first.
    points: Vec<Point>,
    /// Their positions from the left end, m.
    positions: Vec<f64>,
    /// Positions nearer than this are one, m.
    same: f64,
    hubs: Vec<Hub>,
}

impl Bending {
    /// Frequency up to which natural frequencies are those of the shaft, Hz: beyond it the modes that are left out count. None
    /// where none is.
    pub fn natural_up_to(&self) -> Option<f64> {
        Some(self.left_out? / HEADROOM / TAU)
    }

    /// Position of the observed point, m.
    pub fn observed(&self) -> f64 {
        self.positions[0]
    }

    /// The place at a position in m, on an arm where a hub holds it; the observed point where none is kept there.
    pub fn place_at(&self, position: f64) -> Place {
        let node = Hub::node_of(&self.hubs, position);
        Place {
            point: self.points[index_of(node, &self.positions, self.same).unwrap_or(0)],
            arm: position - node,
        }
    }

    /// Puts the coordinates into another order: the old index of each new one, and the new index of each old one.
    pub fn arrange(&mut self, order: &[Option<usize>], places: &[usize]) {
        for (first, second, _) in &mut self.planes {
            (*first, *second) = (places[*first], places[*second]);
        }
        for point in &mut self.points {
            point.coordinates = point.coordinates.map(|old| places[old]);
        }
        for deflections in &mut self.deflections {
            *deflections = DMatrix::from_fn(deflections.nrows(), order.len(), |node, column| {
                order[column].map_or(0.0, |old| deflections[(node, old)])
            });
        }
    }
}

/// Index of the position that is one with another.
fn index_of(position: f64, positions: &[f64], same: f64) -> Option<usize> {
    let near = |own: &f64| (own - position).abs() < same;
    positions.iter().position(near)
}

impl FlexibleShaft {
    /// Positions of the points that are kept: the observed one first, then those of bearings, loads and unbalances, and of
    /// a massless shaft those of discs, so that all of its mass is at points.
    fn points(&self, definition: &RotorDefinition) -> Vec<f64> {
        let unbalances = self.unbalances.iter().map(|own| own.position);
        let mut points = vec![self.observed];
        let discs = self.discs.iter().filter(|_| self.is_massless());
        let discs = discs.map(|disc| disc.position);
        let hubs = self.hubs();
        for position in definition.positions().chain(unbalances).chain(discs) {
            let position = Hub::node_of(&hubs, position);
            if index_of(position, &points, self.same_position()).is_none() {
                points.push(position);
            }
        }
        points
    }

    /// Has modes for an excitation in rad/s where their number is not given.
    fn reduction(&self, points: &[f64], excitation: f64) -> Result<ReducedShaft, ShaftError> {
        let highest = HEADROOM * excitation;
        self.mesh(points, None)?.reduced(points, |frequencies| {
            self.modes.unwrap_or_else(|| {
                let below = frequencies.iter().filter(|own| **own < highest);
                below.count().clamp(LEAST_MODES, MOST_MODES)
            })
        })
    }
}

impl RotorDefinition {
    /// This shaft with the modes of bending for an excitation in rad/s, where their number is not given; a shaft that cannot be
    /// reduced is reported where it is assembled.
    pub(crate) fn with_modes_for(&self, excitation: f64) -> Self {
        let open = self.flexible.as_ref().filter(|own| own.modes.is_none());
        let reduced = open.and_then(|own| own.reduction(&own.points(self), excitation).ok());
        reduced.map_or_else(|| self.clone(), |found| self.with_modes(found.modes))
    }
}

impl Structure {
    /// The structure of a shaft that bends, without housings.
    ///
    /// # Errors
    /// [`ShaftError`] where positions lie beyond the shaft or it cannot be reduced.
    pub fn bending(
        shaft: &FlexibleShaft,
        definition: &RotorDefinition,
    ) -> Result<Self, ShaftError> {
        let points = shaft.points(definition);
        let reduction = shaft.reduction(&points, definition.highest_excitation())?;
        let layout = Layout {
            points: points.len(),
            modes: reduction.modes,
            axial: definition.shaft.freedoms.moves(2),
        };
        let plane = &reduction.plane;
        let mut mass = layout.both(&plane.mass);
        mass[(layout.z(), layout.z())] = shaft.mass();
        let elastic = layout.both(&plane.stiffness);
        let internal_damping = &elastic * shaft.internal_damping;
        Ok(Self {
            coordinates: coordinates(&layout, &points, &reduction),
            dofs: layout.dofs(),
            freedoms: definition.shaft.freedoms,
            shaft_mass: definition.shaft.mass,
            matrices: Matrices {
                mass,
                damping: internal_damping.clone(),
                stiffness: elastic,
                // w = u + i v: the gyroscopic force is i ω P ẇ, that of damping inside the shaft −τ K (ẇ − i ω w)
                gyroscopic: -layout.across(&plane.polar),
                internal_damping,
                circulatory: layout.across(&plane.stiffness) * shaft.internal_damping,
            },
            shaft: layout.point(0),
            rigid_motions: rigid_motions(&layout, &points),
            bodies: Vec::new(),
            followers: DMatrix::zeros(0, 0),
            attachments: Vec::new(),
            elements: Vec::new(),
            load_places: Vec::new(),
            unbalances: Vec::new(),
            bending: Some(Bending {
                deflections: deflections(&layout, &reduction),
                planes: layout.planes(),
                modes: layout.modes,
                left_out: reduction.left_out,
                nodes: reduction.nodes,
                points: (0..points.len()).map(|own| layout.point(own)).collect(),
                positions: points,
                same: shaft.same_position(),
                hubs: shaft.hubs(),
            }),
        })
    }
}

fn coordinates(layout: &Layout, points: &[f64], reduction: &ReducedShaft) -> Vec<Coordinate> {
    let mut coordinates = vec![Coordinate::from_axis(2, ""); layout.size()];
    for (number, position) in points.iter().enumerate() {
        let owner = format!(" of the shaft at {:.1} mm", 1e3 * position);
        for (axis, index) in layout.point(number).coordinates.into_iter().enumerate() {
            if axis != 2 {
                coordinates[index] = Coordinate::from_axis(axis, &owner);
            }
        }
    }
    for (mode, (first, second, _)) in layout.planes()[2 * layout.points..].iter().enumerate() {
        for (index, axis) in [(*first, "x"), (*second, "y")] {
            coordinates[index] = Coordinate {
                name: format!("bending mode {} along {axis}", mode + 1),
                kind: CoordinateKind::Mode(reduction.largest_deflection(mode)),
            };
        }
    }
    coordinates
}

fn rigid_motions(layout: &Layout, points: &[f64]) -> [DVector<f64>; FREEDOMS] {
    let mut motions = std::array::from_fn(|_| DVector::zeros(layout.size()));
    for (number, position) in points.iter().enumerate() {
        let [x, y, z, tilt_x, tilt_y] = layout.point(number).coordinates;
        let arm = position - points[0];
        let parts = [
            (0, x, 1.0),
            (1, y, 1.0),
            (2, z, 1.0),
            (3, tilt_x, 1.0),
            (3, y, -arm),
            (4, tilt_y, 1.0),
            (4, x, arm),
        ];
        for (axis, index, part) in parts {
            motions[axis][index] = part;
        }
    }
    motions
}

/// Deflections of all nodes by all coordinates: along x, and along y.
fn deflections(layout: &Layout, reduction: &ReducedShaft) -> [DMatrix<f64>; 2] {
    let nodes = reduction.nodes.len();
    let [mut along_x, mut along_y] = [(); 2].map(|()| DMatrix::zeros(nodes, layout.size()));
    for (first, second, sign) in layout.planes() {
        for node in 0..nodes {
            let part = reduction.transformation[(2 * node, first)];
            along_x[(node, first)] = part;
            along_y[(node, second)] = sign * part;
        }
    }
    [along_x, along_y]
}
