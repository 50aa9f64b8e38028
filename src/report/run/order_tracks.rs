//! Amplitudes and phases of orders over the speed.

use crate::analysis::{Channel, OrderTracks, Track};
use crate::physics::PER_MINUTE;
use crate::report::figure::{Axis, Curve, Figure, Name, Panel, Point, distinct};
use crate::report::raster::moving;
use crate::report::terminal::shown_column;
use crate::table::Table;

/// Height of a plot, px.
pub(super) const ORDERS_HEIGHT: u32 = 212;

/// A phase is drawn where its order has this part of the channel's largest amplitude.
pub(super) const LEAST_OF_PHASE: f64 = 0.01;

/// One row a window: time, speed, then amplitude and phase of every order of every channel.
pub(in crate::report) fn tracks_table(tracks: &OrderTracks) -> Table<'static> {
    let mut table = Table::from_items(&tracks.points)
        .number("t", "s", |point| point.time)
        .number("speed", "rad/s", |point| point.speed);
    for (row, channel) in tracks.channels.iter().enumerate() {
        for (index, order) in tracks.tracked.iter().enumerate() {
            let of = column(&order.name);
            let [amplitude, phase] = channel.lines().map(|column| column.of_part(&of));
            table = table
                .column(amplitude, |point| point.tracks[row][index].amplitude)
                .column(phase, |point| point.tracks[row][index].phase);
        }
    }
    table.end()
}

/// `1×` → `order_1`, `2×BPFO` → `BPFO_2x`, `BPFO of bearing 2` → `BPFO_of_bearing_2`, `3× + BPFO` → `order_3_and_BPFO`.
pub(in crate::report) fn column(name: &str) -> String {
    if let Some((one, others)) = name.split_once(" + ") {
        return format!("{}_and_{}", column(one), column(others));
    }
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
    let loudest: Vec<f64> = channels.map(|channel| tracks.loudest(channel)).collect();
    let panels = moving(&loudest).flat_map(|row| {
        let phases = phases(tracks, row, LEAST_OF_PHASE * loudest[row]);
        [amplitudes(tracks, row), phases]
    });
    let names = tracks.tracked.iter().map(|order| order.name.as_str());
    let figure = Figure::new("order_tracks", title, 2, panels.collect());
    figure.with_names(Name::each(names))
}

pub(in crate::report) fn amplitudes(tracks: &OrderTracks, row: usize) -> Panel {
    let (name, factor) = shown_column(&tracks.channels[row].measure("amplitude"));
    let curve = |order: usize| {
        let points = over_speed(tracks, row, order, |track| Some(factor * track.amplitude));
        Curve::line(distinct(order), points)
    };
    let curves = (0..tracks.tracked.len()).map(curve);
    Panel::holding(speeds(tracks), name, ORDERS_HEIGHT, curves.collect())
}

/// Where an order is louder than `least`, in the unit of the channel.
pub(in crate::report) fn phases(tracks: &OrderTracks, row: usize, least: f64) -> Panel {
    let name = (format!("phase of {}", tracks.channels[row]), "deg");
    let phase = |track: &Track| (track.amplitude > least).then(|| track.phase.to_degrees());
    // dots, for a line would run across the figure where the angle begins anew
    let curve = |order| Curve::dots(distinct(order), over_speed(tracks, row, order, phase));
    let angles = Axis::over(name, -190.0..190.0);
    Panel {
        curves: (0..tracks.tracked.len()).map(curve).collect(),
        ..Panel::new(speeds(tracks), angles, ORDERS_HEIGHT)
    }
}

pub(in crate::report) fn over_speed(
    tracks: &OrderTracks,
    channel: usize,
    order: usize,
    value: impl Fn(&Track) -> Option<f64>,
) -> Vec<Point> {
    let values = tracks.points.iter().map(|point| {
        let value = value(&point.tracks[channel][order])?;
        Some((PER_MINUTE * point.speed, value))
    });
    values.flatten().collect()
}

pub(in crate::report) fn speeds(tracks: &OrderTracks) -> Axis {
    let speeds = tracks.points.iter().map(|point| PER_MINUTE * point.speed);
    Axis::spanning(shown_column(&Channel::Speed.column()).0, speeds)
}
