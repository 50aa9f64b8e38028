//! `[damping]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::components::{Axes, refuse_held_key};
use crate::bearing::ContactDamping;
use crate::rotor::{Damping as Model, Freedoms, Rotor, RotorDefinition};
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
    /// with the cages turned by half a ball spacing. A run whose speed changes keeps the coefficients of its start.
    #[schemars(range(min = 0.0, max = 10.0))]
    pub ratio: Option<f64>,
    /// Damping matrix as this time multiplied by the stiffness matrix at the static
    /// equilibrium, also in a run whose speed changes; measured on ball bearings: "2.5 us" to "25 us".
    #[schemars(extend("examples" = ["10 us"], "x-minimum" = 0.0, "x-maximum" = 1.0))]
    pub stiffness_time: Option<Quantity<Time>>,
    /// Damping of the contacts of all balls and of each slice of rollers after Hunt and Crossley: a contact bears (1 + 1.5 α δ̇)
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
#[schemars(deny_unknown_fields, extend("minProperties" = 1))]
pub struct Coefficients {
    /// Along the axes.
    #[serde(flatten)]
    pub axes: Axes<Damping>,
    /// About X and Y.
    #[schemars(extend("x-minimum" = 0.0))]
    pub tilt: Option<Quantity<TiltDamping>>,
}

/// Damping ratio below which a mode is not damped: round-off of an eigenvalue.
const LEAST_RATIO: f64 = 1e-9;
/// What comes of no damping, and what to write.
const UNDAMPED: &str = "a free vibration does not decay, the start is never forgotten and is in the spectra; shafts \
                        on ball bearings have ratio = 0.02 to 0.04 in [damping]";

/// Warns where no table damps the shaft, and bearings, housings and the shaft itself leave a mode undamped.
pub fn warn_where_undamped(
    input: Option<&DampingInput>,
    rotor: &RotorDefinition,
    problems: &mut Problems<'_>,
) {
    let none = match input {
        None if problems.is_faulty("damping") => return,
        None => "no `[damping]`",
        Some(input) if input.ratio == Some(0.0) => "`damping.ratio` is 0",
        Some(_) => return,
    };
    let mut modes = Vec::new();
    if rotor.is_damped_by_parts() {
        if !problems.issues.is_empty() {
            return;
        }
        let assembled = Rotor::assemble(rotor);
        modes = assembled.map_or_else(|_| Vec::new(), |rotor| rotor.natural_frequencies());
        modes.retain(|mode| mode.damping_ratio.abs() < LEAST_RATIO);
        if modes.is_empty() {
            return;
        }
    }
    let which = modes.first().map_or_else(String::new, |mode| {
        let frequency = mode.frequency;
        format!(", and nothing else damps the mode at {frequency:.1} Hz")
    });
    problems.warn(format!("{none}{which}: {UNDAMPED}"));
}

/// The damping; none where the table is absent.
pub fn build(
    input: Option<&DampingInput>,
    freedoms: Freedoms,
    problems: &mut Problems<'_>,
) -> Model {
    let Some(input) = input else {
        return Model::Undamped;
    };
    if let Some(coefficients) = &input.coefficients {
        coefficients.build(freedoms, problems)
    } else if let Some(ratio) = input.ratio {
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
            ("x", 0, si(&self.axes.x)),
            ("y", 1, si(&self.axes.y)),
            ("z", 2, si(&self.axes.z)),
            ("tilt", 3, si(&self.tilt)),
        ];
        for (key, axis, value) in given {
            let moves = freedoms.moves(axis);
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
