//! `[damping]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::components::refuse_held_key;
use crate::bearing::ContactDamping;
use crate::rotor::{Damping as Model, Freedoms};
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{ContactLoss, Damping, Quantity, TiltDamping, Time, si};

/// Viscous damping, given in at most one of three ways, and damping of the contacts; at least one
/// of them all.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "minProperties" = 1,
    "x-at-most-one" = ["coefficients", "ratio", "stiffness_time"]
))]
pub struct DampingInput {
    /// Damping coefficient of each freedom; one left out is not damped.
    pub coefficients: Option<Coefficients>,
    /// Ratio of the critical damping of each freedom at the static equilibrium, 0 to 10;
    /// measured on ball bearings: 0.02 to 0.04. Where a single ball carries the shaft in its clearance,
    /// with the cages turned by half a ball spacing.
    #[schemars(range(min = 0.0, max = 10.0))]
    pub ratio: Option<f64>,
    /// Damping matrix as this time multiplied by the stiffness matrix at the static
    /// equilibrium; measured on ball bearings: "2.5 us" to "25 us".
    #[schemars(extend("examples" = ["10 us"], "x-minimum" = 0.0, "x-maximum" = 1.0))]
    pub stiffness_time: Option<Quantity<Time>>,
    /// Damping of the contacts of all balls after Hunt and Crossley: a contact bears (1 + 1.5 α δ̇)
    /// times its load, δ̇ the rate of its approach. α is what a sphere loses of its speed in an impact,
    /// per speed: "0.08 s/m" to "0.32 s/m" for dry steel, more behind oil.
    #[schemars(extend("examples" = [{ "inner": "0.2 s/m", "outer": "0.2 s/m" }]))]
    pub contact: Option<ContactInput>,
}

/// Damping of the contacts; at least one race.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("minProperties" = 1))]
pub struct ContactInput {
    /// At the inner race.
    #[schemars(extend("x-minimum" = 0.0))]
    pub inner: Option<Quantity<ContactLoss>>,
    /// At the outer race.
    #[schemars(extend("x-minimum" = 0.0))]
    pub outer: Option<Quantity<ContactLoss>>,
}

/// The damping of the contacts; none where it is not given.
pub fn contact(input: Option<&DampingInput>) -> ContactDamping {
    let input = input.and_then(|input| input.contact.as_ref());
    let damping = input.map(|contact| ContactDamping {
        inner: si(&contact.inner).unwrap_or(0.0),
        outer: si(&contact.outer).unwrap_or(0.0),
    });
    damping.unwrap_or_default()
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

/// What comes of no damping, and what to write.
const UNDAMPED: &str = "a free vibration does not decay, the start is never forgotten and stands in the spectra; shafts \
                        on ball bearings have ratio = 0.02 to 0.04 in [damping]";

/// The damping; none, with a warning, where the table is absent.
pub fn build(
    input: Option<&DampingInput>,
    freedoms: Freedoms,
    problems: &mut Problems<'_>,
) -> Model {
    let Some(input) = input else {
        if !problems.distrusts("damping") {
            problems.warn(format!("no `[damping]`: {UNDAMPED}"));
        }
        return Model::Undamped;
    };
    if let Some(coefficients) = &input.coefficients {
        coefficients.build(freedoms, problems)
    } else if let Some(ratio) = input.ratio {
        if ratio == 0.0 {
            problems.warn(format!("`damping.ratio` is 0: {UNDAMPED}"));
        }
        Model::Ratio(ratio)
    } else if let Some(time) = &input.stiffness_time {
        Model::StiffnessTime(time.si())
    } else {
        Model::Undamped
    }
}

impl Coefficients {
    fn build(&self, freedoms: Freedoms, problems: &mut Problems<'_>) -> Model {
        let given = [
            ("x", 1, si(&self.x)),
            ("y", 2, si(&self.y)),
            ("z", 3, si(&self.z)),
            ("tilt", 5, si(&self.tilt)),
        ];
        for (key, needed, value) in given {
            let moves = needed <= freedoms.count();
            if value.is_some() && !moves {
                let path = format!("damping.coefficients.{key}");
                refuse_held_key(&path, freedoms, problems);
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
