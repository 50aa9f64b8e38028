//! The numbers of a study that its figures show.

use super::digest::{Digest, number};
use super::statistics::varies;
use crate::report::figure::Label;
use crate::report::terminal::shown_column;
use crate::study::many::RunRecord;

/// The number that says how a motion repeats.
const PERIOD: &str = "period_cycles";

/// What the figures show where a study names nothing.
const SHOWN: [&str; 8] = [
    "x_rms_m",
    "y_rms_m",
    "z_rms_m",
    "x_order_1_m",
    "largest_ball_load_N",
    "bearing_1_life_h",
    "natural_frequency_1_Hz",
    "stiffness_y_N_m",
];

/// A number that the figures show.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shown {
    /// Its place among the columns.
    pub column: usize,
    /// What it is called, with the unit in which it is drawn.
    pub label: Label,
    /// What its values are multiplied by for that.
    factor: f64,
    /// Whether it is a count only where it is positive.
    is_code: bool,
}

impl Shown {
    /// What is drawn of a run.
    pub fn value(&self, row: &RunRecord) -> f64 {
        let value = number(row, self.column);
        match self.is_code && value < 0.0 {
            true => f64::NAN,
            false => self.factor * value,
        }
    }
}

impl Digest {
    /// The numbers that the study names or else some of all that vary, as far as runs have them.
    pub(super) fn shown(&self) -> Vec<Shown> {
        let names: Vec<&str> = match &self.head.named {
            Some(named) => named.iter().map(String::as_str).collect(),
            None => SHOWN.to_vec(),
        };
        let known = |name: &&str| {
            let column = self.column(name)?;
            let digest = &self.columns[column];
            let tells = varies(self, digest) || (self.head.named.is_some() && digest.known > 1);
            let (label, factor) = shown_column(&digest.column);
            let is_code = digest.column.quantity == PERIOD;
            let label = if is_code {
                "cycles of a motion that repeats".into()
            } else {
                label.into()
            };
            tells.then_some(Shown {
                column,
                label,
                factor,
                is_code,
            })
        };
        names.iter().filter_map(known).collect()
    }
}
