//! Column names of amplitudes and phases in the files.

use crate::analysis::{Channel, column_unit};

/// `x_amplitude_m`, `force_x_amplitude_N`.
pub(super) fn amplitude_column(channel: Channel) -> String {
    format!("{channel}_amplitude_{}", column_unit(channel.unit()))
}

/// `x_phase_rad`, `force_x_phase_rad`.
pub(super) fn phase_column(channel: Channel) -> String {
    format!("{channel}_phase_rad")
}
