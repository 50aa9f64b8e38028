//! Panels of curves, as the figures of static questions have them.

use std::ops::Range;

use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint};
use plotters::prelude::*;

use super::figure::{
    Area, DrawError, GRID, INK, LINE, PALETTE, font, padded_range, px, tick_format,
};

/// A full turn, degrees.
const TURN: f64 = 360.0;
/// Height of the strip of names above the panels, px.
const NAMES_HEIGHT: u32 = 24;
/// Most names in the strip.
const MOST_NAMES: usize = 8;
/// Width of the scale to the left of a panel, px.
const SCALE_WIDTH: u32 = 82;
/// Most room for a name, px.
const NAME_WIDTH: u32 = 140;

/// A curve.
#[derive(Debug, Clone)]
pub(super) struct Curve {
    /// Its points, from left to right.
    pub points: Vec<(f64, f64)>,
    /// Its colour.
    pub colour: RGBColor,
    /// Points of it that are marked.
    pub marks: Vec<(f64, f64)>,
}

/// Curves over one axis.
#[derive(Debug, Clone)]
pub(super) struct Panel {
    /// Quantity and unit of the horizontal axis.
    pub x_name: String,
    /// Where the horizontal axis has its ticks, its ends the first and the last.
    pub x_ticks: Vec<f64>,
    /// Quantity and unit of the vertical axis.
    pub y_name: String,
    /// The curves.
    pub curves: Vec<Curve>,
}

/// An axis whose ticks are given.
struct Ticked<'a> {
    range: Range<f64>,
    ticks: &'a [f64],
}

impl Ranged for Ticked<'_> {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, pixels: (i32, i32)) -> i32 {
        let part = (value - self.range.start) / (self.range.end - self.range.start);
        pixels.0 + (part * f64::from(pixels.1 - pixels.0)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.to_vec()
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

/// Ticks of a full turn in degrees.
pub(super) fn azimuth_ticks() -> Vec<f64> {
    (0..=8).map(|step| 45.0 * f64::from(step)).collect()
}

/// Values at azimuths in rad, as points over one turn in degrees.
pub(super) fn turned(values: impl IntoIterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let turned = |(azimuth, value): (f64, f64)| (azimuth.to_degrees().rem_euclid(TURN), value);
    let mut points: Vec<_> = values.into_iter().map(turned).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points
}

/// The curve through points of one turn, from its start to its end.
pub(super) fn all_around(mut points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let (Some(&first), Some(&last)) = (points.first(), points.last()) else {
        return points;
    };
    // the line from the last point over the end of the turn to the first
    let gap = first.0 + TURN - last.0;
    let part = (TURN - last.0) / gap;
    let seam = last.1 + part * (first.1 - last.1);
    points.insert(0, (0.0, seam));
    points.push((TURN, seam));
    points
}

/// Colour number `index` of `count` values in their order: blue over green to yellow.
pub(super) fn graded(index: usize, count: usize) -> RGBColor {
    /// The colour map viridis in five anchors (Smith & van der Walt, 2015).
    const ANCHORS: [[f64; 3]; 5] = [
        [68.0, 1.0, 84.0],
        [59.0, 82.0, 139.0],
        [33.0, 145.0, 140.0],
        [94.0, 201.0, 98.0],
        [215.0, 205.0, 40.0],
    ];
    let steps = count.saturating_sub(1).max(1);
    let place = (ANCHORS.len() - 1) as f64 * index as f64 / steps as f64;
    let below = (place as usize).min(ANCHORS.len() - 2);
    let part = place - below as f64;
    let mixed = |k: usize| ANCHORS[below][k] * (1.0 - part) + ANCHORS[below + 1][k] * part;
    let [red, green, blue] = [0, 1, 2].map(|k| mixed(k).round() as u8);
    RGBColor(red, green, blue)
}

/// Colour number `index` of things without an order.
pub(super) fn distinct(index: usize) -> RGBColor {
    PALETTE[index % PALETTE.len()]
}

/// Draws the panels row by row under a strip that names the colours.
pub(super) fn draw(
    area: &Area,
    names: &[(String, RGBColor)],
    panels: &[Panel],
    columns: usize,
) -> Result<(), DrawError> {
    let (strip, below) = area.split_vertically(px(NAMES_HEIGHT));
    draw_names(&strip, names)?;
    let rows = panels.len().div_ceil(columns).max(1);
    for (panel, area) in panels.iter().zip(below.split_evenly((rows, columns))) {
        draw_panel(&area, panel)?;
    }
    Ok(())
}

/// The names side by side, each behind a stroke of its colour; of many, some.
pub(super) fn draw_names(strip: &Area, names: &[(String, RGBColor)]) -> Result<(), DrawError> {
    let shown = shown_names(names.len());
    let (width, height) = strip.dim_in_pixel();
    let room = width.saturating_sub(px(SCALE_WIDTH)) / shown.max(1) as u32;
    let slot = room.min(px(NAME_WIDTH)) as i32;
    let middle = height as i32 / 2;
    for place in 0..shown {
        let index = place * (names.len() - 1) / (shown - 1).max(1);
        let (name, colour) = &names[index];
        let left = place as i32 * slot + px(SCALE_WIDTH) as i32;
        let stroke = [(left, middle), (left + px(18) as i32, middle)];
        strip.draw(&PathElement::new(stroke, colour.stroke_width(2 * LINE)))?;
        let corner = (left + px(23) as i32, middle - px(7) as i32);
        strip.draw(&Text::new(name.clone(), corner, font(12)))?;
    }
    Ok(())
}

/// How many of `count` names are shown: of many, as many as can be evenly spaced ones.
fn shown_names(count: usize) -> usize {
    if count <= MOST_NAMES {
        return count;
    }
    (4..=MOST_NAMES)
        .rev()
        .find(|shown| (count - 1).is_multiple_of(shown - 1))
        .unwrap_or(MOST_NAMES)
}

fn draw_panel(area: &Area, panel: &Panel) -> Result<(), DrawError> {
    let values = value_range(panel);
    let ends = (panel.x_ticks.first(), panel.x_ticks.last());
    let (Some(&left), Some(&right)) = ends else {
        return Ok(());
    };
    let mut chart = ChartBuilder::on(area)
        .margin_top(px(10))
        .margin_left(px(8))
        .margin_right(px(24))
        .set_label_area_size(LabelAreaPosition::Left, px(74))
        .set_label_area_size(LabelAreaPosition::Bottom, px(44))
        .build_cartesian_2d(
            Ticked {
                range: left..right,
                ticks: &panel.x_ticks,
            },
            values.clone(),
        )?;
    chart
        .configure_mesh()
        .bold_line_style(GRID)
        .light_line_style(TRANSPARENT)
        .x_labels(panel.x_ticks.len())
        .y_labels(6)
        .x_label_formatter(&tick_format(right - left))
        .y_label_formatter(&tick_format(values.end - values.start))
        .x_desc(&panel.x_name)
        .y_desc(&panel.y_name)
        .axis_style(INK)
        .label_style(font(12))
        .axis_desc_style(font(13))
        .draw()?;
    for curve in &panel.curves {
        let points = curve.points.iter().copied();
        chart.draw_series(LineSeries::new(points, curve.colour.stroke_width(LINE)))?;
        let dot = |point: &(f64, f64)| Circle::new(*point, px(3), curve.colour.filled());
        chart.draw_series(curve.marks.iter().map(dot))?;
    }
    Ok(())
}

fn value_range(panel: &Panel) -> Range<f64> {
    let points = panel.curves.iter().flat_map(|curve| &curve.points);
    let values = points
        .map(|point| point.1)
        .filter(|value| value.is_finite());
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    padded_range(low, high)
}

/// Round numbers that span the values, about five steps apart.
pub(super) fn round_ticks(low: f64, high: f64) -> Vec<f64> {
    let span = if high > low {
        high - low
    } else {
        low.abs().max(1.0)
    };
    let magnitude = 10f64.powf((span / 5.0).log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0]
        .map(|factor| factor * magnitude)
        .into_iter()
        .find(|step| span / step <= 6.0)
        .unwrap_or(span);
    let first = (low / step).floor();
    let last = (high / step).ceil().max(first + 1.0);
    let count = (last - first) as usize;
    (0..=count)
        .map(|tick| (first + tick as f64) * step)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_span_the_values() {
        for (low, high) in [(200.0, 1000.0), (0.0, 1e-4), (3.0, 3.0), (-7.0, 2500.0)] {
            let ticks = round_ticks(low, high);
            assert!((2..=9).contains(&ticks.len()), "{ticks:?}");
            assert!(ticks[0] <= low && ticks[ticks.len() - 1] >= high);
        }
    }

    #[test]
    fn of_many_names_evenly_spaced_ones_are_shown() {
        let shown = [1, 8, 9, 17, 21, 26, 24].map(shown_names);
        assert_eq!(shown, [1, 8, 5, 5, 6, 6, 8]);
    }

    #[test]
    fn a_turn_is_closed_at_its_seam() {
        let points = all_around(turned([
            (-90f64.to_radians(), 4.0),
            (90f64.to_radians(), 2.0),
        ]));
        assert_eq!(points[0], (0.0, 3.0));
        assert_eq!(points[3], (360.0, 3.0));
    }
}
