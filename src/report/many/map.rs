//! Numbers over the two axes of a grid, as maps.

use std::ops::Range;

use plotters::prelude::*;

use super::digest::{Digest, Row};
use super::figures::{HEIGHT, Shown, padded};
use crate::report::ReportError;
use crate::report::figure::{Area, DrawError, INK, font, px, svg, tick_format};
use crate::report::figure_curves::graded;

/// Steps of colour in a map.
const SHADES: usize = 64;
/// Most maps below each other.
const MOST_MAPS: usize = 8;
/// Height of one of several maps, px.
const MAP_HEIGHT: u32 = 400;
/// Height of the title above them, px.
const TITLE_HEIGHT: u32 = 40;

impl Digest {
    /// What the study names, or else vibration, over both axes of a grid.
    pub(super) fn map(&self, title: &str) -> Option<Result<String, ReportError>> {
        if self.axes.len() != 2 || self.drawn || !self.is_complete() {
            return None;
        }
        let edges = [0, 1].map(|axis| edges(self.rows.iter().map(|row| row.values[axis])));
        let [Some(x), Some(y)] = edges else {
            return None;
        };
        let mut shown = self.shown();
        shown.truncate(if self.named.is_some() { MOST_MAPS } else { 1 });
        let count = shown.len();
        let height = (count as u32 * MAP_HEIGHT + TITLE_HEIGHT).max(HEIGHT);
        (count > 0).then(|| {
            svg("map.svg", height, title, |area| {
                for (shown, area) in shown.iter().zip(area.split_evenly((count, 1))) {
                    let area = area.titled(&shown.title, font(15))?;
                    self.draw_number(&area, shown, [&x, &y])?;
                }
                Ok(())
            })
        })
    }

    fn draw_number(&self, area: &Area, shown: &Shown, edges: [&Edges; 2]) -> Result<(), DrawError> {
        let value = |row: &Row| shown.factor() * row.numbers[shown.column];
        let values = self.rows.iter().map(value);
        let range = padded(values.filter(|value| value.is_finite()));
        let (chart, scale) = area.split_horizontally(px(780));
        let cells = self.rows.iter().map(|row| (row, value(row)));
        draw_map(&chart, [&self.axes[0], &self.axes[1]], edges, &range, cells)?;
        draw_scale(&scale, &range)
    }
}

/// The values of an axis in order, and the edges halfway between them.
fn edges(values: impl Iterator<Item = f64>) -> Option<(Vec<f64>, Vec<f64>)> {
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

type Edges = (Vec<f64>, Vec<f64>);

fn draw_map<'r>(
    area: &Area,
    names: [&String; 2],
    axes: [&Edges; 2],
    range: &Range<f64>,
    cells: impl Iterator<Item = (&'r Row, f64)>,
) -> Result<(), DrawError> {
    let span = |edges: &Edges| edges.1[0]..edges.1[edges.1.len() - 1];
    let [x, y] = axes.map(span);
    let mut chart = ChartBuilder::on(area)
        .margin(px(12))
        .set_label_area_size(LabelAreaPosition::Left, px(78))
        .set_label_area_size(LabelAreaPosition::Bottom, px(48))
        .build_cartesian_2d(x.clone(), y.clone())?;
    let drawn = cells.filter_map(|(row, value)| {
        let shade = shade(value, range)?;
        let [across, up] = [0, 1].map(|axis| {
            let place = axes[axis]
                .0
                .partition_point(|known| *known < row.values[axis]);
            [axes[axis].1[place], axes[axis].1[place + 1]]
        });
        let corners = [(across[0], up[0]), (across[1], up[1])];
        Some(Rectangle::new(corners, shade.filled()))
    });
    chart.draw_series(drawn)?;
    chart
        .configure_mesh()
        .disable_mesh()
        .x_label_formatter(&tick_format(x.end - x.start))
        .y_label_formatter(&tick_format(y.end - y.start))
        .x_desc(names[0])
        .y_desc(names[1])
        .axis_style(INK)
        .label_style(font(13))
        .axis_desc_style(font(14))
        .draw()?;
    Ok(())
}

fn shade(value: f64, range: &Range<f64>) -> Option<RGBColor> {
    let part = (value - range.start) / (range.end - range.start);
    let step = (part * SHADES as f64) as usize;
    value
        .is_finite()
        .then(|| graded(step.min(SHADES - 1), SHADES))
}

/// The colours of a map beside it.
fn draw_scale(area: &Area, range: &Range<f64>) -> Result<(), DrawError> {
    let mut chart = ChartBuilder::on(area)
        .margin(px(12))
        .set_label_area_size(LabelAreaPosition::Right, px(60))
        .set_label_area_size(LabelAreaPosition::Bottom, px(48))
        .build_cartesian_2d(0.0..1.0, range.clone())?;
    let step = (range.end - range.start) / SHADES as f64;
    let bars = (0..SHADES).map(|k| {
        let low = range.start + k as f64 * step;
        Rectangle::new([(0.0, low), (1.0, low + step)], graded(k, SHADES).filled())
    });
    chart.draw_series(bars)?;
    chart
        .configure_mesh()
        .disable_mesh()
        .disable_x_axis()
        .y_label_formatter(&tick_format(range.end - range.start))
        .axis_style(INK)
        .label_style(font(12))
        .draw()?;
    Ok(())
}
