//! The shaft: its sections and discs or its mass, and its unbalances.

use super::super::figure::{GREY, distinct};
use super::super::terminal::{MICRO, MILLI};
use super::drawing::Drawing;
use super::{CONTACTS, Scale, UNBALANCE};
use crate::numerics::digits::to_digits;
use crate::rotor::{Disc, FlexibleShaft, RotorDefinition};

/// Part of a direction below which it is not drawn.
const ACROSS: f64 = 0.05;

/// Radius of a steel disc of the mass and moment of inertia of a disc, mm.
pub(super) fn disc_radius(disc: &Disc) -> f64 {
    MILLI * (2.0 * disc.inertia_polar / disc.mass).sqrt()
}

impl Drawing {
    /// One section from end to end, with the axis.
    pub fn shaft(&mut self, scale: &Scale) {
        let [left, right] = scale.ends;
        self.rectangle(GREY, scale.ends, [-scale.shaft, scale.shaft]);
        let beyond = 0.1 * (right - left);
        self.fine(GREY, vec![(left - beyond, 0.0), (right + beyond, 0.0)]);
    }

    /// Sections, discs and unbalances of a shaft that bends, with the point that is observed.
    pub fn flexible(&mut self, shaft: &FlexibleShaft, scale: &Scale) {
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
    pub fn unbalance(&mut self, at: f64, angle: f64, size: &str, length: f64, scale: &Scale) {
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

    /// The centre of mass and the unbalance.
    pub fn mass(&mut self, rotor: &RotorDefinition, scale: &Scale) {
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
}
