//! `sprocket` of `[[load]]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::rotor::load::{ChainDrive, Sprocket};
use crate::scenario::quantity::{Angle, Force, Length, Quantity};

/// A chain strand that pulls at a driving sprocket on the shaft. Constant torque is assumed: the
/// pull is inverse to the lever, which falls and rises with every tooth.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SprocketInput {
    /// Number of teeth that carry a joint of the chain in turn, 3 to 1000.
    #[schemars(extend("examples" = [8]), range(min = 3, max = 1000))]
    pub teeth: u32,
    /// Distance of two joints of the chain, for instance "126 mm".
    #[schemars(extend("examples" = ["126 mm"], "x-minimum" = 1e-4))]
    pub pitch: Quantity<Length>,
    /// Length of the free strand, from the sprocket to its next guide.
    #[schemars(extend("examples" = ["1 m"], "x-minimum" = 1e-3))]
    pub span: Quantity<Length>,
    /// Mean pull of the strand; counts in the static equilibrium.
    #[schemars(extend("examples" = ["2 kN"]))]
    pub force: Quantity<Force>,
    /// Direction of the pull, from +X towards +Y. Default: "0 rad", along +X.
    #[serde(default)]
    pub direction: Quantity<Angle>,
    /// Number of harmonics of the meshing frequency, 1 to 64. Default: 8.
    #[serde(default = "some_harmonics")]
    #[schemars(range(min = 1, max = 64))]
    pub harmonics: u32,
}

fn some_harmonics() -> u32 {
    8
}

impl SprocketInput {
    /// The pull of the chain.
    pub fn build(&self) -> Sprocket {
        Sprocket::new(&ChainDrive {
            teeth: self.teeth,
            pitch: self.pitch.si(),
            span: self.span.si(),
            force: self.force.si(),
            direction: self.direction.si(),
            harmonics: self.harmonics,
        })
    }
}
