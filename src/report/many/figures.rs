//! What is drawn of a study, and its numbers along an axis.

use std::ops::Range;

use super::digest::Digest;
use crate::report::ReportError;
use crate::report::figure::{padded_range, svg};
use crate::report::figure_curves::{Curve, Panel, distinct, draw, round_ticks};
use crate::report::units::MICRO;

/// Panels side by side.
const COLUMNS: usize = 2;
/// Height of a row of panels, px.
const ROW_HEIGHT: u32 = 330;
/// Height of title and names, px.
pub(super) const HEAD_HEIGHT: u32 = 60;
/// Height of a figure of one panel, px.
pub(super) const HEIGHT: u32 = 600;
/// What the figures show where a study names nothing: name of the column, what it is called.
const SHOWN: [(&str, &str); 8] = [
    ("x_rms_m", "x, RMS in µm"),
    ("y_rms_m", "y, RMS in µm"),
    ("z_rms_m", "z, RMS in µm"),
    ("x_order_1_m", "x, order 1 in µm"),
    ("largest_ball_load_N", "largest ball load in N"),
    ("bearing_1_life_h", "life L10r of bearing 1 in h"),
    ("natural_frequency_1_Hz", "lowest natural frequency in Hz"),
    ("stiffness_y_N_m", "stiffness K_yy in N/m"),
];

fn shown(name: &str, column: usize) -> Shown {
    // what ends in N_m is a stiffness or a moment
    let length = name.strip_suffix("_m").filter(|rest| !rest.ends_with("_N"));
    let known = SHOWN.iter().find(|(known, _)| *known == name);
    let title = match (known, length) {
        (Some((_, title)), _) => (*title).to_owned(),
        (None, Some(rest)) => format!("{rest} in µm"),
        (None, None) => stiffness_title(name).unwrap_or_else(|| name.to_owned()),
    };
    Shown {
        column,
        title,
        is_length: length.is_some(),
    }
}

/// `stiffness K_xx in N/m` of `stiffness_x_N_m`.
fn stiffness_title(name: &str) -> Option<String> {
    let axis = name.strip_prefix("stiffness_")?.strip_suffix("_N_m")?;
    Some(format!("stiffness K_{axis}{axis} in N/m"))
}

/// A number that the figures show.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Shown {
    /// Its place among the columns.
    pub column: usize,
    /// What it is called, with the unit in which it is drawn.
    pub title: String,
    /// Whether it is a length, drawn in µm.
    is_length: bool,
}

impl Shown {
    /// What its values are multiplied by.
    pub fn factor(&self) -> f64 {
        if self.is_length { MICRO } else { 1.0 }
    }
}

impl Digest {
    /// The numbers that the study names or else some of all, as far as runs have them.
    pub(super) fn shown(&self) -> Vec<Shown> {
        let names: Vec<&str> = match &self.named {
            Some(named) => named.iter().map(String::as_str).collect(),
            None => SHOWN.iter().map(|(name, _)| *name).collect(),
        };
        let known = |name: &&str| {
            let column = self.column(name)?;
            (self.columns[column].known > 1).then(|| shown(name, column))
        };
        names.iter().filter_map(known).collect()
    }

    /// Numbers along the only axis, by direction.
    pub(super) fn response(&self, title: &str) -> Option<Result<String, ReportError>> {
        let [axis] = &self.axes[..] else {
            return None;
        };
        let [low, high] = self.ends(0)?;
        let panels: Vec<_> = self
            .shown()
            .into_iter()
            .map(|shown| Panel {
                x_name: axis.clone(),
                x_ticks: round_ticks(low, high),
                curves: [false, true]
                    .into_iter()
                    .filter_map(|down| self.curve(&shown, down))
                    .collect(),
                y_name: shown.title,
            })
            .collect();
        let up_and_down =
            self.rows.iter().any(|row| row.down) && !self.rows.iter().all(|row| row.down);
        let names: &[&str] = if up_and_down {
            &["up", "down"]
        } else {
            &["runs"]
        };
        let names: Vec<_> = names
            .iter()
            .enumerate()
            .map(|(index, name)| ((*name).to_owned(), distinct(index)))
            .collect();
        let height = HEAD_HEIGHT + panels.len().div_ceil(COLUMNS) as u32 * ROW_HEIGHT;
        Some(svg("response.svg", height, title, |area| {
            draw(area, &names, &panels, COLUMNS)
        }))
    }

    fn curve(&self, shown: &Shown, down: bool) -> Option<Curve> {
        let rows = self.rows.iter().filter(|row| row.down == down);
        let mut points: Vec<_> = rows
            .map(|row| (row.values[0], shown.factor() * row.numbers[shown.column]))
            .filter(|(_, value)| value.is_finite())
            .collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        (!points.is_empty()).then(|| Curve {
            marks: if points.len() <= 60 && !self.drawn {
                points.clone()
            } else {
                Vec::new()
            },
            points,
            colour: distinct(usize::from(down)),
        })
    }

    /// Least and largest value of an axis.
    pub(super) fn ends(&self, axis: usize) -> Option<[f64; 2]> {
        let values = self.rows.iter().map(|row| row.values[axis]);
        let low = values.clone().fold(f64::INFINITY, f64::min);
        let high = values.fold(f64::NEG_INFINITY, f64::max);
        (low < high).then_some([low, high])
    }
}

/// A range that holds all values with a margin.
pub(super) fn padded(values: impl Iterator<Item = f64> + Clone) -> Range<f64> {
    let low = values.clone().fold(f64::INFINITY, f64::min);
    padded_range(low, values.fold(f64::NEG_INFINITY, f64::max))
}
