//! The trace as a figure: one panel for each freedom that moves.

use std::ops::Range;

use plotters::prelude::*;

use super::decimator::Decimator;
use super::figure::{
    Area, CURVE_BUCKETS, DrawError, GRID, INK, LINE, PALETTE, font, padded_range, px, svg,
    tick_format,
};
use super::{Bucket, ReportError};
use crate::analysis::Channel;
use crate::report::units::MICRO;
use crate::rotor::{FREEDOMS, Sample};

/// Height of a figure of up to three panels, px.
const HEIGHT: u32 = 600;
/// Height of each further panel, px.
const PANEL_HEIGHT: u32 = 130;

/// Collects the envelope of every moving freedom; its memory does not grow with the run.
#[derive(Debug, Clone)]
pub struct TraceFigure {
    panels: Vec<(Channel, Decimator)>,
    /// First and last time, s.
    time: Option<(f64, f64)>,
}

impl TraceFigure {
    /// For the first `freedoms` of x, y, z, θx, θy.
    pub fn new(freedoms: usize) -> Self {
        let channels = (0..freedoms.min(FREEDOMS)).map(Channel::Displacement);
        Self {
            panels: channels
                .map(|channel| (channel, Decimator::new(CURVE_BUCKETS)))
                .collect(),
            time: None,
        }
    }

    /// Takes one sample.
    pub fn sample(&mut self, sample: &Sample) {
        let (start, _) = self.time.unwrap_or((sample.time, sample.time));
        self.time = Some((start, sample.time));
        for (channel, envelope) in &mut self.panels {
            if let Some(value) = channel.of(sample) {
                envelope.push(sample.time, MICRO * value);
            }
        }
    }

    /// Draws the SVG.
    ///
    /// # Errors
    /// [`ReportError::Draw`] where the drawing library fails.
    pub fn draw(&self, title: &str) -> Result<String, ReportError> {
        let further = self.panels.len().saturating_sub(3) as u32;
        svg(
            "trace.svg",
            HEIGHT + further * PANEL_HEIGHT,
            title,
            |area| {
                let (panels, axis) =
                    area.split_vertically(area.dim_in_pixel().1.saturating_sub(px(48)) as i32);
                let areas = panels.split_evenly((self.panels.len().max(1), 1));
                for ((panel, (channel, envelope)), colour) in
                    areas.iter().zip(&self.panels).zip(PALETTE)
                {
                    draw_panel(panel, *channel, envelope, self.time_range(), colour)?;
                }
                self.draw_time_axis(&axis)
            },
        )
    }

    fn time_range(&self) -> Range<f64> {
        match self.time {
            Some((start, end)) if end > start => start..end,
            _ => 0.0..1.0,
        }
    }

    /// The time axis that all panels share.
    fn draw_time_axis(&self, area: &Area) -> Result<(), DrawError> {
        let time = self.time_range();
        let mut chart = ChartBuilder::on(area)
            .margin_left(px(12))
            .margin_right(px(24))
            .set_label_area_size(LabelAreaPosition::Left, px(78))
            .set_label_area_size(LabelAreaPosition::Bottom, px(44))
            .build_cartesian_2d(time.clone(), 0.0..1.0)?;
        chart
            .configure_mesh()
            .disable_mesh()
            .disable_y_axis()
            .x_labels(8)
            .x_label_formatter(&tick_format(time.end - time.start))
            .x_desc("time in s")
            .axis_style(INK)
            .label_style(font(13))
            .axis_desc_style(font(14))
            .draw()?;
        Ok(())
    }
}

fn draw_panel(
    area: &Area,
    channel: Channel,
    envelope: &Decimator,
    time: Range<f64>,
    colour: RGBColor,
) -> Result<(), DrawError> {
    let low = envelope.buckets().map(|bucket| bucket.low());
    let high = envelope.buckets().map(|bucket| bucket.high());
    let values = padded_range(
        low.fold(f64::INFINITY, f64::min),
        high.fold(f64::NEG_INFINITY, f64::max),
    );
    let mut chart = ChartBuilder::on(area)
        .margin_top(px(8))
        .margin_left(px(12))
        .margin_right(px(24))
        .set_label_area_size(LabelAreaPosition::Left, px(78))
        .build_cartesian_2d(time, values.clone())?;
    chart
        .configure_mesh()
        .bold_line_style(GRID)
        .light_line_style(TRANSPARENT)
        .x_labels(8)
        .y_labels(5)
        .y_label_formatter(&tick_format(values.end - values.start))
        .y_desc(axis_name(channel))
        .axis_style(INK)
        .label_style(font(13))
        .axis_desc_style(font(14))
        .draw()?;
    let points = envelope
        .buckets()
        .flat_map(|Bucket { first, last }| [first, last]);
    chart.draw_series(LineSeries::new(points, colour.stroke_width(LINE)))?;
    Ok(())
}

/// Quantity and unit, as `x in µm`.
fn axis_name(channel: Channel) -> String {
    let name = match channel {
        Channel::Displacement(3) => "θx",
        Channel::Displacement(4) => "θy",
        other => other.name(),
    };
    format!("{name} in µ{}", channel.unit())
}
