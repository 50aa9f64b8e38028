//! Cells along |A1|, and the polynomials of all cells.

use super::cells::{AXIAL_TERMS, CoupleCell, ForceCell, ROOT_TERMS};
use super::compile::Draft;
use super::dividing::{Divided, WideStrip};
use super::polynomial::{lobatto, power_weights, weights_at};
use super::reduced::{Reduced, difference, part_place, powers_along_root, weighted};
use super::strips::BINS;
use crate::bearing::BallLaw;

/// Most cells along |A1|.
const MOST_ACROSS: usize = 64;
/// Most cells of a table whose strips are all alike.
const MOST_EVEN_CELLS: usize = 8192;

/// How a cell comes from the columns.
pub(super) struct CellColumns {
    /// Weights of the coefficients of t⁰ … t³.
    powers: [Vec<f64>; AXIAL_TERMS],
    /// Weights of its errors between the nodes.
    errors: [Vec<f64>; 2],
}

/// Strips that are all alike.
pub(super) struct Evenly {
    /// Bins in each.
    pub(super) width: usize,
    /// Cells along |A1| of each.
    pub(super) across: usize,
}

impl Evenly {
    /// Of the width of the narrowest parts of wide strips and with as many cells as any part has; none where that
    /// is too much.
    pub(super) fn of(wide: &[WideStrip], across: &[usize]) -> Option<Self> {
        let width = wide.iter().map(|strip| strip.bins() / strip.parts).min()?;
        let across = across.iter().copied().max()?;
        (BINS / width * across <= MOST_EVEN_CELLS).then_some(Self { width, across })
    }
}

impl<L: BallLaw + Clone> Draft<'_, L> {
    /// Of each number of cells along |A1| that a strip may have, 1, 2, 4 …, how they come from the
    /// columns.
    pub(super) fn columns_of_cells(&self) -> Vec<Vec<CellColumns>> {
        let numbers = std::iter::successors(Some(1), |across| Some(2 * across));
        numbers
            .take_while(|&across| across <= MOST_ACROSS)
            .map(|across| {
                (0..across)
                    .map(|cell| {
                        let nodes = self.node_weights(cell, across);
                        let errors = [0.0, 0.8].map(|x| {
                            let exact = weights_at(part_place(cell, across, x), self.columns);
                            difference(&weights_at(x, AXIAL_TERMS), &nodes, &exact)
                        });
                        let powers = combined(&power_weights_of_halves(), &nodes);
                        CellColumns { powers, errors }
                    })
                    .collect()
            })
            .collect()
    }

    /// Of every strip the fewest cells along |A1| whose polynomials follow the columns.
    pub(super) fn across(
        &self,
        Divided { roots, values, .. }: &Divided,
        columns: &[Vec<CellColumns>],
    ) -> Vec<usize> {
        let follows = |node: usize, cells: &Vec<CellColumns>| {
            cells.iter().flat_map(|cell| &cell.errors).all(|weights| {
                let error = weighted(values[node].iter().copied(), weights);
                self.is_small(&error, roots[node])
            })
        };
        (0..values.len() / (ROOT_TERMS - 1))
            .map(|strip| {
                let first = strip * (ROOT_TERMS - 1);
                let fits = |cells: &&Vec<CellColumns>| {
                    (first..first + ROOT_TERMS).all(|node| follows(node, cells))
                };
                columns.iter().find(fits).map_or(MOST_ACROSS, Vec::len)
            })
            .collect()
    }

    /// Weights of the columns at the nodes of a cell along |A1|.
    fn node_weights(&self, cell: usize, across: usize) -> [Vec<f64>; AXIAL_TERMS] {
        std::array::from_fn(|node| {
            let x = lobatto(node, AXIAL_TERMS);
            weights_at(part_place(cell, across, x), self.columns)
        })
    }

    /// The polynomials of all cells, strip by strip; those of couples where `COUPLE` says so.
    pub(super) fn cells<const COUPLE: bool>(
        &self,
        Divided { values, .. }: &Divided,
        across: &[usize],
        columns: &[Vec<CellColumns>],
    ) -> (Vec<ForceCell>, Vec<CoupleCell>) {
        let by_root = power_weights_of_halves::<ROOT_TERMS>();
        let count = across.iter().sum();
        let mut forces = Vec::with_capacity(count);
        let mut couples = Vec::with_capacity(if COUPLE { count } else { 0 });
        for (strip, across) in across.iter().enumerate() {
            let first = strip * (ROOT_TERMS - 1);
            for CellColumns { powers, .. } in &columns[across.ilog2() as usize] {
                let rows: [[Reduced; AXIAL_TERMS]; ROOT_TERMS] = std::array::from_fn(|root| {
                    let row = &values[first + root];
                    std::array::from_fn(|l| weighted(row.iter().copied(), &powers[l]))
                });
                let terms = powers_along_root(&rows, &by_root);
                forces.push(ForceCell(terms.map(|row| {
                    let pair = |l: usize| [row[l][0], row[l][1], row[l + 1][0], row[l + 1][1]];
                    [pair(0), pair(2)]
                })));
                if COUPLE {
                    let couple = terms.map(|row| row.map(|term| term[2] * self.arm));
                    couples.push(CoupleCell(couple));
                }
            }
        }
        (forces, couples)
    }
}

/// Weights as [`power_weights`], for the powers of half of the coordinate from −1 to 1.
fn power_weights_of_halves<const N: usize>() -> [[f64; N]; N] {
    let mut weights = power_weights::<N>();
    for (power, row) in weights.iter_mut().enumerate() {
        row.iter_mut()
            .for_each(|weight| *weight *= f64::powi(2.0, power as i32));
    }
    weights
}

/// Weights of sums, by weights `of`, of what has weights of its own.
fn combined(
    of: &[[f64; AXIAL_TERMS]; AXIAL_TERMS],
    own: &[Vec<f64>; AXIAL_TERMS],
) -> [Vec<f64>; AXIAL_TERMS] {
    of.map(|weights| {
        (0..own[0].len())
            .map(|column| {
                weights
                    .iter()
                    .zip(own)
                    .map(|(weight, own)| weight * own[column])
                    .sum()
            })
            .collect()
    })
}
