//! A run whose speed changes: its waterfall and its order tracks.

use std::ops::Range;

use serde_json::{Map as Object, Value, json};

use super::figure::{Axis, Curve, Figure, Label, Map, Name, Panel, Point, WHITE, distinct};
use super::findings::with_keys;
use super::terminal::{
    Lines, MICRO, PER_MINUTE, PER_SECOND, listed, shown_column, shown_unit, significant,
};
use crate::analysis::{Channel, OrderTracks, Slice, Track, Waterfall};
use crate::simulate::{Extreme, Maps, RunUp};
use crate::study::campbell::{Campbell, CriticalSpeed};
use crate::table::{Column, Table};

/// What is drawn of the maps, as far as they are not empty.
pub(super) fn maps_figures(title: &str, maps: &Maps) -> Vec<Figure> {
    let waterfall = !maps.waterfall.slices.is_empty();
    let tracks = !maps.tracks.points.is_empty();
    let waterfall = waterfall.then(|| waterfall_figure(title, maps));
    let tracks = tracks.then(|| order_figure(title, &maps.tracks));
    waterfall.into_iter().chain(tracks).collect()
}

/// The largest motion and the critical speeds that were passed, which are known where the run is mapped.
pub(super) fn run_up_json(run_up: &RunUp, campbell: Option<&Campbell>) -> Value {
    let axes = run_up.axes.iter();
    let axes: Object<_, _> = axes
        .map(|(channel, extreme)| (channel.name().to_owned(), json!(extreme)))
        .collect();
    let passed = campbell.map(|campbell| campbell.passed(run_up));
    let further = json!({
        "meaning": "largest distances from the static equilibrium, in m and rad, and when and at which speed they were reached; critical \
                    speeds of the linearised shaft that its own order crossed",
        "axes": axes,
        "critical_speeds_passed": passed,
    });
    with_keys(run_up, further)
}

/// The largest motion and the critical speeds that were passed.
pub(super) fn add_run_up(out: &mut Lines, run_up: &RunUp, campbell: Option<&Campbell>) {
    let at = |extreme: &Extreme| {
        let rpm = PER_MINUTE * extreme.speed;
        format!("at {rpm:.0} rpm, {:.4} s", extreme.time)
    };
    let radial = &run_up.radial;
    let size = significant(MICRO * radial.amplitude);
    out.line(
        "peak",
        format!("{size} µm from the equilibrium {}", at(radial)),
    );
    for (channel, extreme) in &run_up.axes {
        let (unit, scale) = shown_unit(channel.unit());
        let size = significant(scale * extreme.amplitude);
        out.more(format!("{channel} {size} {unit} {}", at(extreme)));
    }
    let Some(campbell) = campbell else { return };
    let passed = campbell.passed(run_up);
    let text = |critical: &CriticalSpeed| {
        let (rpm, damping) = (PER_MINUTE * critical.speed, critical.damping_ratio);
        format!("{rpm:.1} rpm ({}, ζ {damping:.3})", critical.whirl)
    };
    match passed[..] {
        [] => out.line("critical", "no critical speed of 1× was passed"),
        _ => out.line(
            "critical",
            format!("passed {}", listed(passed.iter().map(text))),
        ),
    }
}

/// What the maps of a run-up rest on.
pub(super) fn maps_json(maps: &Maps) -> Value {
    let (waterfall, tracks) = (&maps.waterfall, &maps.tracks);
    json!({
        "waterfall": {
            "window": "hann",
            "window_s": waterfall.window(),
            "samples": waterfall.length,
            "overlap_samples": waterfall.length - waterfall.hop,
            "resolution_Hz": waterfall.resolution,
            "frequencies": waterfall.bins(),
            "spectra": waterfall.slices.len(),
            "scaling": "one-sided, peak values; the mean is kept at frequency zero",
        },
        "order_tracks": {
            "window": "hann over the angle of the shaft",
            "window_revolutions": tracks.revolutions,
            "resolution_orders": tracks.resolution(),
            "bandwidth_orders": tracks.bandwidth(),
            "points": tracks.points.len(),
            "orders": tracks.orders,
            "tracks": tracks.tracked.iter().zip(&tracks.bias).map(|(track, bias)| {
                json!({ "name": track.name, "order": track.order, "bias": bias })
            }).collect::<Value>(),
            "bias": "what is left of the averaging over a window at the largest amplitude, in parts of it",
            "scaling": "peak values; phase of cos(order psi + phase), psi the angle of the shaft; mean \
                        and all orders fitted together by weighted least squares, what a window averages taken away \
                        again; orders closer than the resolution share a track at their mean",
        },
    })
}

/// Time, mean speed and frequency, then the amplitude of every channel.
pub(super) fn waterfall_columns(waterfall: &Waterfall) -> Vec<Column> {
    let mut columns = [Channel::Time, Channel::Speed]
        .map(Channel::column)
        .to_vec();
    columns.push(Column::frequency());
    columns.extend(
        waterfall
            .channels
            .iter()
            .map(|channel| channel.measure("amplitude")),
    );
    columns
}

/// A row a frequency of every spectrum.
pub(super) fn waterfall_table(waterfall: &Waterfall) -> Table<'static> {
    Table::of_rows(waterfall_columns(waterfall), waterfall_rows(waterfall))
}

/// Its rows, spectrum by spectrum: as a table they would be too long to be held twice.
pub(super) fn waterfall_rows(waterfall: &Waterfall) -> impl Iterator<Item = Vec<f64>> {
    waterfall.slices.iter().flat_map(|slice| {
        (0..waterfall.bins()).map(|k| {
            let place = [slice.time, slice.speed, k as f64 * waterfall.resolution];
            let amplitudes = slice.amplitude.iter().map(|amplitude| amplitude[k]);
            place.into_iter().chain(amplitudes).collect()
        })
    })
}

/// Height of a plot, px.
const WATERFALL_HEIGHT: u32 = 242;
/// Name of the file.
const FILE: &str = "waterfall";

/// The spectra of several runs over what differs between them: a raster with its name a row.
pub(in crate::report) fn runs_figure(
    title: &str,
    over: impl Into<Label>,
    rows: &[(String, Raster)],
) -> Figure {
    let over = over.into();
    let panels = rows.iter().map(|(name, raster)| {
        let x = Axis::over(over.clone(), raster.range(1.0));
        panel(raster, name, raster.loudest(), x)
    });
    Figure::new(FILE, title, 1, panels.collect())
}

/// Every channel that moves over time and, with its orders, over speed.
fn waterfall_figure(title: &str, maps: &Maps) -> Figure {
    let waterfall = &maps.waterfall;
    let channels = 0..waterfall.channels.len();
    let over_time = channels.map(|channel| Raster::over_time(waterfall, channel));
    let over_time: Vec<Raster> = over_time.collect();
    let loudest: Vec<f64> = over_time.iter().map(Raster::loudest).collect();
    let panels = moving(&loudest).flat_map(|channel| {
        let (name, loudest) = (waterfall.channels[channel].name(), loudest[channel]);
        let [time, speed] = [&over_time[channel], &Raster::over_speed(waterfall, channel)];
        let [seconds, speeds] =
            [(Channel::Time, time), (Channel::Speed, speed)].map(|(of, raster)| {
                let (label, factor) = shown_column(&of.column());
                Axis::over(label, raster.range(factor))
            });
        let time = panel(time, name, loudest, seconds);
        let mut speed = panel(speed, name, loudest, speeds);
        draw_orders(&mut speed, maps);
        [time, speed]
    });
    Figure::new(FILE, title, 2, panels.collect())
}

/// A raster over an axis that it fills, up to a little above its content.
fn panel(raster: &Raster, name: &str, loudest: f64, x: Axis) -> Panel {
    let raster = &raster.up_to_content(loudest);
    let [low, high] = raster.frequencies;
    let y = Axis::over(shown_column(&Column::frequency()).0, low..high);
    let is_seen = x.ends[1] > x.ends[0] && loudest > 0.0;
    let top = (MICRO * loudest).log10();
    let amplitudes =
        || Axis::of_logarithms((format!("{name} amplitude"), "µm"), top - DECADES..top);
    Panel {
        map: is_seen.then(|| raster.map(loudest)),
        bar: is_seen.then(amplitudes),
        ..Panel::new(x, y, WATERFALL_HEIGHT)
    }
}

/// Orders as lines over the speed, each with its name near its end.
fn draw_orders(panel: &mut Panel, maps: &Maps) {
    let (left, right, high) = (panel.x.least(), panel.x.most(), panel.y.most());
    for order in &maps.tracks.orders {
        // 1/min → rad/s → Hz
        let at = |shown: f64| order.order * shown / PER_MINUTE * PER_SECOND;
        let end = right.min(right * high / at(right));
        let line = [left, end].map(|speed| (speed, at(speed)));
        panel.curves.push(Curve {
            fine: true,
            name: order.name.clone(),
            ..Curve::line(WHITE, line.to_vec())
        });
        let near = left + 0.82 * (end - left);
        let name = order.name.clone();
        panel.labels.push(((near, at(near)), name, WHITE));
    }
}

/// Most cells along an axis: more cannot be seen.
pub(in crate::report) const MOST_CELLS: usize = 320;
/// Cells along the axis of speed.
const SPEED_CELLS: usize = 200;
/// Decades below the loudest cell that are told apart.
const DECADES: f64 = 4.0;
/// Part of the largest amplitude that counts as content, and how far beyond its highest frequency a map goes.
const CONTENT: f64 = 1e-3;
const BEYOND: f64 = 1.2;
/// A channel below this part of the loudest one does not move.
const ROUND_OFF: f64 = 1e-9;
/// Bins that hold the mean, which was taken away.
const MEAN_BINS: usize = 1;

/// Amplitudes over one axis and frequency.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::report) struct Raster {
    /// Ends of the first axis, s or rad/s.
    pub ends: [f64; 2],
    /// Ends of the axis of frequencies, Hz.
    pub frequencies: [f64; 2],
    /// Columns by the first axis, each by rising frequency, m.
    columns: Vec<Vec<f64>>,
}

impl Raster {
    /// Of columns at even steps, each by rising frequency, m.
    pub fn new(ends: [f64; 2], frequencies: [f64; 2], columns: Vec<Vec<f64>>) -> Self {
        Self {
            ends,
            frequencies,
            columns,
        }
    }

    /// Over time: a column a spectrum, neighbours joined where they are too many.
    pub fn over_time(waterfall: &Waterfall, channel: usize) -> Self {
        let slices = &waterfall.slices;
        let step = waterfall.window() * waterfall.hop as f64 / waterfall.length as f64;
        let columns = slices
            .chunks(slices.len().div_ceil(MOST_CELLS).max(1))
            .map(|some| mean_square(waterfall, channel, some.iter()))
            .collect();
        let ends = [slices.first(), slices.last()];
        let [first, last] = ends.map(|slice| slice.map_or(0.0, |slice| slice.time));
        Self {
            ends: [first - 0.5 * step, last + 0.5 * step],
            frequencies: frequencies(waterfall),
            columns,
        }
    }

    /// Over speed: in a column all spectra of about its speed, or the nearest one where there is none.
    pub fn over_speed(waterfall: &Waterfall, channel: usize) -> Self {
        let slices = || waterfall.slices.iter();
        let speeds = || slices().map(|slice| slice.speed);
        let (low, high) = (
            speeds().fold(f64::INFINITY, f64::min),
            speeds().fold(0.0, f64::max),
        );
        let step = (high - low) / SPEED_CELLS as f64;
        let columns = (0..SPEED_CELLS).map(|cell| {
            let middle = low + (cell as f64 + 0.5) * step;
            let away = |speed: f64| (speed - middle).abs();
            let nearest = speeds().map(away).fold(f64::INFINITY, f64::min);
            let reach = nearest.max(0.5 * step);
            let about = slices().filter(|slice| away(slice.speed) <= reach);
            mean_square(waterfall, channel, about)
        });
        Self {
            ends: [low, high],
            frequencies: frequencies(waterfall),
            columns: columns.collect(),
        }
    }

    /// What the first axis shows, in a unit of which `scale` make one of its own.
    fn range(&self, scale: f64) -> Range<f64> {
        scale * self.ends[0]..scale * self.ends[1]
    }

    /// Loudest cell but for the mean, m.
    pub fn loudest(&self) -> f64 {
        let cells = self
            .columns
            .iter()
            .flat_map(|column| column.iter().skip(MEAN_BINS));
        cells.copied().fold(0.0, f64::max)
    }

    /// Without what is far above the highest frequency of its content.
    fn up_to_content(&self, loudest: f64) -> Self {
        let counts = |value: &f64| *value > CONTENT * loudest;
        let highest = |column: &Vec<f64>| column.iter().rposition(counts);
        let rows = self.columns.iter().filter_map(highest).max();
        let all = self.columns.first().map_or(0, Vec::len);
        let kept = rows
            .map_or(all, |row| (BEYOND * (row + 1) as f64).ceil() as usize)
            .min(all);
        let [low, high] = self.frequencies;
        let columns = self
            .columns
            .iter()
            .map(|column| column[..kept.min(column.len())].to_vec());
        Self {
            ends: self.ends,
            frequencies: [low, low + (high - low) * kept as f64 / all.max(1) as f64],
            columns: columns.collect(),
        }
    }

    /// Levels from the highest frequency down, 0 at [`DECADES`] below `loudest` or less, 255 there or above.
    pub fn map(&self, loudest: f64) -> Map {
        let height = self.columns.first().map_or(0, Vec::len);
        let joined = height.div_ceil(MOST_CELLS).max(1);
        let level = |row: usize, column: &Vec<f64>| {
            let cells = column[row * joined..((row + 1) * joined).min(height)].iter();
            let value = cells.copied().fold(0.0, f64::max);
            let part = 1.0 + (value / loudest).log10() / DECADES;
            (255.0 * part.clamp(0.0, 1.0)).round() as u8
        };
        let rows = (0..height.div_ceil(joined)).rev();
        let pixels = rows.flat_map(|row| self.columns.iter().map(move |column| level(row, column)));
        Map {
            width: self.columns.len(),
            levels: pixels.collect(),
        }
    }
}

/// Which channels are more than round-off beside the loudest, by the largest amplitude of each.
pub(in crate::report) fn moving(loudest: &[f64]) -> impl Iterator<Item = usize> {
    let floor = ROUND_OFF * loudest.iter().copied().fold(0.0, f64::max);
    (0..loudest.len()).filter(move |channel| loudest[*channel] > floor)
}

/// A bin is as wide as the step of frequencies, about its middle.
fn frequencies(waterfall: &Waterfall) -> [f64; 2] {
    let half = 0.5 * waterfall.resolution;
    [-half, waterfall.bins() as f64 * waterfall.resolution - half]
}

/// Root of the mean square of some spectra.
fn mean_square<'a>(
    waterfall: &Waterfall,
    channel: usize,
    slices: impl Iterator<Item = &'a Slice>,
) -> Vec<f64> {
    let mut sums = vec![0.0; waterfall.bins()];
    let mut count = 0.0;
    for slice in slices {
        count += 1.0;
        for (sum, amplitude) in sums.iter_mut().zip(&slice.amplitude[channel]) {
            *sum += amplitude * amplitude;
        }
    }
    sums.iter().map(|sum: &f64| (sum / count).sqrt()).collect()
}

/// Height of a plot, px.
const ORDERS_HEIGHT: u32 = 212;
/// A phase is drawn where its order has this part of the channel's largest amplitude.
const LEAST_OF_PHASE: f64 = 0.01;

/// One row a window: time, speed, then amplitude and phase of every order of every channel.
pub(super) fn tracks_table(tracks: &OrderTracks) -> Table<'static> {
    let mut table = Table::of(&tracks.points)
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
fn column(name: &str) -> String {
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
fn order_figure(title: &str, tracks: &OrderTracks) -> Figure {
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

fn amplitudes(tracks: &OrderTracks, row: usize) -> Panel {
    let name = (format!("amplitude of {}", tracks.channels[row]), "µm");
    let curve = |order: usize| {
        let points = over_speed(tracks, row, order, |track| Some(MICRO * track.amplitude));
        Curve::line(distinct(order), points)
    };
    let curves = (0..tracks.tracked.len()).map(curve);
    Panel::holding(speeds(tracks), name, ORDERS_HEIGHT, curves.collect())
}

/// Where an order is louder than `least`, m.
fn phases(tracks: &OrderTracks, row: usize, least: f64) -> Panel {
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

fn over_speed(
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

fn speeds(tracks: &OrderTracks) -> Axis {
    let speeds = tracks.points.iter().map(|point| PER_MINUTE * point.speed);
    Axis::spanning(shown_column(&Channel::Speed.column()).0, speeds)
}
