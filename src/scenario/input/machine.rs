//! `[machine]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::physics::{MachineGroup, MachineSupport};
use crate::simulate::Machine;

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
