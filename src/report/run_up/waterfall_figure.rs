//! `waterfall.svg`: short-time spectra over time and over speed, every channel a row.

use super::raster::{DECADES, Raster, moving};
use crate::report::figure::{Axis, Curve, Figure, Name, Panel, WHITE, graded};
use crate::report::units::{MICRO, PER_MINUTE, PER_SECOND};
use crate::simulate::Maps;

/// Height of a plot, px.
const HEIGHT: u32 = 242;
/// Name of the file.
const FILE: &str = "waterfall.svg";

/// The spectra of several runs over what differs between them: a raster with its name a row.
pub(in crate::report) fn runs_figure(title: &str, over: &str, rows: &[(String, Raster)]) -> Figure {
    let panels = rows.iter().map(|(name, raster)| {
        let loudest = raster.loudest();
        panel(raster, loudest, heard(over, name, loudest), 1.0)
    });
    Figure::new(FILE, title, 1, panels.collect()).with_names(levels())
}

/// Every channel that moves over time and, with its orders, over speed.
pub(super) fn waterfall_figure(title: &str, maps: &Maps) -> Figure {
    let waterfall = &maps.waterfall;
    let channels = 0..waterfall.channels.len();
    let over_time: Vec<Raster> = channels
        .map(|channel| Raster::over_time(waterfall, channel))
        .collect();
    let loudest: Vec<f64> = over_time.iter().map(Raster::loudest).collect();
    let panels = moving(&loudest).flat_map(|channel| {
        let (name, loudest) = (waterfall.channels[channel].name(), loudest[channel]);
        let time = heard("time in s", name, loudest);
        let time = panel(&over_time[channel], loudest, time, 1.0);
        let speed = Raster::over_speed(waterfall, channel);
        let mut speed = panel(&speed, loudest, "speed in 1/min".to_owned(), PER_MINUTE);
        draw_orders(&mut speed, maps);
        [time, speed]
    });
    Figure::new(FILE, title, 2, panels.collect()).with_names(levels())
}

/// What is below, with the loudest amplitude in m.
fn heard(below: &str, name: &str, loudest: f64) -> String {
    format!("{below} ({name}: loudest {:.3e} µm)", MICRO * loudest)
}

/// A raster over an axis that shows its ends times `scale`.
fn panel(raster: &Raster, loudest: f64, below: String, scale: f64) -> Panel {
    let [left, right] = raster.ends.map(|end| scale * end);
    let [low, high] = raster.frequencies;
    let x = Axis::over(below, left..right);
    let y = Axis::over("frequency in Hz", low..high);
    Panel {
        map: (right > left && loudest > 0.0).then(|| raster.map(loudest)),
        ..Panel::new(x, y, HEIGHT)
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
            ..Curve::line(WHITE, line.to_vec())
        });
        let near = left + 0.82 * (end - left);
        let name = order.name.clone();
        panel.labels.push(((near, at(near)), name, WHITE));
    }
}

/// What the colours mean: some decades below the loudest cell up to it.
fn levels() -> Vec<Name> {
    let decades = DECADES as usize;
    let level = |decade: usize| {
        let text = match decades - decade {
            0 => "1".to_owned(),
            below if below == decades => format!("1e-{below} of the loudest of each row"),
            below => format!("1e-{below}"),
        };
        Name::new(text, graded(decade, decades + 1))
    };
    (0..=decades).map(level).collect()
}
