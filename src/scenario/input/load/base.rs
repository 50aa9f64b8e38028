//! `base` of `[[load]]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::PerFreedom;
use super::harmonic::HarmonicInput;
use super::shock::ShockInput;
use crate::rotor::load::BaseAcceleration;
use crate::rotor::{FREEDOMS, Freedoms};
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Acceleration, Quantity, si};

/// Acceleration of the housing, of one of two kinds.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = ["harmonic", "shock"]))]
pub struct BaseInput {
    /// A cosine of time or of the shaft's angle.
    pub harmonic: Option<HarmonicInput<Accelerations>>,
    /// A half-sine shock, once or at a fixed interval.
    pub shock: Option<ShockInput<Accelerations>>,
}

/// Accelerations along the axes; at least one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("minProperties" = 1))]
pub struct Accelerations {
    /// Along X.
    pub x: Option<Quantity<Acceleration>>,
    /// Along Y.
    pub y: Option<Quantity<Acceleration>>,
    /// Along Z.
    pub z: Option<Quantity<Acceleration>>,
}

impl PerFreedom for Accelerations {
    fn given(&self) -> [Option<f64>; FREEDOMS] {
        [si(&self.x), si(&self.y), si(&self.z), None, None]
    }
}

impl BaseInput {
    /// The acceleration of whichever kind is given.
    pub fn build(
        &self,
        freedoms: Freedoms,
        problems: &mut Problems<'_>,
    ) -> Option<BaseAcceleration> {
        if let Some(input) = &self.harmonic {
            let harmonic = problems.inside("harmonic", |p| input.build(freedoms, p));
            return Some(BaseAcceleration::Harmonic(harmonic));
        }
        let input = self.shock.as_ref()?;
        let shock = problems.inside("shock", |p| input.build(freedoms, p));
        Some(BaseAcceleration::Shock(shock))
    }
}
