//! How much the numbers of a study follow what was drawn, as bars.

use plotters::prelude::*;

use super::digest::Digest;
use super::figures::HEAD_HEIGHT;
use crate::report::ReportError;
use crate::report::figure::{Area, DrawError, INK, font, px, svg};
use crate::report::figure_curves::distinct;

/// Height of a bar, px.
const BAR: u32 = 26;

impl Digest {
    /// How much the numbers shown follow each axis.
    pub(super) fn tornado(&self, title: &str) -> Option<Result<String, ReportError>> {
        let names: Vec<_> = self
            .shown()
            .iter()
            .map(|shown| &self.columns[shown.column].name)
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
