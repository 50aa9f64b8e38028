//! Natural frequencies over the speed: tables, figure, text and JSON.

use std::f64::consts::TAU;

use serde_json::{Value, json};

use super::figure::{Axis, Colour, Curve, Figure, GREY, Name, Panel, distinct};
use super::shaft_shapes::shapes_at;
use super::terminal::{Lines, PER_SECOND, decimal, or_dash, rounded, shown_column};
use super::{FileSet, Findings};
use crate::analysis::Channel;
use crate::physics::PER_MINUTE;
use crate::rotor::{Mode, RotorDefinition, Whirl};
use crate::scenario::Scenario;
use crate::study::campbell::{Branch, Campbell, CriticalSpeed};
use crate::table::{Column, Table};

/// Branches and critical speeds.
///
/// `rotor` is the shaft of the diagram: where it bends its modes are drawn at the highest speed. `named` are the orders of
/// bearings with their names.
pub fn campbell_findings(
    scenario: &Scenario,
    rotor: &RotorDefinition,
    campbell: &Campbell,
    named: &[(f64, String)],
) -> Findings {
    let [_, fastest] = ends(campbell);
    let branches = campbell.branches.iter().map(|branch| {
        let [first, last] = end_modes(branch).map(|mode| mode.map(Mode::damped_frequency));
        json!({ "whirl": branch.whirl(), "first_Hz": first, "last_Hz": last })
    });
    let title = &scenario.title;
    let mut figures = vec![figure(title, campbell, named)];
    figures.extend(shapes_at(title, rotor, fastest));
    let mut text = Lines::titled(title);
    let reported = |(order, name): &(f64, String)| format!("{name} is order {order:.4}");
    let named_orders: Vec<_> = named.iter().map(reported).collect();
    text.each("order", &named_orders);
    add_branches(&mut text, campbell);
    if let (Some(highest), 1..) = (campbell.highest_frequency, campbell.left_out) {
        text.put(format!(
            "branches above {highest:.0} Hz are left out, {} of them: --highest-frequency asks for more",
            campbell.left_out
        ));
    }
    if campbell.critical_speeds.is_empty() {
        text.put("no critical speed in the range\n");
    } else {
        add_critical(&mut text, campbell, named);
    }
    let found = json!({
        "from_rad_s": campbell.speeds.first(),
        "to_rad_s": campbell.speeds.last(),
        "count": campbell.speeds.len(),
        "orders": campbell.orders,
        "orders_of_bearings": named_orders,
        "highest_frequency_Hz": campbell.highest_frequency,
        "branches_left_out": campbell.left_out,
        "branches": branches.collect::<Value>(),
        "least_assurance": campbell.least_assurance,
        "frequency_error": campbell.frequency_error(),
        "critical_speeds": campbell.critical_speeds,
        "warnings": campbell.warnings,
    });
    Findings {
        tables: vec![("campbell", modes(campbell))],
        figures,
        ..Findings::new(FileSet::sealed("campbell.json"), scenario, found, text)
    }
}

/// The modes, branch by branch from 1 on; the order is missing at rest.
pub(super) fn modes(campbell: &Campbell) -> Table<'static> {
    let branches = campbell.branches.iter().enumerate();
    let modes = branches.flat_map(|(index, branch)| {
        let modes = campbell.speeds.iter().zip(&branch.modes);
        modes.filter_map(move |(speed, mode)| Some((index + 1, *speed, mode.as_ref()?)))
    });
    let modes: Vec<_> = modes.collect();
    Table::from_items(&modes)
        .number("speed", "rad/s", |(_, speed, _)| *speed)
        .count("branch", |(branch, ..)| *branch as f64)
        .number("frequency", "Hz", |(.., mode)| mode.damped_frequency())
        .number("undamped_frequency", "Hz", |(.., mode)| {
            mode.eigenvalue.norm() / TAU
        })
        .number("damping_ratio", "", |(.., mode)| mode.damping_ratio())
        .number("order", "", |(_, speed, mode)| {
            (*speed > 0.0).then(|| mode.damped_frequency() * TAU / speed)
        })
        .word("whirl", |(.., mode)| mode.whirl())
        .number("forward_share", "", |(.., mode)| mode.forward_share())
        .end()
}

fn add_branches(out: &mut Lines, campbell: &Campbell) {
    let speeds = ends(campbell).map(|speed| PER_MINUTE * speed);
    let [first, last] = speeds.map(|speed| format!("Hz at\n{speed:.0} 1/min"));
    let header = ["branch", "whirl", &first, &last, "damping ratio\nthere"];
    let frequency =
        |mode: Option<&Mode>| or_dash(mode.map(|mode| format!("{:.2}", mode.damped_frequency())));
    let rows = campbell.branches.iter().enumerate().map(|(index, branch)| {
        let [first, last] = end_modes(branch);
        vec![
            (index + 1).to_string(),
            branch.whirl().to_string(),
            frequency(first),
            frequency(last),
            last.map_or_else(String::new, |mode| decimal(mode.damping_ratio())),
        ]
    });
    out.table(header, rows);
}

/// The modes of a branch at the first and at the last speed.
fn end_modes(branch: &Branch) -> [Option<&Mode>; 2] {
    [branch.modes.first(), branch.modes.last()].map(|mode| mode?.as_ref())
}

/// The critical speeds, each of a branch.
fn critical_table(campbell: &Campbell, named: &[(f64, String)]) -> Table<'static> {
    let whirl = |critical: &CriticalSpeed| {
        let branch = campbell.branches.get(critical.branch);
        branch.map_or(critical.whirl, Branch::whirl)
    };
    Table::from_items(&campbell.critical_speeds)
        .column(Column::order(), |critical| critical.order)
        .word("name", |critical| order_name(critical.order, named))
        .count("branch", |critical| (critical.branch + 1) as f64)
        .word("whirl", whirl)
        .number("speed", "rad/s", |critical| critical.speed)
        .number("frequency", "Hz", |critical| critical.frequency)
        .number("damping_ratio", "", |critical| critical.damping_ratio)
        .end()
}

/// What an order is called: `BPFO of bearing 1`, or `2×`.
fn order_name(order: f64, named: &[(f64, String)]) -> String {
    let known = named.iter().find(|(known, _)| *known == order);
    known.map_or_else(
        || format!("{}×", rounded(order, 2)),
        |(_, name)| name.clone(),
    )
}

fn add_critical(out: &mut Lines, campbell: &Campbell, named: &[(f64, String)]) {
    let shown = [
        ("order", "name"),
        ("branch", "branch"),
        ("whirl", "whirl"),
        ("critical speed", "speed"),
        ("frequency", "frequency"),
        ("damping ratio", "damping_ratio"),
    ];
    out.show(&critical_table(campbell, named), &shown, 5);
    let errors = campbell.critical_speeds.iter();
    let errors = errors.filter_map(|critical| critical.reduction_error);
    if let Some(largest) = errors.max_by(f64::total_cmp) {
        out.put(format!(
            "with more modes of bending in each plane the frequencies there differ by at most {largest:.1e}"
        ));
    }
}

/// Height of a plot, px.
const HEIGHT: u32 = 322;

/// Part of the line of an order at which it is named.
const NAMED_AT: f64 = 0.9;
/// Orders that differ by less than this part of them lie on each other.
const CLOSE: f64 = 0.05;

/// Frequencies with the orders and critical speeds above, damping ratios below.
pub(super) fn figure(title: &str, campbell: &Campbell, named: &[(f64, String)]) -> Figure {
    let whirls = WHIRLS.map(|whirl| Name::new(whirl.to_string(), colour(whirl)));
    let orders = campbell.orders.iter();
    let orders: Vec<String> = orders.map(|order| order_name(*order, named)).collect();
    let orders = Name::new(format!("orders {}", orders.join(", ")), GREY);
    let panels = vec![frequencies(campbell, named), damping(campbell)];
    Figure::new("campbell", title, 1, panels).with_names(whirls.into_iter().chain([orders]))
}

/// In the order of their colours.
const WHIRLS: [Whirl; 4] = [
    Whirl::Forward,
    Whirl::Backward,
    Whirl::Straight,
    Whirl::Axial,
];

fn colour(whirl: Whirl) -> Colour {
    distinct(WHIRLS.iter().position(|known| *known == whirl).unwrap_or(0))
}

fn frequencies(campbell: &Campbell, named: &[(f64, String)]) -> Panel {
    let mut curves = branches(campbell, Mode::damped_frequency);
    let points = curves.iter().flat_map(|curve| &curve.points);
    let top = points.map(|point| point.1).fold(0.0, f64::max);
    let top = campbell
        .highest_frequency
        .map_or(top, |highest| highest.min(top));
    // what leaves the figure is cut
    for curve in &mut curves {
        curve.points.retain(|point| point.1 <= 1.05 * top);
    }
    let [first, last] = ends(campbell);
    // up to the highest frequency, where the line leaves the figure
    let end = |order: f64| last.min(1.05 * top / (order * PER_SECOND)).max(first);
    let mut apart: Vec<(f64, f64)> = Vec::new();
    for order in &campbell.orders {
        // names of lines that lie on each other would cover each other
        if apart
            .iter()
            .all(|(known, _)| (known / order - 1.0).abs() > CLOSE)
        {
            apart.push((*order, end(*order)));
        }
    }
    curves.extend(campbell.orders.iter().map(|order| {
        let end = end(*order);
        let ends = [first, end].map(|speed| (PER_MINUTE * speed, order * speed * PER_SECOND));
        Curve {
            name: order_name(*order, named),
            ..Curve::line(GREY, ends.to_vec())
        }
    }));
    curves.extend(campbell.critical_speeds.iter().map(|critical| {
        let place = (PER_MINUTE * critical.speed, critical.frequency);
        let (order, branch) = (order_name(critical.order, named), critical.branch + 1);
        Curve {
            name: format!("critical speed: branch {branch} crosses {order}"),
            ..Curve::dots(colour(critical.whirl), vec![place])
        }
    }));
    let label = |(order, end): (f64, f64)| {
        let speed = first + NAMED_AT * (end - first);
        let place = (PER_MINUTE * speed, order * speed * PER_SECOND);
        (place, order_name(order, named), GREY)
    };
    let frequency = ("natural frequency", "Hz");
    Panel {
        labels: apart.into_iter().map(label).collect(),
        ..Panel::holding(speeds(campbell), frequency, HEIGHT, curves)
    }
}

/// From zero on, so that what hardly changes looks so.
fn damping(campbell: &Campbell) -> Panel {
    let mut curves = branches(campbell, Mode::damping_ratio);
    let [first, _] = ends(campbell);
    curves.push(Curve::line(GREY, vec![(PER_MINUTE * first, 0.0)]));
    Panel::holding(speeds(campbell), "damping ratio", HEIGHT, curves)
}

/// First and last speed, rad/s.
fn ends(campbell: &Campbell) -> [f64; 2] {
    let ends = [campbell.speeds.first(), campbell.speeds.last()];
    ends.map(|speed| speed.copied().unwrap_or(0.0))
}

fn speeds(campbell: &Campbell) -> Axis {
    let [first, last] = ends(campbell).map(|speed| PER_MINUTE * speed);
    let (label, _) = shown_column(&Channel::Speed.column());
    Axis::over(label, first..last)
}

/// Every branch, cut where it has no mode.
fn branches(campbell: &Campbell, value: fn(&Mode) -> f64) -> Vec<Curve> {
    let mut curves = Vec::new();
    for (index, branch) in campbell.branches.iter().enumerate() {
        let name = format!("branch {}, {}", index + 1, branch.whirl());
        let all = campbell.speeds.iter().zip(&branch.modes);
        let all = all.map(|(speed, mode)| Some((PER_MINUTE * speed, value(mode.as_ref()?))));
        let all: Vec<_> = all.collect();
        for piece in all.split(Option::is_none) {
            let points = piece.iter().copied().flatten().collect();
            curves.push(Curve {
                name: name.clone(),
                ..Curve::line(colour(branch.whirl()), points)
            });
        }
    }
    curves
}
