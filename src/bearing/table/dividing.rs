//! Strips along the approach, from the exact law.

use super::cells::ROOT_TERMS;
use super::compile::Draft;
use super::polynomial::{lobatto, weights_at};
use super::reduced::{Reduced, between, difference, part_place, weighted};
use super::strips::BINS;
use crate::bearing::BallLaw;

/// Nodes along the approach of a strip in which the exact law is asked.
const STRIP_NODES: usize = 8;
/// Most strips of a table into which one of those is divided.
const FINEST: usize = 32;

/// A strip in which one polynomial of high degree is exact enough.
pub(super) struct WideStrip {
    first_bin: usize,
    next_bin: usize,
    /// Forces over f at its nodes in all columns.
    rows: Vec<Vec<Reduced>>,
    /// Fewest equal parts in which polynomials of low degree follow that of high degree.
    pub(super) parts: usize,
}

impl WideStrip {
    /// Its width.
    pub(super) fn bins(&self) -> usize {
        self.next_bin - self.first_bin
    }
}

/// Strips of a table, and what their polynomials go through.
pub(super) struct Divided {
    pub(super) first_bins: Vec<usize>,
    /// v at their nodes; strips side by side share one.
    pub(super) roots: Vec<f64>,
    /// Forces over f at the nodes in all columns.
    pub(super) values: Vec<Vec<Reduced>>,
}

impl<L: BallLaw + Clone> Draft<'_, L> {
    /// Wide strips: halves of halves of the range, in each of which one polynomial of high degree is exact enough.
    pub(super) fn wide_strips(&self) -> Vec<WideStrip> {
        let mut strips: Vec<WideStrip> = Vec::new();
        let mut waiting = vec![(0, BINS)];
        while let Some((first, next)) = waiting.pop() {
            let [low, high] = [first, next].map(|bin| self.bin_root(bin));
            if next - first > 1 && !self.fits(low, high) {
                let middle = first.midpoint(next);
                waiting.push((middle, next));
                waiting.push((first, middle));
                continue;
            }
            let root = |x: f64| 0.5 * (low + high) + 0.5 * (high - low) * x;
            let border = strips.last().and_then(|strip| strip.rows.last().cloned());
            let mut rows = vec![border.unwrap_or_else(|| self.row(low))];
            rows.extend((1..STRIP_NODES).map(|node| self.row(root(lobatto(node, STRIP_NODES)))));
            strips.push(WideStrip {
                first_bin: first,
                next_bin: next,
                parts: self.parts(&rows, [low, high], FINEST.min(next - first)),
                rows,
            });
        }
        strips
    }

    /// v at the start of a bin.
    fn bin_root(&self, bin: usize) -> f64 {
        let [start, end] = self.limits.roots;
        start + (end - start) * (bin as f64 / BINS as f64)
    }

    /// The wide strips in so many equal parts each: the table's strips, their polynomials of low degree taken from
    /// those of the wide ones.
    pub(super) fn divided(
        &self,
        wide: &[WideStrip],
        parts: impl Fn(&WideStrip) -> usize,
    ) -> Divided {
        let (mut first_bins, mut roots, mut values) = (Vec::new(), Vec::new(), Vec::new());
        for strip in wide {
            let [low, high] = [strip.first_bin, strip.next_bin].map(|bin| self.bin_root(bin));
            let parts = parts(strip);
            for part in 0..parts {
                first_bins.push(strip.first_bin + part * strip.bins() / parts);
                for node in 0..ROOT_TERMS - 1 {
                    let x = part_place(part, parts, lobatto(node, ROOT_TERMS));
                    roots.push(0.5 * (low + high) + 0.5 * (high - low) * x);
                    values.push(between(&strip.rows, x));
                }
            }
        }
        roots.push(self.bin_root(BINS));
        values.extend(wide.last().and_then(|strip| strip.rows.last().cloned()));
        Divided {
            first_bins,
            roots,
            values,
        }
    }

    /// Fewest equal parts of a wide strip in which polynomials of low degree follow that of high
    /// degree through `rows`.
    fn parts(&self, rows: &[Vec<Reduced>], [low, high]: [f64; 2], most: usize) -> usize {
        let follows = |parts: usize| {
            (0..parts).all(|part| {
                let nodes: [Vec<f64>; ROOT_TERMS] = std::array::from_fn(|node| {
                    weights_at(
                        part_place(part, parts, lobatto(node, ROOT_TERMS)),
                        STRIP_NODES,
                    )
                });
                [0.0, 0.8].into_iter().all(|x| {
                    let place = part_place(part, parts, x);
                    let difference = difference(
                        &weights_at(x, ROOT_TERMS),
                        &nodes,
                        &weights_at(place, STRIP_NODES),
                    );
                    let root = 0.5 * (low + high) + 0.5 * (high - low) * place;
                    (0..self.columns).all(|column| {
                        let values = rows.iter().map(|row| row[column]);
                        self.is_small(&weighted(values, &difference), root)
                    })
                })
            })
        };
        let mut parts = 1;
        while parts < most && !follows(parts) {
            parts *= 2;
        }
        parts
    }

    /// Forces over f at v in all columns.
    fn row(&self, root: f64) -> Vec<Reduced> {
        (0..self.columns)
            .map(|column| self.reduced(lobatto(column, self.columns), root))
            .collect()
    }

    /// Whether one polynomial in v serves from `low` to `high`, seen at both ends of the span and in
    /// its middle, between the nodes.
    fn fits(&self, low: f64, high: f64) -> bool {
        let root = |x: f64| 0.5 * (low + high) + 0.5 * (high - low) * x;
        [0.0, -1.0, 1.0].into_iter().all(|along| {
            let nodes: [Reduced; STRIP_NODES] =
                std::array::from_fn(|index| self.reduced(along, root(lobatto(index, STRIP_NODES))));
            [0.0, -0.7, 0.7].into_iter().all(|x| {
                let exact = self.reduced(along, root(x));
                let own = weighted(nodes.into_iter(), &weights_at(x, STRIP_NODES));
                let error = std::array::from_fn(|output| own[output] - exact[output]);
                self.is_small(&error, root(x))
            })
        })
    }
}
