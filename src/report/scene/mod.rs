//! The shaft to scale, seen from the side: bearings with their facing and the lines of their contacts, loads,
//! unbalance and housings.
//!
//! Z runs to the right and Y upwards, in mm. Balls, pitch circles, positions and contact angles are those of the
//! scenario; thickness and width of the rings, of which it says nothing, are those of common bearings.

mod drawing;
mod loads;
mod shaft;
mod supports;

use super::figure::{Axis, Figure, Name, Panel, ends};
use super::terminal::MILLI;
use crate::bearing::MountedBearing;
use crate::rotor::RotorDefinition;
use drawing::Drawing;
use shaft::disc_radius;
use supports::radii;

/// Places of the colours.
const RINGS: usize = 0;
const CONTACTS: usize = 1;
const LOADS: usize = 2;
const UNBALANCE: usize = 3;
const HOUSINGS: usize = 4;

/// Sizes that all parts are measured by, mm.
struct Scale {
    /// Radius of the shaft.
    shaft: f64,
    /// Radius of the largest outer ring.
    outer: f64,
    /// Ends of the shaft.
    ends: [f64; 2],
}

/// The shaft of a scenario with all that sits on it.
pub(crate) fn scene_figure(title: &str, rotor: &RotorDefinition) -> Figure {
    let scale = Scale::from_rotor(rotor);
    let mut drawing = Drawing::default();
    match &rotor.flexible {
        Some(flexible) => drawing.flexible(flexible, &scale),
        None => {
            drawing.shaft(&scale);
            drawing.mass(rotor, &scale);
        }
    }
    for (number, element) in (1..).zip(&rotor.elements) {
        if let Some(position) = element.position {
            drawing.element(number, MILLI * position, &element.law, &scale);
            drawing.housing(MILLI * position, element.housing.as_ref(), &scale);
        }
    }
    for (index, bearing) in rotor.bearings.iter().enumerate() {
        drawing.bearing(index + 1, bearing, &scale);
    }
    drawing.loads(rotor, &scale);
    let [left, right] = scale.ends;
    let (high, middle) = (2.3 * scale.outer, 0.5 * (left + right));
    let half = 0.55 * (right - left);
    let panel = Panel {
        curves: drawing.curves,
        labels: drawing.labels,
        aspect: Some(1.0),
        ..Panel::new(
            Axis::over(("z", "mm"), middle - half..middle + half),
            Axis::over(("y", "mm"), -high..high),
            0,
        )
    };
    let names = [
        rings_and_elements(rotor),
        "lines of contact",
        "loads",
        "unbalance",
        "housings",
    ];
    Figure::new("scene", title, 1, vec![panel]).with_names(Name::each(names))
}

impl Scale {
    fn from_rotor(rotor: &RotorDefinition) -> Self {
        let bearings = || rotor.bearings.iter();
        let positions = bearings().map(|bearing| bearing.position);
        let positions = positions.chain(rotor.loads.iter().map(|load| load.position));
        let elements = rotor.elements.iter().filter_map(|own| own.position);
        let positions = positions.chain(elements);
        let positions = positions.map(|position| MILLI * position).chain([0.0]);
        let mut ends = ends(positions).unwrap_or_default();
        let inner = bearings().map(|bearing| radii(bearing)[0]);
        let mut shaft = inner.fold(f64::INFINITY, f64::min);
        let outer = bearings().map(|bearing| radii(bearing)[3]);
        let mut outer = outer.fold(0.0, f64::max);
        if let Some(flexible) = &rotor.flexible {
            ends = flexible.ends().map(|end| MILLI * end);
            let sections = flexible.sections.iter();
            let radii = sections.map(|own| 0.5 * MILLI * own.outer_diameter);
            let thickest = radii.fold(0.02 * (ends[1] - ends[0]), f64::max);
            let discs = flexible.discs.iter().map(|disc| 0.45 * disc_radius(disc));
            outer = discs.fold(outer.max(2.0 * thickest), f64::max);
            shaft = shaft.min(thickest);
        }
        if outer == 0.0 {
            // nothing but springs and a rigid shaft
            outer = 0.1 * (ends[1] - ends[0]).max(100.0);
        }
        Self {
            shaft: shaft.min(outer),
            outer,
            ends: [ends[0] - outer, ends[1] + outer],
        }
    }
}

/// What the rings and what rolls between them is called.
fn rings_and_elements(rotor: &RotorDefinition) -> &'static str {
    let bearings = || rotor.bearings.iter();
    let has_rollers = |own: &MountedBearing| own.bearing.geometry.rollers().is_some();
    match (bearings().any(has_rollers), bearings().all(has_rollers)) {
        (false, _) => "rings and balls",
        (true, true) => "rings and rollers",
        (true, false) => "rings, balls and rollers",
    }
}

#[cfg(test)]
mod tests {
    use super::super::figure::{Curve, distinct};
    use super::*;
    use crate::scenario::Scenario;

    /// The rollers of a motor lie along the shaft, those of a spherical bearing lean with their contacts.
    #[test]
    fn rollers_are_drawn_by_their_length_and_diameter() {
        let motor = include_str!("../../../scenarios/motor-6206-nu206.toml");
        let conveyor = include_str!("../../../scenarios/conveyor-head-22212.toml");
        for (text, count, legend) in [
            (motor, 2, "rings, balls and rollers"),
            (conveyor, 8, "rings and rollers"),
        ] {
            let scenario = Scenario::from_toml(text).expect("a shipped scenario");
            let rotor = &scenario.question.rotor;
            let geometry = rotor.bearings.last().expect("a bearing").bearing.geometry;
            let rollers = geometry.rollers().expect("rollers");
            let size = [rollers.length, geometry.ball_diameter()].map(|length| MILLI * length);
            let figure = scene_figure("", rotor);
            assert_eq!(figure.names[0].text, legend);
            let is_roller = |curve: &&Curve| {
                let distance = |from: usize, to: usize| {
                    let [(x0, y0), (x1, y1)] = [from, to].map(|corner| curve.points[corner]);
                    (x1 - x0).hypot(y1 - y0)
                };
                curve.points.len() == 5
                    && (distance(0, 1) - size[0]).abs() < 1e-9
                    && (distance(1, 2) - size[1]).abs() < 1e-9
            };
            let found = figure.panels[0].curves.iter().filter(is_roller);
            assert_eq!(found.count(), count);
        }
    }

    /// A bearing that is loaded along +Z has its contacts with the outer race on that side of its balls, at its contact
    /// angle; facing the other way it is mirrored.
    #[test]
    fn lines_of_contact_lean_the_way_the_bearing_is_loaded() {
        let text = include_str!("../../../scenarios/back-to-back-7205c.toml");
        let scenario = Scenario::from_toml(text).expect("a shipped scenario");
        let figure = scene_figure("", &scenario.question.rotor);
        let lines = figure.panels[0].curves.iter();
        let lines = lines.filter(|curve| curve.colour == distinct(CONTACTS));
        let slopes = lines.map(|curve| {
            let [(z0, y0), (z1, y1)] = curve.points[..] else {
                panic!("a line has two points")
            };
            (z1 - z0) / (y1 - y0).abs()
        });
        let slope = 15f64.to_radians().tan();
        let expected: Vec<f64> = scenario
            .question
            .rotor
            .bearings
            .iter()
            .flat_map(|bearing| [bearing.facing.sign() * slope; 2])
            .collect();
        let slopes: Vec<f64> = slopes.collect();
        assert_eq!(slopes.len(), 4);
        assert!(slopes[0] * slopes[2] < 0.0, "the pair faces both ways");
        for (found, expected) in slopes.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-9, "{slopes:?}");
        }
    }
}
