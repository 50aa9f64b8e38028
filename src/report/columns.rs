//! Column names of the files: quantity and unit, valid as names in Matlab and pandas; and what
//! the JSON files have in common.

use serde_json::{Value, json};

use crate::analysis::Channel;
use crate::bearing::Matrix5;
use crate::physics::BallPass;
use crate::rotor::FREEDOMS;

/// Unit as the end of a column name: `m`, `rad`, `N` or `N_m`.
fn unit_suffix(channel: Channel) -> String {
    channel.unit().replace(' ', "_")
}

/// `x_m`, `tilt_x_rad`, `force_x_N`, `moment_x_N_m`.
pub(super) fn value_column(channel: Channel) -> String {
    format!("{channel}_{}", unit_suffix(channel))
}

/// `x_amplitude_m`, `force_x_amplitude_N`.
pub(super) fn amplitude_column(channel: Channel) -> String {
    format!("{channel}_amplitude_{}", unit_suffix(channel))
}

/// `x_phase_rad`, `force_x_phase_rad`.
pub(super) fn phase_column(channel: Channel) -> String {
    format!("{channel}_phase_rad")
}

/// A unit such as `rad/s` or `kg m^2` as the end of a column name: `rad_s`, `kg_m2`.
pub(super) fn unit_name(unit: &str) -> String {
    unit.replace('^', "").replace([' ', '/', '.'], "_")
}

/// K with the names of its rows and columns.
pub(super) fn matrix(stiffness: &Matrix5) -> Value {
    let names = |channel: fn(usize) -> Channel| -> Value {
        (0..FREEDOMS).map(channel).map(value_column).collect()
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
