//! The shaft to scale, seen from the side: bearings with their facing and the lines of their contacts, loads,
//! unbalance and housings.
//!
//! Z runs to the right and Y upwards, in mm. Balls, pitch circles, positions and contact angles are those of the
//! scenario; thickness and width of the rings, of which it says nothing, are those of common bearings.

use super::figure::{Axis, Colour, Curve, Figure, GREY, Name, Panel, Point, distinct, ends};
use super::terminal::{MICRO, MILLI, to_digits};
use crate::bearing::{Housing, MountedBearing};
use crate::rotor::{Disc, ElementLaw, FlexibleShaft, Load, LoadKind, RotorDefinition};

/// Thickness of a ring at its groove, in ball diameters.
const RING: f64 = 0.35;
/// Half the width of a ring, in ball diameters.
const HALF_WIDTH: f64 = 0.95;
/// Straight lines of a circle.
const CIRCLE: usize = 40;

/// Part of a direction below which it is not drawn.
const ACROSS: f64 = 0.05;

const RINGS: usize = 0;
const CONTACTS: usize = 1;
const LOADS: usize = 2;
const UNBALANCE: usize = 3;
const HOUSINGS: usize = 4;

/// What is drawn so far, mm.
#[derive(Default)]
struct Drawing {
    curves: Vec<Curve>,
    labels: Vec<(Point, String, Colour)>,
}

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
        "rings and balls",
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

/// Radius of a steel disc of the mass and moment of inertia of a disc, mm.
fn disc_radius(disc: &Disc) -> f64 {
    MILLI * (2.0 * disc.inertia_polar / disc.mass).sqrt()
}

/// Radii of bore, inner groove, outer groove and outer ring, mm.
fn radii(bearing: &MountedBearing) -> [f64; 4] {
    let geometry = &bearing.bearing.geometry;
    let [pitch, ball] = [geometry.pitch_diameter(), geometry.ball_diameter()].map(|d| MILLI * d);
    [-1.0 - 2.0 * RING, -1.0, 1.0, 1.0 + 2.0 * RING].map(|part| 0.5 * (pitch + part * ball))
}

/// A row of balls or rollers, or the contacts on one side of a row that touches on either.
struct Row {
    /// From the middle of the bearing, mm.
    offset: f64,
    /// Contact angle, rad.
    angle: f64,
}

/// The rows of a bearing with a pitch radius in mm. Lines of contact of two rows meet in its middle.
fn rows(bearing: &MountedBearing, pitch: f64) -> Vec<Row> {
    let geometry = &bearing.bearing.geometry;
    let angle = geometry.contact_angle();
    let row = |angle: f64| Row {
        offset: if geometry.rows() > 1 {
            pitch * angle.tan()
        } else {
            0.0
        },
        angle,
    };
    // a bearing without a preferred side touches on either
    match geometry.is_symmetric() {
        true => vec![row(-angle), row(angle)],
        false => vec![row(bearing.facing.sign() * angle)],
    }
}

impl Drawing {
    fn line(&mut self, colour: Colour, points: Vec<Point>) {
        self.curves.push(Curve::line(colour, points));
    }

    fn fine(&mut self, colour: Colour, points: Vec<Point>) {
        self.curves.push(Curve {
            fine: true,
            ..Curve::line(colour, points)
        });
    }

    fn label(&mut self, at: Point, text: impl Into<String>, colour: Colour) {
        self.labels.push((at, text.into(), colour));
    }

    fn rectangle(&mut self, colour: Colour, [left, right]: [f64; 2], [low, high]: [f64; 2]) {
        let (first, third) = ((left, low), (right, high));
        self.line(
            colour,
            vec![first, (right, low), third, (left, high), first],
        );
    }

    /// A roller of a length and a diameter, whose contacts lean from the radial direction by an angle in rad.
    fn roller(&mut self, (x, y): Point, [length, diameter]: [f64; 2], lean: f64) {
        let (sin, cos) = lean.sin_cos();
        let corners = [
            (1.0, 1.0),
            (-1.0, 1.0),
            (-1.0, -1.0),
            (1.0, -1.0),
            (1.0, 1.0),
        ];
        let corners = corners.map(|(along, across)| {
            let (along, across) = (0.5 * along * length, 0.5 * across * diameter);
            (
                x + along * cos + across * sin,
                y - along * sin + across * cos,
            )
        });
        self.line(distinct(RINGS), corners.to_vec());
    }

    fn circle(&mut self, colour: Colour, (x, y): Point, radius: f64) {
        let angles = (0..=CIRCLE).map(|k| std::f64::consts::TAU * k as f64 / CIRCLE as f64);
        let points = angles.map(|angle| (x + radius * angle.cos(), y + radius * angle.sin()));
        self.line(colour, points.collect());
    }

    /// An arrow from `from` by `by`.
    fn arrow(&mut self, colour: Colour, from: Point, by: Point) {
        let (tip, size) = ((from.0 + by.0, from.1 + by.1), by.0.hypot(by.1));
        let (along, across) = ((by.0 / size, by.1 / size), 0.12 * size);
        let barb = |side: f64| {
            let back = 1.8 * across;
            (
                tip.0 - back * along.0 + side * across * along.1,
                tip.1 - back * along.1 - side * across * along.0,
            )
        };
        self.line(colour, vec![from, tip, barb(1.0), tip, barb(-1.0)]);
    }

    /// One section from end to end, with the axis.
    fn shaft(&mut self, scale: &Scale) {
        let [left, right] = scale.ends;
        self.rectangle(GREY, scale.ends, [-scale.shaft, scale.shaft]);
        let beyond = 0.1 * (right - left);
        self.fine(GREY, vec![(left - beyond, 0.0), (right + beyond, 0.0)]);
    }

    /// Sections, discs and unbalances of a shaft that bends, with the point that is observed.
    fn flexible(&mut self, shaft: &FlexibleShaft, scale: &Scale) {
        let mut left = MILLI * shaft.ends()[0];
        for section in &shaft.sections {
            let right = left + MILLI * section.length;
            let [outer, bore] = [section.outer_diameter, section.inner_diameter]
                .map(|diameter| 0.5 * MILLI * diameter);
            self.rectangle(GREY, [left, right], [-outer, outer]);
            if bore > 0.0 {
                for at in [bore, -bore] {
                    self.fine(GREY, vec![(left, at), (right, at)]);
                }
            }
            left = right;
        }
        let [first, last] = scale.ends;
        self.fine(GREY, vec![(first, 0.0), (last, 0.0)]);
        for disc in &shaft.discs {
            let radius = disc_radius(disc).max(1.2 * scale.shaft);
            let width = (MILLI * disc.mass
                / (7850.0 * std::f64::consts::PI * (1e-3 * radius).powi(2)))
            .clamp(0.1 * radius, radius);
            let at = MILLI * disc.position;
            let across = [at - 0.5 * width, at + 0.5 * width];
            self.rectangle(GREY, across, [-radius, radius]);
            let text = format!("{} kg", to_digits(disc.mass, 4));
            self.label((across[1], -radius), text, GREY);
        }
        for own in &shaft.unbalances {
            let size = format!("{} g mm", to_digits(1e6 * own.amount, 4));
            let at = MILLI * own.position;
            self.unbalance(at, own.angle, &size, 0.9 * scale.outer, scale);
        }
        let at = MILLI * shaft.observed;
        self.circle(distinct(CONTACTS), (at, 0.0), 0.15 * scale.shaft);
        self.label((at, 0.0), "observed", distinct(CONTACTS));
    }

    /// An unbalance with the shaft at angle 0: its upward part by an arrow, which has no scale, that across the picture
    /// by a circle.
    fn unbalance(&mut self, at: f64, angle: f64, size: &str, length: f64, scale: &Scale) {
        let colour = distinct(UNBALANCE);
        let (sin, cos) = angle.sin_cos();
        if sin.abs() > ACROSS {
            self.arrow(colour, (at, 0.0), (0.0, length * sin));
        }
        if cos.abs() > ACROSS {
            self.circle(colour, (at, 0.0), 0.15 * scale.shaft);
        }
        let text = format!("{size} at {}°", to_digits(angle.to_degrees(), 4));
        self.label((at, 1.05 * length), text, colour);
    }

    /// An element: springs from the shaft to the ground, or a ring about the shaft.
    fn element(&mut self, number: usize, at: f64, law: &ElementLaw, scale: &Scale) {
        let half = 0.12 * scale.outer;
        let across = [at - half, at + half];
        let name = match law {
            ElementLaw::Linear(_) | ElementLaw::OverSpeed(_) => {
                self.spring(at, scale);
                "element"
            }
            ElementLaw::SqueezeFilm(_) => "squeeze film, element",
            ElementLaw::Rub(_) => "rub, element",
        };
        if !matches!(law, ElementLaw::Linear(_) | ElementLaw::OverSpeed(_)) {
            for side in [1.0, -1.0] {
                let band = [1.15, 1.5].map(|part| side * part * scale.shaft);
                self.rectangle(distinct(RINGS), across, band);
                self.ground(across, band[1], side * half);
            }
        }
        let place = (across[0], -1.15 * scale.outer);
        self.label(place, format!("{name} {number}"), distinct(RINGS));
    }

    /// Springs from the shaft to the ground.
    fn spring(&mut self, at: f64, scale: &Scale) {
        let step = (scale.outer - scale.shaft) / 8.0;
        let across = 0.12 * scale.outer;
        for side in [1.0, -1.0] {
            let turns = (0..=8).map(|k| {
                let offset = match k {
                    0 | 8 => 0.0,
                    k if k % 2 == 0 => across,
                    _ => -across,
                };
                (at + offset, side * (scale.shaft + f64::from(k) * step))
            });
            self.line(distinct(RINGS), turns.collect());
            let across = [at - across, at + across];
            self.ground(across, side * scale.outer, side * 0.1 * scale.outer);
        }
    }

    /// Rings, balls and lines of contact above and below the axis, and what the outer ring sits in.
    fn bearing(&mut self, number: usize, bearing: &MountedBearing, scale: &Scale) {
        let geometry = &bearing.bearing.geometry;
        let ball = MILLI * geometry.ball_diameter();
        let centre = MILLI * bearing.position;
        let [bore, inner, outer, outside] = radii(bearing);
        let pitch = 0.5 * (inner + outer);
        let rows = rows(bearing, pitch);
        let elements = &rows[..geometry.rows()];
        let roller = geometry.rollers().map(|rollers| MILLI * rollers.length);
        let reach =
            |row: &Row| row.offset.abs() + 0.5 * roller.map_or(ball, |length| length + 0.4 * ball);
        let half = elements.iter().map(reach).fold(HALF_WIDTH * ball, f64::max);
        let across = [centre - half, centre + half];
        for side in [1.0, -1.0] {
            let band = |low: f64, high: f64| [side * low, side * high];
            self.rectangle(distinct(RINGS), across, band(bore, inner + 0.12 * ball));
            self.rectangle(distinct(RINGS), across, band(outer - 0.12 * ball, outside));
            for row in elements {
                let middle = (centre + row.offset, side * pitch);
                match roller {
                    Some(length) => self.roller(middle, [length, ball], side * row.angle),
                    None => self.circle(distinct(RINGS), middle, 0.5 * ball),
                }
            }
            for Row { offset, angle } in &rows {
                // from the axis through the ball or roller to its contact with the outer race and a little further
                let end = pitch + 0.8 * ball;
                let at = |radius: f64| {
                    let z = centre + offset + (radius - pitch) * angle.tan();
                    (z, side * radius)
                };
                self.fine(distinct(CONTACTS), vec![at(0.0), at(end)]);
            }
            match bearing.housing {
                Some(_) => {
                    let across = [across[0] - 0.3 * half, across[1] + 0.3 * half];
                    let band = band(outside, outside + 0.6 * ball);
                    self.rectangle(distinct(HOUSINGS), across, band);
                }
                None => self.ground(across, side * outside, side * 0.25 * ball),
            }
        }
        let name = format!("bearing {number}");
        self.label((across[0], -1.15 * outside), name, distinct(RINGS));
        self.housing(across[0], bearing.housing.as_ref(), scale);
    }

    /// The name of a housing.
    fn housing(&mut self, at: f64, housing: Option<&Housing>, scale: &Scale) {
        if let Some(housing) = housing {
            let text = format!("housing, {} kg", to_digits(housing.mass, 4));
            self.label((at, 1.35 * scale.outer), text, distinct(HOUSINGS));
        }
    }

    /// Hatching beyond a ring that is fixed to the ground.
    fn ground(&mut self, [left, right]: [f64; 2], at: f64, beyond: f64) {
        let step = (right - left) / 6.0;
        for k in 0..=6 {
            let x = left + f64::from(k) * step;
            self.fine(GREY, vec![(x, at), (x + step, at + beyond)]);
        }
    }

    /// The centre of mass and the unbalance.
    fn mass(&mut self, rotor: &RotorDefinition, scale: &Scale) {
        let shaft = &rotor.shaft;
        let radius = 0.35 * scale.shaft;
        self.circle(GREY, (0.0, 0.0), radius);
        self.fine(GREY, vec![(0.0, -radius), (0.0, radius)]);
        let text = format!("m {} kg", to_digits(shaft.mass, 4));
        self.label((radius, -0.55 * scale.shaft), text, GREY);
        if shaft.is_unbalanced() {
            let [eccentricity, angle] = shaft.mass_eccentricity();
            let size = format!("e {} µm", to_digits(MICRO * eccentricity, 4));
            self.unbalance(0.0, angle, &size, 0.9 * scale.shaft, scale);
        }
    }

    /// Loads at their positions: constant ones with their direction, axial parts at the end of the shaft that they pull at,
    /// varying ones from above.
    fn loads(&mut self, rotor: &RotorDefinition, scale: &Scale) {
        let colour = distinct(LOADS);
        let [left, right] = scale.ends;
        // a coupling has several loads in one
        let mut shown: Vec<(f64, String)> = Vec::new();
        for load in &rotor.loads {
            let named = (load.position, name_of(load));
            if !shown.contains(&named) {
                shown.push(named);
            } else {
                continue;
            }
            let index = shown.len() - 1;
            let at = MILLI * load.position;
            let from = (1.35 + 0.3 * index as f64).min(1.95) * scale.outer;
            let constant = load.as_constant().copied();
            let [x, y, z, ..] = constant.unwrap_or([0.0, -1.0, 0.0, 0.0, 0.0]);
            let mut text_at = (at, from);
            if z != 0.0 {
                let end = if z > 0.0 { right } else { left };
                self.arrow(colour, (end, 0.0), (scale.outer * z.signum(), 0.0));
                if x == 0.0 && y == 0.0 {
                    text_at = (end, 0.35 * scale.shaft);
                }
            }
            if x != 0.0 {
                // across the picture
                self.circle(colour, (at, 0.0), 0.15 * scale.shaft);
            }
            if y != 0.0 {
                text_at = (at, -y.signum() * from);
                let by = (0.0, y.signum() * (from - scale.shaft));
                self.arrow(colour, text_at, by);
            }
            self.label(text_at, name_of(load), colour);
        }
    }
}

/// What a load is called; of a constant one its components that are not zero.
fn name_of(load: &Load) -> String {
    let name = match &load.kind {
        LoadKind::Constant(parts) => {
            let axes = [
                ("x", "N"),
                ("y", "N"),
                ("z", "N"),
                ("Mx", "N m"),
                ("My", "N m"),
            ];
            let given = axes.into_iter().zip(parts);
            let texts: Vec<_> = given
                .filter(|(_, part)| **part != 0.0)
                .map(|((axis, unit), part)| format!("{axis} {} {unit}", to_digits(*part, 4)))
                .collect();
            return texts.join(", ");
        }
        LoadKind::Harmonic(_) => "harmonic load",
        LoadKind::Shock(_) => "shock",
        LoadKind::RandomShocks(_) => "random shocks",
        LoadKind::Sprocket(_) => "chain on a sprocket",
        LoadKind::Noise(_) => "noise",
        LoadKind::Series(_) => "series of forces",
        LoadKind::Base(_) => "acceleration of the housing",
    };
    name.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenario::Scenario;

    /// The rollers of a motor lie along the shaft, those of a spherical bearing lean with their contacts.
    #[test]
    fn rollers_are_drawn_by_their_length_and_diameter() {
        let motor = include_str!("../../scenarios/motor-6206-nu206.toml");
        let conveyor = include_str!("../../scenarios/conveyor-head-22212.toml");
        for (text, count) in [(motor, 2), (conveyor, 8)] {
            let scenario = Scenario::from_toml(text).expect("a shipped scenario");
            let rotor = &scenario.question.rotor;
            let geometry = rotor.bearings.last().expect("a bearing").bearing.geometry;
            let rollers = geometry.rollers().expect("rollers");
            let size = [rollers.length, geometry.ball_diameter()].map(|length| MILLI * length);
            let figure = scene_figure("", rotor);
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
        let text = include_str!("../../scenarios/back-to-back-7205c.toml");
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
