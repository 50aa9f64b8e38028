//! What is drawn of a study, and its numbers along an axis.

use super::digest::Digest;
use crate::report::figure::{Axis, Curve, Figure, Name, Panel, distinct, ends};
use crate::report::terminal::MICRO;

/// Height of a plot, px.
const ROW_HEIGHT: u32 = 272;
/// Height of a plot that stands alone, px.
pub(super) const HEIGHT: u32 = 480;
/// Most points of a curve that are marked.
const MOST_MARKS: usize = 60;
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
    pub(super) fn response(&self, title: &str) -> Option<Figure> {
        let [axis] = &self.axes[..] else {
            return None;
        };
        let ends = self.ends(0)?;
        let panels = self.shown().into_iter().map(|shown| {
            let both = [false, true].into_iter();
            let curves = both.filter_map(|down| self.curve(&shown, down)).collect();
            Panel::of(Axis::spanning(axis, ends), shown.title, ROW_HEIGHT, curves)
        });
        let down = self.rows.iter().filter(|row| row.down).count();
        let names: &[&str] = if down > 0 && down < self.rows.len() {
            &["up", "down"]
        } else {
            &["runs"]
        };
        let figure = Figure::new("response.svg", title, 2, panels.collect());
        Some(figure.with_names(Name::each(names.iter().copied())))
    }

    fn curve(&self, shown: &Shown, down: bool) -> Option<Curve> {
        let rows = self.rows.iter().filter(|row| row.down == down);
        let mut points: Vec<_> = rows
            .map(|row| (row.values[0], shown.factor() * row.numbers[shown.column]))
            .filter(|(_, value)| value.is_finite())
            .collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let most_marks = if self.drawn { 0 } else { MOST_MARKS };
        let colour = distinct(usize::from(down));
        (!points.is_empty()).then(|| Curve::marked(colour, points, most_marks))
    }

    /// Least and largest value of an axis.
    pub(super) fn ends(&self, axis: usize) -> Option<[f64; 2]> {
        let ends = ends(self.rows.iter().map(|row| row.values[axis]));
        ends.filter(|[low, high]| low < high)
    }
}
