//! Sections and discs as beam elements between nodes, in one plane of bending.

use nalgebra::{DMatrix, DVector};

use crate::bearing::MountedBearing;
use crate::physics::{BeamElement, ElementMatrix};
use crate::rotor::PlaneUnbalance;

/// Positions nearer than this part of the shaft's length are one node.
const SAME_NODE: f64 = 1e-9;
/// Fewest elements of a shaft: the lowest ten frequencies are then those of the beam to 1e-4.
const LEAST_ELEMENTS: f64 = 40.0;

/// A rigid disc on the shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disc {
    /// Distance of its centre from the left end of the shaft, m.
    pub position: f64,
    /// Mass, kg.
    pub mass: f64,
    /// Moment of inertia about a diameter, kg m².
    pub inertia_transverse: f64,
    /// Moment of inertia about the axis of the shaft, kg m².
    pub inertia_polar: f64,
    /// Length of the shaft about its centre that it keeps from bending, m; zero of a thin disc.
    pub hub_width: f64,
}

/// A part of the shaft that does not bend: what lies within it moves with its node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Hub {
    ends: [f64; 2],
    node: f64,
}

impl Disc {
    /// A ring of a width and of outer and inner diameters in m, of a density in kg/m³.
    pub fn of_size(position: f64, width: f64, diameters: [f64; 2], density: f64) -> Self {
        let [outer, inner] = diameters;
        let mass = density * std::f64::consts::FRAC_PI_4 * width * (outer * outer - inner * inner);
        let squares = outer * outer + inner * inner;
        Self {
            position,
            mass,
            inertia_transverse: mass * (squares / 16.0 + width * width / 12.0),
            inertia_polar: mass * squares / 8.0,
            hub_width: 0.0,
        }
    }

    /// Positions of both ends of its hub, m.
    pub(crate) fn hub_ends(&self) -> [f64; 2] {
        [-0.5, 0.5].map(|part| self.position + part * self.hub_width)
    }

    /// The inner ring of a bearing, of which the geometry of the balls says about as much as is true of common series: bore
    /// d_m − 1.7 D, shoulders d_m − 0.6 D, width 1.9 D. Of a 6204 these are 20.0, 28.7 and 15.1 mm.
    pub fn inner_ring(mounted: &MountedBearing) -> Self {
        let geometry = &mounted.bearing.geometry;
        let (pitch, ball) = (geometry.pitch_diameter(), geometry.ball_diameter());
        let diameters = [pitch - 0.6 * ball, (pitch - 1.7 * ball).max(0.0)];
        let density = mounted.bearing.ring_material.density;
        Self::of_size(mounted.position, 1.9 * ball, diameters, density)
    }
}

/// An unbalance in a plane of the shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointUnbalance {
    /// Distance from the left end of the shaft, m.
    pub position: f64,
    /// U = m e, kg m.
    pub amount: f64,
    /// Angle from +X at shaft angle 0, rad.
    pub angle: f64,
}

impl PointUnbalance {
    /// As an unbalance of a point of the shaft so far before it, m.
    pub(in crate::rotor) fn about(&self, arm: f64) -> PlaneUnbalance {
        let mut unbalance = PlaneUnbalance::default();
        unbalance.add(self.amount, self.angle, arm);
        unbalance
    }
}

/// A shaft of sections one after the other, with discs. Positions count from its left end.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FlexibleShaft {
    /// Parts of one cross-section each, from the left end on, towards +Z; a density of zero makes a massless one.
    pub sections: Vec<BeamElement>,
    /// Node positions and matrices of another program in place of sections.
    pub matrices: Option<Mesh>,
    /// In any order.
    pub discs: Vec<Disc>,
    /// Unbalances in planes.
    pub unbalances: Vec<PointUnbalance>,
    /// Position whose displacement is recorded, m.
    pub observed: f64,
    /// Modes between the points that forces act at, in each plane; none: as many as the excitation asks for.
    pub modes: Option<usize>,
    /// Time τ of the internal damping τ K, which turns with the shaft, s.
    pub internal_damping: f64,
}

/// Why a shaft cannot be built.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ShaftError {
    /// A position beyond the ends of the shaft.
    #[error(
        "a position of {position} m lies beyond the shaft, which is {length} m long from its left end"
    )]
    Beyond {
        /// The position from the left end, m.
        position: f64,
        /// Length of the shaft, m.
        length: f64,
    },
    /// The matrices cannot be reduced.
    #[error(
        "the shaft cannot be reduced to the {points} points where bearings, loads and unbalances sit: a part of it has no \
         stiffness"
    )]
    Singular {
        /// Number of points that are kept.
        points: usize,
    },
    /// Points without mass or moment of inertia, positions from the left end in m, of a shaft that has some elsewhere.
    #[error(
        "bearings, loads, unbalances or the observed point sit at {}, where the shaft has no mass or no moment of inertia, \
         although it has some between them: put a disc there that has both, or give these nodes some",
        millimetres(.0)
    )]
    Massless(Vec<f64>),
    /// Coordinates without mass follow from the forces on them, and these must not vary by themselves.
    #[error(
        "{0} have no mass or moment of inertia, and damping, an unbalance or a varying load acts there: put a disc there \
         that has both, however small, or take what acts there to a disc"
    )]
    Followers(String),
    /// A point between the nodes of given matrices.
    #[error(
        "no node of the shaft's matrices lies at {position} m: the nearest one is at {nearest} m"
    )]
    NoNode {
        /// The position from the left end, m.
        position: f64,
        /// Of the nearest node, m.
        nearest: f64,
    },
}

/// `0.0 mm, 200.0 mm`.
fn millimetres(positions: &[f64]) -> String {
    let texts = positions.iter().map(|at| format!("{:.1} mm", 1e3 * at));
    texts.collect::<Vec<_>>().join(", ")
}

/// Matrices of one plane of bending: deflection and slope of every node, from the left.
#[derive(Debug, Clone, PartialEq)]
pub struct Plane {
    /// Mass with the rotary inertia about a diameter.
    pub mass: DMatrix<f64>,
    /// Rotary inertia about the axis of the shaft: the gyroscopic matrix couples both planes by it.
    pub polar: DMatrix<f64>,
    /// Of bending and shear.
    pub stiffness: DMatrix<f64>,
}

/// Nodes of a shaft and its matrices in a plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Positions of the nodes from the left end, m.
    pub nodes: Vec<f64>,
    /// Matrices of deflection and slope of the nodes.
    pub plane: Plane,
    /// With hubs, positions of all nodes, those within hubs too, and their deflections and slopes by those of `nodes`.
    pub whole: Option<(Vec<f64>, DMatrix<f64>)>,
}

impl FlexibleShaft {
    /// Length, m.
    pub fn length(&self) -> f64 {
        match &self.matrices {
            Some(mesh) => mesh.nodes.last().map_or(0.0, |last| last - mesh.nodes[0]),
            None => self.sections.iter().map(|section| section.length).sum(),
        }
    }

    /// Mass of sections and discs, kg.
    pub fn mass(&self) -> f64 {
        let sections = self
            .elements_of_sections()
            .map(|(_, element)| element.mass());
        let given = self.matrices.iter();
        let given = given.map(|mesh| Plane::of_motion(&mesh.plane.mass, |_| [1.0, 0.0]));
        let discs = self.discs.iter().map(|disc| disc.mass);
        sections.chain(given).chain(discs).sum()
    }

    /// Moment of inertia about the axis of the shaft, kg m².
    pub fn inertia_polar(&self) -> f64 {
        let of_section = |(_, element): (f64, BeamElement)| {
            2.0 * element.material.density * element.second_moment() * element.length
        };
        let discs = self.discs.iter().map(|disc| disc.inertia_polar);
        let given = self.matrices.iter();
        let given =
            given.map(|mesh| Plane::of_motion(&mesh.plane.polar, |node| [mesh.nodes[node], 1.0]));
        discs
            .chain(self.elements_of_sections().map(of_section))
            .chain(given)
            .sum()
    }

    /// Whether its sections have stiffness and no mass.
    pub(super) fn is_massless(&self) -> bool {
        let mut sections = self.sections.iter();
        !self.sections.is_empty() && sections.all(|section| section.material.density == 0.0)
    }

    /// Positions of its ends, m.
    pub(crate) fn ends(&self) -> [f64; 2] {
        let left = self.matrices.as_ref().map_or(0.0, |mesh| mesh.nodes[0]);
        [left, left + self.length()]
    }

    /// Position of its middle, m; of given matrices that of the node next to it.
    pub(crate) fn middle(&self) -> f64 {
        let [left, right] = self.ends();
        let middle = 0.5 * (left + right);
        self.matrices
            .as_ref()
            .map_or(middle, |mesh| mesh.nodes[mesh.node_at(middle)])
    }

    /// Outer diameter at a position, m: the larger one where sections meet; zero of given matrices.
    pub(crate) fn outer_diameter_at(&self, position: f64) -> f64 {
        let same = self.same_position();
        let here = self.elements_of_sections().filter(|(start, element)| {
            (start - same..=start + element.length + same).contains(&position)
        });
        here.map(|(_, element)| element.outer_diameter)
            .fold(0.0, f64::max)
    }

    /// Moment of inertia about a transverse axis through the centre of mass, were it rigid, kg m².
    pub(crate) fn inertia_transverse(&self) -> f64 {
        let Ok(Mesh { nodes, plane, .. }) = self.mesh(&[], None) else {
            return 0.0;
        };
        let about = |origin: f64| Plane::of_motion(&plane.mass, |node| [nodes[node] - origin, 1.0]);
        // I(a) = I_c + m (a − c)² at three origins
        let mass = self.mass();
        let [left, right] = self.ends();
        let (first, last) = (about(left), about(right));
        let centre = 0.5 * (left + right) + (first - last) / (2.0 * mass * (right - left));
        about(centre)
    }

    /// The parts that discs keep from bending, with the observed point for a node where they hold it.
    pub(super) fn hubs(&self) -> Vec<Hub> {
        let discs = self.discs.iter().filter(|disc| disc.hub_width > 0.0);
        let same = self.same_position();
        let hub = |disc: &Disc| {
            let half = 0.5 * disc.hub_width + same;
            let ends = [disc.position - half, disc.position + half];
            let node = match (ends[0]..=ends[1]).contains(&self.observed) {
                true => self.observed,
                false => disc.position,
            };
            Hub { ends, node }
        };
        discs.map(hub).collect()
    }

    /// Positions nearer than this are one, m.
    pub(super) fn same_position(&self) -> f64 {
        SAME_NODE * self.length()
    }

    /// Every section as one element, with the position of its left end.
    fn elements_of_sections(&self) -> impl Iterator<Item = (f64, BeamElement)> {
        self.sections.iter().scan(0.0, |left, section| {
            let start = *left;
            *left += section.length;
            Some((start, *section))
        })
    }

    /// Beam elements with nodes at the ends of sections, at discs and at `points`, none longer than `longest` in m or,
    /// without it, than a fortieth of the shaft.
    ///
    /// # Errors
    /// [`ShaftError::Beyond`] where a disc or a point lies beyond the shaft.
    pub(super) fn mesh(&self, points: &[f64], longest: Option<f64>) -> Result<Mesh, ShaftError> {
        let length = self.length();
        let same = self.same_position();
        let discs = self.discs.iter().map(|disc| disc.position);
        let mut fixed: Vec<f64> = discs.chain(points.iter().copied()).collect();
        let hubs = self.discs.iter().filter(|disc| disc.hub_width > 0.0);
        fixed.extend(hubs.flat_map(Disc::hub_ends));
        if let Some(&position) = fixed
            .iter()
            .find(|at| !(-same..=length + same).contains(*at))
        {
            return Err(ShaftError::Beyond { position, length });
        }
        if let Some(given) = &self.matrices {
            let off = |at: &&f64| (given.nodes[given.node_at(**at)] - **at).abs() > same;
            if let Some(&position) = fixed.iter().find(off) {
                let nearest = given.nodes[given.node_at(position)];
                return Err(ShaftError::NoNode { position, nearest });
            }
            let whole = given.clone().with_discs(&self.discs);
            return Ok(whole.with_hubs(&self.hubs()));
        }
        fixed.extend(self.elements_of_sections().map(|(start, _)| start));
        fixed.push(length);
        fixed.sort_by(f64::total_cmp);
        fixed.dedup_by(|a, b| *a - *b < same);
        let longest = longest.unwrap_or(length / LEAST_ELEMENTS);
        let nodes = subdivided(&fixed, longest);
        let plane = self.plane(&nodes);
        let whole = None;
        let mesh = Mesh {
            nodes,
            plane,
            whole,
        };
        Ok(mesh.with_discs(&self.discs).with_hubs(&self.hubs()))
    }

    fn plane(&self, nodes: &[f64]) -> Plane {
        let size = 2 * nodes.len();
        let [mut mass, mut polar, mut stiffness] = [(); 3].map(|()| DMatrix::zeros(size, size));
        for (index, ends) in nodes.windows(2).enumerate() {
            let element = self.element_between(ends[0], ends[1]);
            add(&mut stiffness, 1.0, &element.stiffness(), index);
            add(&mut mass, 1.0, &element.translational_inertia(), index);
            add(&mut mass, 1.0, &element.rotary_inertia(), index);
            add(&mut polar, 2.0, &element.rotary_inertia(), index);
        }
        Plane {
            mass,
            polar,
            stiffness,
        }
    }

    /// The element between two neighbouring nodes, with the cross-section of the section that they lie in.
    fn element_between(&self, left: f64, right: f64) -> BeamElement {
        let middle = 0.5 * (left + right);
        let (_, element) = self
            .elements_of_sections()
            .take_while(|(start, _)| *start <= middle)
            .last()
            .unwrap_or_else(|| unreachable!("a mesh has nodes inside its sections"));
        BeamElement {
            length: right - left,
            ..element
        }
    }
}

impl Plane {
    /// `vᵀ A v` of a matrix for the deflections w and slopes θ of a rigid motion at all nodes.
    fn of_motion(matrix: &DMatrix<f64>, motion: impl Fn(usize) -> [f64; 2]) -> f64 {
        let parts = (0..matrix.nrows() / 2).flat_map(motion);
        let motion = DVector::from_iterator(matrix.nrows(), parts);
        motion.dot(&(matrix * &motion))
    }
}

impl Mesh {
    /// With discs at the nodes.
    fn with_discs(mut self, discs: &[Disc]) -> Self {
        for disc in discs {
            let slope = 2 * self.node_at(disc.position) + 1;
            self.plane.mass[(slope - 1, slope - 1)] += disc.mass;
            self.plane.mass[(slope, slope)] += disc.inertia_transverse;
            self.plane.polar[(slope, slope)] += disc.inertia_polar;
        }
        self
    }

    /// With one node for each hub, which the nodes within it follow as parts of a rigid body.
    fn with_hubs(self, hubs: &[Hub]) -> Self {
        if hubs.is_empty() {
            return self;
        }
        let followed: Vec<f64> = self
            .nodes
            .iter()
            .map(|at| Hub::node_of(hubs, *at))
            .collect();
        let mut nodes = followed.clone();
        nodes.dedup();
        let mut carried = DMatrix::zeros(2 * followed.len(), 2 * nodes.len());
        let mut node = 0;
        for (row, (at, followed)) in self.nodes.iter().zip(&followed).enumerate() {
            node += usize::from(nodes[node] != *followed);
            // w = w_c + a θ_c, θ = θ_c
            carried[(2 * row, 2 * node)] = 1.0;
            carried[(2 * row, 2 * node + 1)] = at - followed;
            carried[(2 * row + 1, 2 * node + 1)] = 1.0;
        }
        let reduce = |matrix: &DMatrix<f64>| carried.tr_mul(&(matrix * &carried));
        Self {
            plane: Plane {
                mass: reduce(&self.plane.mass),
                polar: reduce(&self.plane.polar),
                stiffness: reduce(&self.plane.stiffness),
            },
            nodes,
            whole: Some((self.nodes, carried)),
        }
    }

    /// Index of the node at a position.
    pub fn node_at(&self, position: f64) -> usize {
        let after = self.nodes.partition_point(|node| *node < position);
        let distance = |index: &usize| {
            let node = self.nodes.get(*index);
            node.map_or(f64::INFINITY, |at| (at - position).abs())
        };
        [after, after.saturating_sub(1)]
            .into_iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .unwrap_or(0)
    }
}

impl Hub {
    /// Position of the node that a position moves with: itself outside all hubs.
    pub fn node_of(hubs: &[Self], position: f64) -> f64 {
        let mut hubs = hubs.iter();
        let hub = hubs.find(|own| (own.ends[0]..=own.ends[1]).contains(&position));
        hub.map_or(position, |own| own.node)
    }
}

/// Positions with others evenly between them, none farther apart than `longest`.
fn subdivided(fixed: &[f64], longest: f64) -> Vec<f64> {
    let mut nodes = vec![0.0];
    for ends in fixed.windows(2) {
        let parts = ((ends[1] - ends[0]) / longest).ceil().max(1.0);
        let step = (ends[1] - ends[0]) / parts;
        nodes.extend((1..parts as usize).map(|part| ends[0] + part as f64 * step));
        nodes.push(ends[1]);
    }
    nodes
}

/// Adds a matrix of the element behind node `index`.
fn add(sum: &mut DMatrix<f64>, factor: f64, element: &ElementMatrix, index: usize) {
    for (row, entries) in element.iter().enumerate() {
        for (column, entry) in entries.iter().enumerate() {
            sum[(2 * index + row, 2 * index + column)] += factor * entry;
        }
    }
}
