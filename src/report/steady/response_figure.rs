//! Branches of steady motions over a parameter: peak to peak of every displacement.

use plotters::style::RGBColor;

use super::super::study::axis_name;
use crate::analysis::Channel;
use crate::report::figure::{Axis, Curve, Figure, GREY, Name, Panel, Point, distinct};
use crate::report::units::MICRO;
use crate::steady::{Response, ResponsePoint};
use crate::study::Variable;

/// Height of a plot, px.
const HEIGHT: u32 = 242;

/// A panel a displacement; what is not stable is grey, marks stand where branches turn or change.
pub(super) fn response(title: &str, variable: &Variable, branches: &[Response]) -> Figure {
    let points = || branches.iter().flat_map(|branch| &branch.points);
    let values = points().map(|point| variable.shown(point.value));
    let axis = Axis::spanning(axis_name(variable), values);
    let swings = points().take(1).flat_map(|point| &point.swings);
    let displacements = swings
        .map(|swing| swing.channel)
        .filter(|channel| matches!(channel, Channel::Displacement(_)));
    let panels = displacements.enumerate().map(|(index, channel)| {
        let name = format!("{channel} peak to peak in µ{}", channel.unit());
        let all = branches.iter().enumerate();
        let curves = all.flat_map(|(number, branch)| {
            curves(branch, distinct(number), |point| {
                let swing = point.swings.get(index);
                let swing = swing.map_or(f64::NAN, |swing| swing.peak_to_peak);
                (variable.shown(point.value), MICRO * swing)
            })
        });
        Panel::of(axis.clone(), name, HEIGHT, curves.collect())
    });
    let multiples = branches.iter().map(|branch| branch.multiple);
    let names = Name::each(multiples.map(|multiple| format!("{multiple} × the period")));
    let unstable = Name::new("not stable", GREY);
    let figure = Figure::new("response.svg", title, 1, panels.collect());
    figure.with_names(names.into_iter().chain([unstable]))
}

/// A branch cut where its stability changes.
fn curves(branch: &Response, colour: RGBColor, at: impl Fn(&ResponsePoint) -> Point) -> Vec<Curve> {
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
