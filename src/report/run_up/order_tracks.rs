//! The table `order_tracks` and `order_tracks.svg`: amplitude and phase of orders over the speed.

use plotters::style::RGBColor;

use super::super::columns::{amplitude_column, phase_column};
use super::super::figure::svg;
use super::super::figure_curves::{Curve, Panel, distinct, draw, round_ticks};
use super::super::table::{Column, TableTarget};
use super::super::{ReportError, WholeFile};
use crate::analysis::{Channel, OrderTracks, Track};
use crate::report::units::{MICRO, PER_MINUTE};

/// Height of a row of panels, px.
const ROW_HEIGHT: u32 = 270;
/// Height of title and names, px.
const HEAD_HEIGHT: u32 = 60;
/// A phase is drawn where its order has this part of the channel's largest amplitude.
const HEARD: f64 = 0.01;
/// A channel below this part of the loudest one does not move.
const ROUND_OFF: f64 = 1e-9;

/// Writes one row a window: time, speed, then amplitude and phase of every order of every channel.
pub(super) fn write(
    tracks: &OrderTracks,
    target: TableTarget<'_>,
) -> Result<Vec<WholeFile>, ReportError> {
    target.write("order_tracks", &columns(tracks), |take| {
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

/// Draws a row of amplitude and phase for each channel.
pub(super) fn figure(title: &str, tracks: &OrderTracks) -> Result<String, ReportError> {
    let names: Vec<(String, RGBColor)> = tracks
        .orders
        .iter()
        .enumerate()
        .map(|(index, order)| (order.name.clone(), distinct(index)))
        .collect();
    let rows = moving(tracks);
    let panels: Vec<Panel> = rows
        .iter()
        .flat_map(|row| {
            let channel = tracks.channels[*row];
            [
                amplitudes(tracks, *row, channel),
                phases(tracks, *row, channel),
            ]
        })
        .collect();
    let height = HEAD_HEIGHT + ROW_HEIGHT * rows.len() as u32;
    svg("order_tracks.svg", height, title, |area| {
        draw(area, &names, &panels, 2)
    })
}

/// Channels that are more than round-off beside the loudest.
fn moving(tracks: &OrderTracks) -> Vec<usize> {
    let channels = 0..tracks.channels.len();
    let loudest = channels.clone().map(|channel| loudest(tracks, channel));
    let all = loudest.clone().fold(0.0, f64::max);
    let rows = channels.zip(loudest);
    rows.filter(|(_, own)| *own > ROUND_OFF * all)
        .map(|(channel, _)| channel)
        .collect()
}

/// Largest amplitude of any order of a channel.
fn loudest(tracks: &OrderTracks, channel: usize) -> f64 {
    let all = tracks
        .points
        .iter()
        .flat_map(|point| &point.tracks[channel]);
    all.map(|track| track.amplitude).fold(0.0, f64::max)
}

fn amplitudes(tracks: &OrderTracks, index: usize, channel: Channel) -> Panel {
    let curve = |order: usize| Curve {
        points: over_speed(tracks, index, order, |track| Some(MICRO * track.amplitude)),
        colour: distinct(order),
        marks: Vec::new(),
    };
    Panel {
        x_name: "speed in 1/min".to_owned(),
        x_ticks: speed_ticks(tracks),
        y_name: format!("amplitude of {channel} in µm"),
        curves: (0..tracks.orders.len()).map(curve).collect(),
    }
}

fn phases(tracks: &OrderTracks, index: usize, channel: Channel) -> Panel {
    let loudest = loudest(tracks, index);
    let heard =
        |track: &Track| (track.amplitude > HEARD * loudest).then(|| track.phase.to_degrees());
    // dots, for a line would run across the figure where the angle begins anew
    let curve = |order: usize| Curve {
        points: Vec::new(),
        colour: distinct(order),
        marks: over_speed(tracks, index, order, heard),
    };
    let mut curves: Vec<Curve> = (0..tracks.orders.len()).map(curve).collect();
    // the range of the axis, in no colour of its own
    curves.push(Curve {
        points: [-180.0, 180.0]
            .map(|angle| (speed_ticks(tracks)[0], angle))
            .to_vec(),
        colour: RGBColor(255, 255, 255),
        marks: Vec::new(),
    });
    Panel {
        x_name: "speed in 1/min".to_owned(),
        x_ticks: speed_ticks(tracks),
        y_name: format!("phase of {channel} in deg"),
        curves,
    }
}

fn over_speed(
    tracks: &OrderTracks,
    channel: usize,
    order: usize,
    value: impl Fn(&Track) -> Option<f64>,
) -> Vec<(f64, f64)> {
    let points = tracks.points.iter();
    points
        .filter_map(|point| {
            Some((
                PER_MINUTE * point.speed,
                value(&point.tracks[channel][order])?,
            ))
        })
        .collect()
}

fn speed_ticks(tracks: &OrderTracks) -> Vec<f64> {
    let speeds = tracks.points.iter().map(|point| PER_MINUTE * point.speed);
    let (low, high) = speeds.fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), speed| {
        (low.min(speed), high.max(speed))
    });
    round_ticks(low, high)
}
