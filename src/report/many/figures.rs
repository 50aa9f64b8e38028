//! What a study looks like: curves along an axis, a map over two, points, sensitivities.

use std::collections::BTreeSet;
use std::ops::Range;
use std::path::Path;

use plotters::prelude::*;

use super::digest::{Digest, Row};
use crate::report::figure::{Area, DrawError, GRID, INK, font, padded_range, px, svg, tick_format};
use crate::report::figure_curves::{Curve, Panel, distinct, draw, graded, round_ticks};
use crate::report::{FileAction, ReportError};

/// m → µm.
const MICRO: f64 = 1e6;
/// Panels side by side.
const COLUMNS: usize = 2;
/// Height of a row of panels, px.
const ROW_HEIGHT: u32 = 330;
/// Height of title and names, px.
const HEAD_HEIGHT: u32 = 60;
/// Height of a figure of one panel, px.
const HEIGHT: u32 = 600;
/// Height of a bar, px.
const BAR: u32 = 26;
/// Steps of colour in a map.
const SHADES: usize = 64;

/// What the figures show, of all that there is: name of the column, what it is called, its factor.
const SHOWN: [(&str, &str, f64); 8] = [
    ("x_rms_m", "x, RMS in µm", MICRO),
    ("y_rms_m", "y, RMS in µm", MICRO),
    ("z_rms_m", "z, RMS in µm", MICRO),
    ("x_order_1_m", "x, order 1 in µm", MICRO),
    ("largest_ball_load_N", "largest ball load in N", 1.0),
    ("bearing_1_life_h", "life L10r of bearing 1 in h", 1.0),
    (
        "natural_frequency_1_Hz",
        "lowest natural frequency in Hz",
        1.0,
    ),
    ("stiffness_y_N_m", "stiffness K_yy in N/m", 1.0),
];

impl Digest {
    fn shown(&self) -> impl Iterator<Item = (usize, &'static str, f64)> + '_ {
        SHOWN.iter().filter_map(|(name, title, factor)| {
            let column = self.column(name)?;
            (self.columns[column].known > 1).then_some((column, *title, *factor))
        })
    }

    /// Numbers along the only axis, by direction.
    pub(super) fn response(&self, title: &str) -> Option<Result<String, ReportError>> {
        let [axis] = &self.axes[..] else {
            return None;
        };
        let [low, high] = self.ends(0)?;
        let panels: Vec<_> = self
            .shown()
            .map(|(column, name, factor)| Panel {
                x_name: axis.clone(),
                x_ticks: round_ticks(low, high),
                y_name: name.to_owned(),
                curves: [false, true]
                    .into_iter()
                    .filter_map(|down| self.curve(column, factor, down))
                    .collect(),
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

    fn curve(&self, column: usize, factor: f64, down: bool) -> Option<Curve> {
        let rows = self.rows.iter().filter(|row| row.down == down);
        let mut points: Vec<_> = rows
            .map(|row| (row.values[0], factor * row.numbers[column]))
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
    fn ends(&self, axis: usize) -> Option<[f64; 2]> {
        let values = self.rows.iter().map(|row| row.values[axis]);
        let low = values.clone().fold(f64::INFINITY, f64::min);
        let high = values.fold(f64::NEG_INFINITY, f64::max);
        (low < high).then_some([low, high])
    }

    /// Vibration over both axes of a grid.
    pub(super) fn map(&self, title: &str) -> Option<Result<String, ReportError>> {
        let [across, up] = &self.axes[..] else {
            return None;
        };
        if self.drawn || !self.is_complete() {
            return None;
        }
        let (column, name, factor) = self.shown().next()?;
        let edges = [0, 1].map(|axis| edges(self.rows.iter().map(|row| row.values[axis])));
        let [Some(x), Some(y)] = edges else {
            return None;
        };
        Some(svg(
            "map.svg",
            HEIGHT,
            &format!("{title}: {name}"),
            |area| {
                let (chart, scale) = area.split_horizontally(px(780));
                let value = |row: &Row| factor * row.numbers[column];
                let values = self
                    .rows
                    .iter()
                    .map(value)
                    .filter(|value| value.is_finite());
                let range = padded(values);
                draw_map(
                    &chart,
                    [across, up],
                    [&x, &y],
                    &range,
                    self.rows.iter().map(|row| (row, value(row))),
                )?;
                draw_scale(&scale, &range)
            },
        ))
    }

    /// How much the numbers shown follow each axis.
    pub(super) fn tornado(&self, title: &str) -> Option<Result<String, ReportError>> {
        let names: Vec<_> = self
            .shown()
            .map(|(column, ..)| &self.columns[column].name)
            .collect();
        let shown: Vec<_> = self
            .sensitivities()
            .iter()
            .filter(|sensitivity| names.contains(&&sensitivity.number))
            .collect();
        let bars: Vec<_> = shown
            .iter()
            .flat_map(|sensitivity| {
                let mut axes = sensitivity.axes.clone();
                axes.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
                axes.into_iter()
                    .map(|(axis, part)| (format!("{} by {axis}", sensitivity.number), part))
            })
            .collect();
        if bars.is_empty() {
            return None;
        }
        let height = HEAD_HEIGHT + 40 + bars.len() as u32 * BAR;
        let title = format!("{title}: rank correlation");
        Some(svg("sensitivity.svg", height, &title, |area| {
            draw_bars(area, &bars)
        }))
    }

    /// Places of the shaft over the only axis.
    pub(super) fn bifurcation(
        &self,
        title: &str,
        points: &Path,
    ) -> Result<Option<String>, ReportError> {
        let [axis] = &self.axes[..] else {
            return Ok(None);
        };
        let Some([low, high]) = self.ends(0) else {
            return Ok(None);
        };
        let (name, places) = self.places(points)?;
        let range = padded(places.iter().map(|(_, place, _)| *place));
        let drawn = svg("bifurcation.svg", HEIGHT, title, |area| {
            let mut chart = ChartBuilder::on(area)
                .margin(px(12))
                .set_label_area_size(LabelAreaPosition::Left, px(78))
                .set_label_area_size(LabelAreaPosition::Bottom, px(48))
                .build_cartesian_2d(low..high, range.clone())?;
            chart
                .configure_mesh()
                .bold_line_style(GRID)
                .light_line_style(TRANSPARENT)
                .x_label_formatter(&tick_format(high - low))
                .y_label_formatter(&tick_format(range.end - range.start))
                .x_desc(axis)
                .y_desc(&name)
                .axis_style(INK)
                .label_style(font(13))
                .axis_desc_style(font(14))
                .draw()?;
            // of points on one spot one is drawn: the file stays small
            let mut taken = BTreeSet::new();
            for (at, place, down) in &places {
                let spot = chart.backend_coord(&(*at, *place));
                if taken.insert((spot.0 / 2, spot.1 / 2, *down)) {
                    let colour = distinct(usize::from(*down));
                    chart.draw_series([Circle::new((*at, *place), 2, colour.filled())])?;
                }
            }
            Ok(())
        })?;
        Ok(Some(drawn))
    }

    /// Of the displacement that is spread most: axis value, place in µm, and direction.
    fn places(&self, points: &Path) -> Result<(String, Vec<Place>), ReportError> {
        let refused = |error: csv::Error| {
            let error = std::io::Error::other(error.to_string());
            ReportError::file(FileAction::Read, points)(error)
        };
        let mut reader = csv::Reader::from_path(points).map_err(refused)?;
        let names = reader.headers().map_err(refused)?.clone();
        let lengths: Vec<_> = (2..names.len())
            .filter(|k| names[*k].ends_with("_m"))
            .collect();
        let mut rows = self.rows.iter().peekable();
        let mut found = Vec::new();
        for record in reader.records() {
            let record = record.map_err(refused)?;
            let run: u64 = record[0].parse().unwrap_or(0);
            while rows.next_if(|row| row.run < run).is_some() {}
            if let Some(row) = rows.peek().filter(|row| row.run == run) {
                let places: Vec<f64> = lengths
                    .iter()
                    .map(|k| MICRO * record[*k].parse().unwrap_or(f64::NAN))
                    .collect();
                found.push((row.values[0], places, row.down));
            }
        }
        let spread = |k: &usize| {
            let range = padded(found.iter().map(|(_, places, _)| places[*k]));
            range.end - range.start
        };
        let widest = (0..lengths.len())
            .max_by(|a, b| spread(a).total_cmp(&spread(b)))
            .unwrap_or(0);
        let name = lengths
            .get(widest)
            .map_or("", |k| names[*k].trim_end_matches("_m"));
        let places = found
            .iter()
            .map(|(at, places, down)| (*at, places[widest], *down));
        Ok((format!("{name} in µm"), places.collect()))
    }
}

/// Value of the axis, place, and whether the run was come to from above.
type Place = (f64, f64, bool);

/// A range that holds all values with a margin.
fn padded(values: impl Iterator<Item = f64> + Clone) -> Range<f64> {
    let low = values.clone().fold(f64::INFINITY, f64::min);
    padded_range(low, values.fold(f64::NEG_INFINITY, f64::max))
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

fn draw_bars(area: &Area, bars: &[(String, f64)]) -> Result<(), DrawError> {
    let count = bars.len() as f64;
    let mut chart = ChartBuilder::on(area)
        .margin(px(12))
        .set_label_area_size(LabelAreaPosition::Bottom, px(40))
        .build_cartesian_2d(-3.2..1.05, 0.0..count)?;
    for (index, (name, part)) in bars.iter().enumerate() {
        let top = count - index as f64;
        let corners = [(0.0, top - 0.85), (*part, top - 0.15)];
        let colour = distinct(usize::from(*part < 0.0));
        chart.draw_series([Rectangle::new(corners, colour.filled())])?;
        chart.draw_series([Text::new(name.clone(), (-3.2, top - 0.25), font(13))])?;
    }
    chart.draw_series([PathElement::new([(0.0, 0.0), (0.0, count)], INK)])?;
    chart
        .configure_mesh()
        .disable_mesh()
        .disable_y_axis()
        .x_label_formatter(&|value| {
            if *value < -1.01 {
                String::new()
            } else {
                format!("{value:.1}")
            }
        })
        .axis_style(INK)
        .label_style(font(13))
        .draw()?;
    Ok(())
}
