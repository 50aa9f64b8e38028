//! What is checked of a catalogue line, and of the balls found for it.

use super::{CatalogueLine, Estimate, EstimateError};
use crate::bearing::{Geometry, GeometryError};

/// A runner-up whose deviation is larger by less than this is worth a note.
const CLOSE: f64 = 0.02;

/// Largest difference from a printed f0.
pub(super) const FACTOR_TOLERANCE: f64 = 0.2;

/// Filling angle (Z − 1)·2 asin(D/d_m) of deep-groove bearings as they are made, degrees.
const FILLING_ANGLE: [f64; 2] = [180.0, 202.0];

impl CatalogueLine {
    pub(super) fn check(&self) -> Result<(), EstimateError> {
        let numbers = [
            ("bore", Some(self.bore)),
            ("outside diameter", Some(self.outside_diameter)),
            ("dynamic load rating", Some(self.dynamic_rating)),
            ("static load rating", self.static_rating),
            ("ball diameter", self.ball_diameter),
            ("pitch diameter", self.pitch_diameter),
        ];
        for (name, value) in numbers {
            if let Some(value) = value.filter(|value| !(*value > 0.0 && value.is_finite())) {
                return Err(EstimateError::Number { name, value });
            }
        }
        if self.bore >= self.outside_diameter {
            return Err(EstimateError::Section {
                bore: self.bore,
                outside_diameter: self.outside_diameter,
            });
        }
        if !(0.0..=Geometry::LARGEST_CONTACT_ANGLE).contains(&self.contact_angle) {
            let degrees = self.contact_angle.to_degrees();
            return Err(GeometryError::ContactAngle { degrees }.into());
        }
        Ok(())
    }

    pub(super) fn notes(&self, estimate: &Estimate, deviation: f64) -> Vec<String> {
        let mut notes = Vec::new();
        let mut off = |name: &str, found: f64, printed: f64, tolerance: f64| {
            let difference = found / printed - 1.0;
            if difference.abs() > tolerance {
                notes.push(format!(
                    "{name} of these balls is {:+.1} % off the print: {found:.0} N against {printed:.0} N",
                    1e2 * difference
                ));
            }
        };
        let internal = &estimate.internal;
        off("C", internal.dynamic_rating, self.dynamic_rating, 0.01);
        if let Some(printed) = self.static_rating {
            off("C0", internal.static_rating, printed, 0.02);
        }
        if let Some(other) = &estimate.runner_up
            && other.deviation - deviation < CLOSE
            && self.agrees(other)
        {
            notes.push(format!(
                "close to it are {other}: give `balls` where you know them"
            ));
        }
        if let (Some(found), Some(printed)) = (estimate.static_factor, self.static_factor)
            && (found - printed).abs() > FACTOR_TOLERANCE
        {
            notes.push(format!(
                "f0 of these balls is {found:.2}, printed is {printed}"
            ));
        }
        let [least, largest] = FILLING_ANGLE;
        let angle = estimate.filling_angle;
        if self.contact_angle == 0.0 && !(least - 0.5..largest + 0.5).contains(&angle) {
            notes.push(format!(
                "the filling angle is {angle:.0}°, that of deep-groove bearings {least:.0}° to {largest:.0}°"
            ));
        }
        notes
    }
}

pub(super) fn filling_angle(balls: usize, ball_diameter: f64, pitch: f64) -> f64 {
    let each = 2.0 * (ball_diameter / pitch).min(1.0).asin();
    (balls.saturating_sub(1) as f64 * each).to_degrees()
}
