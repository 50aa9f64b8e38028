//! Ball laws compiled into tables for the motion of a rotor.

use super::{FREEDOMS, Rotor, Sample};
use crate::bearing::{Geometry, Support, TableError, TableReport};

/// Error of a table over the largest static ball load.
const TABLE_TOLERANCE: f64 = 1e-9;
/// Swing that a table allows for, over the motion that is expected.
const MARGIN: f64 = 4.0;
/// Largest swings of x and y and of z and the tilts, over the distance of the groove centres: what
/// is expected of a rotor whose bearings hardly hold it at rest is far too much.
const LARGEST: [f64; 2] = [0.06, 0.04];
/// Parts of that swing, the widest of which for which the law has a table is taken.
const PARTS: [f64; 3] = [1.0, 0.5, 0.25];

/// What became of the table of one bearing.
pub type Tabulation = Option<Result<TableReport, TableError>>;

impl Rotor {
    /// Compiles the ball laws of all bearings into tables for the motion that the
    /// linearised rotor lets expect; none of a bearing that would not gain, and none at all
    /// where the speed varies.
    pub fn tabulate(&mut self) -> Vec<Tabulation> {
        let Some(speed) = self.steady_from(0.0) else {
            return vec![None; self.supports.len()];
        };
        let swing = self.swing();
        let place = self.equilibrium.displacement;
        let compile = |support: &mut Support| {
            let mut tabulation = None;
            for part in PARTS {
                let swing = swing.map(|swing| part * swing);
                tabulation = support.tabulate(&place, &swing, speed, TABLE_TOLERANCE);
                if !matches!(tabulation, Some(Err(_))) {
                    break;
                }
            }
            tabulation
        };
        self.supports.iter_mut().map(compile).collect()
    }

    /// How far from the static equilibrium the kept freedoms may come, m and rad.
    fn swing(&self) -> [f64; FREEDOMS] {
        let distance = Support::largest(&self.supports, Geometry::groove_centre_distance);
        let arm = Support::largest(&self.supports, Geometry::inner_groove_radius);
        let expected = self.amplitude_estimate(self.speed());
        std::array::from_fn(|axis| {
            let lever = if axis < 3 { 1.0 } else { arm };
            let largest = LARGEST[usize::from(axis >= 2)] * distance / lever;
            if axis < self.kept {
                (MARGIN * expected[axis]).min(largest)
            } else {
                0.0
            }
        })
    }

    /// Counts, for every bearing, whether a ball is outside its table in an observed state.
    pub fn count_outside_tables(&self, sample: &Sample, counts: &mut [u64]) {
        let rotation = self.speed.at(sample.time);
        let mut counts = counts.iter_mut();
        self.for_each_support(&rotation, &self.phases(&rotation), |support, rotation| {
            let inside = support.is_inside_table(&sample.displacement, rotation);
            if let Some(count) = counts.next() {
                *count += u64::from(!inside);
            }
        });
    }
}
