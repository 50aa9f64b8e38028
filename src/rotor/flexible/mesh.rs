//! Sections and discs as beam elements between nodes, in one plane of bending.

use nalgebra::{DMatrix, DVector};

use super::disc::Disc;
use super::shaft_error::ShaftError;
use crate::physics::{BeamElement, ElementMatrix};
use crate::rotor::PlaneUnbalance;

/// Positions nearer than this part of the shaft's length are one node.
const SAME_NODE: f64 = 1e-9;
/// Fewest elements of a shaft: the lowest ten frequencies are then those of the beam to 1e-4.
const LEAST_ELEMENTS: f64 = 40.0;

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

    /// Whether a position in m lies on it, up to the round-off of lengths that add up.
    pub(crate) fn reaches(&self, position: f64) -> bool {
        let [left, right] = self.ends();
        let slack = self.slack();
        (left - slack..=right + slack).contains(&position)
    }

    /// Distance within which two positions are the same, m.
    pub(crate) fn slack(&self) -> f64 {
        SAME_NODE * self.length()
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
