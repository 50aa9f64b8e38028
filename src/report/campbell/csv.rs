//! `campbell.csv`: one row a speed and branch.

use std::io::{self, Write};

use super::super::statics::number;
use crate::study::campbell::Campbell;

const COLUMNS: [&str; 8] = [
    "speed_rad_s",
    "branch",
    "frequency_Hz",
    "undamped_frequency_Hz",
    "damping_ratio",
    "order",
    "whirl",
    "forward_share",
];

/// Writes the modes, branch by branch from 1 on; the order is empty at rest.
pub(super) fn write(campbell: &Campbell, writer: impl Write) -> io::Result<()> {
    let mut csv = csv::Writer::from_writer(writer);
    csv.write_record(COLUMNS)?;
    for (index, branch) in campbell.branches.iter().enumerate() {
        for (speed, mode) in campbell.speeds.iter().zip(&branch.modes) {
            let Some(mode) = mode else { continue };
            let frequency = mode.damped_frequency();
            let order = frequency * std::f64::consts::TAU / speed;
            csv.write_record([
                number(*speed),
                (index + 1).to_string(),
                number(frequency),
                number(mode.eigenvalue.norm() / std::f64::consts::TAU),
                number(mode.damping_ratio()),
                if *speed > 0.0 {
                    number(order)
                } else {
                    String::new()
                },
                mode.whirl().to_string(),
                number(mode.forward_share()),
            ])?;
        }
    }
    csv.flush()
}
