//! Tables beside the trace, one row a sample.

use super::table::Column;
use crate::rotor::Sample;

/// What a table shows of the samples.
#[derive(Debug, Clone, Copy)]
pub(super) struct TableKind {
    /// Name of the file without its ending.
    pub stem: &'static str,
    /// Names of the columns, each with its unit.
    pub columns: &'static [&'static str],
    /// Appends the values of a row; none where the sample has nothing to show.
    pub row: fn(&Sample, &mut Vec<f64>),
}

impl TableKind {
    /// Where the energy is: `energy.csv`.
    pub const ENERGY: Self = Self {
        stem: "energy",
        columns: &[
            "t_s",
            "kinetic_J",
            "stored_J",
            "loads_J",
            "unbalance_J",
            "rotation_J",
            "viscous_damping_J",
            "contact_damping_J",
            "bearings_J",
            "drive_J",
            "load_torque_J",
            "bearing_friction_J",
        ],
        row: |sample, row| {
            if let Some(energy) = &sample.energy {
                row.extend([sample.time, energy.kinetic, energy.stored]);
                row.extend(energy.works.values());
            }
        },
    };
    /// Moments on a driven shaft: `drive.csv`.
    pub const DRIVE: Self = Self {
        stem: "drive",
        columns: &[
            "t_s",
            "speed_rad_s",
            "drive_torque_N_m",
            "load_torque_N_m",
            "friction_moment_N_m",
            "vibration_torque_N_m",
            "twist_rad",
        ],
        row: |sample, row| {
            if let Some(moments) = &sample.drive {
                row.extend([sample.time, sample.speed, moments.drive, moments.load]);
                row.extend([moments.friction, moments.vibration, moments.twist]);
            }
        },
    };

    /// Its columns.
    pub fn columns(&self) -> Vec<Column> {
        self.columns.iter().copied().map(Column::number).collect()
    }
}
