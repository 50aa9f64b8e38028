//! From an exact law to its table.

use super::across::Evenly;
use super::ball_table::BallTable;
use super::counted::Counted;
use super::division::Division;
use super::even_strips::EvenStrips;
use super::law::TableLaw;
use super::limits::Limits;
use super::polynomial::lobatto;
use super::reduced::Reduced;
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
/// Offset places at which the error is measured.
const PROBES: usize = 1500;
/// Most cells of a table.
const MOST_CELLS: usize = 16_384;
/// Least width of the region over its distance from zero: in a narrower one rounding would count in bins.
const NARROWEST: f64 = 1e-3;

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
pub(super) struct Draft<'a, L> {
    law: &'a Counted<'a, L>,
    /// Where a ring's balls may be looked up.
    region: BallRegion,
    pub(super) limits: Limits,
    /// Number of places along |A1| at which the exact law is asked.
    pub(super) columns: usize,
    /// Error that each step may make, N.
    step: f64,
    /// Arm by which a couple counts as a force, m.
    pub(super) arm: f64,
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
        // a circle about the outer groove centre has no place of its own on either side of A2 = 0
        let limits = if low > 0.0 && nodes.iter().all(|&axial| law.load(axial, low) > lifted) {
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
    pub(super) fn reduced(&self, along: f64, root: f64) -> Reduced {
        let chart = &self.limits.chart;
        let [by_axial, by_radial, by_couple] = chart.factors(along, root);
        // at lift-off the force fades faster than f
        if by_axial == 0.0 {
            return [0.0; 3];
        }
        let axial = chart.axial(along);
        let force = self.law.force(axial, chart.radial(along, root));
        [
            force.axial / by_axial,
            force.radial / by_radial,
            force.couple / self.arm / by_couple,
        ]
    }

    /// Whether an error of forces over f is within a step's share.
    pub(super) fn is_small(&self, error: &Reduced, root: f64) -> bool {
        // the largest A2 is where |A1| is least
        let factors = self.limits.chart.factors(-1.0, root);
        let mut errors = error.iter().zip(factors);
        errors.all(|(error, factor)| error.abs() * factor <= self.step)
    }

    fn table<const COUPLE: bool>(&self, law: &L) -> Result<TableLaw<L, COUPLE>, TableError> {
        let wide = self.wide_strips();
        let columns = self.columns_of_cells();
        let uneven = self.divided(&wide, |strip| strip.parts);
        let across = self.across(&uneven, &columns);
        let (division, (forces, couples)) = match Evenly::of(&wide, &across) {
            Some(Evenly { width, across }) => {
                let nodes = self.divided(&wide, |strip| strip.bins() / width);
                let even = EvenStrips::new(self.limits.roots, BINS / width, across);
                let across = vec![across; BINS / width];
                (
                    Division::Even(even),
                    self.cells::<COUPLE>(&nodes, &across, &columns),
                )
            }
            None => {
                let cells = across.iter().sum();
                if cells > MOST_CELLS {
                    let relative_error = f64::INFINITY;
                    return Err(TableError::Tolerance {
                        relative_error,
                        cells,
                    });
                }
                let strips = Strips::new(self.limits.roots, &uneven.first_bins, &across);
                let cells = self.cells::<COUPLE>(&uneven, &across, &columns);
                (Division::Uneven(strips), cells)
            }
        };
        let table = BallTable {
            speed: self.law.speed,
            region: self.region,
            chart: self.limits.chart,
            division,
            forces,
            couples,
        };
        Ok(TableLaw {
            exact: law.clone(),
            table,
        })
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::{JonesFilmLaw, JonesLaw, Oil, catalogue};
    use crate::physics::RaceControl;

    const SPEED: f64 = 1000.0;
    const LOAD: f64 = 300.0;

    /// Forces of places as far apart as rounding counts, on both sides of borders between cells, less what the slope
    /// makes of their distance: the largest step, N.
    fn largest_step<L: BallLaw + Clone>(law: L, pressed: f64) -> f64 {
        let bearing = catalogue::find("7205C").unwrap().bearing().unwrap();
        let (axial, radial) = (
            bearing.geometry.free_axial(),
            bearing.geometry.free_radial(),
        );
        let region = BallRegion {
            axial: [axial + pressed - 8e-6, axial + pressed + 8e-6],
            radial: [radial - 12e-6, radial + 12e-6],
        };
        let (law, _) = TableLaw::<_, false>::compile(law, region, SPEED, LOAD, 1e-9).unwrap();
        let Division::Even(_) = law.table.division else {
            panic!("strips of unequal width");
        };
        let cell = |axial, radial| {
            law.table
                .locate_single(axial, radial, SPEED)
                .map(|place| place.cell)
        };
        let (mut largest, mut borders) = (0.0_f64, 0);
        for line in 0..40 {
            // to both sides of every border on lines across the region
            let part = (f64::from(line) + 0.5) / 40.0;
            let axial = region.axial[0] + (region.axial[1] - region.axial[0]) * part;
            let mut low = region.radial[0];
            let step = (region.radial[1] - region.radial[0]) / 64.0;
            while low + step < region.radial[1] {
                let (mut below, mut above) = (low, low + step);
                low = above;
                if cell(axial, below) == cell(axial, above) {
                    continue;
                }
                while above - below > 1e-18 {
                    let middle = 0.5 * (below + above);
                    if cell(axial, middle) == cell(axial, below) {
                        below = middle;
                    } else {
                        above = middle;
                    }
                }
                borders += 1;
                let (here, slope) = law.force_and_tangent(axial, below, SPEED);
                let there = law.force(axial, above, SPEED);
                for (step, slope) in [
                    (there.axial - here.axial, slope[0][1]),
                    (there.radial - here.radial, slope[1][1]),
                ] {
                    largest = largest.max((step - slope * (above - below)).abs());
                }
            }
        }
        assert!(borders > 200, "{borders}");
        largest
    }

    #[test]
    fn where_strips_are_alike_the_force_is_continuous() {
        let bearing = catalogue::find("7205C").unwrap().bearing().unwrap();
        let oil = Oil {
            viscosity: 0.04,
            pressure_viscosity: 2.2e-8,
        };
        let film = JonesFilmLaw::with_film(&bearing, RaceControl::Outer, oil, SPEED).unwrap();
        let dry = JonesLaw::new(&bearing, RaceControl::Outer).unwrap();
        for step in [largest_step(film, 32e-6), largest_step(dry, 32e-6)] {
            assert!(step < 1e-11 * LOAD, "{step:e}");
        }
    }
}
