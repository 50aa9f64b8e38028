//! `waterfall.svg`: short-time spectra over time and over speed, every channel a row.

use plotters::prelude::*;

use super::super::ReportError;
use super::super::figure::{Area, DrawError, INK, font, px, svg, tick_format};
use super::super::figure_curves::graded;
use super::super::png::data_uri;
use super::raster::{DECADES, Raster};
use crate::analysis::{TrackedOrder, Waterfall};
use crate::report::units::{MICRO, PER_MINUTE, PER_SECOND};
use crate::simulate::Maps;

/// Height of a row, px.
const ROW_HEIGHT: u32 = 300;
/// Height of title and scale, px.
const HEAD_HEIGHT: u32 = 70;
/// Height of the scale of colours, px.
const SCALE_HEIGHT: u32 = 30;
/// A channel below this part of the loudest one does not move.
const ROUND_OFF: f64 = 1e-9;
/// Colours of the scale.
const COLOURS: usize = 256;

/// A map of the figure, and the colour that holds its place while the figure is drawn.
struct Place {
    held: RGBColor,
    uri: String,
}

/// Draws the spectra of several runs over what differs between them: a raster with its name a row.
pub(in crate::report) fn draw_runs(
    title: &str,
    over: &str,
    rows: &[(String, Raster)],
) -> Result<String, ReportError> {
    let mut places = Vec::new();
    let height = HEAD_HEIGHT + ROW_HEIGHT * rows.len() as u32;
    let text = svg("waterfall.svg", height, title, |area| {
        let (scale, below) = area.split_vertically(px(SCALE_HEIGHT));
        draw_scale(&scale)?;
        let areas = below.split_evenly((rows.len().max(1), 1));
        for ((name, raster), area) in rows.iter().zip(&areas) {
            let loudest = raster.loudest();
            let axis = Axis {
                name: format!("{over} ({name}: loudest {:.3e} µm)", MICRO * loudest),
                scale: 1.0,
                orders: &[],
            };
            draw_map(area, raster, loudest, &axis, &mut places)?;
        }
        Ok(())
    })?;
    Ok(places.iter().fold(text, placed))
}

/// Draws the SVG, the maps as pictures inside it.
pub(super) fn draw(title: &str, maps: &Maps) -> Result<String, ReportError> {
    let waterfall = &maps.waterfall;
    let rows = moving_rows(waterfall);
    let mut places = Vec::new();
    let height = HEAD_HEIGHT + ROW_HEIGHT * rows.len() as u32;
    let mut text = svg("waterfall.svg", height, title, |area| {
        let (scale, below) = area.split_vertically(px(SCALE_HEIGHT));
        draw_scale(&scale)?;
        let areas = below.split_evenly((rows.len().max(1), 1));
        for (row, area) in rows.iter().zip(&areas) {
            draw_row(area, maps, row, &mut places)?;
        }
        Ok(())
    })?;
    for place in &places {
        text = placed(text, place);
    }
    Ok(text)
}

/// A channel that moves.
struct Row {
    channel: usize,
    over_time: Raster,
    loudest: f64,
}

/// Channels that are more than round-off beside the loudest.
fn moving_rows(waterfall: &Waterfall) -> Vec<Row> {
    let rows = (0..waterfall.channels.len()).map(|channel| {
        let over_time = Raster::over_time(waterfall, channel);
        Row {
            channel,
            loudest: over_time.loudest(),
            over_time,
        }
    });
    let mut rows: Vec<Row> = rows.collect();
    let loudest = rows.iter().map(|row| row.loudest).fold(0.0, f64::max);
    rows.retain(|row| row.loudest > ROUND_OFF * loudest);
    rows
}

/// A channel over time and over speed.
fn draw_row(area: &Area, maps: &Maps, row: &Row, places: &mut Vec<Place>) -> Result<(), DrawError> {
    let waterfall = &maps.waterfall;
    let name = waterfall.channels[row.channel];
    let loudest = MICRO * row.loudest;
    let halves = area.split_evenly((1, 2));
    let time = Axis {
        name: format!("time in s ({name}: loudest {loudest:.3e} µm)"),
        scale: 1.0,
        orders: &[],
    };
    draw_map(&halves[0], &row.over_time, row.loudest, &time, places)?;
    let speed = Axis {
        name: "speed in 1/min".to_owned(),
        scale: PER_MINUTE,
        orders: &maps.tracks.orders,
    };
    let raster = Raster::over_speed(waterfall, row.channel);
    draw_map(&halves[1], &raster, row.loudest, &speed, places)
}

/// The first axis of a map.
struct Axis<'a> {
    name: String,
    scale: f64,
    /// Orders that are drawn as lines over the speed.
    orders: &'a [TrackedOrder],
}

fn palette() -> Vec<[u8; 3]> {
    let colours = (0..COLOURS).map(|index| graded(index, COLOURS));
    colours
        .map(|RGBColor(red, green, blue)| [red, green, blue])
        .collect()
}

fn draw_map(
    area: &Area,
    raster: &Raster,
    loudest: f64,
    axis: &Axis<'_>,
    places: &mut Vec<Place>,
) -> Result<(), DrawError> {
    let [left, right] = raster.ends.map(|end| axis.scale * end);
    let [low, high] = raster.frequencies;
    if right <= left || loudest <= 0.0 {
        return Ok(());
    }
    let (width, pixels) = raster.pixels(loudest);
    // colours that no other part of a figure has
    let place = Place {
        held: RGBColor(1, 2, 3 + places.len() as u8),
        uri: data_uri(width, &pixels, &palette()),
    };
    let mut chart = ChartBuilder::on(area)
        .margin_top(px(8))
        .margin_left(px(8))
        .margin_right(px(20))
        .set_label_area_size(LabelAreaPosition::Left, px(66))
        .set_label_area_size(LabelAreaPosition::Bottom, px(44))
        .build_cartesian_2d(left..right, low..high)?;
    chart
        .configure_mesh()
        .disable_mesh()
        .x_labels(6)
        .y_labels(6)
        .x_label_formatter(&tick_format(right - left))
        .y_label_formatter(&tick_format(high - low))
        .x_desc(&axis.name)
        .y_desc("frequency in Hz")
        .axis_style(INK)
        .label_style(font(12))
        .axis_desc_style(font(13))
        .draw()?;
    let corners = [(left, high), (right, low)];
    chart.draw_series([Rectangle::new(corners, place.held.filled())])?;
    places.push(place);
    for order in axis.orders {
        // 1/min → rad/s → Hz
        let at = |shown: f64| order.order * shown / axis.scale * PER_SECOND;
        let end = right.min(right * high / at(right));
        let line = [(left, at(left)), (end, at(end))];
        chart.draw_series([PathElement::new(line, WHITE.mix(0.55).stroke_width(1))])?;
        let style = font(10).color(&WHITE);
        let near = left + 0.82 * (end - left);
        chart.draw_series([Text::new(order.name.clone(), (near, at(near)), style)])?;
    }
    Ok(())
}

/// Colours from some decades below the loudest cell up to it.
fn draw_scale(area: &Area) -> Result<(), DrawError> {
    let (left, top, bottom) = (px(360) as i32, px(6) as i32, px(20) as i32);
    let step = px(1) as i32;
    for index in 0..COLOURS {
        let from = left + step * index as i32;
        let corners = [(from, top), (from + step, bottom)];
        area.draw(&Rectangle::new(corners, graded(index, COLOURS).filled()))?;
    }
    let below = format!("1e-{DECADES:.0} of the loudest");
    area.draw(&Text::new(below, (px(235) as i32, top), font(12)))?;
    let end = left + step * COLOURS as i32 + px(6) as i32;
    area.draw(&Text::new("the loudest of each row", (end, top), font(12)))?;
    Ok(())
}

/// Puts a picture where a rectangle of its colour was drawn.
fn placed(text: String, place: &Place) -> String {
    let RGBColor(red, green, blue) = place.held;
    let held = format!(" opacity=\"1\" fill=\"#{red:02X}{green:02X}{blue:02X}\" stroke=\"none\"/>");
    let picture = format!(
        " preserveAspectRatio=\"none\" image-rendering=\"optimizeSpeed\" href=\"{}\"/>",
        place.uri
    );
    let Some(end) = text.find(&held) else {
        return text;
    };
    let (before, after) = (&text[..end], &text[end + held.len()..]);
    match before.rfind("<rect") {
        Some(start) => {
            let extent = &before[start + "<rect".len()..];
            format!("{}<image{extent}{picture}{after}", &before[..start])
        }
        None => text,
    }
}
