//! From an exact law to its table.

use super::ball_table::BallTable;
use super::cells::{AXIAL_TERMS, CoupleCell, ForceCell, ROOT_TERMS};
use super::counted::Counted;
use super::law::TableLaw;
use super::limits::Limits;
use super::polynomial::{lobatto, power_weights, weights_at};
use super::reduced::{Reduced, between, difference, part_place, powers, weighted};
use super::region::BallRegion;
use super::report::{TableError, TableReport};
use super::strips::{BINS, Strips};
use crate::bearing::BallLaw;

/// Load at which a ball counts as lifted off, of the largest one.
const LIFTED_SHARE: f64 = 1e-14;
/// Share of the tolerance that each step of the interpolation may use.
const STEP_SHARE: f64 = 0.25;
/// Numbers of places along |A1| at which the exact law is asked, one attempt after the other.
const COLUMNS: [usize; 3] = [11, 18, 30];
/// Most cells along |A1|.
const MOST_ACROSS: usize = 64;
/// Offset places at which the error is measured.
const PROBES: usize = 1500;
/// Most cells of a table.
const MOST_CELLS: usize = 16_384;
/// Nodes along the approach of a strip in which the exact law is asked.
const STRIP_NODES: usize = 8;
/// Least width of the region over its distance from zero: in a narrower one rounding would count in bins.
const NARROWEST: f64 = 1e-3;
/// Most strips of a table into which one of those is divided.
const FINEST: usize = 32;

impl<L: BallLaw + Clone, const COUPLE: bool> TableLaw<L, COUPLE> {
    /// Compiles `law` at a shaft speed in rad/s over a region, so that no force differs by more than
    /// `tolerance` times `load` in N. A couple may differ by that times the distance of the groove
    /// centres.
    ///
    /// # Errors
    /// [`TableError`] where the region is none or too narrow, or the law does not allow for the tolerance.
    pub fn compile(
        law: L,
        region: BallRegion,
        speed: f64,
        load: f64,
        tolerance: f64,
    ) -> Result<(Self, TableReport), TableError> {
        let counted = Counted::new(&law, speed);
        let mut failure = TableError::NoRegion;
        for columns in COLUMNS {
            let draft = Draft::new(&counted, region, columns, load, tolerance)?;
            let table = draft.table::<COUPLE>(&law)?;
            let error = draft.error_of(&table);
            let cells = table.table.forces.len();
            let relative_error = error / load;
            if relative_error <= tolerance {
                let evaluations = counted.evaluations();
                let report = TableReport {
                    error,
                    relative_error,
                    cells,
                    evaluations,
                };
                return Ok((table, report));
            }
            failure = TableError::Tolerance {
                relative_error,
                cells,
            };
        }
        Err(failure)
    }
}

/// A table in the making: the coordinates, and how exact it is to be.
struct Draft<'a, L> {
    law: &'a Counted<'a, L>,
    /// Where a ring's balls may be looked up.
    region: BallRegion,
    limits: Limits,
    columns: usize,
    /// Error that each step may make, N.
    step: f64,
    /// Arm by which a couple counts as a force, m.
    arm: f64,
}

/// The strips of a table.
struct Division {
    first_bins: Vec<usize>,
    /// v at their nodes; strips side by side share one.
    roots: Vec<f64>,
    /// Forces over f at the nodes in all columns.
    values: Vec<Vec<Reduced>>,
}

/// How a cell comes from the columns.
struct CellColumns {
    /// Weights of its nodes.
    nodes: [Vec<f64>; AXIAL_TERMS],
    /// Weights of its errors between the nodes.
    errors: [Vec<f64>; 2],
}

impl<'a, L: BallLaw + Clone> Draft<'a, L> {
    fn new(
        law: &'a Counted<'a, L>,
        region: BallRegion,
        columns: usize,
        load: f64,
        tolerance: f64,
    ) -> Result<Self, TableError> {
        let span = region.axial_span();
        let [low, high] = region.radial;
        if !(span[1] > span[0] && high > low && load > 0.0 && tolerance > 0.0) {
            return Err(TableError::NoRegion);
        }
        let along = |index| lobatto(index, columns);
        let nodes: Vec<f64> = (0..columns)
            .map(|index| 0.5 * (span[0] + span[1]) + 0.5 * (span[1] - span[0]) * along(index))
            .collect();
        let distance = span[1].hypot(high);
        let lifted = LIFTED_SHARE * load;
        let limits = if nodes.iter().all(|&axial| law.load(axial, low) > lifted) {
            Limits::loaded(span, region.radial)
        } else {
            Limits::lifting(law, span, &nodes, region.radial, lifted)?
        };
        let [start, end] = limits.roots;
        if end - start < NARROWEST * end || span[1] - span[0] < NARROWEST * span[1] {
            return Err(TableError::NoRegion);
        }
        Ok(Self {
            law,
            region: region.one_sided(limits.lowest),
            limits,
            columns,
            step: STEP_SHARE * tolerance * load,
            arm: distance,
        })
    }

    /// Forces over f at τ and v.
    fn reduced(&self, along: f64, root: f64) -> Reduced {
        let chart = &self.limits.chart;
        let factor = chart.factor(root);
        // at lift-off the force fades faster than f
        if factor == 0.0 {
            return [0.0; 3];
        }
        let axial = chart.axial(along);
        let force = self.law.force(axial, chart.radial(along, root));
        [force.axial, force.radial, force.couple / self.arm].map(|force| force / factor)
    }

    fn table<const COUPLE: bool>(&self, law: &L) -> Result<TableLaw<L, COUPLE>, TableError> {
        let Division {
            first_bins,
            roots,
            values,
        } = self.divided();
        let columns = self.columns_of_cells();
        let across = self.across(&roots, &values, &columns);
        let cells = across.iter().sum();
        if cells > MOST_CELLS {
            let relative_error = f64::INFINITY;
            return Err(TableError::Tolerance {
                relative_error,
                cells,
            });
        }
        let (forces, couples) = self.cells(&values, &across, &columns);
        let table = BallTable {
            speed: self.law.speed,
            region: self.region,
            chart: self.limits.chart,
            strips: Strips::new(self.limits.roots, &first_bins, &across),
            forces,
            couples: if COUPLE { couples } else { Vec::new() },
        };
        Ok(TableLaw {
            exact: law.clone(),
            table,
        })
    }

    /// First bins of wide strips: halves of halves of the range, in each of which one polynomial of
    /// high degree is exact enough.
    fn wide_strips(&self) -> Vec<usize> {
        let mut first_bins = Vec::new();
        let mut waiting = vec![(0, BINS)];
        while let Some((first, next)) = waiting.pop() {
            let [low, high] = [first, next].map(|bin| self.bin_root(bin));
            if next - first == 1 || self.fits(low, high) {
                first_bins.push(first);
            } else {
                let middle = first.midpoint(next);
                waiting.push((middle, next));
                waiting.push((first, middle));
            }
        }
        first_bins
    }

    /// v at the start of a bin.
    fn bin_root(&self, bin: usize) -> f64 {
        let [start, end] = self.limits.roots;
        start + (end - start) * (bin as f64 / BINS as f64)
    }

    /// The table's strips, their polynomials of low degree taken from those of wide strips.
    fn divided(&self) -> Division {
        let wide = self.wide_strips();
        let (mut first_bins, mut roots, mut values) = (Vec::new(), Vec::new(), Vec::new());
        let mut border = self.row(self.bin_root(0));
        for (strip, &first) in wide.iter().enumerate() {
            let next = wide.get(strip + 1).copied().unwrap_or(BINS);
            let [low, high] = [first, next].map(|bin| self.bin_root(bin));
            let root = |x: f64| 0.5 * (low + high) + 0.5 * (high - low) * x;
            let mut rows = vec![border];
            rows.extend((1..STRIP_NODES).map(|node| self.row(root(lobatto(node, STRIP_NODES)))));
            let parts = self.parts(&rows, [low, high], FINEST.min(next - first));
            for part in 0..parts {
                first_bins.push(first + part * (next - first) / parts);
                for node in 0..ROOT_TERMS - 1 {
                    let x = part_place(part, parts, lobatto(node, ROOT_TERMS));
                    roots.push(root(x));
                    values.push(between(&rows, x));
                }
            }
            border = rows.swap_remove(STRIP_NODES - 1);
        }
        roots.push(self.bin_root(BINS));
        values.push(border);
        Division {
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

    /// Whether an error of forces over f is within a step's share.
    fn is_small(&self, error: &Reduced, root: f64) -> bool {
        let factor = self.limits.chart.factor(root);
        error.iter().all(|error| error.abs() * factor <= self.step)
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

    /// Of each number of cells along |A1| that a strip may have, 1, 2, 4 …, how they come from the
    /// columns.
    fn columns_of_cells(&self) -> Vec<Vec<CellColumns>> {
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
                        CellColumns { nodes, errors }
                    })
                    .collect()
            })
            .collect()
    }

    /// Of every strip the fewest cells along |A1| whose polynomials follow the columns.
    fn across(
        &self,
        roots: &[f64],
        values: &[Vec<Reduced>],
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

    /// The polynomials of all cells, strip by strip.
    fn cells(
        &self,
        values: &[Vec<Reduced>],
        across: &[usize],
        columns: &[Vec<CellColumns>],
    ) -> (Vec<ForceCell>, Vec<CoupleCell>) {
        let by_root = power_weights::<ROOT_TERMS>();
        // t is half of the coordinate from −1 to 1
        let mut by_axial = power_weights::<AXIAL_TERMS>();
        for (power, row) in by_axial.iter_mut().enumerate() {
            row.iter_mut()
                .for_each(|weight| *weight *= f64::powi(2.0, power as i32));
        }
        let (mut forces, mut couples) = (Vec::new(), Vec::new());
        for (strip, across) in across.iter().enumerate() {
            for CellColumns { nodes: weights, .. } in &columns[across.ilog2() as usize] {
                let first = strip * (ROOT_TERMS - 1);
                let nodes: [[Reduced; AXIAL_TERMS]; ROOT_TERMS] = std::array::from_fn(|root| {
                    std::array::from_fn(|node| {
                        weighted(values[first + root].iter().copied(), &weights[node])
                    })
                });
                let terms = powers(&nodes, &by_root, &by_axial);
                forces.push(ForceCell(terms.map(|row| {
                    let pair = |l: usize| [row[l][0], row[l][1], row[l + 1][0], row[l + 1][1]];
                    [pair(0), pair(2)]
                })));
                let couple = terms.map(|row| row.map(|term| term[2] * self.arm));
                couples.push(CoupleCell(couple));
            }
        }
        (forces, couples)
    }

    /// Largest difference from the exact law over places that lie evenly and on no node.
    fn error_of<const COUPLE: bool>(&self, table: &TableLaw<L, COUPLE>) -> f64 {
        let mut largest = 0.0_f64;
        for probe in 0..PROBES {
            let part = (probe as f64 + 0.5) / PROBES as f64;
            // a lattice by the golden section
            let along = 2.0 * (probe as f64 * 0.618_033_988_749_894_9).fract() - 1.0;
            let (chart, root) = (&self.limits.chart, self.limits.root(part));
            let axial = chart.axial(along);
            let radial = chart.radial(along, root);
            let exact = self.law.force(axial, radial);
            let own = table.force(axial, radial, self.law.speed);
            largest = largest
                .max((own.axial - exact.axial).abs())
                .max((own.radial - exact.radial).abs())
                .max((own.couple - exact.couple).abs() / self.arm);
        }
        largest
    }
}
