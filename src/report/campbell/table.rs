//! `campbell.csv`: one row a speed and branch.

use std::f64::consts::TAU;

use super::super::table::Table;
use crate::study::campbell::Campbell;

/// The modes, branch by branch from 1 on; the order is missing at rest.
pub(super) fn modes(campbell: &Campbell) -> Table {
    let branches = campbell.branches.iter().enumerate();
    let modes: Vec<_> = branches
        .flat_map(|(index, branch)| {
            let modes = campbell.speeds.iter().zip(&branch.modes);
            modes.filter_map(move |(speed, mode)| Some((index + 1, *speed, mode.as_ref()?)))
        })
        .collect();
    let shapes = || modes.iter().map(|(.., mode)| mode);
    let order = |(_, speed, mode): &(usize, f64, &crate::rotor::Mode)| {
        (*speed > 0.0).then(|| mode.damped_frequency() * TAU / speed)
    };
    let mut table = Table::default();
    table.numbers("speed_rad_s", modes.iter().map(|(_, speed, _)| *speed));
    table.counts("branch", modes.iter().map(|(branch, ..)| *branch as f64));
    table.numbers("frequency_Hz", shapes().map(|mode| mode.damped_frequency()));
    let undamped = shapes().map(|mode| mode.eigenvalue.norm() / TAU);
    table.numbers("undamped_frequency_Hz", undamped);
    table.numbers("damping_ratio", shapes().map(|mode| mode.damping_ratio()));
    table.numbers("order", modes.iter().map(order));
    table.words("whirl", shapes().map(|mode| mode.whirl()));
    table.numbers("forward_share", shapes().map(|mode| mode.forward_share()));
    table
}
