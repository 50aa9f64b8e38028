//! `campbell.svg`: natural frequencies and damping over the speed.

use plotters::style::RGBColor;

use super::super::ReportError;
use super::super::figure::{PALETTE, svg};
use super::super::figure_curves::{Curve, Panel, draw, round_ticks};
use crate::report::units::{PER_MINUTE, PER_SECOND};
use crate::rotor::{Mode, Whirl};
use crate::study::campbell::Campbell;

/// Height of a panel, px.
const PANEL_HEIGHT: u32 = 380;
/// Height of title and names, px.
const HEAD_HEIGHT: u32 = 60;
/// Orders of the shaft.
const GREY: RGBColor = RGBColor(150, 150, 150);

/// Frequencies with the orders and critical speeds above, damping ratios below.
pub(super) fn draw_campbell(title: &str, campbell: &Campbell) -> Result<String, ReportError> {
    let whirls = [
        Whirl::Forward,
        Whirl::Backward,
        Whirl::Straight,
        Whirl::Axial,
    ];
    let present = |whirl: &Whirl| {
        campbell
            .branches
            .iter()
            .any(|branch| branch.whirl() == *whirl)
    };
    let mut names: Vec<(String, RGBColor)> = whirls
        .into_iter()
        .filter(present)
        .map(|whirl| (whirl.to_string(), colour(whirl)))
        .collect();
    let orders = campbell.orders.iter();
    let orders: Vec<String> = orders.map(|order| hundredths(*order)).collect();
    if !orders.is_empty() {
        names.push((format!("orders {}", orders.join(", ")), GREY));
    }
    let panels = [frequencies(campbell), damping(campbell)];
    svg(
        "campbell.svg",
        HEAD_HEIGHT + 2 * PANEL_HEIGHT,
        title,
        |area| draw(area, &names, &panels, 1),
    )
}

/// An order with up to two decimals.
fn hundredths(order: f64) -> String {
    format!("{}", (100.0 * order).round() / 100.0)
}

fn colour(whirl: Whirl) -> RGBColor {
    match whirl {
        Whirl::Forward => PALETTE[0],
        Whirl::Backward => PALETTE[1],
        Whirl::Straight => PALETTE[2],
        Whirl::Axial => PALETTE[3],
    }
}

fn frequencies(campbell: &Campbell) -> Panel {
    let mut curves = branches(campbell, Mode::damped_frequency);
    let points = curves.iter().flat_map(|curve| &curve.points);
    let top = points.map(|point| point.1).fold(0.0, f64::max);
    let ends = [campbell.speeds.first(), campbell.speeds.last()];
    let [first, last] = ends.map(|speed| speed.copied().unwrap_or(0.0));
    curves.extend(campbell.orders.iter().map(|order| {
        // up to the highest frequency, where the line leaves the figure
        let end = last.min(1.05 * top / (order * PER_SECOND)).max(first);
        let at = |speed: f64| (PER_MINUTE * speed, order * speed * PER_SECOND);
        Curve {
            points: vec![at(first), at(end)],
            colour: GREY,
            marks: Vec::new(),
        }
    }));
    curves.extend(campbell.critical_speeds.iter().map(|critical| Curve {
        points: Vec::new(),
        colour: colour(critical.whirl),
        marks: vec![(PER_MINUTE * critical.speed, critical.frequency)],
    }));
    panel(campbell, "natural frequency in Hz", curves)
}

/// From zero on, so that what hardly changes looks so.
fn damping(campbell: &Campbell) -> Panel {
    let mut curves = branches(campbell, Mode::damping_ratio);
    let first = PER_MINUTE * campbell.speeds.first().copied().unwrap_or(0.0);
    curves.push(Curve {
        points: vec![(first, 0.0)],
        colour: GREY,
        marks: Vec::new(),
    });
    panel(campbell, "damping ratio", curves)
}

fn panel(campbell: &Campbell, name: &str, curves: Vec<Curve>) -> Panel {
    let ends = [campbell.speeds.first(), campbell.speeds.last()];
    let [first, last] = ends.map(|speed| PER_MINUTE * speed.copied().unwrap_or(0.0));
    let mut ticks = round_ticks(first, last);
    // the last speed ends the axis
    let near = 1e-6 * (last - first);
    ticks.retain(|tick| (first..last - near).contains(tick));
    ticks.insert(0, first);
    ticks.dedup();
    ticks.push(last);
    Panel {
        x_name: "speed in 1/min".to_owned(),
        x_ticks: ticks,
        y_name: name.to_owned(),
        curves,
    }
}

/// Every branch, cut where it has no mode.
fn branches(campbell: &Campbell, value: fn(&Mode) -> f64) -> Vec<Curve> {
    let mut curves = Vec::new();
    for branch in &campbell.branches {
        let all = campbell.speeds.iter().zip(&branch.modes);
        let all: Vec<_> = all
            .map(|(speed, mode)| Some((PER_MINUTE * speed, value(mode.as_ref()?))))
            .collect();
        for piece in all.split(Option::is_none) {
            curves.push(Curve {
                points: piece.iter().copied().flatten().collect(),
                colour: colour(branch.whirl()),
                marks: Vec::new(),
            });
        }
    }
    curves
}
