//! Kinds of questions about a scene, and the columns of their answers.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::analysis::{BodyQuantity, Channel};
use crate::rotor::RotorDefinition;
use crate::study::many::{NumberColumn, number_columns, static_columns};
use crate::table::Column;

/// Critical speeds that have a name.
pub(super) const CRITICAL_SPEEDS: usize = 8;
/// Orders of the shaft whose lines are numbers of a motion.
pub(super) const ORDERS: [&str; 3] = ["order_1", "order_2", "order_3"];

/// Which question is asked.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum Kind {
    /// The static equilibrium of the shaft, as `jeffcott bearing` answers it.
    Bearing,
    /// Natural frequencies at the speed of the scenario, and critical speeds, as of `jeffcott campbell`.
    Campbell,
    /// The motion that the shaft settles to, as `jeffcott steady` finds it.
    Steady,
    /// A run over the `[time]` of the scenario, as of `jeffcott run`.
    Run,
}

impl Kind {
    /// The numbers of its answers about a rotor.
    pub fn columns(self, rotor: &RotorDefinition) -> Vec<Column> {
        let of_runs = |columns: Vec<NumberColumn>| columns.into_iter().map(|own| own.column);
        match self {
            Self::Bearing => of_runs(static_columns(rotor)).collect(),
            Self::Run => of_runs(number_columns(rotor)).collect(),
            Self::Campbell => {
                let modes = (1..=rotor.shaft.freedoms.axes().len()).flat_map(mode_columns);
                modes
                    .chain((1..=CRITICAL_SPEEDS).map(critical_column))
                    .collect()
            }
            Self::Steady => {
                let channels = Channel::of_motion(rotor);
                channels.into_iter().flat_map(motion_columns).collect()
            }
        }
    }
}

/// Frequency and damping ratio of a mode, called as in the tables of studies.
pub(super) fn mode_columns(mode: usize) -> [Column; 2] {
    [("natural_frequency", "Hz"), ("damping_ratio", "")]
        .map(|(what, unit)| Column::number(format!("{what}_{mode}"), unit))
}

pub(super) fn critical_column(number: usize) -> Column {
    Column::number(format!("critical_speed_{number}"), "rad/s")
}

/// What is measured of a channel of a steady motion, called as in the tables of studies: mean, RMS, range and orders, of a length
/// also the RMS velocity.
pub(super) fn motion_columns(channel: Channel) -> Vec<Column> {
    let measures = ["mean", "rms", "peak_to_peak"].into_iter().chain(ORDERS);
    let columns = measures.map(|what| channel.measure(what));
    let velocity = velocity_of(channel).map(|velocity| velocity.measure("rms"));
    columns.chain(velocity).collect()
}

/// The velocity of a displacement that is a length.
pub(super) fn velocity_of(channel: Channel) -> Option<Channel> {
    match channel {
        Channel::Displacement(axis) if channel.unit() == "m" => Some(Channel::Velocity(axis)),
        Channel::Body {
            body,
            quantity: BodyQuantity::Displacement,
            axis,
        } => Some(Channel::Body {
            body,
            quantity: BodyQuantity::Velocity,
            axis,
        }),
        _ => None,
    }
}
