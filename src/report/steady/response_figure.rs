//! Branches of steady motions over a parameter: peak to peak of every displacement.

use plotters::style::RGBColor;

use super::super::ReportError;
use super::super::figure::svg;
use super::super::figure_curves::{Curve, Panel, distinct, draw, round_ticks};
use super::super::study::axis_name;
use crate::analysis::Channel;
use crate::report::units::MICRO;
use crate::steady::{Response, ResponsePoint};
use crate::study::Variable;

/// Height of a panel, px.
const PANEL_HEIGHT: u32 = 300;
/// Height of title and names, px.
const HEAD_HEIGHT: u32 = 60;
/// What is not stable.
const GREY: RGBColor = RGBColor(150, 150, 150);

/// A panel a displacement; what is not stable is grey, marks stand where branches turn or change.
pub(super) fn response(
    title: &str,
    variable: &Variable,
    branches: &[Response],
) -> Result<String, ReportError> {
    let points = || branches.iter().flat_map(|branch| &branch.points);
    let values = points().map(|point| variable.shown(point.value));
    let low = values.clone().fold(f64::INFINITY, f64::min);
    let high = values.fold(f64::NEG_INFINITY, f64::max);
    let channels: Vec<Channel> = points()
        .take(1)
        .flat_map(|point| &point.swings)
        .map(|swing| swing.channel)
        .filter(|channel| matches!(channel, Channel::Displacement(_)))
        .collect();
    let panels: Vec<Panel> = channels
        .iter()
        .enumerate()
        .map(|(index, channel)| Panel {
            x_name: axis_name(variable),
            x_ticks: round_ticks(low, high),
            y_name: format!(
                "{channel} peak to peak in {}",
                if channel.unit() == "m" {
                    "µm"
                } else {
                    "µrad"
                }
            ),
            curves: branches
                .iter()
                .enumerate()
                .flat_map(|(number, branch)| curves(variable, branch, index, distinct(number)))
                .collect(),
        })
        .collect();
    let mut names: Vec<(String, RGBColor)> = branches
        .iter()
        .enumerate()
        .map(|(number, branch)| {
            (
                format!("{} × the period", branch.multiple),
                distinct(number),
            )
        })
        .collect();
    names.push(("not stable".to_owned(), GREY));
    svg(
        "response.svg",
        HEAD_HEIGHT + PANEL_HEIGHT * panels.len().max(1) as u32,
        title,
        |area| draw(area, &names, &panels, 1),
    )
}

/// A branch cut where its stability changes.
fn curves(variable: &Variable, branch: &Response, index: usize, colour: RGBColor) -> Vec<Curve> {
    let at = |point: &ResponsePoint| {
        let swing = point
            .swings
            .get(index)
            .map_or(f64::NAN, |swing| swing.peak_to_peak);
        (variable.shown(point.value), MICRO * swing)
    };
    let mut drawn: Vec<Curve> =
        branch
            .points
            .windows(2)
            .fold(Vec::new(), |mut curves: Vec<Curve>, pair| {
                let colour = if pair[1].stable { colour } else { GREY };
                match curves.last_mut().filter(|last| last.colour == colour) {
                    Some(last) => last.points.push(at(&pair[1])),
                    None => curves.push(Curve {
                        points: vec![at(&pair[0]), at(&pair[1])],
                        colour,
                        marks: Vec::new(),
                    }),
                }
                curves
            });
    drawn.push(Curve {
        points: Vec::new(),
        colour,
        marks: branch
            .specials
            .iter()
            .map(|special| at(&special.point))
            .collect(),
    });
    drawn
}
