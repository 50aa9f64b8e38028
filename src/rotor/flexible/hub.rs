//! Hubs: parts of a shaft that their discs keep from bending.

use nalgebra::DMatrix;

use super::disc::Disc;
use super::mesh::{FlexibleShaft, Mesh, Plane};

/// A part of the shaft that does not bend: what lies within it moves with its node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Hub {
    ends: [f64; 2],
    node: f64,
}

impl Hub {
    /// Position of the node that a position moves with: itself outside all hubs.
    pub fn node_of(hubs: &[Self], position: f64) -> f64 {
        let mut hubs = hubs.iter();
        let hub = hubs.find(|own| (own.ends[0]..=own.ends[1]).contains(&position));
        hub.map_or(position, |own| own.node)
    }
}

impl FlexibleShaft {
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
}

impl Mesh {
    /// With one node for each hub, which the nodes within it follow as parts of a rigid body.
    pub(super) fn with_hubs(self, hubs: &[Hub]) -> Self {
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
}
