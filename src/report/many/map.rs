//! Numbers over the two axes of a grid, as maps.

use super::digest::{Digest, Row};
use super::figures::{HEIGHT, Shown};
use crate::report::figure::{Axis, Figure, Panel, graded, padded};

/// Steps of colour in a map.
const SHADES: usize = 64;
/// Most maps below each other.
const MOST_MAPS: usize = 8;
/// Height of one of several maps, px.
const MAP_HEIGHT: u32 = 300;

/// The values of an axis in order, and the edges halfway between them.
type Edges = (Vec<f64>, Vec<f64>);

impl Digest {
    /// What the study names, or else vibration, over both axes of a grid.
    pub(super) fn map(&self, title: &str) -> Option<Figure> {
        if self.axes.len() != 2 || self.drawn || !self.is_complete() {
            return None;
        }
        let edges = [0, 1].map(|axis| edges(self.rows.iter().map(|row| row.values[axis])));
        let [Some(x), Some(y)] = edges else {
            return None;
        };
        let mut shown = self.shown();
        shown.truncate(if self.named.is_some() { MOST_MAPS } else { 1 });
        let height = if shown.len() > 1 { MAP_HEIGHT } else { HEIGHT };
        let panels = shown
            .iter()
            .map(|shown| self.mapped(shown, [&x, &y], height));
        (!shown.is_empty()).then(|| Figure::new("map.svg", title, 1, panels.collect()))
    }

    /// One number in every cell of the grid.
    fn mapped(&self, shown: &Shown, edges: [&Edges; 2], height: u32) -> Panel {
        let value = |row: &Row| shown.factor() * row.numbers[shown.column];
        let range = padded(self.rows.iter().map(value));
        let span = range.end - range.start;
        let shade = |value: f64| {
            let step = (value - range.start) / span * SHADES as f64;
            graded((step as usize).min(SHADES - 1), SHADES)
        };
        let cells = self.rows.iter().filter_map(|row| {
            let value = value(row);
            let [across, up] = [0, 1].map(|axis| {
                let (values, edges) = edges[axis];
                let place = values.partition_point(|known| *known < row.values[axis]);
                [edges[place], edges[place + 1]]
            });
            let corners = [(across[0], up[0]), (across[1], up[1])];
            value.is_finite().then(|| (corners, shade(value)))
        });
        let [x, y] = [0, 1].map(|axis| {
            let edges = &edges[axis].1;
            Axis::over(&self.axes[axis], edges[0]..edges[edges.len() - 1])
        });
        Panel {
            title: shown.title.clone(),
            cells: cells.collect(),
            bar: Some(Axis::over("", range.clone())),
            ..Panel::new(x, y, height)
        }
    }
}

/// The values of an axis in order, and the edges halfway between them.
fn edges(values: impl Iterator<Item = f64>) -> Option<Edges> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    let [first, second, ..] = values[..] else {
        return None;
    };
    let last = values[values.len() - 1];
    let before = values[values.len() - 2];
    let inner = values.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    let start = std::iter::once(first - 0.5 * (second - first));
    let end = std::iter::once(last + 0.5 * (last - before));
    let edges = start.chain(inner).chain(end).collect();
    Some((values, edges))
}
