//! `campbell.svg`: natural frequencies and damping over the speed.

use plotters::style::RGBColor;

use crate::report::figure::{Axis, Curve, Figure, GREY, Name, Panel, distinct, round_ticks};
use crate::report::units::{PER_MINUTE, PER_SECOND};
use crate::rotor::{Mode, Whirl};
use crate::study::campbell::Campbell;

/// Height of a plot, px.
const HEIGHT: u32 = 322;

/// Frequencies with the orders and critical speeds above, damping ratios below.
pub(super) fn campbell_figure(title: &str, campbell: &Campbell) -> Figure {
    let whirls = [
        Whirl::Forward,
        Whirl::Backward,
        Whirl::Straight,
        Whirl::Axial,
    ];
    let present = |whirl: &Whirl| {
        let mut branches = campbell.branches.iter();
        branches.any(|branch| branch.whirl() == *whirl)
    };
    let present = whirls.into_iter().filter(present);
    let mut names: Vec<Name> = present
        .map(|whirl| Name::new(whirl.to_string(), colour(whirl)))
        .collect();
    let orders = campbell.orders.iter();
    let orders: Vec<String> = orders.map(|order| hundredths(*order)).collect();
    if !orders.is_empty() {
        names.push(Name::new(format!("orders {}", orders.join(", ")), GREY));
    }
    let panels = vec![frequencies(campbell), damping(campbell)];
    Figure::new("campbell.svg", title, 1, panels).with_names(names)
}

/// An order with up to two decimals.
fn hundredths(order: f64) -> String {
    format!("{}", (100.0 * order).round() / 100.0)
}

fn colour(whirl: Whirl) -> RGBColor {
    distinct(match whirl {
        Whirl::Forward => 0,
        Whirl::Backward => 1,
        Whirl::Straight => 2,
        Whirl::Axial => 3,
    })
}

fn frequencies(campbell: &Campbell) -> Panel {
    let mut curves = branches(campbell, Mode::damped_frequency);
    let points = curves.iter().flat_map(|curve| &curve.points);
    let top = points.map(|point| point.1).fold(0.0, f64::max);
    let [first, last] = ends(campbell);
    curves.extend(campbell.orders.iter().map(|order| {
        // up to the highest frequency, where the line leaves the figure
        let end = last.min(1.05 * top / (order * PER_SECOND)).max(first);
        let ends = [first, end].map(|speed| (PER_MINUTE * speed, order * speed * PER_SECOND));
        Curve::line(GREY, ends.to_vec())
    }));
    curves.extend(campbell.critical_speeds.iter().map(|critical| {
        let place = (PER_MINUTE * critical.speed, critical.frequency);
        Curve::dots(colour(critical.whirl), vec![place])
    }));
    Panel::of(speeds(campbell), "natural frequency in Hz", HEIGHT, curves)
}

/// From zero on, so that what hardly changes looks so.
fn damping(campbell: &Campbell) -> Panel {
    let mut curves = branches(campbell, Mode::damping_ratio);
    let [first, _] = ends(campbell);
    curves.push(Curve::line(GREY, vec![(PER_MINUTE * first, 0.0)]));
    Panel::of(speeds(campbell), "damping ratio", HEIGHT, curves)
}

/// First and last speed, rad/s.
fn ends(campbell: &Campbell) -> [f64; 2] {
    let ends = [campbell.speeds.first(), campbell.speeds.last()];
    ends.map(|speed| speed.copied().unwrap_or(0.0))
}

/// Round speeds between the first and the last, which end the axis.
fn speeds(campbell: &Campbell) -> Axis {
    let [first, last] = ends(campbell).map(|speed| PER_MINUTE * speed);
    let near = 1e-6 * (last - first);
    let mut ticks = round_ticks(first, last);
    ticks.retain(|tick| (first + near..last - near).contains(tick));
    ticks.insert(0, first);
    ticks.push(last);
    Axis::ticked("speed in 1/min", &ticks)
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
            let points = piece.iter().copied().flatten().collect();
            curves.push(Curve::line(colour(branch.whirl()), points));
        }
    }
    curves
}
