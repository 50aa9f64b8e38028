//! Ball laws compiled into tables for the motion of a rotor.

use super::Rotor;
use super::point::Attachment;
use crate::bearing::{Support, TableError, TableReport, Vector5};

/// Error of a table over the largest static ball load.
const TABLE_TOLERANCE: f64 = 1e-9;
/// Amplitude that a table allows for, over the motion that is expected.
const MARGIN: f64 = 4.0;
/// Largest amplitudes of x and y and of z and the tilts, over the distance of the groove centres: what
/// is expected of a rotor whose bearings hardly hold it at rest is far too much.
const LARGEST: [f64; 2] = [0.06, 0.04];
/// Parts of that amplitude, the widest of which for which the law has a table is taken.
const PARTS: [f64; 3] = [1.0, 0.5, 0.25];

/// What became of the table of one bearing.
pub type Tabulation = Option<Result<TableReport, TableError>>;

impl Rotor {
    /// Compiles the ball laws of all bearings into tables for the motion that the
    /// linearised rotor lets expect; none of a bearing that would not gain, and none at all
    /// where the speed varies.
    pub fn tabulate(&mut self) -> Vec<Tabulation> {
        let Some(speed) = self.steady_from(0.0) else {
            return vec![None; self.elements.supports().count()];
        };
        let amplitudes = self.amplitude_estimate(speed);
        let rest = &self.start.rest;
        let compile = |(attachment, support): (&Attachment, &mut Support)| {
            let position = attachment.displacement(rest, &[]);
            let amplitude = largest_amplitude(support, &attachment.reach(&amplitudes));
            let mut tabulation = None;
            for part in PARTS {
                let amplitude = amplitude.map(|amplitude| part * amplitude);
                tabulation = support.tabulate(&position, &amplitude, speed, TABLE_TOLERANCE);
                if !matches!(tabulation, Some(Err(_))) {
                    break;
                }
            }
            tabulation
        };
        self.elements.bearings_mut().map(compile).collect()
    }

    /// Whether [`Rotor::tabulate`] would compile the balls of any bearing.
    pub(crate) fn gains_from_tables(&self) -> bool {
        self.steady_from(0.0).is_some() && self.elements.supports().any(Support::gains_from_table)
    }

    /// Counts, for every bearing, whether a ball is outside its table in an observed state.
    pub(crate) fn count_outside_tables(&self, time: f64, state: &[f64], counts: &mut [u64]) {
        let rotation = self.excitation.speed.at(time);
        let at = self.instant(state, &rotation);
        for ((bearing, motion), count) in self.elements.bearings_at(&at).zip(counts) {
            let (displacement, seen) = (&motion.displacement, &motion.rotation);
            *count += u64::from(!bearing.support.is_inside_table(displacement, seen));
        }
    }
}

/// How far the rings of a bearing may come from their static positions, m and rad, where they are expected to move by an
/// amplitude.
fn largest_amplitude(support: &Support, expected: &Vector5) -> Vector5 {
    let geometry = &support.definition().bearing.geometry;
    let distance = geometry.length_scale();
    let arm = geometry.lever();
    std::array::from_fn(|axis| {
        let lever = if axis < 3 { 1.0 } else { arm };
        let largest = LARGEST[usize::from(axis >= 2)] * distance / lever;
        (MARGIN * expected[axis]).min(largest)
    })
}
