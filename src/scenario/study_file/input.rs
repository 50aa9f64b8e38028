//! The keys of a study file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::analysis::SectionKind;
use crate::scenario::axis::AxisInput;
use crate::scenario::scalar::Scalar;
use crate::study::many::Sweep;
use crate::study::plan::MOST_RUNS;

/// Many runs of one scenario.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "jeffcott study")]
pub struct StudyFileInput {
    /// What the study is called. Default: the name of its file.
    pub title: Option<String>,
    /// The scenario that all runs start from, relative to this file.
    #[schemars(extend("examples" = ["../steady-7205c.toml"]))]
    pub base: String,
    /// How the values of the axes are combined. Default: "grid".
    #[serde(default)]
    pub sampling: SamplingKind,
    /// How many runs are drawn; only where they are drawn.
    #[schemars(range(min = 1, max = MOST_RUNS))]
    pub runs: Option<u64>,
    /// Decides all that is drawn. Default: 0.
    #[serde(default)]
    pub seed: u64,
    /// Every so many runs the error is measured by a second pass, from the first run on; 0 on none.
    /// Default: 10.
    #[serde(default = "every_tenth")]
    pub verify_every: u64,
    /// Whether each run goes on from where its neighbour along the last axis ended, and in which order.
    /// Default: every run starts by itself.
    pub sweep: Option<Sweep>,
    /// The numbers that vary, on a grid the last one fastest.
    #[schemars(extend("minItems" = 1, "maxItems" = 16))]
    pub axis: Vec<AxisInput>,
    /// What all runs have otherwise than the base.
    #[serde(default)]
    pub set: Vec<SetInput>,
    /// How long every run is in cycles at its own speed, in place of the `[time]` of the base.
    pub cycles: Option<CyclesInput>,
    /// What is kept of every run.
    #[serde(default)]
    pub keep: KeepInput,
}

/// How long a run is in cycles at its own, constant speed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CyclesInput {
    /// What counts as a cycle.
    pub of: SectionKind,
    /// Cycles that settle. Default: 0.
    #[serde(default)]
    #[schemars(range(min = 0, max = 1_000_000_000))]
    pub settle: u32,
    /// Cycles after them.
    #[schemars(range(min = 1, max = 1_000_000_000), extend("examples" = [100]))]
    pub kept: u32,
}

fn every_tenth() -> u64 {
    10
}

/// How the values of the axes are combined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SamplingKind {
    /// Every value with every other.
    #[default]
    Grid,
    /// Drawn, each part of every axis once.
    LatinHypercube,
    /// Sobol's sequence, shifted at random.
    Sobol,
    /// Drawn independently.
    MonteCarlo,
}

/// One value that all runs have.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SetInput {
    /// Path of the key of a number, or of a word out of several.
    #[schemars(extend("examples" = ["time.duration", "model.contact"]))]
    pub key: String,
    /// Its value, written as that key is.
    #[schemars(extend("examples" = ["0.5 s"]))]
    pub value: Scalar,
}

/// What is kept of every run, beside its numbers.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct KeepInput {
    /// Which numbers, by the names of their columns; the figures draw them in this order. The measured error
    /// is always kept. Default: all, of which the figures draw some.
    #[schemars(extend("minItems" = 1, "maxItems" = 64, "examples" = [["x_rms_m", "bearing_1_life_h"]]))]
    pub numbers: Option<Vec<String>>,
    /// Whether the amplitudes of the displacements are kept, in `spectra.csv`. Default: false.
    pub spectra: bool,
    /// Highest frequency of them in shaft orders. Default: 20.
    #[schemars(range(min = 0.0))]
    pub highest_order: Option<f64>,
    /// Whether the trace of every run is kept, in `traces/trace-<number>.csv`; `traces.csv` says what they are
    /// known by. Default: false.
    pub traces: bool,
    /// Whether stiffness and damping of every bearing at the static equilibrium are kept, in
    /// `stiffness.csv`, and for rotor dynamics with ROSS, in `ross_*.toml`, as functions of the speed.
    /// Default: false.
    pub bearing_stiffness: bool,
    /// Whether the place of the shaft is kept once a revolution or once a ball pass after the settle
    /// time, in `poincare.csv`. Default: not.
    pub poincare: Option<SectionKind>,
}
