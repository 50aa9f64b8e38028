//! Fidelity levels: what each costs, and how far it is from the highest one.
//!
//! From the highest level on, one thing is taken away at a time: the law of the contacts goes down to the frozen
//! stiffness, the cage is held, freedoms are held. The levels are run by the scene's own method at its own
//! tolerance.

use std::fmt;
use std::sync::atomic::AtomicBool;

use serde::{Serialize, Serializer};
use serde_json::json;

use super::Errors;
use super::trial::{Cost, Trial, unless_stopped, with};
use super::truth::{Scale, Truth};
use crate::analysis::Moments;
use crate::bearing::Oil;
use crate::keys;
use crate::rotor::{CageMotion, Freedoms, Rotor, RotorDefinition, check_constraints};
use crate::simulate::{Model, SimulateError};
use crate::study::Fidelity;

/// One way to simulate the scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct Configuration {
    /// Law of the contacts.
    pub fidelity: Fidelity,
    /// Motion of the cages.
    pub(crate) cage: CageMotion,
    /// Freedoms that move.
    pub(crate) freedoms: Freedoms,
}

impl fmt::Display for Configuration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let cage = match self.cage {
            CageMotion::Operating => "operating",
            CageMotion::Rolling => "rolling",
            CageMotion::Frozen => "frozen",
        };
        write!(f, "{}, {cage}, {}", self.fidelity, self.freedoms.name())
    }
}

impl Configuration {
    /// The configuration of a scene; of bearings with different laws the highest counts.
    fn from_rotor(rotor: &RotorDefinition) -> Option<Self> {
        let fidelity = rotor.bearings.iter().map(Fidelity::from).max()?;
        Some(Self {
            fidelity,
            cage: rotor.cage,
            freedoms: rotor.shaft.freedoms,
        })
    }

    /// The scene in this configuration.
    fn apply(&self, model: &Model, oils: &[Option<Oil>]) -> Model {
        let mut model = with(model, model.integrator.method, model.integrator.tolerance);
        let oils = oils.iter().copied().chain(std::iter::repeat(None));
        for (bearing, oil) in model.rotor.bearings.iter_mut().zip(oils) {
            *bearing = self.fidelity.applied_to(bearing, oil);
        }
        model.rotor.cage = self.cage;
        model.rotor.shaft.freedoms = self.freedoms;
        model
    }
}

/// A configuration to run.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// The configuration.
    pub configuration: Configuration,
    /// Whether it is the scene as it is written.
    pub as_written: bool,
    /// The scene in it, or why it cannot be built.
    pub model: Result<Model, String>,
}

/// The fidelity levels of a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct FidelityLevels {
    /// The highest level.
    #[serde(serialize_with = "keys::optional_name")]
    pub top: Option<Configuration>,
    /// The levels, the highest first.
    #[serde(rename = "rungs")]
    pub rows: Vec<FidelityRow>,
}

/// A fidelity level.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct FidelityRow {
    /// What it simulates.
    #[serde(rename = "model", serialize_with = "keys::name")]
    pub configuration: Configuration,
    /// Whether it is the scene as it is written.
    pub as_written: bool,
    /// What it costs and how far it is from the highest level after the settle time, or why it is not
    /// available. All is relative to the largest root mean square of the vibration of the highest level:
    /// differences of traces are root mean squares about their mean, and that mean, by which the
    /// shaft vibrates about another position, is the difference of the means in the statistics.
    #[serde(flatten, serialize_with = "measured")]
    pub result: Result<(Cost, Errors), String>,
}

/// Cost and difference, or a note that says why there are none.
fn measured<S: Serializer>(
    result: &Result<(Cost, Errors), String>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    let result = result.as_ref();
    let measured = result.map(|(cost, errors)| json!({ "cost": cost, "difference": errors }));
    keys::or_note(&measured, serializer)
}

/// Freedoms that can move, the most first.
const FREEDOMS: [Freedoms; 3] = [Freedoms::All, Freedoms::Translational, Freedoms::Radial];

/// The levels of a scene, the highest first.
pub(super) fn plan(model: &Model, oils: &[Option<Oil>]) -> Vec<Level> {
    let written = Configuration::from_rotor(&model.rotor);
    let level = |configuration: Configuration| Level {
        configuration,
        as_written: written == Some(configuration),
        model: build(model, oils, configuration),
    };
    let cage = match model.rotor.cage {
        CageMotion::Frozen => CageMotion::default(),
        turns => turns,
    };
    // the highest configuration that can be built
    let all = FREEDOMS.iter().flat_map(|&freedoms| {
        let laws = Fidelity::ALL.into_iter().rev();
        laws.map(move |fidelity| Configuration {
            fidelity,
            cage,
            freedoms,
        })
    });
    let Some(top) = all.map(&level).find(|level| level.model.is_ok()) else {
        return Vec::new();
    };
    let best = top.configuration;
    let laws = Fidelity::ALL.into_iter().rev();
    let mut others: Vec<Configuration> = laws
        .map(|fidelity| Configuration { fidelity, ..best })
        .collect();
    others.push(Configuration {
        cage: CageMotion::Frozen,
        ..best
    });
    others.extend(FREEDOMS.map(|freedoms| Configuration { freedoms, ..best }));
    others.extend(written);
    let mut levels = vec![top];
    for configuration in others {
        let is_same = |level: &Level| level.configuration == configuration;
        if !levels.iter().any(is_same) {
            levels.push(level(configuration));
        }
    }
    levels
}

/// The scene in a configuration, where all that it takes is known.
fn build(
    model: &Model,
    oils: &[Option<Oil>],
    configuration: Configuration,
) -> Result<Model, String> {
    if configuration.fidelity.has_film() && oils.iter().all(Option::is_none) {
        return Err("no bearing has a [bearing.oil]".to_owned());
    }
    if configuration.freedoms.tilts() && model.rotor.shaft.inertia_transverse == 0.0 {
        return Err("[shaft] gives no inertia_transverse".to_owned());
    }
    let model = configuration.apply(model, oils);
    let rotor = Rotor::assemble(&model.rotor).map_err(|error| error.to_string())?;
    check_constraints(&model.rotor, &rotor).map_err(|error| error.to_string())?;
    Ok(model)
}

/// Runs all levels. `done` is called after each.
pub(super) fn measure(
    settle: f64,
    levels: Vec<Level>,
    stop: &AtomicBool,
    mut done: impl FnMut(),
) -> Result<FidelityLevels, SimulateError> {
    let mut rows = Vec::new();
    let mut truth: Option<Truth> = None;
    let mut top = None;
    for level in levels {
        let result = match level.model {
            Err(reason) => Err(reason),
            Ok(model) => {
                let run = || {
                    let trial = Trial::run(&model, stop)?;
                    Ok((trial.cost(&model, stop)?, trial))
                };
                unless_stopped(run())?.map(|(cost, trial)| match &truth {
                    Some(truth) => (cost, truth.errors(&trial)),
                    None => {
                        top = Some(level.configuration);
                        let highest = truth.insert(vibration(trial, settle));
                        (cost, highest.errors(&highest.trial))
                    }
                })
            }
        };
        rows.push(FidelityRow {
            configuration: level.configuration,
            as_written: level.as_written,
            result,
        });
        done();
    }
    Ok(FidelityLevels { top, rows })
}

/// The run of the highest level as what the others are compared with, by their vibration about their own means.
fn vibration(trial: Trial, settle: f64) -> Truth {
    let size = trial.trace.vibration();
    let [displacement, force] = size.map(|size| size.max(f64::MIN_POSITIVE));
    Truth {
        trial,
        scale: Scale {
            displacement,
            force,
        },
        norm: Moments::rms,
        from: settle,
    }
}
