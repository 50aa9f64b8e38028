//! `[damping]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::components::refuse_held_key;
use crate::rotor::{Damping as Model, Freedoms};
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Damping, Quantity, TiltDamping, Time};

/// Viscous damping, given in exactly one of three ways.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = ["coefficients", "ratio", "stiffness_time"]))]
pub struct DampingSpec {
    /// Damping coefficient of each freedom; one left out is not damped.
    pub coefficients: Option<Coefficients>,
    /// Ratio of the critical damping of each freedom at the static equilibrium, 0 to 10;
    /// measured on ball bearings: 0.02 to 0.04.
    #[schemars(range(min = 0.0, max = 10.0))]
    pub ratio: Option<f64>,
    /// Damping matrix as this time multiplied by the stiffness matrix at the static
    /// equilibrium; measured on ball bearings: "2.5 us" to "25 us".
    #[schemars(extend("examples" = ["10 us"], "x-minimum" = 0.0, "x-maximum" = 1.0))]
    pub stiffness_time: Option<Quantity<Time>>,
}

/// Damping coefficients of the freedoms; at least one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("minProperties" = 1))]
pub struct Coefficients {
    /// Along X.
    #[schemars(extend("x-minimum" = 0.0))]
    pub x: Option<Quantity<Damping>>,
    /// Along Y.
    #[schemars(extend("x-minimum" = 0.0))]
    pub y: Option<Quantity<Damping>>,
    /// Along Z.
    #[schemars(extend("x-minimum" = 0.0))]
    pub z: Option<Quantity<Damping>>,
    /// About X and Y.
    #[schemars(extend("x-minimum" = 0.0))]
    pub tilt: Option<Quantity<TiltDamping>>,
}

/// The damping; none, with a warning, where the table is absent.
pub fn build(spec: Option<&DampingSpec>, freedoms: Freedoms, problems: &mut Problems<'_>) -> Model {
    let Some(spec) = spec else {
        if !problems.distrusts("damping") {
            problems.warn(
                "no `[damping]`: a free vibration does not decay, the start is never forgotten",
            );
        }
        return Model::Undamped;
    };
    if let Some(coefficients) = &spec.coefficients {
        coefficients.build(freedoms, problems)
    } else if let Some(ratio) = spec.ratio {
        Model::Ratio(ratio)
    } else if let Some(time) = &spec.stiffness_time {
        Model::StiffnessTime(time.si())
    } else {
        Model::Undamped
    }
}

impl Coefficients {
    fn build(&self, freedoms: Freedoms, problems: &mut Problems<'_>) -> Model {
        let along = |value: &Option<Quantity<Damping>>| value.as_ref().map(Quantity::si);
        let tilt = self.tilt.as_ref().map(Quantity::si);
        let given = [
            ("x", 1, along(&self.x)),
            ("y", 2, along(&self.y)),
            ("z", 3, along(&self.z)),
            ("tilt", 5, tilt),
        ];
        for (key, needed, value) in given {
            let moves = needed <= freedoms.count();
            if value.is_some() && !moves {
                refuse_held_key("damping.coefficients", key, freedoms, problems);
            }
            if value.is_none() && moves {
                problems.warn(format!(
                    "`damping.coefficients` has no `{key}`: it is not damped"
                ));
            }
        }
        let [x, y, z, tilt] = given.map(|(_, _, value)| value.unwrap_or(0.0));
        Model::Coefficients([x, y, z, tilt, tilt])
    }
}
