//! Column names of the files: quantity and unit, valid as names in Matlab and pandas.

use crate::analysis::Channel;

/// Unit as the end of a column name: `m`, `rad`, `N` or `N_m`.
fn unit_suffix(channel: Channel) -> String {
    channel.unit().replace(' ', "_")
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
