//! Column names of the files: quantity and unit, valid as names in Matlab and pandas; and what
//! the JSON files have in common.

use serde_json::{Value, json};

use crate::analysis::{Channel, column_unit};
use crate::bearing::Matrix5;
use crate::physics::BallPass;
use crate::rotor::FREEDOMS;

/// `x_amplitude_m`, `force_x_amplitude_N`.
pub(super) fn amplitude_column(channel: Channel) -> String {
    format!("{channel}_amplitude_{}", column_unit(channel.unit()))
}

/// `x_phase_rad`, `force_x_phase_rad`.
pub(super) fn phase_column(channel: Channel) -> String {
    format!("{channel}_phase_rad")
}

/// K with the names of its rows and columns.
pub(super) fn matrix(stiffness: &Matrix5) -> Value {
    let names = |channel: fn(usize) -> Channel| -> Value {
        (0..FREEDOMS).map(channel).map(Channel::column).collect()
    };
    let row = |row: usize| -> Value { stiffness.row(row).iter().copied().collect() };
    json!({
        "meaning": "forces and moments that the bearings need per displacement and tilt at the \
                    static equilibrium; the unit of an entry is that of its row over that of its \
                    column",
        "rows": names(Channel::Force),
        "columns": names(Channel::Displacement),
        "matrix": (0..FREEDOMS).map(row).collect::<Value>(),
    })
}

/// Ball-pass frequencies.
pub(super) fn ball_pass(pass: &BallPass) -> Value {
    json!({
        "outer_Hz": pass.outer,
        "inner_Hz": pass.inner,
        "spin_Hz": pass.spin,
        "cage_Hz": pass.cage,
    })
}
