//! Craig–Bampton reduction of a plane: the points that forces act at, and the lowest modes between them.

use nalgebra::{DMatrix, RowDVector};

use super::ShaftError;
use super::mesh::{Mesh, Plane};

/// Modes whose 1/ω² is below this part of the largest have no mass to speak of.
const MASSLESS: f64 = 1e-12;

/// Fewest modes of a plane where their number follows from the excitation.
const LEAST_MODES: usize = 4;
/// Most of them.
const MOST_MODES: usize = 20;

/// A plane in few coordinates: deflection and slope of the points that something acts at or that are observed, in their
/// order, and behind them shares of modes.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::rotor) struct Reduction {
    /// Positions of all nodes, m.
    pub nodes: Vec<f64>,
    /// Deflection and slope of all nodes by the coordinates that are kept.
    pub transformation: DMatrix<f64>,
    pub plane: Plane,
    /// Number of modes with the held points fixed.
    pub modes: usize,
    /// Number of coordinates that are shares of modes.
    pub shares: usize,
}

impl Reduction {
    /// Largest deflection of a node by one of a share of modes, m.
    pub fn largest_deflection(&self, share: usize) -> f64 {
        let first = self.transformation.ncols() - self.shares;
        let shape = self.transformation.column(first + share);
        shape
            .iter()
            .step_by(2)
            .fold(0.0, |largest: f64, part| largest.max(part.abs()))
    }
}

/// Points of a shaft whose deflection and slope are coordinates.
#[derive(Debug, Clone, Copy)]
pub(in crate::rotor) struct Points<'a> {
    /// Positions, m.
    pub positions: &'a [f64],
    /// Which of them bearings hold: modes are those with these fixed, and forces there act exactly.
    pub held: &'a [bool],
}

impl Mesh {
    /// Keeps some points and so many modes, or as many as the other points ask for, two each.
    ///
    /// ```text
    /// q = T (q_b, η),   T = [ I 0 ; −K_ii⁻¹ K_ib  Φ ],   K_ii Φ = M_ii Φ Λ,   Φᵀ M_ii Φ = I
    /// ```
    ///
    /// with q_b of the held points. Deflection and slope of the other points, linear in q_b and η, take the place of as many
    /// η: the motions that are possible stay the same. Were they held, too, the shaft between neighbouring points would be
    /// short and stiff, and the steps of an explicit method with it.
    ///
    /// Fewer modes stand where the shaft has no more inside. Static deflections under forces at the held points, and the
    /// inertia of motions as a rigid body, are exact with any number of modes.
    ///
    /// Source: R. R. Craig & M. C. C. Bampton, *AIAA J.* 6 (1968) 1313–1319.
    ///
    /// # Errors
    /// [`ShaftError::Singular`] where the inside is not held by the points.
    pub(in crate::rotor) fn reduced(
        self,
        points: Points<'_>,
        modes: usize,
    ) -> Result<Reduction, ShaftError> {
        self.reduced_to(points, |_| modes)
    }

    /// The same with the modes below an angular frequency in rad/s, but at least four and at most twenty.
    pub(in crate::rotor) fn reduced_below(
        self,
        points: Points<'_>,
        frequency: f64,
    ) -> Result<Reduction, ShaftError> {
        self.reduced_to(points, |frequencies| {
            let below = frequencies.iter().filter(|own| **own < frequency).count();
            below.clamp(LEAST_MODES, MOST_MODES)
        })
    }

    fn reduced_to(
        self,
        points: Points<'_>,
        count: impl Fn(&[f64]) -> usize,
    ) -> Result<Reduction, ShaftError> {
        let Points { positions, held } = points;
        let free = 2 * held.iter().filter(|held| !**held).count();
        let of_bearings: Vec<f64> = positions
            .iter()
            .zip(held)
            .filter(|(_, held)| **held)
            .map(|(position, _)| *position)
            .collect();
        let enough = |frequencies: &[f64]| count(frequencies).max(free);
        let (transformation, modes) = match self
            .transformation(&of_bearings, enough)
            .and_then(|(by_modes, modes)| Some((self.with_points(&by_modes, points)?, modes)))
        {
            Some(found) => found,
            // points that the modes cannot tell from the bearings are held, too
            None => self
                .transformation(positions, count)
                .ok_or(ShaftError::Singular {
                    points: positions.len(),
                })?,
        };
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
        Ok(Reduction {
            nodes: self.nodes,
            shares: transformation.ncols() - 2 * positions.len(),
            transformation,
            plane,
            modes,
        })
    }

    /// T by the deflections and slopes of all points and the shares that are left, of the T by those of held points and
    /// modes; none where the modes do not tell the other points from the held ones.
    fn with_points(&self, by_modes: &DMatrix<f64>, points: Points<'_>) -> Option<DMatrix<f64>> {
        let Points { positions, held } = points;
        let size = by_modes.ncols();
        let row = |position: f64, slope: usize| by_modes.row(2 * self.node_at(position) + slope);
        // the new coordinates by the old ones: rows of points, then the shares that are kept
        let mut rows: Vec<_> = Vec::new();
        for position in positions {
            rows.extend([0, 1].map(|slope| row(*position, slope).into_owned()));
        }
        let bearings = 2 * held.iter().filter(|held| **held).count();
        let others = positions.iter().zip(held).filter(|(_, held)| !**held);
        let lever = self.nodes.last()? - self.nodes.first()?;
        let modal: Vec<_> = others
            .flat_map(|(position, _)| {
                [(0, 1.0), (1, lever)].map(|(slope, unit)| (*position, slope, unit))
            })
            .map(|(position, slope, unit)| {
                unit * row(position, slope).columns(bearings, size - bearings)
            })
            .collect();
        let replaced = independent_columns(&modal)?;
        for share in (0..size - bearings).filter(|share| !replaced.contains(share)) {
            let unit = |_, column| f64::from(u8::from(column == bearings + share));
            rows.push(DMatrix::from_fn(1, size, unit).row(0).into_owned());
        }
        let new_by_old = DMatrix::from_rows(&rows);
        Some(by_modes * new_by_old.try_inverse()?)
    }

    /// T, a row for each deflection and slope of the nodes, with the points at `positions` held, and the number of its modes;
    /// of all their frequencies, lowest first, `count` says how many.
    fn transformation(
        &self,
        positions: &[f64],
        count: impl Fn(&[f64]) -> usize,
    ) -> Option<(DMatrix<f64>, usize)> {
        let points = positions.iter().map(|position| self.node_at(*position));
        let boundary: Vec<usize> = points.flat_map(|node| [2 * node, 2 * node + 1]).collect();
        let size = 2 * self.nodes.len();
        let interior: Vec<usize> = (0..size).filter(|row| !boundary.contains(row)).collect();
        let Plane {
            mass, stiffness, ..
        } = &self.plane;
        let mut transformation = DMatrix::zeros(size, boundary.len());
        for (column, row) in boundary.iter().enumerate() {
            transformation[(*row, column)] = 1.0;
        }
        if interior.is_empty() {
            return Some((transformation, 0));
        }
        let inner_stiffness = block(stiffness, &interior, &interior).cholesky()?;
        let followed = inner_stiffness.solve(&block(stiffness, &interior, &boundary));
        let shapes = lowest_modes(
            &block(mass, &interior, &interior),
            &inner_stiffness.l(),
            count,
        )?;
        transformation = transformation.resize_horizontally(boundary.len() + shapes.ncols(), 0.0);
        for (inner, row) in interior.iter().enumerate() {
            for column in 0..boundary.len() {
                transformation[(*row, column)] = -followed[(inner, column)];
            }
            for mode in 0..shapes.ncols() {
                transformation[(*row, boundary.len() + mode)] = shapes[(inner, mode)];
            }
        }
        Some((transformation, shapes.ncols()))
    }
}

/// Least independent part of a point's deflections by modes, of the largest: points nearer to bearings are held, too.
const DISTINCT: f64 = 1e-2;

/// As many columns of some rows as there are rows, each as independent of the others as can be.
fn independent_columns(rows: &[RowDVector<f64>]) -> Option<Vec<usize>> {
    if rows.is_empty() {
        return Some(Vec::new());
    }
    let mut left = DMatrix::from_rows(rows);
    let largest = left
        .column_iter()
        .map(|column| column.norm())
        .fold(0.0, f64::max);
    let mut found = Vec::new();
    for _ in rows {
        let norms = left.column_iter().map(|column| column.norm());
        let (best, norm) = norms.enumerate().max_by(|a, b| a.1.total_cmp(&b.1))?;
        if norm <= DISTINCT * largest {
            return None;
        }
        let direction = left.column(best) / norm;
        let shares = direction.tr_mul(&left);
        left -= &direction * shares;
        found.push(best);
    }
    Some(found)
}

/// The lowest modes of `K φ = ω² M φ` with φᵀ M φ = 1, where K = L Lᵀ: of all frequencies in rad/s, lowest first, `count`
/// says how many. The mass may be singular.
fn lowest_modes(
    mass: &DMatrix<f64>,
    factor: &DMatrix<f64>,
    count: impl Fn(&[f64]) -> usize,
) -> Option<DMatrix<f64>> {
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
    let mut shapes = DMatrix::zeros(mass.nrows(), order.len());
    for (column, mode) in order.into_iter().enumerate() {
        let shape = factor.tr_solve_lower_triangular(&modes.eigenvectors.column(mode))?;
        // the largest deflection points along the axis, so that shapes do not turn with round-off
        let sign = shape[shape.iamax()].signum();
        shapes.set_column(column, &(shape * (sign / modes.eigenvalues[mode].sqrt())));
    }
    Some(shapes)
}

fn block(matrix: &DMatrix<f64>, rows: &[usize], columns: &[usize]) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), columns.len(), |row, column| {
        matrix[(rows[row], columns[column])]
    })
}

#[cfg(test)]
#[path = "reduction_tests.rs"]
mod tests;
