//! `[[load]]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::components::Components;
use crate::rotor::{FREEDOMS, Freedoms};
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Force, Moment};

/// An external load on the shaft, acting at the centre of mass.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LoadSpec {
    /// Forces x, y, z (for instance z = "1000 N") and moments tilt_x, tilt_y (for instance
    /// tilt_x = "2 N m") that act from the start on. With freedoms = "radial" the force z does
    /// not move the shaft but sets the axial position that it is held at.
    #[schemars(extend("examples" = [{ "z": "1000 N" }]))]
    pub constant: Components<Force, Moment>,
}

/// Sum of all loads, N and N m.
pub fn sum(loads: &[LoadSpec], freedoms: Freedoms, problems: &mut Problems<'_>) -> [f64; FREEDOMS] {
    // An axial load acts on a held z too, moments on held tilts do not.
    let first_held = freedoms.count().max(3);
    let mut total = [0.0; FREEDOMS];
    for (index, load) in loads.iter().enumerate() {
        let path = format!("load[{index}].constant");
        load.constant
            .refuse_held(&path, first_held, freedoms, problems);
        for (sum, value) in total.iter_mut().zip(load.constant.values()) {
            *sum += value.unwrap_or(0.0);
        }
    }
    total
}
