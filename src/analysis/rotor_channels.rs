//! Which channels a shaft has.

use serde::Deserialize;
use serde_json::Value;

use super::{Channel, Part};
use crate::rotor::{Body, RotorDefinition};

impl Channel {
    /// The columns of the table `trace` of a shaft, where no others are asked for: its housings, too, and of several
    /// bearings and elements the force of each along the axes that the shaft moves along.
    pub(crate) fn of_trace_of(rotor: &RotorDefinition) -> Vec<Self> {
        let lengths = rotor.shaft.freedoms.lengths();
        let bodies = Self::of_bodies(rotor, lengths);
        let forces = Self::of_bearings(rotor).filter(|force| force.unit() == "N");
        Self::of_trace().chain(bodies).chain(forces).collect()
    }

    /// The columns of the table `trace` of a shaft, or time and the columns that the `[output]` of a scenario asks for.
    pub(crate) fn of_trace_in(scenario: &Value, rotor: &RotorDefinition) -> Vec<Self> {
        let asked = Vec::deserialize(&scenario["output"]["channels"]).ok();
        let timed = |asked: Vec<Self>| [Self::Time].into_iter().chain(asked).collect();
        asked.map_or_else(|| Self::of_trace_of(rotor), timed)
    }

    /// Force of a bearing, from 0, or of an element behind the bearings.
    pub(crate) fn of_part(rotor: &RotorDefinition, number: usize, freedom: usize) -> Self {
        let part = match number.checked_sub(rotor.bearings.len()) {
            None => Part::Bearing(number),
            Some(element) => Part::Element(element),
        };
        Self::PartForce { part, freedom }
    }

    /// Forces of each of several bearings and elements along the freedoms that move; that of a single one is the total.
    fn of_bearings(rotor: &RotorDefinition) -> impl Iterator<Item = Self> {
        let parts = Some(rotor.part_count()).filter(|count| *count > 1);
        let axes = rotor.shaft.freedoms.axes();
        let parts =
            (0..parts.unwrap_or(0)).flat_map(|part| axes.iter().map(move |axis| (part, *axis)));
        parts.map(|(part, freedom)| Self::of_part(rotor, part, freedom))
    }

    /// What a motion is described by besides displacements and forces of the shaft: displacements of its housings, and
    /// forces of each of several bearings.
    pub(crate) fn of_parts(rotor: &RotorDefinition) -> Vec<Self> {
        let lengths = rotor.shaft.freedoms.lengths();
        let bodies = Self::of_bodies(rotor, lengths);
        let displacements = bodies.filter(|channel| channel.unit() == "m");
        displacements.chain(Self::of_bearings(rotor)).collect()
    }

    /// Displacements and forces of the freedoms that move, then [`Channel::of_parts`].
    pub(crate) fn of_motion(rotor: &RotorDefinition) -> Vec<Self> {
        let mut channels = Self::of_freedoms(rotor.shaft.freedoms);
        channels.extend(Self::of_parts(rotor));
        channels
    }

    /// Why a shaft has no such column, and what to do, where it has none.
    pub(crate) fn missing_of(self, rotor: &RotorDefinition) -> Option<[String; 2]> {
        let lengths = rotor.shaft.freedoms.lengths();
        match self {
            Self::Body { body, axis, .. } if !rotor.bodies().contains(&body) || axis >= lengths => {
                let (what, key) = match body {
                    Body::Housing(_) => ("housing", "[bearing.housing]"),
                    Body::Resonator(_) => ("resonator", "[bearing.housing.resonator]"),
                };
                Some([
                    format!("there is no `{self}`: no such {what} moves that way"),
                    format!("give the bearing a table {key}, or leave it out"),
                ])
            }
            Self::PartForce { part, .. } => {
                let (number, count, kind, counted) = match part {
                    Part::Bearing(number) => {
                        let counted = "each of a set by itself";
                        (number, rotor.bearings.len(), "bearings", counted)
                    }
                    Part::Element(number) => {
                        let counted = "apart from the bearings";
                        (number, rotor.elements.len(), "elements", counted)
                    }
                };
                (number >= count).then(|| {
                    [
                        format!("there is no `{self}`: the number of {kind} is {count}"),
                        format!("{kind} count from 1, {counted}"),
                    ]
                })
            }
            _ => None,
        }
    }

    /// Columns of the bodies besides the shaft that are observed and move along the first `axes` of x, y, z.
    pub(crate) fn of_bodies(rotor: &RotorDefinition, axes: usize) -> impl Iterator<Item = Self> {
        let bodies = rotor.bodies().into_iter();
        let observed = bodies.filter(|body| body.is_observed());
        observed.flat_map(move |body| Self::of_body(body, axes))
    }
}
