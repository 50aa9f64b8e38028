//! Balls at the static equilibrium.

use serde_json::{Value, json};

use crate::bearing::{BallLine, BearingState};
use crate::simulate::StaticState;

/// Every ball of every bearing, null where a bearing knows none: azimuth and contact angles in degrees, loads in N.
pub(super) fn balls(equilibrium: &StaticState) -> Value {
    let bearings = equilibrium.bearings.iter();
    bearings.map(|state| state.as_ref().map(balls_of)).collect()
}

fn balls_of(state: &BearingState) -> Value {
    state.balls.iter().map(ball).collect()
}

fn ball(line: &BallLine) -> Value {
    json!({
        "azimuth": line.azimuth.to_degrees(),
        "load": [line.inner.load, line.outer.load],
        "angle": [line.inner.angle.to_degrees(), line.outer.angle.to_degrees()],
    })
}
