//! What is checked of a catalogue line, and of the balls found for it.

use super::rating::REFERENCE_GROOVES;
use super::search::{BY_ISO, FACTOR_TOLERANCE, is_rare_size};
use super::{Candidate, CatalogueLine, Estimate, EstimateError};
use crate::bearing::{Geometry, GeometryError};

/// Balls whose deviation is larger by less than this are named as well as those that are taken: makers' C_0 lie up to 3 %
/// from that of their balls.
const CLOSE: f64 = 0.03;

/// [`CLOSE`] where a C of ISO 281, and an f0 that is met to [`MET`], speak for the balls as well.
const CLOSE_TO_SETTLED: f64 = 0.01;

/// Difference of f0 from its print by the rounding of both ratings.
const MET: f64 = 0.1;

/// Most other balls that are named.
const MOST_NAMED: usize = 3;

/// Filling angle (Z − 1)·2 asin(D/d_m) of deep-groove bearings as they are made, degrees.
const FILLING_ANGLE: [f64; 2] = [180.0, 202.0];

/// Largest ball of bearings as they are made, over the height of the section: both rings need their share under the grooves.
const USUAL_BALL: f64 = 0.65;

/// Refuses a printed line whose sizes and forces are no positive numbers, and a bearing without a section.
pub(super) fn check_print(
    [bore, outside_diameter]: [f64; 2],
    contact_angle: f64,
    others: &[(&'static str, Option<f64>)],
) -> Result<(), EstimateError> {
    let boundary = [
        ("bore", Some(bore)),
        ("outside diameter", Some(outside_diameter)),
    ];
    for (name, value) in boundary.iter().chain(others) {
        if let Some(value) = value.filter(|value| !(*value > 0.0 && value.is_finite())) {
            return Err(EstimateError::Number { name, value });
        }
    }
    if bore >= outside_diameter {
        return Err(EstimateError::Section {
            bore,
            outside_diameter,
        });
    }
    if !(0.0..=Geometry::LARGEST_CONTACT_ANGLE).contains(&contact_angle) {
        let degrees = contact_angle.to_degrees();
        return Err(GeometryError::ContactAngle { degrees }.into());
    }
    Ok(())
}

/// Note of a rating, N, that is further off the print than a tolerance; `parts` are balls or rollers.
pub(super) fn off_print(
    name: &str,
    parts: &str,
    [found, printed]: [f64; 2],
    tolerance: f64,
) -> Option<String> {
    let difference = found / printed - 1.0;
    (difference.abs() > tolerance).then(|| {
        format!(
            "{name} of these {parts} is {:+.1} % off the print: {found:.0} N against {printed:.0} N",
            1e2 * difference
        )
    })
}

/// Note of the nearest of others that fit nearly as well, and of the keys that would settle it.
pub(super) fn near_as_well(
    others: impl Iterator<Item = impl ToString>,
    keys: &str,
) -> Option<String> {
    let named: Vec<_> = others.take(MOST_NAMED).map(|own| own.to_string()).collect();
    let named = (!named.is_empty()).then(|| named.join(" and "))?;
    Some(format!(
        "the ratings fit {named} nearly as well: give {keys} where you know them"
    ))
}

impl CatalogueLine {
    pub(super) fn check(&self) -> Result<(), EstimateError> {
        let others = [
            ("dynamic load rating", Some(self.dynamic_rating)),
            ("static load rating", self.static_rating),
            ("ball diameter", self.ball_diameter),
            ("pitch diameter", self.pitch_diameter),
        ];
        let boundary = [self.bore, self.outside_diameter];
        check_print(boundary, self.contact_angle, &others)
    }

    pub(super) fn notes(
        &self,
        estimate: &Estimate,
        best: &Candidate,
        others: &[Candidate],
    ) -> Vec<String> {
        let mut notes = Vec::new();
        let internal = &estimate.internal;
        let off = |name, ratings, tolerance| off_print(name, "balls", ratings, tolerance);
        if !self.is_rated_usually(internal.dynamic_rating) {
            let ratings = [internal.dynamic_rating, self.dynamic_rating];
            notes.extend(off("C", ratings, 0.0));
        }
        if let Some(printed) = self.static_rating {
            let is_of_given = self.groove_factors.is_none()
                || best.static_rating == internal.static_rating
                || off("C0", [best.static_rating, printed], 0.02).is_some();
            notes.extend(match is_of_given {
                true => off("C0", [internal.static_rating, printed], 0.02),
                false => Some(format!(
                    "the printed C0 is that of grooves of {} and {}, as ISO 76 rates narrower ones: in the given grooves it is {:.0} N",
                    REFERENCE_GROOVES[0], REFERENCE_GROOVES[1], internal.static_rating
                )),
            });
        }
        let dynamic = internal.dynamic_rating / self.dynamic_rating - 1.0;
        let factors = estimate.static_factor.zip(self.static_factor);
        let is_met = factors.is_some_and(|(found, printed)| (found - printed).abs() <= MET);
        let is_settled = is_met && dynamic.abs() <= BY_ISO;
        let close = if is_settled { CLOSE_TO_SETTLED } else { CLOSE };
        let fits = |other: &&Candidate| {
            other.deviation - best.deviation < close && self.fits(other) && self.agrees(other)
        };
        let keys = "`balls`, `ball_diameter` or `f0`";
        notes.extend(near_as_well(others.iter().filter(fits), keys));
        let (balls, ball_diameter) = (internal.balls, internal.ball_diameter);
        let excess = self.factor_excess(balls, ball_diameter);
        if let Some((found, printed)) = factors
            && excess.is_some_and(|excess| excess > FACTOR_TOLERANCE)
        {
            notes.push(format!(
                "f0 of these balls is {found:.2}, printed is {printed}"
            ));
        }
        if self.contact_angle == 0.0
            && !is_usual_filling(balls, ball_diameter, internal.pitch_diameter)
        {
            let ([least, largest], angle) = (FILLING_ANGLE, estimate.filling_angle);
            notes.push(format!(
                "the filling angle is {angle:.0}°, that of deep-groove bearings {least:.0}° to {largest:.0}°"
            ));
        }
        if self.ball_diameter.is_none() && is_rare_size(ball_diameter) {
            notes.push(
                "balls of this size are rare, and none of a usual size fit as well".to_owned(),
            );
        }
        if !is_usual_size(ball_diameter, self.section()) {
            notes.push(format!(
                "balls of {:.3} mm leave little of rings whose section is {:.2} mm high: usual are balls of at most {:.0} % of it",
                1e3 * ball_diameter,
                1e3 * self.section(),
                1e2 * USUAL_BALL
            ));
        }
        notes
    }
}

/// Whether the balls of a deep-groove bearing can be filled in, and fill it.
pub(super) fn is_usual_filling(balls: usize, ball_diameter: f64, pitch: f64) -> bool {
    let [least, largest] = FILLING_ANGLE;
    (least - 0.5..largest + 0.5).contains(&filling_angle(balls, ball_diameter, pitch))
}

/// Whether balls are as small as those of bearings as they are made.
pub(super) fn is_usual_size(ball_diameter: f64, section: f64) -> bool {
    ball_diameter <= USUAL_BALL * section
}

pub(super) fn filling_angle(balls: usize, ball_diameter: f64, pitch: f64) -> f64 {
    let each = 2.0 * (ball_diameter / pitch).min(1.0).asin();
    (balls.saturating_sub(1) as f64 * each).to_degrees()
}
