//! Ball laws compiled into tables for the motion of a rotor.

use super::{FREEDOMS, Rotor, Sample};
use crate::bearing::{Support, TableError, TableReport};

/// Error of a table over the largest static ball load.
const TABLE_TOLERANCE: f64 = 1e-9;
/// Swings of the balls that a table allows for, over the motion that is expected: the widest for
/// which the law has one.
const MARGINS: [f64; 3] = [4.0, 2.0, 1.0];

/// What became of the table of one bearing.
pub type Tabulation = Option<Result<TableReport, TableError>>;

impl Rotor {
    /// Compiles the ball laws of all bearings into tables for the motion to be expected at a
    /// tolerance, [`Rotor::motion_scale`]; none of a bearing that would not gain, and none at all
    /// where the speed varies.
    pub fn tabulate(&mut self, tolerance: f64) -> Vec<Tabulation> {
        let Some(speed) = self.steady_from(0.0) else {
            return vec![None; self.supports.len()];
        };
        let scale = self.motion_scale(tolerance);
        let place = self.equilibrium.displacement;
        let (kept, supports) = (self.kept, &mut self.supports);
        let swing = |margin: f64| -> [f64; FREEDOMS] {
            std::array::from_fn(|axis| {
                if axis < kept {
                    margin * scale.length / scale.lever(axis)
                } else {
                    0.0
                }
            })
        };
        let compile = |support: &mut Support| {
            let mut tabulation = None;
            for margin in MARGINS {
                tabulation = support.tabulate(&place, &swing(margin), speed, TABLE_TOLERANCE);
                if !matches!(tabulation, Some(Err(_))) {
                    break;
                }
            }
            tabulation
        };
        supports.iter_mut().map(compile).collect()
    }

    /// Counts, for every bearing, whether a ball is outside its table in an observed state.
    pub fn count_outside_tables(&self, sample: &Sample, counts: &mut [u64]) {
        let rotation = self.speed.at(sample.time);
        let mut counts = counts.iter_mut();
        self.for_each_support(rotation.angle, &self.phases(&rotation), |support, cage| {
            let inside = support.is_inside_table(&sample.displacement, cage, rotation.speed);
            if let Some(count) = counts.next() {
                *count += u64::from(!inside);
            }
        });
    }
}
