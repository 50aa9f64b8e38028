//! Craig–Bampton reduction of a plane: the points that forces act at, and the lowest modes between them.

use nalgebra::DMatrix;

use super::ShaftError;
use super::mesh::{Mesh, Plane};

/// Modes whose 1/ω² is below this part of the largest have no mass to speak of.
const MASSLESS: f64 = 1e-12;

/// A plane in few coordinates: deflection and slope of the points that forces act at, in their order, and behind them the
/// lowest modes of the shaft with all these points fixed.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::rotor) struct ReducedShaft {
    /// Positions of all nodes, m.
    pub nodes: Vec<f64>,
    /// Deflection and slope of all nodes by the coordinates that are kept.
    pub transformation: DMatrix<f64>,
    pub plane: Plane,
    /// Number of modes.
    pub modes: usize,
    /// Angular frequency of the lowest mode that is left out, rad/s; none where all are kept.
    pub left_out: Option<f64>,
}

impl ReducedShaft {
    /// Largest deflection of a node by a share of one of a mode, m.
    pub fn largest_deflection(&self, mode: usize) -> f64 {
        let first = self.transformation.ncols() - self.modes;
        let shape = self.transformation.column(first + mode);
        shape
            .iter()
            .step_by(2)
            .fold(0.0, |largest: f64, part| largest.max(part.abs()))
    }
}

impl Mesh {
    /// Keeps the points at `positions` and so many modes as `count` says by the angular frequencies of all.
    ///
    /// ```text
    /// q = T (q_b, η),   T = [ I 0 ; −K_ii⁻¹ K_ib  Φ ],   K_ii Φ = M_ii Φ Λ,   Φᵀ M_ii Φ = I
    /// ```
    ///
    /// There are fewer modes where the shaft has no more inside. Static deflections under forces at the points, and the
    /// inertia of motions as a rigid body, are exact with any number of modes.
    ///
    /// Source: R. R. Craig & M. C. C. Bampton, *AIAA J.* 6 (1968) 1313–1319.
    ///
    /// # Errors
    /// [`ShaftError::Singular`] where the inside is not held by the points, [`ShaftError::Massless`] where some of them have
    /// no inertia and the inside has.
    pub(in crate::rotor) fn reduced(
        self,
        positions: &[f64],
        count: impl Fn(&[f64]) -> usize,
    ) -> Result<ReducedShaft, ShaftError> {
        let kept: Vec<usize> = positions.iter().map(|at| self.node_at(*at)).collect();
        let inside = (0..self.nodes.len()).filter(|node| !kept.contains(node));
        let inertia_inside = inside.flat_map(|node| self.inertia_at(node));
        let lack = |node: &&usize| self.inertia_at(**node).contains(&0.0);
        let massless = kept.iter().filter(lack).map(|node| self.nodes[*node]);
        let massless: Vec<f64> = massless.collect();
        if !massless.is_empty() && inertia_inside.fold(0.0, f64::max) > 0.0 {
            return Err(ShaftError::Massless(massless));
        }
        let singular = ShaftError::Singular {
            points: positions.len(),
        };
        let (transformation, left_out) = self.transformation(positions, count).ok_or(singular)?;
        let modes = transformation.ncols() - 2 * positions.len();
        let reduce = |matrix: &DMatrix<f64>| {
            let reduced = transformation.tr_mul(&(matrix * &transformation));
            // what round-off leaves of the symmetry
            0.5 * (&reduced + reduced.transpose())
        };
        let plane = Plane {
            mass: reduce(&self.plane.mass),
            polar: reduce(&self.plane.polar),
            stiffness: reduce(&self.plane.stiffness),
        };
        let (nodes, transformation) = match self.whole {
            None => (self.nodes, transformation),
            Some((nodes, carried)) => (nodes, carried * transformation),
        };
        Ok(ReducedShaft {
            modes,
            left_out,
            nodes,
            transformation,
            plane,
        })
    }

    /// Mass and moment of inertia of a node.
    fn inertia_at(&self, node: usize) -> [f64; 2] {
        [2 * node, 2 * node + 1].map(|row| self.plane.mass[(row, row)])
    }

    /// T, a row for each deflection and slope of the nodes, and the angular frequency of the lowest mode left out.
    fn transformation(
        &self,
        positions: &[f64],
        count: impl Fn(&[f64]) -> usize,
    ) -> Option<(DMatrix<f64>, Option<f64>)> {
        let points = positions.iter().map(|position| self.node_at(*position));
        let boundary: Vec<usize> = points.flat_map(|node| [2 * node, 2 * node + 1]).collect();
        let size = 2 * self.nodes.len();
        let interior: Vec<usize> = (0..size).filter(|row| !boundary.contains(row)).collect();
        let mut transformation = DMatrix::zeros(size, boundary.len());
        for (column, row) in boundary.iter().enumerate() {
            transformation[(*row, column)] = 1.0;
        }
        if interior.is_empty() {
            return Some((transformation, None));
        }
        let inside = |matrix: &DMatrix<f64>, columns: &[usize]| {
            matrix.select_rows(&interior).select_columns(columns)
        };
        let Plane {
            mass, stiffness, ..
        } = &self.plane;
        let inner_stiffness = inside(stiffness, &interior).cholesky()?;
        let followed = inner_stiffness.solve(&inside(stiffness, &boundary));
        let (shapes, left_out) =
            lowest_modes(&inside(mass, &interior), &inner_stiffness.l(), count)?;
        let kept = boundary.len();
        transformation = transformation.resize_horizontally(kept + shapes.ncols(), 0.0);
        for (inner, row) in interior.iter().enumerate() {
            let mut row = transformation.row_mut(*row);
            row.columns_mut(0, kept).copy_from(&-followed.row(inner));
            row.columns_mut(kept, shapes.ncols())
                .copy_from(&shapes.row(inner));
        }
        Some((transformation, left_out))
    }
}

/// The lowest modes of `K φ = ω² M φ` with φᵀ M φ = 1, where K = L Lᵀ: `count` says how many by the frequencies of all in
/// rad/s, lowest first. With the frequency of the first one that is not among them. The mass may be singular.
fn lowest_modes(
    mass: &DMatrix<f64>,
    factor: &DMatrix<f64>,
    count: impl Fn(&[f64]) -> usize,
) -> Option<(DMatrix<f64>, Option<f64>)> {
    // L⁻¹ M L⁻ᵀ has the eigenvalues 1/ω², the largest of which are the most exact
    let half = factor.solve_lower_triangular(mass)?;
    let compliance = factor.solve_lower_triangular(&half.transpose())?;
    let symmetric = 0.5 * (&compliance + compliance.transpose());
    let modes = symmetric.symmetric_eigen();
    let least = MASSLESS * modes.eigenvalues.amax();
    let mut order: Vec<usize> = (0..modes.eigenvalues.len())
        .filter(|mode| modes.eigenvalues[*mode] > least)
        .collect();
    order.sort_by(|a, b| modes.eigenvalues[*b].total_cmp(&modes.eigenvalues[*a]));
    let frequency = |mode: &usize| 1.0 / modes.eigenvalues[*mode].sqrt();
    let frequencies: Vec<f64> = order.iter().map(frequency).collect();
    order.truncate(count(&frequencies));
    let left_out = frequencies.get(order.len()).copied();
    let mut shapes = DMatrix::zeros(mass.nrows(), order.len());
    for (column, mode) in order.into_iter().enumerate() {
        let shape = factor.tr_solve_lower_triangular(&modes.eigenvectors.column(mode))?;
        // the largest deflection points along the axis, so that shapes do not turn with round-off
        let sign = shape[shape.iamax()].signum();
        shapes.set_column(column, &(shape * (sign / modes.eigenvalues[mode].sqrt())));
    }
    Some((shapes, left_out))
}

#[cfg(test)]
#[path = "reduction_tests.rs"]
mod tests;
