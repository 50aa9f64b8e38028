//! What all figures share: size, fonts, colours, axes.

use plotters::coord::Shift;
use plotters::prelude::*;

use super::ReportError;

/// Width of a figure, px.
pub(super) const WIDTH: u32 = 900;

/// Drawing units a pixel: the library draws at whole units, so this is the sharpness of curves.
pub(super) const SCALE: u32 = 2;

/// Colours of Okabe & Ito (2008) that are told apart by every kind of colour vision.
pub(super) const PALETTE: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
];

/// Width of a curve, drawing units.
pub(super) const LINE: u32 = 2;

/// Text and axes.
pub(super) const INK: RGBColor = RGBColor(40, 40, 40);
/// Grid.
pub(super) const GRID: RGBColor = RGBColor(225, 225, 225);

/// Points of a curve: more cannot be seen on the width of a figure.
pub(super) const CURVE_BUCKETS: usize = 2048;

/// What the drawing library answers.
pub(super) type DrawError = Box<dyn std::error::Error + Send + Sync>;

/// The area that a figure is drawn on.
pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Lengths in px as drawing units.
pub(super) const fn px(pixels: u32) -> u32 {
    pixels * SCALE
}

/// A font of `size` px. No system font is needed: the text is drawn by whoever shows the SVG.
pub(super) fn font(size: u32) -> TextStyle<'static> {
    ("sans-serif", px(size)).into_font().color(&INK)
}

/// Draws an SVG of [`WIDTH`] × `height` px with `title` above what `draw` puts below it.
pub(super) fn svg(
    figure: &'static str,
    height: u32,
    title: &str,
    draw: impl FnOnce(&Area) -> Result<(), DrawError>,
) -> Result<String, ReportError> {
    let mut text = String::new();
    render(&mut text, height, title, draw)
        .map_err(|source| ReportError::Draw { figure, source })?;
    // The canvas is SCALE times as large as the picture that shows it.
    let canvas = format!("width=\"{}\" height=\"{}\"", px(WIDTH), px(height));
    let picture = format!("width=\"{WIDTH}\" height=\"{height}\"");
    Ok(text.replacen(&canvas, &picture, 1))
}

fn render(
    text: &mut String,
    height: u32,
    title: &str,
    draw: impl FnOnce(&Area) -> Result<(), DrawError>,
) -> Result<(), DrawError> {
    let root = SVGBackend::with_string(text, (px(WIDTH), px(height))).into_drawing_area();
    root.fill(&WHITE)?;
    let below = root
        .margin(px(8), 0, 0, 0)
        .titled(&printable(title), font(18))?;
    draw(&below)?;
    root.present()?;
    Ok(())
}

/// Text without the control characters that XML 1.0 forbids.
fn printable(text: &str) -> String {
    let blank = |c: char| if c.is_control() { ' ' } else { c };
    text.chars().map(blank).collect()
}

/// Formats numbers of an axis of the given span with as many decimals as tell its ticks apart.
pub(super) fn tick_format(span: f64) -> impl Fn(&f64) -> String {
    let decimals = (1.0 - span.log10().floor()).clamp(0.0, 12.0) as usize;
    move |value| {
        // No minus sign before zeros.
        let value = if value.abs() < span * 1e-6 {
            0.0
        } else {
            *value
        };
        format!("{value:.decimals$}")
    }
}

/// An envelope of values with a margin, never empty: a constant gets a visible neighbourhood.
pub(super) fn padded_range(low: f64, high: f64) -> std::ops::Range<f64> {
    if low > high {
        return -1.0..1.0;
    }
    let scale = low.abs().max(high.abs());
    let smallest = if scale > 0.0 { 1e-6 * scale } else { 1.0 };
    let margin = 0.06 * (high - low).max(smallest);
    low - margin..high + margin
}
