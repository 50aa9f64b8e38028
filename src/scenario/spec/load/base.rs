//! `base` of `[[load]]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::PerFreedom;
use super::harmonic::HarmonicSpec;
use super::shock::ShockSpec;
use crate::rotor::load::BaseAcceleration;
use crate::rotor::{FREEDOMS, Freedoms};
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Acceleration, Quantity, si};

/// Acceleration of the housing, of one of two kinds.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = ["harmonic", "shock"]))]
pub struct BaseSpec {
    /// A cosine of time or of the shaft's angle.
    pub harmonic: Option<HarmonicSpec<Accelerations>>,
    /// A half-sine shock, once or at a fixed interval.
    pub shock: Option<ShockSpec<Accelerations>>,
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

impl BaseSpec {
    /// The acceleration of whichever kind is given.
    pub fn build(
        &self,
        path: &str,
        freedoms: Freedoms,
        problems: &mut Problems<'_>,
    ) -> Option<BaseAcceleration> {
        if let Some(spec) = &self.harmonic {
            let harmonic = spec.build(&format!("{path}.harmonic"), freedoms, problems);
            return Some(BaseAcceleration::Harmonic(harmonic));
        }
        let spec = self.shock.as_ref()?;
        let shock = spec.build(&format!("{path}.shock"), freedoms, problems);
        Some(BaseAcceleration::Shock(shock))
    }
}
