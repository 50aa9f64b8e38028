//! `[initial]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::components::Components;
use crate::rotor::{FREEDOMS, Freedoms, InitialPosition, InitialState};
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Angle, AngularSpeed, Length, Velocity};

/// Where the motion starts.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct InitialInput {
    /// Position at the start. Default: "equilibrium".
    pub from: InitialPosition,
    /// Displacements that replace those of `from`, for instance { x = "1 um" }.
    pub displacement: Option<Components<Length, Angle>>,
    /// Velocities that replace rest, for instance { x = "1 mm/s" }.
    pub velocity: Option<Components<Velocity, AngularSpeed>>,
}

impl InitialInput {
    /// The state at the start.
    pub fn build(&self, freedoms: Freedoms, problems: &mut Problems<'_>) -> InitialState {
        let held = freedoms.count();
        let mut state = InitialState {
            from: self.from,
            displacement: [None; FREEDOMS],
            velocity: [None; FREEDOMS],
        };
        if let Some(displacement) = &self.displacement {
            displacement.refuse_held("initial.displacement", held, freedoms, problems);
            state.displacement = displacement.values();
        }
        if let Some(velocity) = &self.velocity {
            velocity.refuse_held("initial.velocity", held, freedoms, problems);
            state.velocity = velocity.values();
        }
        state
    }
}
