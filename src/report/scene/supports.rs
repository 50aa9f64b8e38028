//! What holds the shaft: bearings and their housings, elements.

use super::super::figure::{Point, distinct};
use super::super::terminal::MILLI;
use super::drawing::Drawing;
use super::{CONTACTS, HOUSINGS, RINGS, Scale};
use crate::bearing::{Housing, MountedBearing};
use crate::numerics::digits::to_digits;
use crate::rotor::ElementLaw;

/// Thickness of a ring at its groove, in ball diameters.
const RING: f64 = 0.35;
/// Half the width of a ring, in ball diameters.
const HALF_WIDTH: f64 = 0.95;

/// Radii of bore, inner groove, outer groove and outer ring, mm.
pub(super) fn radii(bearing: &MountedBearing) -> [f64; 4] {
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
    /// Rings, balls and lines of contact above and below the axis, and what the outer ring sits in.
    pub fn bearing(&mut self, number: usize, bearing: &MountedBearing, scale: &Scale) {
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

    /// The name of a housing.
    pub fn housing(&mut self, at: f64, housing: Option<&Housing>, scale: &Scale) {
        if let Some(housing) = housing {
            let text = format!("housing, {} kg", to_digits(housing.mass, 4));
            self.label((at, 1.35 * scale.outer), text, distinct(HOUSINGS));
        }
    }

    /// An element: springs from the shaft to the ground, or a ring about the shaft.
    pub fn element(&mut self, number: usize, at: f64, law: &ElementLaw, scale: &Scale) {
        let half = 0.12 * scale.outer;
        let across = [at - half, at + half];
        let (name, is_ring) = match law {
            ElementLaw::Linear(_) | ElementLaw::OverSpeed(_) => ("element", false),
            ElementLaw::SqueezeFilm(_) => ("squeeze film, element", true),
            ElementLaw::Rub(_) => ("rub, element", true),
        };
        if !is_ring {
            self.spring(at, scale);
        } else {
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
}
