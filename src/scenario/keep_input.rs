//! What a study keeps of every run, as it is written.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::analysis::SectionKind;

/// What is kept of every run, besides its numbers.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub(super) struct KeepInput {
    /// Which numbers, by the names of their columns; the figures draw them in this order. The measured error
    /// is always kept. Default: all but the lines of forces, as `bearing1_force_x_order_1_N`; the figures draw some.
    #[schemars(extend("minItems" = 1, "maxItems" = 64, "examples" = [["x_rms_m", "bearing_1_life_h"]]))]
    pub numbers: Option<Vec<String>>,
    /// At how many azimuths around a bearing, from +X on, the answers of ask = "bearing" have deformation, loads and
    /// contact angles, in `around.csv`. Default: where its balls are.
    #[schemars(range(min = 3, max = 3600))]
    pub positions: Option<u32>,
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
