//! `harmonic` of `[[load]]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{PerFreedom, moving};
use crate::rotor::Freedoms;
use crate::rotor::load::{Harmonic, Pace};
use crate::scenario::problems::Problems;
use crate::scenario::quantity::{Angle, Frequency, Quantity, si};

/// A cosine, either of time or of the shaft's angle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("x-exactly-one" = ["frequency", "order"]))]
pub struct HarmonicInput<A> {
    /// Amplitude of each freedom.
    pub amplitude: A,
    /// Periods a second, for instance "50 Hz".
    #[schemars(extend("examples" = ["50 Hz"], "x-minimum" = 0.0))]
    pub frequency: Option<Quantity<Frequency>>,
    /// Periods per revolution of the shaft, 0 to 10000.
    #[schemars(range(min = 0.0, max = 10_000.0))]
    pub order: Option<f64>,
    /// Phase at the start: the load is amplitude · cos(phase) there. Default: "0 rad".
    #[serde(default)]
    pub phase: Quantity<Angle>,
}

impl<A: PerFreedom> HarmonicInput<A> {
    /// The harmonic load.
    pub fn build(&self, freedoms: Freedoms, problems: &mut Problems<'_>) -> Harmonic {
        let frequency = si(&self.frequency).unwrap_or(0.0);
        Harmonic {
            amplitude: moving(&self.amplitude, ".amplitude", freedoms, problems),
            pace: self.order.map_or(Pace::Frequency(frequency), Pace::Order),
            phase: self.phase.si(),
        }
    }
}
