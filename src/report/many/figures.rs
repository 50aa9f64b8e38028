//! What is drawn of a study: numbers along an axis and over two, places of the shaft, rank correlations.

use super::digest::{Digest, is_down};
use super::shown::Shown;
use crate::numerics::distinct::rising;
use crate::report::figure::{
    Axis, Cell, Curve, Figure, GREY, Label, Mark, Name, Panel, Point, distinct, ends, graded,
    padded,
};
use crate::report::terminal::shown_column;
use crate::report::variable::{axis_label, key_in_words, variable_column};
use crate::study::many::RunRecord;

/// Height of a plot, px.
const ROW_HEIGHT: u32 = 272;
/// Height of a single plot, px.
pub(super) const HEIGHT: u32 = 480;
/// Most points of a curve that are marked.
const MOST_MARKS: usize = 60;
/// Steps of colour in a map.
const SHADES: usize = 64;
/// Most points of a number that are drawn as dots.
const MOST_DOTS: usize = 500;
/// Most axes that numbers are scattered over, side by side.
const MOST_ACROSS: usize = 4;
/// Most maps below each other.
pub(super) const MOST_MAPS: usize = 8;
/// Height of one of several maps, px.
const MAP_HEIGHT: u32 = 300;

/// The values of an axis in order, and the edges halfway between them.
type Edges = (Vec<f64>, Vec<f64>);

/// Height of a bar, px.
const BAR: u32 = 26;

impl Digest {
    /// Numbers along the only axis, by direction.
    pub(super) fn response(&self) -> Option<Figure> {
        let [axis] = &self.head.axes[..] else {
            return None;
        };
        let (axis, ends) = (axis_label(axis), self.ends(0)?);
        let shown = self.shown();
        if shown.is_empty() {
            return None;
        }
        let panels = shown.into_iter().map(|shown| {
            let both = [false, true].into_iter();
            let curves = both.filter_map(|down| self.curve(&shown, down)).collect();
            Panel::holding(
                Axis::spanning(axis.clone(), ends),
                shown.label,
                ROW_HEIGHT,
                curves,
            )
        });
        let figure = Figure::new("response", &self.head.title, 2, panels.collect());
        Some(figure.with_names(self.directions()))
    }

    /// What the colours mean: how a run came to its value.
    pub(super) fn directions(&self) -> Vec<Name> {
        let is_there = |down| self.rows.iter().any(|row| is_down(row) == down);
        if is_there(false) && is_there(true) {
            Name::each(["up", "down"])
        } else {
            Name::each(["runs"])
        }
    }

    fn curve(&self, shown: &Shown, down: bool) -> Option<Curve> {
        let rows = self.rows.iter().filter(|row| is_down(row) == down);
        let mut found: Vec<(Point, u64)> = rows
            .map(|row| ((self.at(row, 0), shown.value(row)), row.run))
            .filter(|((_, value), _)| value.is_finite())
            .collect();
        found.sort_by(|(a, _), (b, _)| a.0.total_cmp(&b.0));
        let (points, runs): (Vec<_>, Vec<_>) = found.into_iter().unzip();
        let most_marks = if self.head.drawn { 0 } else { MOST_MARKS };
        let colour = distinct(usize::from(down));
        (!points.is_empty()).then(|| Curve {
            runs,
            ..Curve::marked(colour, points, most_marks)
        })
    }

    /// What the study names, or else vibration, over both axes of a grid.
    pub(super) fn map(&self) -> Option<Figure> {
        if self.head.axes.len() != 2 || self.head.drawn || !self.is_complete() {
            return None;
        }
        let edges = [0, 1].map(|axis| edges(self.rows.iter().map(|row| self.at(row, axis))));
        let [Some(x), Some(y)] = edges else {
            return None;
        };
        let mut shown = self.shown();
        shown.truncate(if self.head.named.is_some() {
            MOST_MAPS
        } else {
            1
        });
        let height = if shown.len() > 1 { MAP_HEIGHT } else { HEIGHT };
        let panels = shown
            .iter()
            .map(|shown| self.mapped(shown, [&x, &y], height));
        (!shown.is_empty()).then(|| Figure::new("map", &self.head.title, 1, panels.collect()))
    }

    /// One number in every cell of the grid.
    fn mapped(&self, shown: &Shown, edges: [&Edges; 2], height: u32) -> Panel {
        let value = |row: &RunRecord| shown.value(row);
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
                let place = values.partition_point(|known| *known < self.at(row, axis));
                [edges[place], edges[place + 1]]
            });
            let corners = [(across[0], up[0]), (across[1], up[1])];
            value.is_finite().then(|| Cell {
                corners,
                colour: shade(value),
                value,
                run: Some(row.run),
            })
        });
        let [x, y] = [0, 1].map(|axis| {
            let edges = &edges[axis].1;
            Axis::over(self.label(axis), edges[0]..edges[edges.len() - 1])
        });
        Panel {
            title: shown.label.to_string(),
            cells: cells.collect(),
            bar: Some(Axis::over("", range.clone())),
            ..Panel::new(x, y, height)
        }
    }

    /// The numbers shown over each of several axes whose values were drawn, a point a run.
    pub(super) fn scatter(&self) -> Option<Figure> {
        let count = self.head.axes.len();
        if count < 2 || !self.head.drawn {
            return None;
        }
        let axes = 0..count.min(MOST_ACROSS);
        let shown = self.shown().into_iter();
        let panels = shown.take(MOST_MAPS).flat_map(|shown| {
            let panel = |axis: usize| self.scattered(&shown, axis);
            axes.clone().filter_map(panel).collect::<Vec<_>>()
        });
        let panels: Vec<Panel> = panels.collect();
        let columns = count.min(MOST_ACROSS);
        (!panels.is_empty()).then(|| Figure::new("scatter", &self.head.title, columns, panels))
    }

    /// One number over one axis.
    fn scattered(&self, shown: &Shown, axis: usize) -> Option<Panel> {
        let rows = self
            .rows
            .iter()
            .map(|row| ((self.at(row, axis), shown.value(row)), row.run));
        let known = rows.filter(|((_, value), _)| value.is_finite());
        let (points, runs): (Vec<Point>, Vec<u64>) = known.unzip();
        let heights = Axis::around(shown.label.clone(), points.iter().map(|point| point.1));
        let few = points.len() <= MOST_DOTS;
        let dots = Curve {
            mark: if few { Mark::Dot } else { Mark::Spot },
            runs,
            ..Curve::dots(distinct(0), points)
        };
        let over = Axis::spanning(self.label(axis), self.ends(axis)?);
        Some(Panel {
            curves: vec![dots],
            ..Panel::new(over, heights, ROW_HEIGHT)
        })
    }

    /// How much the numbers shown follow each axis.
    pub(super) fn tornado(&self) -> Option<Figure> {
        let shown: Vec<_> = self.shown().iter().map(|shown| shown.column).collect();
        let mut bars = Vec::new();
        for sensitivity in &self.sensitivities {
            let is_shown = |column: &usize| self.columns[*column].column == sensitivity.number;
            if shown.iter().any(is_shown) {
                let correlations = sensitivity.rank_correlation.iter();
                let mut axes: Vec<_> = correlations.collect();
                axes.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
                let name = |axis: &str| {
                    let mut axes = self.head.axes.iter();
                    let variable = axes.find(|known| variable_column(known).name() == axis);
                    let label = variable.map_or_else(|| axis.to_owned(), key_in_words);
                    let ((number, _), _) = shown_column(&sensitivity.number);
                    format!("{number} by {label}")
                };
                bars.extend(axes.into_iter().map(|(axis, part)| (name(axis), *part)));
            }
        }
        if bars.is_empty() {
            return None;
        }
        let count = bars.len();
        let cells = bars.iter().enumerate().map(|(index, &(_, value))| Cell {
            corners: [(0.0, index as f64 + 0.15), (value, index as f64 + 0.85)],
            colour: distinct(usize::from(value < 0.0)),
            value,
            run: None,
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
        let title = format!("{}: rank correlation", self.head.title);
        Some(Figure::new("sensitivity", &title, 1, vec![panel]))
    }

    fn label(&self, axis: usize) -> Label {
        axis_label(&self.head.axes[axis])
    }

    /// Value of an axis in a row, in the unit of its label.
    pub(super) fn at(&self, row: &RunRecord, axis: usize) -> f64 {
        self.head.axes[axis].shown(row.values[axis])
    }

    /// Least and largest value of an axis, in the unit of its label.
    pub(super) fn ends(&self, axis: usize) -> Option<[f64; 2]> {
        let ends = ends(self.rows.iter().map(|row| self.at(row, axis)));
        ends.filter(|[low, high]| low < high)
    }
}

/// The values of an axis in order, and the edges halfway between them.
fn edges(values: impl Iterator<Item = f64>) -> Option<Edges> {
    let values = rising(values);
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
