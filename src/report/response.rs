//! Branches of steady motions over a parameter.

use serde::Serialize;
use serde_json::json;

use super::figure::{Axis, Colour, Curve, Figure, GREY, Name, Panel, Point, distinct};
use super::terminal::{Lines, MICRO, measured_text};
use super::variable::{axis_label, shown, variable_column};
use super::{FileSet, Findings};
use crate::analysis::Channel;
use crate::scenario::Scenario;
use crate::shooting::SpecialKind;
use crate::steady::{MotionRange, Response, ResponsePoint};
use crate::study::Variable;
use crate::table::Table;

/// Error of the motions of a response: of that where it is largest compared with the motion, the largest difference of a mean or
/// peak-to-peak range of a displacement from that of a motion found more exactly.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct ResponseError {
    /// Value of the parameter.
    value: f64,
    /// The difference, m.
    displacement_m: f64,
    /// That difference over the largest peak-to-peak range.
    relative: f64,
    /// Tolerances of both.
    tolerance: f64,
    reference_tolerance: f64,
}

impl ResponseError {
    /// The largest error of the motions of some branches, with the tolerance that was asked for; none where none was measured.
    pub fn largest(branches: &[Response], tolerance: f64) -> Option<Self> {
        let points = branches.iter().flat_map(|branch| &branch.points);
        let measured = points.filter_map(|point| Some((point.value, point.range_error?)));
        let (value, largest) = measured.max_by(|a, b| a.1.relative.total_cmp(&b.1.relative))?;
        Some(Self {
            value,
            displacement_m: largest.displacement,
            relative: largest.relative,
            tolerance,
            reference_tolerance: largest.reference_tolerance,
        })
    }

    fn text(&self, variable: &Variable) -> String {
        let sizes = [self.displacement_m, self.relative];
        let measured = measured_text(sizes, [self.tolerance, self.reference_tolerance]);
        format!("{measured}, at {}", shown(variable, self.value))
    }
}

/// Branches of steady motions along a parameter.
pub fn response_findings(
    scenario: &Scenario,
    variable: &Variable,
    branches: &[Response],
    error: Option<ResponseError>,
    warnings: &[String],
) -> Findings {
    let title = &scenario.title;
    // the motions are in `response.csv`
    let found = json!({
        "over": variable.key,
        "unit": variable.unit,
        "branches": branches,
        "measured_error": error,
        "warnings": warnings,
    });
    let mut text = text(title, variable, branches);
    if let Some(error) = error {
        text.line("error", error.text(variable));
    }
    Findings {
        tables: vec![
            ("response", table(variable, branches, all, false)),
            (
                "response_specials",
                table(variable, branches, specials, true),
            ),
        ],
        figures: vec![figure(title, variable, branches)],
        incomplete: branches.iter().any(|branch| branch.incomplete),
        ..Findings::new(FileSet::sealed("response.json"), scenario, found, text)
    }
}

/// Branches, where they turn and where their motions change their kind.
fn text(title: &str, variable: &Variable, branches: &[Response]) -> Lines {
    let mut out = Lines::titled(title);
    for (number, branch) in branches.iter().enumerate() {
        let text = format!(
            "{} × the period, {} motions, {}; {}",
            branch.multiple,
            branch.points.len(),
            stability(branch),
            branch.end
        );
        out.line(&format!("branch {}", number + 1), text);
        for special in &branch.specials {
            let multiplier = special.point.multipliers.first();
            let size = multiplier.map_or(f64::NAN, |value| value.norm());
            let text = format!(
                "{} at {}, largest multiplier {size:.6}",
                special.kind,
                shown(variable, special.point.value)
            );
            out.more(text);
        }
        for unrefined in &branch.unrefined {
            let [from, to] = unrefined.between.map(|value| shown(variable, value));
            let text = format!(
                "{} between {from} and {to}, not found any nearer: a jump, {:.1e} are left",
                unrefined.kind, unrefined.left
            );
            out.more(text);
        }
    }
    out
}

/// How many motions of a branch are stable, and how many neutral where any is.
fn stability(branch: &Response) -> String {
    let count = |is: fn(&&ResponsePoint) -> bool| branch.points.iter().filter(is).count();
    let stable = count(|point| point.stable);
    match count(|point| point.neutral) {
        0 => format!("{stable} of them stable"),
        neutral => format!("{stable} of them stable and {neutral} neutral"),
    }
}

/// A motion, and what happens there.
type Row<'a> = (Option<SpecialKind>, &'a ResponsePoint);

/// A column of a displacement or force, and its value.
type Measure = (&'static str, fn(&MotionRange) -> f64);

fn all(branch: &Response) -> Vec<Row<'_>> {
    branch.points.iter().map(|point| (None, point)).collect()
}

fn specials(branch: &Response) -> Vec<Row<'_>> {
    let specials = branch.specials.iter();
    let specials = specials.map(|special| (Some(special.kind), &special.point));
    specials.collect()
}

/// Motions of every branch, in their order along it: all, or those where branches turn or their motions change their
/// kind.
fn table(
    variable: &Variable,
    branches: &[Response],
    motions: fn(&Response) -> Vec<Row<'_>>,
    kinds: bool,
) -> Table<'static> {
    let rows = (1..).zip(branches).flat_map(|(number, branch)| {
        let motions = motions(branch).into_iter();
        motions.map(move |(kind, point)| (number, branch.multiple, kind, point))
    });
    let rows: Vec<_> = rows.collect();
    let mut table = Table::from_items(&rows)
        .count("branch", |(number, ..)| f64::from(*number))
        .count("multiple", |(_, multiple, ..)| f64::from(*multiple));
    if kinds {
        let kind = |kind: &Option<SpecialKind>| kind.map(|kind| kind.to_string());
        table = table.word("kind", |(_, _, own, _)| kind(own).unwrap_or_default());
    }
    table = table
        .column(variable_column(variable), |(.., point)| point.value)
        .number("period", "s", |(.., point)| point.period)
        .count("stable", |(.., point)| f64::from(point.stable))
        .count("neutral", |(.., point)| f64::from(point.neutral));
    // every motion has the columns of the first
    let Some(first) = branches.first().and_then(|branch| branch.points.first()) else {
        return table.end();
    };
    let measures: [Measure; 3] = [
        ("mean", |swing| swing.mean),
        ("peak_to_peak", |swing| swing.peak_to_peak),
        ("rms", |swing| swing.rms),
    ];
    for (index, swing) in first.ranges.iter().enumerate() {
        for (what, measure) in measures {
            let column = swing.channel.measure(what);
            table = table.column(column, |(.., point)| point.ranges.get(index).map(measure));
        }
    }
    for index in 0..first.multipliers.len() {
        let name = |part: &str| format!("multiplier_{}_{part}", index + 1);
        table = table
            .number(name("re"), "", |(.., own)| {
                Some(own.multipliers.get(index)?.re)
            })
            .number(name("im"), "", |(.., own)| {
                Some(own.multipliers.get(index)?.im)
            });
        let mut points = rows.iter().map(|(.., point)| point);
        if points.any(|point| !point.multiplier_errors.is_empty()) {
            table = table.number(name("error"), "", |(.., own)| {
                own.multiplier_errors.get(index).copied()
            });
        }
    }
    table.end()
}

/// Height of a plot, px.
const HEIGHT: u32 = 242;

/// A panel a displacement; what is not stable is grey, marks show where branches turn or change.
fn figure(title: &str, variable: &Variable, branches: &[Response]) -> Figure {
    let points = || branches.iter().flat_map(|branch| &branch.points);
    let values = points().map(|point| variable.shown(point.value));
    let axis = Axis::spanning(axis_label(variable), values);
    let ranges = points().take(1).flat_map(|point| &point.ranges);
    let displacements = ranges
        .map(|swing| swing.channel)
        .filter(|channel| matches!(channel, Channel::Displacement(_)));
    let panels = displacements.enumerate().map(|(index, channel)| {
        let name = (
            format!("{channel} peak to peak"),
            format!("µ{}", channel.unit()),
        );
        let all = branches.iter().enumerate();
        let curves = all.flat_map(|(number, branch)| {
            curves(branch, distinct(number), |point| {
                let swing = point.ranges.get(index);
                let swing = swing.map_or(f64::NAN, |swing| swing.peak_to_peak);
                (variable.shown(point.value), MICRO * swing)
            })
        });
        Panel::holding(axis.clone(), name, HEIGHT, curves.collect())
    });
    let multiples = branches.iter().map(|branch| branch.multiple);
    let names = Name::each(multiples.map(|multiple| format!("{multiple} × the period")));
    let unstable = Name::new("not stable", GREY);
    let figure = Figure::new("response", title, 1, panels.collect());
    figure.with_names(names.into_iter().chain([unstable]))
}

/// A branch cut where its stability changes.
fn curves(branch: &Response, colour: Colour, at: impl Fn(&ResponsePoint) -> Point) -> Vec<Curve> {
    let mut drawn = Vec::<Curve>::new();
    for pair in branch.points.windows(2) {
        let colour = if pair[1].stable { colour } else { GREY };
        match drawn.last_mut().filter(|last| last.colour == colour) {
            Some(last) => last.points.push(at(&pair[1])),
            None => drawn.push(Curve::line(colour, vec![at(&pair[0]), at(&pair[1])])),
        }
    }
    let specials = branch.specials.iter();
    let marks = specials.map(|special| at(&special.point)).collect();
    drawn.push(Curve::dots(colour, marks));
    drawn
}
