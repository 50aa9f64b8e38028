//! `[model]`, `[integrator]`, `[time]` and `[machine]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::bearing::ContactLaw;
use crate::integrate::{Method, Settings};
use crate::physics::{MachineGroup, MachineSupport, RaceControl};
use crate::rotor::CageMotion;
use crate::scenario::Issue;
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Quantity, Time};
use crate::simulate::Machine;

/// Which physics to simulate.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ModelInput {
    /// Force law of the bearings. Default: "hertz".
    pub contact: ContactChoice,
    /// With contact = "auto": largest difference of force and stiffness from the most exact law, at the
    /// operating points of the scene, relative, 1e-9 to 1. Default: 1e-3.
    #[schemars(range(min = 1e-9, max = 1))]
    pub model_error: Option<f64>,
    /// Whether oil films part balls and races; the bearings then need `[bearing.oil]`.
    /// Default: false.
    pub film: bool,
    /// Which race the balls roll on without spinning, with contact = "jones". Default: "outer".
    pub race_control: Option<RaceControl>,
    /// Whether costly ball laws (all but "hertz" without film) are compiled into tables before the
    /// motion starts: many times as fast at constant speed, with an error below 1e-9 of the largest
    /// static ball load, which the summary states. Where a ball leaves the table, and where the speed
    /// varies, the law itself is used. Default: false.
    pub table: bool,
    /// How the balls go round. Default: "operating".
    pub cage: CageMotion,
}

/// Force law of a bearing.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum ContactChoice {
    /// The stiffness matrix at the static equilibrium, frozen.
    Linear,
    /// Hertz contact of each ball with both races; the inertia of the balls is neglected.
    #[default]
    Hertz,
    /// Jones's ball equilibrium: as "hertz", with the centrifugal force and the gyroscopic moment
    /// of every ball.
    Jones,
    /// The cheapest of all these, with oil films where `[bearing.oil]` is given, whose force and stiffness
    /// differ from the most exact one by no more than `model_error` at the operating points of the scene.
    Auto,
}

impl ContactChoice {
    /// Whether the law may know the inertia of the balls.
    pub fn knows_inertia(self) -> bool {
        matches!(self, Self::Jones | Self::Auto)
    }

    /// The force law of rollers, whose inertia none knows.
    pub fn without_inertia(self) -> ContactLaw {
        match self {
            Self::Linear => ContactLaw::Linear,
            _ => ContactLaw::Hertz,
        }
    }

    /// The force law; the race control plays a part in Jones's only.
    pub fn law(self, control: Option<RaceControl>) -> ContactLaw {
        match self {
            Self::Linear => ContactLaw::Linear,
            Self::Hertz => ContactLaw::Hertz,
            // what is to be chosen starts at the top
            Self::Jones | Self::Auto => ContactLaw::Jones(control.unwrap_or_default()),
        }
    }
}

/// How to integrate and how exactly.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct IntegratorInput {
    /// Integration method. Default: "auto".
    pub method: Method,
    /// Error aimed at, relative to the scale of the motion, 1e-13 to 1e-2.
    /// Default: 1e-8.
    #[schemars(range(min = 1e-13, max = 1e-2))]
    pub tolerance: f64,
    /// Largest number of steps, accepted and rejected together. Default: 100 million.
    #[schemars(range(min = 1, max = 1_000_000_000_000_i64))]
    pub step_limit: u64,
    /// Whether a second run at a tenth of the tolerance measures the error of the first.
    /// Default: true.
    pub verify: bool,
}

impl Default for IntegratorInput {
    fn default() -> Self {
        Self {
            method: Method::Auto,
            tolerance: 1e-8,
            step_limit: 100_000_000,
            verify: true,
        }
    }
}

impl IntegratorInput {
    /// Method, tolerance and limit.
    pub fn build(&self) -> Settings {
        Settings {
            method: self.method,
            tolerance: self.tolerance,
            step_limit: self.step_limit,
        }
    }
}

/// How long to simulate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TimeInput {
    /// Simulated time, for instance "0.5 s".
    #[schemars(extend("x-minimum" = 1e-6))]
    pub duration: Quantity<Time>,
    /// Time at the start that the spectra leave out, so that the transient does not colour
    /// them; shorter than the duration. Default: "0 s".
    #[serde(default)]
    #[schemars(extend("examples" = ["0.2 s"], "x-minimum" = 0.0))]
    pub settle: Quantity<Time>,
}

impl TimeInput {
    /// Time that the spectra are taken of, s.
    pub fn window(&self) -> f64 {
        self.duration.si() - self.settle.si()
    }

    /// Refuses a settle time that leaves nothing.
    pub fn check(&self, problems: &mut Problems<'_>) {
        if self.window() <= 0.0 {
            let duration = self.duration.si();
            let message = format!("`settle` must be shorter than the `duration` of {duration} s");
            problems.refuse(Issue::new("time.settle", message).against("time.duration"));
        }
    }
}

/// The machine that the shaft is part of. Where it is given, `run` says in which evaluation zone of ISO 20816-3 the
/// vibration lies.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MachineInput {
    /// Group of ISO 20816-3. 1: rated power above 300 kW, or an electrical machine with a shaft height of 315 mm or more; 2:
    /// rated power of 15 kW to 300 kW, or an electrical machine with a shaft height of 160 mm to 315 mm.
    #[schemars(range(min = 1, max = 2), extend("examples" = [2]))]
    pub group: u8,
    /// Its support: "rigid" where the lowest natural frequency of machine and support lies at least a quarter above the
    /// frequency of rotation, else "flexible".
    #[schemars(extend("examples" = ["rigid"]))]
    pub support: MachineSupport,
}

impl MachineInput {
    /// As the run judges it.
    pub fn build(&self) -> Machine {
        Machine {
            group: match self.group {
                1 => MachineGroup::Large,
                _ => MachineGroup::Medium,
            },
            support: self.support,
        }
    }
}
