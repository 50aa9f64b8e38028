//! How much the numbers of a study follow what was drawn, as bars.

use super::digest::Digest;
use crate::report::figure::{Axis, Curve, Figure, GREY, Panel, distinct};

/// Height of a bar, px.
const BAR: u32 = 26;

impl Digest {
    /// How much the numbers shown follow each axis.
    pub(super) fn tornado(&self, title: &str) -> Option<Figure> {
        let shown: Vec<_> = self.shown().iter().map(|shown| shown.column).collect();
        let mut bars = Vec::new();
        for sensitivity in self.sensitivities() {
            let is_shown = |column: &usize| self.columns[*column].name == sensitivity.number;
            if shown.iter().any(is_shown) {
                let correlations = sensitivity.rank_correlation.iter();
                let mut axes: Vec<_> = correlations.collect();
                axes.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
                let name = |axis: &str| format!("{} by {axis}", sensitivity.number);
                bars.extend(axes.into_iter().map(|(axis, part)| (name(axis), *part)));
            }
        }
        if bars.is_empty() {
            return None;
        }
        let count = bars.len();
        let cells = bars.iter().enumerate().map(|(index, (_, part))| {
            let top = index as f64;
            let colour = distinct(usize::from(*part < 0.0));
            ([(0.0, top + 0.15), (*part, top + 0.85)], colour)
        });
        let cells = cells.collect();
        let zero = Curve::line(GREY, vec![(0.0, 0.0), (0.0, count as f64)]);
        let panel = Panel {
            cells,
            curves: vec![zero],
            ..Panel::new(
                Axis::over("rank correlation", -1.05..1.05),
                Axis::names(bars.into_iter().map(|(name, _)| name)),
                BAR * count as u32,
            )
        };
        let title = format!("{title}: rank correlation");
        Some(Figure::new("sensitivity.svg", &title, 1, vec![panel]))
    }
}
