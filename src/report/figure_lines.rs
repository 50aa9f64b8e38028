//! Axes and legend of a figure of amplitudes or powers over frequency or order.

use std::ops::Range;

use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;

use super::figure::{Area, DrawError, GRID, INK, LINE, font, px, tick_format};

/// Decades shown below the strongest line.
const DECADES: i32 = 6;

/// What the axes of most spectra say.
pub(super) const AMPLITUDE_OVER_FREQUENCY: [&str; 2] = ["frequency in Hz", "amplitude in µm"];

/// Frequency or order, and what stands over it.
pub(super) type LineChart<'a, 'b> =
    ChartContext<'a, SVGBackend<'b>, Cartesian2d<RangedCoordf64, LogCoord<f64>>>;

/// Some decades below the strongest amplitude and a little above it.
pub(super) fn amplitude_range(strongest: f64) -> Range<f64> {
    let top = if strongest > 0.0 { strongest } else { 1.0 };
    10f64.powi(top.log10().floor() as i32 - DECADES + 1)..4.0 * top
}

/// Draws the axes over a range of frequencies or orders and of amplitudes or powers, with what they say.
pub(super) fn line_chart<'a, 'b>(
    area: &'a Area<'b>,
    places: Range<f64>,
    amplitudes: Range<f64>,
    [below, upright]: [&str; 2],
) -> Result<LineChart<'a, 'b>, DrawError> {
    let mut chart = ChartBuilder::on(area)
        .margin_top(px(8))
        .margin_left(px(12))
        .margin_right(px(24))
        .set_label_area_size(LabelAreaPosition::Left, px(68))
        .set_label_area_size(LabelAreaPosition::Bottom, px(48))
        .build_cartesian_2d(places.clone(), amplitudes.log_scale())?;
    chart
        .configure_mesh()
        .bold_line_style(GRID)
        .light_line_style(TRANSPARENT)
        .x_labels(10)
        .x_label_formatter(&tick_format(places.end))
        .y_label_formatter(&power_of_ten)
        .x_desc(below)
        .y_desc(upright)
        .axis_style(INK)
        .label_style(font(13))
        .axis_desc_style(font(14))
        .draw()?;
    Ok(chart)
}

/// A stroke of the legend.
pub(super) fn legend_stroke(from: (i32, i32), colour: RGBColor) -> PathElement<(i32, i32)> {
    let to = (from.0 + px(20) as i32, from.1);
    PathElement::new([from, to], colour.stroke_width(2 * LINE))
}

/// Draws the names of what was drawn before.
pub(super) fn draw_legend<'a, 'b: 'a>(chart: &mut LineChart<'a, 'b>) -> Result<(), DrawError> {
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .margin(px(8))
        .legend_area_size(px(28))
        .background_style(WHITE.mix(0.85))
        .border_style(GRID)
        .label_font(font(14))
        .draw()?;
    Ok(())
}

/// `10⁻³`.
fn power_of_ten(value: &f64) -> String {
    let exponent = value.log10().round() as i32;
    let superscript = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32('⁰' as u32 + digit as u32 - '0' as u32).unwrap_or(digit),
    };
    let exponent: String = exponent.to_string().chars().map(superscript).collect();
    format!("10{exponent}")
}
