//! A table of so many cells, and its error.

use super::ball_table::BallTable;
use super::cells::{AXIAL_TERMS, Cell, ROOT_TERMS};
use super::chart::Chart;
use super::grid::{Grid, Parts};
use super::interpolation::{lobatto, power_weights, weighted};
use super::region::BallRegion;
use super::report::TableError;
use crate::bearing::law::{Ball, BallForce, ForceLaw};

/// Places at which the error along one of the coordinates is measured, and the whole error.
const PROBES: [usize; 2] = [300, 1500];
/// Least width of the region over its distance from zero: in a narrower one rounding would count.
const NARROWEST: f64 = 1e-3;

/// Where the error of a table is measured.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Probes {
    /// On borders between cells along |A1|, which are nodes: what is off there is so along v.
    AlongRoot,
    /// On borders between cells along v.
    AlongAxial,
    /// On no node.
    All,
}

/// What a table is made from.
pub(super) struct Draft<'a, L> {
    law: &'a L,
    speed: f64,
    region: BallRegion,
    chart: Chart,
    /// Range of v.
    roots: [f64; 2],
    /// Arm by which a couple counts as a force, m.
    arm: f64,
    pub(super) evaluations: usize,
}

impl<'a, L: ForceLaw> Draft<'a, L> {
    pub(super) fn new(
        law: &'a L,
        region: BallRegion,
        speed: f64,
        load: f64,
    ) -> Result<Self, TableError> {
        let region = region.folded();
        let ([start, end], [low, high]) = (region.axial, region.radial);
        if !(end - start >= NARROWEST * end && end > 0.0 && high > low && load > 0.0) {
            return Err(TableError::NoRegion);
        }
        let mut evaluations = 0;
        let mut load_at = |axial, radial| {
            evaluations += 1;
            let force = law.force(&Ball::at(axial, radial), speed);
            force.axial.hypot(force.radial)
        };
        let chart = Chart::new(&region, &mut load_at, load)?;
        Ok(Self {
            law,
            speed,
            region,
            roots: chart.roots(&region),
            chart,
            arm: end.hypot(high),
            evaluations,
        })
    }

    /// The exact force at a place.
    fn force(&mut self, [axial, radial]: [f64; 2]) -> BallForce {
        self.evaluations += 1;
        self.law.force(&Ball::at(axial, radial), self.speed)
    }

    /// The table of so many cells along v and along |A1|.
    pub(super) fn table(&mut self, [strips, columns]: [usize; 2]) -> BallTable {
        let grid = Grid {
            root: Parts::new(self.roots, strips),
            along: Parts::new([-1.0, 1.0], columns),
        };
        let root_nodes = lobatto::<ROOT_TERMS>().map(|node| 0.5 * node);
        let axial_nodes = lobatto::<AXIAL_TERMS>().map(|node| 0.5 * node);
        let along = grid.along.nodes(&axial_nodes);
        let row = |root| {
            along
                .iter()
                .map(|&along| self.reduced(along, root))
                .collect()
        };
        let values: Vec<Vec<Reduced>> = grid.root.nodes(&root_nodes).into_iter().map(row).collect();
        let (by_root, by_axial) = (power_weights(&root_nodes), power_weights(&axial_nodes));
        let (mut forces, mut couples) = (Vec::new(), Vec::new());
        for (strip, column) in
            (0..strips).flat_map(|strip| (0..columns).map(move |column| (strip, column)))
        {
            let (first_row, first) = (strip * (ROOT_TERMS - 1), column * (AXIAL_TERMS - 1));
            // Σ over the nodes along v, then along |A1|
            let terms = by_root.map(|by_root| {
                let rows: [Reduced; AXIAL_TERMS] = std::array::from_fn(|l| {
                    weighted(&by_root, |k| values[first_row + k][first + l])
                });
                by_axial.map(|by_axial| weighted(&by_axial, |l| rows[l]))
            });
            forces.push(Cell::new(
                &terms.map(|row| row.map(|[axial, radial, _]| [axial, radial])),
            ));
            if L::HAS_COUPLE {
                couples.push(Cell::new(
                    &terms.map(|row| row.map(|[.., couple]| [couple, 0.0])),
                ));
            }
        }
        // as of a race that holds no moment
        if couples.iter().all(Cell::is_zero) {
            couples.clear();
        }
        BallTable {
            speed: self.speed,
            region: self.region,
            chart: self.chart,
            grid,
            forces,
            couples,
        }
    }

    /// Forces over u at τ and v.
    fn reduced(&mut self, along: f64, root: f64) -> Reduced {
        // at lift-off the force fades faster than u
        if root <= 0.0 {
            return [0.0; 3];
        }
        let force = self.force(self.chart.place(along, root));
        [force.axial, force.radial, force.couple].map(|force| force / (root * root))
    }

    /// Largest difference of a table from the exact law over places that lie evenly.
    pub(super) fn error_of(&mut self, table: &BallTable, probes: Probes) -> f64 {
        let count = PROBES[usize::from(probes == Probes::All)];
        let [strips, columns] =
            [table.grid.root, table.grid.along].map(|parts| parts.count() as f64);
        let [start, end] = self.roots;
        let mut largest = 0.0_f64;
        for probe in 0..count {
            // a lattice by the golden section
            let mut part = (probe as f64 + 0.5) / count as f64;
            let mut across = (probe as f64 * 0.618_033_988_749_894_9).fract();
            match probes {
                Probes::AlongRoot => across = (across * columns).round() / columns,
                Probes::AlongAxial => part = (part * strips).round() / strips,
                Probes::All => {}
            }
            let place = self
                .chart
                .place(2.0 * across - 1.0, start + (end - start) * part);
            let [axial, radial] = place;
            if !table.region.contains(axial, radial) {
                continue;
            }
            let (own, exact) = (
                table.force(&Ball::at(axial, radial), self.speed),
                self.force(place),
            );
            for difference in [
                own.axial - exact.axial,
                own.radial - exact.radial,
                (own.couple - exact.couple) / self.arm,
            ] {
                // what is no number is no force
                let off = if difference.is_nan() {
                    f64::INFINITY
                } else {
                    difference.abs()
                };
                largest = largest.max(off);
            }
        }
        largest
    }
}

/// Axial force, radial force and couple over u.
type Reduced = [f64; 3];
