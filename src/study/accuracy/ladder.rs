//! The ladder of physics: what each rung costs, and how far it is from the top one.
//!
//! From the top rung on, one thing is taken away at a time: the law of the contacts goes down to the frozen
//! stiffness, the cage stands, freedoms are held. The rungs are run by the scene's own method at its own
//! tolerance.

use std::fmt;
use std::sync::atomic::AtomicBool;

use serde::{Serialize, Serializer};

use super::reference::{Cost, Trial, measure as measure_cost, observe, with};
use super::trace::View;
use super::{Errors, Norm, Scale, is_interrupted};
use crate::bearing::Oil;
use crate::keys;
use crate::rotor::{CageMotion, Freedoms, Rotor, RotorDefinition, check_constraints};
use crate::simulate::{Model, SimulateError};
use crate::study::Rung;

/// One way to simulate the scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct Configuration {
    /// Law of the contacts.
    pub rung: Rung,
    /// Motion of the cages.
    pub(crate) cage: CageMotion,
    /// Freedoms that move.
    pub(crate) freedoms: Freedoms,
}

impl fmt::Display for Configuration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let cage = match self.cage {
            CageMotion::Rolling => "rolling",
            CageMotion::Frozen => "frozen",
        };
        let freedoms = match self.freedoms {
            Freedoms::Radial => "radial",
            Freedoms::Translational => "translational",
            Freedoms::All => "all",
        };
        write!(f, "{}, {cage}, {freedoms}", self.rung)
    }
}

impl Configuration {
    /// The configuration of a scene; of bearings with different laws the highest counts.
    fn of(rotor: &RotorDefinition) -> Option<Self> {
        let rung = rotor.bearings.iter().map(Rung::from).max()?;
        Some(Self {
            rung,
            cage: rotor.cage,
            freedoms: rotor.shaft.freedoms,
        })
    }

    /// The scene in this configuration.
    fn apply(&self, model: &Model, oils: &[Option<Oil>]) -> Model {
        let mut model = with(model, model.integrator.method, model.integrator.tolerance);
        let oils = oils.iter().copied().chain(std::iter::repeat(None));
        for (bearing, oil) in model.rotor.bearings.iter_mut().zip(oils) {
            *bearing = self.rung.of(bearing, oil);
        }
        model.rotor.cage = self.cage;
        model.rotor.shaft.freedoms = self.freedoms;
        model
    }
}

/// A configuration to run.
#[derive(Debug, Clone, PartialEq)]
pub struct Climb {
    /// The configuration.
    pub configuration: Configuration,
    /// Whether it is the scene as it is written.
    pub as_written: bool,
    /// The scene in it, or why it cannot be built.
    pub model: Result<Model, String>,
}

/// The ladder of a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Ladder {
    /// The top rung.
    #[serde(serialize_with = "keys::optional_name")]
    pub top: Option<Configuration>,
    /// The rungs, the top one first.
    #[serde(rename = "rungs")]
    pub rows: Vec<LadderRow>,
}

/// A rung.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct LadderRow {
    /// What it simulates.
    #[serde(rename = "model", serialize_with = "keys::name")]
    pub configuration: Configuration,
    /// Whether it is the scene as it is written.
    pub as_written: bool,
    /// What it costs and how far it is from the top rung after the settle time, or why it is not
    /// available. All is relative to the largest root mean square of the vibration of the top rung:
    /// differences of traces are root mean squares about their mean, and that mean, by which the
    /// shaft vibrates about another place, is the difference of the means in the statistics.
    #[serde(flatten, serialize_with = "measured")]
    pub result: Result<(Cost, Errors), String>,
}

/// Cost and difference, or a note that says why there are none.
fn measured<S: Serializer>(
    result: &Result<(Cost, Errors), String>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    #[derive(Serialize)]
    struct Measured<'a> {
        cost: &'a Cost,
        difference: &'a Errors,
    }
    let result = result.as_ref();
    keys::or_note(
        &result.map(|(cost, difference)| Measured { cost, difference }),
        serializer,
    )
}

/// The rungs of a scene, the top one first.
pub(super) fn plan(model: &Model, oils: &[Option<Oil>]) -> Vec<Climb> {
    let written = Configuration::of(&model.rotor);
    let climb = |configuration: Configuration| Climb {
        configuration,
        as_written: written == Some(configuration),
        model: build(model, oils, configuration),
    };
    let Some(top) = top(&climb) else {
        return Vec::new();
    };
    let best = top.configuration;
    let laws = Rung::ALL.into_iter().rev();
    let mut others: Vec<Configuration> = laws.map(|rung| Configuration { rung, ..best }).collect();
    others.push(Configuration {
        cage: CageMotion::Frozen,
        ..best
    });
    for freedoms in [Freedoms::All, Freedoms::Translational, Freedoms::Radial] {
        others.push(Configuration { freedoms, ..best });
    }
    others.extend(written);
    let mut climbs = vec![top];
    for configuration in others {
        if climbs
            .iter()
            .all(|climb| climb.configuration != configuration)
        {
            climbs.push(climb(configuration));
        }
    }
    climbs
}

/// The highest configuration that can be built.
fn top(climb: &impl Fn(Configuration) -> Climb) -> Option<Climb> {
    [Freedoms::All, Freedoms::Translational, Freedoms::Radial]
        .into_iter()
        .flat_map(|freedoms| {
            Rung::ALL.into_iter().rev().map(move |rung| Configuration {
                rung,
                cage: CageMotion::Rolling,
                freedoms,
            })
        })
        .map(climb)
        .find(|climb| climb.model.is_ok())
}

/// The scene in a configuration, where all that it takes is known.
fn build(
    model: &Model,
    oils: &[Option<Oil>],
    configuration: Configuration,
) -> Result<Model, String> {
    if configuration.rung.has_film() && oils.iter().all(Option::is_none) {
        return Err("no bearing has a [bearing.oil]".to_owned());
    }
    if configuration.freedoms == Freedoms::All && model.rotor.shaft.inertia_transverse == 0.0 {
        return Err("[shaft] gives no inertia_transverse".to_owned());
    }
    let model = configuration.apply(model, oils);
    let rotor = Rotor::assemble(&model.rotor).map_err(|error| error.to_string())?;
    check_constraints(&model.rotor, &rotor).map_err(|error| error.to_string())?;
    Ok(model)
}

/// Runs all rungs. `done` is called after each.
pub(super) fn measure(
    settle: f64,
    climbs: Vec<Climb>,
    stop: &AtomicBool,
    mut done: impl FnMut(),
) -> Result<Ladder, SimulateError> {
    let mut rows = Vec::new();
    let mut truth: Option<(Trial, Scale)> = None;
    let mut top = None;
    for climb in climbs {
        let result = match climb.model {
            Err(reason) => Err(reason),
            Ok(model) => match run(&model, truth.as_ref(), settle, stop) {
                Err(error) if is_interrupted(&error) => return Err(error),
                Err(error) => Err(error.to_string()),
                Ok((cost, errors, trial)) => {
                    if truth.is_none() {
                        top = Some(climb.configuration);
                        let scale = vibration(&trial);
                        truth = Some((trial, scale));
                    }
                    Ok((cost, errors))
                }
            },
        };
        rows.push(LadderRow {
            configuration: climb.configuration,
            as_written: climb.as_written,
            result,
        });
        done();
    }
    Ok(Ladder { top, rows })
}

/// Runs a rung; without a `truth` it is the truth itself.
fn run(
    model: &Model,
    truth: Option<&(Trial, Scale)>,
    from: f64,
    stop: &AtomicBool,
) -> Result<(Cost, Errors, Trial), SimulateError> {
    let rotor = Rotor::assemble(&model.rotor)?;
    let scale = rotor.motion_scale(model.integrator.tolerance);
    let view = View::new(&rotor, &scale, model.settle, super::samples(model, &rotor));
    let trial = observe(model, view, stop)?;
    let errors = match truth {
        Some((truth, scale)) => Errors::between(&trial, truth, scale, Norm::Vibration, from),
        None => Errors::between(&trial, &trial, &vibration(&trial), Norm::Vibration, from),
    };
    Ok((measure_cost(model, stop)?, errors, trial))
}

/// What differences are relative to.
fn vibration(trial: &Trial) -> Scale {
    let [displacement, force] = trial.trace.vibration();
    Scale {
        displacement: displacement.max(f64::MIN_POSITIVE),
        force: force.max(f64::MIN_POSITIVE),
    }
}
