//! From an exact law to its table: more and more cells, until the measured error is small enough.

use serde::Serialize;

use super::ball_table::BallTable;
use super::cells::{AXIAL_TERMS, Cell, Grid, Parts, ROOT_TERMS, lobatto, power_weights, weighted};
use super::chart::{BallRegion, Chart};
use crate::bearing::law::{Ball, BallForce, ForceLaw};

/// Cells along v and along |A1| to begin with.
const FEWEST_CELLS: [usize; 2] = [8, 2];
/// Most cells of a table.
const MOST_CELLS: usize = 4096;
/// Most doublings of their number at a time: an error of much too large cells says little of smaller ones.
const MOST_DOUBLINGS: f64 = 3.0;
/// Share of the tolerance that the error along each of the coordinates may have.
const SHARE: f64 = 0.7;

/// What a table is good for, and what it took.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct TableReport {
    /// Largest difference from the exact force at offset places of the whole region, N.
    #[serde(rename = "error_N")]
    pub error: f64,
    /// That difference relative to the load that the tolerance refers to.
    pub relative_error: f64,
    /// Number of cells.
    pub cells: usize,
    /// Evaluations of the exact law, those for the error among them.
    pub evaluations: usize,
}

/// Why a law stays without a table.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum TableError {
    /// No range, or no load to refer to.
    #[error("the balls move in no region of their own, or carry nothing")]
    NoRegion,
    /// The line of lift-off cannot be followed.
    #[error("the balls lift off outside the reach of a table")]
    LiftOff,
    /// The surfaces under the balls are not perfect.
    #[error(
        "a table knows a ball by its place alone, and the surfaces under the balls are not perfect"
    )]
    Imperfect,
    /// The law is not smooth enough.
    #[error("a table of {cells} cells has a relative error of {relative_error:e}")]
    Tolerance {
        /// Measured error relative to the load that the tolerance refers to.
        relative_error: f64,
        /// Number of cells.
        cells: usize,
    },
}

impl BallTable {
    /// Compiles `law` at a shaft speed in rad/s over a region, so that no force differs by more than
    /// `tolerance` times `load` in N. A couple may differ by that times the distance of the groove
    /// centres.
    ///
    /// # Errors
    /// [`TableError`] where the region is none or too narrow, or the law does not allow for the tolerance.
    pub fn compile<L: ForceLaw>(
        law: &L,
        region: BallRegion,
        speed: f64,
        load: f64,
        tolerance: f64,
    ) -> Result<(Self, TableReport), TableError> {
        let mut draft = Draft::new(law, region, speed, load)?;
        let (allowed, share) = (tolerance * load, SHARE * tolerance * load);
        let mut cells = FEWEST_CELLS;
        loop {
            let table = draft.table(cells);
            let along = [Probes::AlongRoot, Probes::AlongAxial];
            let errors = along.map(|probes| draft.error_of(&table, probes));
            let mut error = errors[0].max(errors[1]);
            let mut growth = [
                growth(errors[0] / share, ROOT_TERMS),
                growth(errors[1] / share, AXIAL_TERMS),
            ];
            if growth == [1; 2] {
                error = error.max(draft.error_of(&table, Probes::All));
                if error <= allowed {
                    let report = TableReport {
                        error,
                        relative_error: error / load,
                        cells: table.forces.len(),
                        evaluations: draft.evaluations,
                    };
                    return Ok((table, report));
                }
                growth = [2; 2];
            }
            cells = [cells[0] * growth[0], cells[1] * growth[1]];
            if cells[0] * cells[1] > MOST_CELLS {
                return Err(TableError::Tolerance {
                    relative_error: error / load,
                    cells: table.forces.len(),
                });
            }
        }
    }
}

/// How many times as many cells, a power of two, bring an error of so many times the allowed one down to it: it falls
/// with a power of the width of the cells.
fn growth(excess: f64, terms: usize) -> usize {
    if excess <= 1.0 {
        return 1;
    }
    1 << (excess.log2() / terms as f64).ceil().min(MOST_DOUBLINGS) as u32
}

/// Positions at which the error along one of the coordinates is measured, and the whole error.
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

    /// The exact force at a position.
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
        let roots = grid.root.nodes(&root_nodes).into_iter();
        let row = |root| {
            along
                .iter()
                .map(|&along| self.reduced(along, root))
                .collect()
        };
        let values: Vec<Vec<Reduced>> = roots.map(row).collect();
        let (by_root, by_axial) = (power_weights(&root_nodes), power_weights(&axial_nodes));
        let (mut forces, mut couples) = (Vec::new(), Vec::new());
        for cell in 0..strips * columns {
            let (strip, column) = (cell / columns, cell % columns);
            let (first_row, first) = (strip * (ROOT_TERMS - 1), column * (AXIAL_TERMS - 1));
            // Σ over the nodes along v, then along |A1|
            let terms = by_root.map(|by_root| {
                let rows: [Reduced; AXIAL_TERMS] = std::array::from_fn(|l| {
                    weighted(&by_root, |k| values[first_row + k][first + l])
                });
                by_axial.map(|by_axial| weighted(&by_axial, |l| rows[l]))
            });
            let pushes = terms.map(|row| row.map(|[axial, radial, _]| [axial, radial]));
            forces.push(Cell::new(&pushes));
            if L::HAS_COUPLE {
                let moments = terms.map(|row| row.map(|[.., couple]| [couple, 0.0]));
                couples.push(Cell::new(&moments));
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
        let force = self.force(self.chart.position(along, root));
        [force.axial, force.radial, force.couple].map(|force| force / (root * root))
    }

    /// Largest difference of a table from the exact law over positions that lie evenly.
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
            let root = start + (end - start) * part;
            let [axial, radial] = self.chart.position(2.0 * across - 1.0, root);
            if !table.region.contains(axial, radial) {
                continue;
            }
            let own = table.force(&Ball::at(axial, radial), self.speed);
            let exact = self.force([axial, radial]);
            for difference in [
                own.axial - exact.axial,
                own.radial - exact.radial,
                (own.couple - exact.couple) / self.arm,
            ] {
                // what is no number is no force
                let no_force = difference.is_nan();
                largest = largest.max(if no_force {
                    f64::INFINITY
                } else {
                    difference.abs()
                });
            }
        }
        largest
    }
}

/// Axial force, radial force and couple over u.
type Reduced = [f64; 3];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::{Ball, BallForce, Bearing, HertzFilmLaw, JonesLaw, Oil, catalogue};
    use crate::physics::RaceControl;

    const SPEED: f64 = 1000.0;
    const LOAD: f64 = 300.0;

    fn bearing() -> Bearing {
        catalogue::find("7205C").unwrap().bearing().unwrap()
    }

    /// Balls that lift off on one side.
    fn region() -> BallRegion {
        let geometry = bearing().geometry;
        let around = |middle: f64, half: f64| [middle - half, middle + half];
        BallRegion {
            axial: around(geometry.free_axial() + 10e-6, 5e-6),
            radial: around(geometry.free_radial(), 20e-6),
        }
    }

    /// The largest step of the force across borders between cells, N.
    fn largest_step<L: ForceLaw>(law: &L) -> f64 {
        let (table, _) = BallTable::compile(law, region(), SPEED, LOAD, 1e-9).unwrap();
        let BallTable { chart, grid, .. } = &table;
        let (mut largest, mut borders) = (0.0_f64, 0);
        for strip in 1..grid.root.count() {
            for column in 1..grid.along.count() {
                let middle = [
                    grid.root.coordinate(strip, -0.5),
                    grid.along.coordinate(column, -0.5),
                ];
                // across both kinds of borders, by so little that rounding decides
                let (root, along) = (1e-9 / grid.root.scale, 1e-9 / grid.along.scale);
                for [root, along] in [[root, 0.0], [0.0, along]] {
                    let at = |side: f64| {
                        let [axial, radial] = chart.position(
                            middle[1]
                                + 0.3 / grid.along.scale * f64::from(root > 0.0)
                                + side * along,
                            middle[0]
                                + 0.3 / grid.root.scale * f64::from(along > 0.0)
                                + side * root,
                        );
                        (
                            table.force_and_tangent(axial, radial, SPEED),
                            [axial, radial],
                        )
                    };
                    let ((below, slope), here) = at(-1.0);
                    let ((above, _), there) = at(1.0);
                    let shift = [there[0] - here[0], there[1] - here[1]];
                    for (step, slope) in [
                        (above.axial - below.axial, slope[0]),
                        (above.radial - below.radial, slope[1]),
                    ] {
                        let rise = slope[0] * shift[0] + slope[1] * shift[1];
                        largest = largest.max((step - rise).abs());
                    }
                    borders += 1;
                }
            }
        }
        assert!(borders > 100, "{borders}");
        largest
    }

    #[test]
    fn the_force_is_continuous_from_cell_to_cell() {
        let oil = Oil {
            viscosity: 0.04,
            pressure_viscosity: 2.2e-8,
        };
        let film = HertzFilmLaw::with_film(&bearing(), oil, SPEED).unwrap();
        let dry = JonesLaw::new(&bearing(), RaceControl::Outer).unwrap();
        for step in [largest_step(&film), largest_step(&dry)] {
            assert!(step < 1e-11 * LOAD, "{step:e}");
        }
    }

    /// The reported error is what is found at other positions.
    #[test]
    fn the_error_is_measured_honestly() {
        let law = JonesLaw::new(&bearing(), RaceControl::Outer).unwrap();
        let (table, report) = BallTable::compile(&law, region(), SPEED, LOAD, 1e-7).unwrap();
        let BallRegion { axial, radial } = region();
        let mut largest = 0.0_f64;
        for (i, j) in (0..100).flat_map(|i| (0..100).map(move |j| (i, j))) {
            let between = |[low, high]: [f64; 2], part: i32| {
                low + (high - low) * (f64::from(part) + 0.37) / 100.0
            };
            let (axial, radial) = (between(axial, i), between(radial, j));
            let ball = Ball::at(axial, radial);
            let (own, exact) = (table.force(&ball, SPEED), law.force(&ball, SPEED));
            let off = (own.axial - exact.axial).abs();
            largest = largest.max(off).max((own.radial - exact.radial).abs());
        }
        assert!(
            largest < 1.5 * report.error && largest > 0.2 * report.error,
            "{largest:e}, {report:?}"
        );
        assert_eq!(report.relative_error, report.error / LOAD);
    }

    #[test]
    fn lifted_balls_bear_nothing_on_both_sides_of_the_line() {
        let law = JonesLaw::new(&bearing(), RaceControl::Outer).unwrap();
        let radial = region().radial;
        let wide = BallRegion {
            radial: [radial[0] - 20e-6, radial[1]],
            ..region()
        };
        let (table, _) = BallTable::compile(&law, wide, SPEED, LOAD, 1e-6).unwrap();
        let (axial, mut lifted) = (wide.axial[0], 0);
        for part in 0..200 {
            let [low, high] = wide.radial;
            let radial = low + (high - low) * f64::from(part) / 199.0;
            let ball = Ball::at(axial, radial);
            let past = law.distance_past_lift_off(&ball, 0, SPEED);
            let own = table.distance_past_lift_off(&ball, 0, SPEED);
            assert!((own > 0.0) == (past > 0.0) || past.abs() < 1e-11);
            if past < -1e-11 {
                assert_eq!(table.force(&ball, SPEED), BallForce::default());
                lifted += 1;
            }
        }
        assert!((20..180).contains(&lifted), "{lifted}");
    }
}
