//! The time that a ball takes from the entry of a spall to its far edge, by kinematics.

use serde::Serialize;

use crate::rotor::Rotor;

/// A spall of a race with sharp edges, whose floor no ball reaches, at a speed.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub(crate) struct SpallPassage {
    /// Number of the bearing, from 1.
    pub bearing: usize,
    /// `the outer race` or `the inner race`.
    pub on: String,
    /// Of its middle, rad.
    #[serde(rename = "angle_rad")]
    pub angle: f64,
    /// Length along the race, m.
    #[serde(rename = "length_m")]
    pub length: f64,
    /// From the entry of a ball to its impact in the middle, s.
    #[serde(rename = "entry_to_impact_s")]
    pub entry_to_impact: f64,
}

/// The spalls of all races at a constant speed in rad/s; none that no ball passes.
pub(super) fn spall_passages(rotor: &Rotor, speed: f64) -> Vec<SpallPassage> {
    let supports = (1..).zip(rotor.supports());
    let passages = supports.flat_map(|(bearing, support)| {
        support.race_spalls().filter_map(move |spall| {
            let rate = speed * (support.cage_ratio() + spall.by_shaft).abs();
            (rate > 0.0).then(|| SpallPassage {
                bearing,
                on: spall.on.to_string(),
                angle: spall.angle,
                length: spall.length,
                entry_to_impact: spall.half_angle / rate,
            })
        })
    });
    passages.collect()
}
