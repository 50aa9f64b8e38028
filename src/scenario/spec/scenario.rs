//! The whole file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::bearing::BearingSpec;
use super::damping::{self, DampingSpec};
use super::initial::InitialSpec;
use super::integrator::IntegratorSpec;
use super::load::{self, LoadSpec, Surroundings};
use super::model::ModelSpec;
use super::output::OutputSpec;
use super::shaft::ShaftSpec;
use super::speed::SpeedSpec;
use super::time::TimeSpec;
use crate::rotor::RotorDefinition;
use crate::scenario::problems::Problems;
use crate::simulate::Model;

/// A shaft on ball bearings, what drives and loads it, how long and how
/// exactly to simulate it, and what to keep. What has a dimension is a string with its unit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Scenario of jeffcott")]
pub struct ScenarioSpec {
    /// Where an editor finds the schema of this file; without effect on the run.
    #[serde(rename = "$schema")]
    pub schema: Option<String>,
    /// One line on what the scenario shows. Default: the name of the file.
    pub title: Option<String>,
    /// The shaft, a concentrated mass with an eccentricity.
    #[schemars(extend("examples" = [{ "mass": "5 kg", "freedoms": "translational" }]))]
    pub shaft: ShaftSpec,
    /// How fast the shaft turns.
    #[schemars(extend("examples" = [{ "constant": "500 rad/s" }]))]
    pub speed: SpeedSpec,
    /// The bearings that carry the shaft, one `[[bearing]]` for each, at least one.
    #[schemars(extend("minItems" = 1, "examples" = [[{ "catalogue": "7205C" }]]))]
    pub bearing: Vec<BearingSpec>,
    /// Which physics to simulate.
    #[serde(default)]
    pub model: ModelSpec,
    /// Viscous damping. Without this table nothing is damped.
    pub damping: Option<DampingSpec>,
    /// External loads, one `[[load]]` for each; they add up.
    #[serde(default)]
    pub load: Vec<LoadSpec>,
    /// Where the motion starts.
    #[serde(default)]
    pub initial: InitialSpec,
    /// How long to simulate.
    #[schemars(extend("examples" = [{ "duration": "0.5 s" }]))]
    pub time: TimeSpec,
    /// How to integrate and how exactly.
    #[serde(default)]
    pub integrator: IntegratorSpec,
    /// What to keep of the run.
    #[serde(default)]
    pub output: OutputSpec,
}

impl ScenarioSpec {
    /// The model, as far as nothing contradicts it.
    pub fn build(&self, problems: &mut Problems<'_>) -> Option<Model> {
        let shaft = self.shaft.build(problems);
        let speed = self.speed.build(problems);
        let mounted = |(index, bearing): (usize, &BearingSpec)| {
            bearing.build(index, self.model.contact, shaft.freedoms, problems)
        };
        let bearings: Vec<_> = self.bearing.iter().enumerate().map(mounted).collect();
        let damping = damping::build(self.damping.as_ref(), shaft.freedoms, problems);
        let around = Surroundings {
            freedoms: shaft.freedoms,
            duration: self.time.duration.si(),
        };
        let (load, loads) = load::build(&self.load, around, problems);
        let initial = self.initial.build(shaft.freedoms, problems);
        self.time.check(problems);
        let speed = speed?;
        let turning = (self.speed.path(), &speed);
        let sampling = self.output.sampling(turning, &self.time, problems)?;
        let mut points = speed.points();
        Some(Model {
            rotor: RotorDefinition {
                shaft,
                speed: points.next()?.speed,
                speed_points: points.collect(),
                cage: self.model.cage.into(),
                damping,
                load,
                loads,
                initial,
                bearings: bearings.into_iter().collect::<Option<_>>()?,
            },
            duration: self.time.duration.si(),
            settle: self.time.settle.si(),
            sampling,
            integrator: self.integrator.build(),
            verify: self.integrator.verify,
            spectrum: self.output.spectrum.then_some(self.output.window.into()),
        })
    }
}
