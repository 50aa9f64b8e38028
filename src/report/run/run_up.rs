//! A run whose speed changes: its waterfall and its order tracks.

use serde_json::{Map as Object, Value, json};

use super::order_tracks::order_figure;
use crate::analysis::{Channel, Waterfall};
use crate::physics::PER_MINUTE;
use crate::report::figure::{Axis, Curve, Figure, Label, Panel, WHITE};
use crate::report::findings::with_keys;
use crate::report::raster::{DECADES, Raster, moving};
use crate::report::terminal::{
    Lines, MICRO, PER_SECOND, listed, shown_column, shown_unit, significant,
};
use crate::simulate::{Extreme, Maps, RunUp};
use crate::study::campbell::{Campbell, CriticalSpeed};
use crate::table::{Column, Table};

/// What is drawn of the maps, as far as they are not empty.
pub(in crate::report) fn maps_figures(title: &str, maps: &Maps) -> Vec<Figure> {
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
pub(in crate::report) fn waterfall_table(waterfall: &Waterfall) -> Table<'static> {
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

/// The spectra of several runs over what differs between them: a raster with its title and channel a row.
pub(in crate::report) fn runs_figure(
    title: &str,
    over: impl Into<Label>,
    rows: &[(String, Channel, Raster)],
) -> Figure {
    let over = over.into();
    // one scale a channel and one range of frequencies, so that rows can be compared
    let loudest = |of: Channel| {
        let own = rows.iter().filter(|(_, channel, _)| *channel == of);
        own.map(|(.., raster)| raster.loudest()).fold(0.0, f64::max)
    };
    let contents = rows
        .iter()
        .map(|(_, channel, raster)| raster.content(loudest(*channel)));
    let highest = contents.fold(0.0, f64::max);
    let panels = rows.iter().map(|(title, channel, raster)| {
        let (x, loudest) = (
            Axis::over(over.clone(), raster.range(1.0)),
            loudest(*channel),
        );
        Panel {
            title: title.clone(),
            ..panel(&raster.up_to(highest), *channel, loudest, x)
        }
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
        let (of, loudest) = (waterfall.channels[channel], loudest[channel]);
        let [time, speed] = [&over_time[channel], &Raster::over_speed(waterfall, channel)];
        let [seconds, speeds] =
            [(Channel::Time, time), (Channel::Speed, speed)].map(|(of, raster)| {
                let (label, factor) = shown_column(&of.column());
                Axis::over(label, raster.range(factor))
            });
        let [time, speed] = [time, speed].map(|raster| raster.up_to(raster.content(loudest)));
        let time = panel(&time, of, loudest, seconds);
        let mut speed = panel(&speed, of, loudest, speeds);
        draw_orders(&mut speed, maps);
        [time, speed]
    });
    Figure::new(FILE, title, 2, panels.collect())
}

/// A raster of a channel over an axis that it fills.
fn panel(raster: &Raster, channel: Channel, loudest: f64, x: Axis) -> Panel {
    let [low, high] = raster.frequencies;
    let y = Axis::over(shown_column(&Column::frequency()).0, low..high);
    let is_seen = x.ends[1] > x.ends[0] && loudest > 0.0;
    let (label, factor) = shown_column(&channel.measure("amplitude"));
    let top = (factor * loudest).log10();
    let amplitudes = || Axis::of_logarithms(label, top - DECADES..top);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::BodyQuantity;

    #[test]
    fn panels_of_one_channel_have_its_unit_and_one_scale() {
        let channel = Channel::Body {
            body: crate::rotor::Body::Housing(0),
            quantity: BodyQuantity::Acceleration,
            axis: 1,
        };
        let columns = |size: f64| vec![vec![0.0, size, 1e-2 * size, 1e-5 * size]; 2];
        let rasters = [(1.0, 40.0), (1e-3, 40.0)].map(|(size, high)| {
            let raster = Raster::new([0.0, 1.0], [0.0, high], columns(size));
            (size.to_string(), channel, raster)
        });
        let figure = runs_figure("", "load", &rasters);
        let [first, second] = &figure.panels[..] else {
            panic!("two rows");
        };
        let bar = first.bar.as_ref().unwrap();
        assert_eq!(bar.label.unit, "m/s²");
        assert!((bar.most() - 1.0).abs() < 1e-12);
        assert_eq!(first.bar, second.bar);
        assert_eq!(first.y, second.y);
        // 60 dB below what the scale ends at
        let level = |panel: &Panel| *panel.map.as_ref().unwrap().levels.iter().max().unwrap();
        assert_eq!([level(first), level(second)], [255, 64]);
    }
}
