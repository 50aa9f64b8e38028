//! The table `order_tracks` and `order_tracks.svg`: amplitude and phase of orders over the speed.

use super::super::columns::{amplitude_column, phase_column};
use super::super::figure::{Axis, Curve, Figure, Name, Panel, Point, distinct};
use super::super::table::Column;
use super::super::{ReportError, RunFolder, WholeFile};
use super::raster::moving;
use crate::analysis::{OrderTracks, Track};
use crate::report::units::{MICRO, PER_MINUTE};

/// Height of a plot, px.
const HEIGHT: u32 = 212;
/// A phase is drawn where its order has this part of the channel's largest amplitude.
const HEARD: f64 = 0.01;

/// Writes one row a window: time, speed, then amplitude and phase of every order of every channel.
pub(super) fn write(
    tracks: &OrderTracks,
    folder: &RunFolder,
) -> Result<Vec<WholeFile>, ReportError> {
    folder.write_rows("order_tracks", &columns(tracks), |take| {
        tracks.points.iter().try_for_each(|point| {
            let tracks = point.tracks.iter().flatten();
            let mut row = vec![point.time, point.speed];
            row.extend(tracks.flat_map(|track| [track.amplitude, track.phase]));
            take(&row)
        })
    })
}

fn columns(tracks: &OrderTracks) -> Vec<Column> {
    let mut columns = ["t_s", "speed_rad_s"].map(Column::number).to_vec();
    for channel in &tracks.channels {
        for order in &tracks.orders {
            let of = column(&order.name);
            let names = [amplitude_column(*channel), phase_column(*channel)];
            columns.extend(names.map(|name| Column::number(format!("{of}_{name}"))));
        }
    }
    columns
}

/// `1×` → `order_1`, `2×BPFO` → `BPFO_2x`, `BPFO of bearing 2` → `BPFO_of_bearing_2`.
fn column(name: &str) -> String {
    let name = name.replace(' ', "_");
    match name.split_once('×') {
        Some((order, "")) => format!("order_{order}"),
        Some((multiple, of)) => format!("{of}_{multiple}x"),
        None => name,
    }
}

/// A row of amplitude and phase for each channel.
pub(super) fn order_figure(title: &str, tracks: &OrderTracks) -> Figure {
    let channels = 0..tracks.channels.len();
    let loudest = channels.map(|channel| loudest(tracks, channel));
    let loudest: Vec<f64> = loudest.collect();
    let panels = moving(&loudest).flat_map(|row| {
        [
            amplitudes(tracks, row),
            phases(tracks, row, HEARD * loudest[row]),
        ]
    });
    let names = tracks.orders.iter().map(|order| order.name.as_str());
    let figure = Figure::new("order_tracks.svg", title, 2, panels.collect());
    figure.with_names(Name::each(names))
}

/// Largest amplitude of any order of a channel.
fn loudest(tracks: &OrderTracks, channel: usize) -> f64 {
    let points = tracks.points.iter();
    let all = points.flat_map(|point| &point.tracks[channel]);
    all.map(|track| track.amplitude).fold(0.0, f64::max)
}

fn amplitudes(tracks: &OrderTracks, row: usize) -> Panel {
    let name = format!("amplitude of {} in µm", tracks.channels[row]);
    let curve = |order: usize| {
        let points = over_speed(tracks, row, order, |track| Some(MICRO * track.amplitude));
        Curve::line(distinct(order), points)
    };
    let curves = (0..tracks.orders.len()).map(curve);
    Panel::of(speeds(tracks), name, HEIGHT, curves.collect())
}

/// Where an order is louder than `least`, m.
fn phases(tracks: &OrderTracks, row: usize, least: f64) -> Panel {
    let name = format!("phase of {} in deg", tracks.channels[row]);
    let heard = |track: &Track| (track.amplitude > least).then(|| track.phase.to_degrees());
    // dots, for a line would run across the figure where the angle begins anew
    let curve = |order| Curve::dots(distinct(order), over_speed(tracks, row, order, heard));
    Panel {
        curves: (0..tracks.orders.len()).map(curve).collect(),
        ..Panel::new(speeds(tracks), Axis::over(name, -190.0..190.0), HEIGHT)
    }
}

fn over_speed(
    tracks: &OrderTracks,
    channel: usize,
    order: usize,
    value: impl Fn(&Track) -> Option<f64>,
) -> Vec<Point> {
    let mut places = Vec::new();
    for point in &tracks.points {
        if let Some(value) = value(&point.tracks[channel][order]) {
            places.push((PER_MINUTE * point.speed, value));
        }
    }
    places
}

fn speeds(tracks: &OrderTracks) -> Axis {
    let speeds = tracks.points.iter().map(|point| PER_MINUTE * point.speed);
    Axis::spanning("speed in 1/min", speeds)
}
